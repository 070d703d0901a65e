#include "model/plugin.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

#include <exception>
#include <filesystem>
#include <utility>

#include "core/error.hpp"
#include "model/decision_check.hpp"

namespace pedzone {
namespace {

constexpr const char* kEntry = "pedzone_walking_model";

/// Calls `work`; what it throws becomes an InputError that names the library.
template <class Work>
auto guarded_call(const std::string& path, const Work& work) {
  const auto error = [&](const std::string& what) {
    return InputError("failed: " + what,
                      {path, 0, "walking model", "", "a model that does not throw"});
  };
  try {
    return work();
  } catch (const std::exception& thrown) {
    throw error(thrown.what());
  } catch (...) {
    throw error("something that is no std::exception was thrown");
  }
}

/// A plug-in's model, watched.
class PluginModel : public WalkingModel {
 public:
  PluginModel(std::string path, std::unique_ptr<WalkingModel> model)
      : path_(std::move(path)), model_(std::move(model)) {}

  void prepare(const Snapshot& snapshot) override {
    snapshot_ = snapshot;
    guarded_call(path_, [&] { model_->prepare(snapshot); });
  }

  void decide(std::size_t first, std::size_t last, std::span<Decision> decisions) const override {
    guarded_call(path_, [&] { model_->decide(first, last, decisions); });
    for (std::size_t i = first; i < last; ++i) {
      check_decision(path_, decisions[i], snapshot_.persons->preferred_speed[i]);
    }
  }

  bool sets_velocity() const override { return model_->sets_velocity(); }
  VehicleForm vehicle_form() const override { return model_->vehicle_form(); }
  bool minds_vehicles() const override { return model_->minds_vehicles(); }

  void rays(std::size_t person, std::vector<Ray>& out) const override {
    guarded_call(path_, [&] { model_->rays(person, out); });
  }

 private:
  std::string path_;
  Snapshot snapshot_;
  std::unique_ptr<WalkingModel> model_;
};

const PluginEntry& entry_of(const std::string& path) {
  std::error_code ignored;
  if (!std::filesystem::exists(path, ignored)) {
    throw ModelError(path, "is missing", "the path of a plug-in");
  }
  // dlopen() searches the system's folders for a name without a slash.
  const std::string file = std::filesystem::absolute(path).string();
  void* const library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    throw ModelError(path, fmt::format("cannot be loaded: {}", dlerror()), "a shared library");
  }
  const auto* const entry = static_cast<const PluginEntry*>(dlsym(library, kEntry));
  if (entry == nullptr) {
    throw ModelError(path, "has no walking model",
                     "a library with PEDZONE_WALKING_MODEL (model/plugin.hpp)");
  }
  if (entry->interface != kModelInterface || entry->layout != kModelLayout) {
    throw ModelError(
        path,
        fmt::format("was built for another interface of walking models ({}/{})", entry->interface,
                    entry->layout),
        fmt::format("{}/{}: build it anew against this pedzone", kModelInterface, kModelLayout));
  }
  return *entry;
}

}  // namespace

std::unique_ptr<WalkingModel> load_plugin(const std::string& path) {
  const PluginEntry& entry = entry_of(path);
  try {
    return std::make_unique<PluginModel>(path, std::unique_ptr<WalkingModel>(entry.make()));
  } catch (const std::exception& thrown) {
    throw ModelError(path, fmt::format("cannot be made: {}", thrown.what()),
                     "a model whose constructor does not throw");
  } catch (...) {
    throw ModelError(path, "cannot be made", "a model whose constructor does not throw");
  }
}

}  // namespace pedzone
