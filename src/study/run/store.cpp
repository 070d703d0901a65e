#include "study/run/store.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <system_error>

#include "core/error.hpp"
#include "results/complete_file.hpp"
#include "study/run/directory_lock.hpp"
#include "study/run/file_sums.hpp"
#include "study/run/versions.hpp"

namespace pedzone::study {
namespace {

namespace fs = std::filesystem;

/// What study.json says.
struct Identity {
  std::string study;   ///< id
  std::string folder;  ///< where the study file's relative paths begin
  std::map<std::string, std::string> versions;
};

InputError refusal(const std::string& folder, const std::string& problem,
                   const std::string& allowed) {
  return {problem, {.element = "results", .value = folder, .allowed = allowed}};
}

std::string identity_text(const Identity& identity) {
  nlohmann::ordered_json json;
  json["format"] = kStudyFormat;
  json["study"] = identity.study;
  json["folder"] = identity.folder;
  json["versions"] = identity.versions;
  return json.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
}

/// Unset where the folder has none. Throws InputError where it has, but of another format.
std::optional<Identity> read_identity(const std::string& folder) {
  const std::string file = folder + "/study.json";
  std::ifstream in(file);
  if (!in) return std::nullopt;
  try {
    const auto json = nlohmann::json::parse(in);
    const int format = json.at("format");
    if (format != kStudyFormat) {
      throw InputError("is of another version of pedzone",
                       {file, 0, "format", std::to_string(format), std::to_string(kStudyFormat)});
    }
    return Identity{json.at("study"), json.at("folder"),
                    json.at("versions").get<std::map<std::string, std::string>>()};
  } catch (const nlohmann::json::exception& error) {
    throw InputError(std::string("cannot be understood (") + error.what() + ")",
                     {.file = file, .allowed = "as pedzone study run wrote it"});
  }
}

constexpr const char* kOtherFolder = "a folder that is new, empty, or this study's";

/// Throws InputError unless the folder is missing, empty, or this study's.
void check_folder(const std::string& folder, const Identity& wanted) {
  if (!fs::exists(folder)) return;
  if (!fs::is_directory(folder)) throw refusal(folder, "is a file", kOtherFolder);
  const std::optional<Identity> found = read_identity(folder);
  if (!found) {
    for (const auto& entry : fs::directory_iterator(folder)) {
      // What is left of a driver that was killed before it could say which study this is.
      const std::string name = entry.path().filename().string();
      if (name == "lock" || name == "study.json.partial") continue;
      throw refusal(folder, "holds something else (" + name + ")", kOtherFolder);
    }
    return;
  }
  if (found->study != wanted.study || found->folder != wanted.folder) {
    throw refusal(folder,
                  fmt::format("holds the results of another study: '{}' in {}, not '{}' in {}",
                              found->study, found->folder, wanted.study, wanted.folder),
                  kOtherFolder);
  }
  if (const auto change = version_change(found->versions, wanted.versions)) {
    throw refusal(folder,
                  fmt::format("holds results of another version ({}: {}, now {})", change->program,
                              change->then, change->now),
                  "the same programs, or another folder");
  }
}

void make_folders(const std::string& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw refusal(folder, "cannot be made (" + error.message() + ")", kOtherFolder);
}

std::string text_of(const std::string& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

/// Whether a run is done in one folder from the same inputs as in another.
bool is_done_alike(const std::string& folder, const std::string& other) {
  try {
    const RunRecord record = read_record(folder + "/record.json");
    return record.status == RunStatus::kDone &&
           record.inputs == read_record(other + "/record.json").inputs;
  } catch (const InputError&) {
    return false;
  }
}

/// Unset where there is none, or one that was cut off where the machine lost its power.
std::optional<RunRecord> record_in(const std::string& folder) {
  const std::string file = folder + "/record.json";
  if (!fs::exists(file)) return std::nullopt;
  try {
    return read_record(file);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

void check(const std::error_code& error, const std::string& what) {
  if (error) throw std::system_error(error, what);
}

}  // namespace

Store Store::create(const std::string& folder, const Study& study,
                    const std::map<std::string, std::string>& versions) {
  const Identity identity{study.id, fs::absolute(study.folder).lexically_normal().string(),
                          versions};
  check_folder(folder, identity);
  make_folders(folder);
  Store store(fs::canonical(folder).string(), identity.study, identity.folder, versions);
  store.lock_ = std::make_shared<const DirectoryLock>(store.folder_, "pedzone study run");
  check_folder(folder, identity);  // another driver may have been faster
  make_folders(store.folder_ + "/runs");
  write_complete_file(store.folder_ + "/study.json", identity_text(identity), kOutOption);
  write_complete_file(store.folder_ + "/study.xml", text_of(study.file), kOutOption);
  return store;
}

Store Store::open(const std::string& folder) {
  const std::optional<Identity> identity = read_identity(folder);
  if (!identity) {
    throw refusal(folder, "holds no study", "a folder made by pedzone study run --out");
  }
  return {fs::canonical(folder).string(), identity->study, identity->folder, identity->versions};
}

Plan Store::plan() const {
  return make_plan(read_study(folder_ + "/study.xml", study_folder_, study_));
}

StoredRuns Store::stored_runs(const Plan& plan) const {
  StoredRuns stored{Records(plan.runs.size()), {}};
  FileSums sums;
  for (std::size_t i = 0; i < plan.runs.size(); ++i) {
    auto record = record_in(run_folder(plan.runs[i].id));
    if (!record) continue;
    if (const auto changed = sums.changed(record->inputs)) {
      ++stored.outdated.count;
      stored.outdated.file = *changed;
    } else {
      stored.records[i] = std::move(*record);
    }
  }
  return stored;
}

std::string Store::run_folder(const std::string& run) const { return folder_ + "/runs/" + run; }

std::string Store::make_folder(const std::string& run) const {
  for (int number = 1;; ++number) {
    const std::string folder =
        fmt::format("{}/runs/.{}.{}.{}.{}", folder_, run, host_name(), getpid(), number);
    std::error_code error;
    if (fs::create_directory(folder, error)) return folder;
    check(error, "cannot make " + folder);
  }
}

void Store::finish(const std::string& folder, const std::string& run) const {
  std::error_code error;
  for (;;) {
    fs::rename(folder, run_folder(run), error);
    if (!error) return;
    if (error != std::errc::directory_not_empty && error != std::errc::file_exists) {
      check(error, "cannot finish " + run_folder(run));
    }
    if (is_done_alike(run_folder(run), folder)) break;
    discard(run);
  }
  fs::remove_all(folder);
}

void Store::discard(const std::string& run) const {
  // First out of its place at once, so that nobody ever sees a part of it there.
  const std::string rubbish = make_folder(run);
  std::error_code error;
  fs::rename(run_folder(run), rubbish, error);
  if (error && error != std::errc::no_such_file_or_directory) {
    check(error, "cannot remove " + run_folder(run));
  }
  fs::remove_all(rubbish);
}

void Store::clear_rubbish() const {
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder_ + "/runs", error)) {
    if (!entry.path().filename().string().starts_with('.')) continue;
    if (is_locked(entry.path().string() + "/log.txt")) continue;
    fs::remove_all(entry.path(), error);  // what still dies in it is removed the next time
  }
}

}  // namespace pedzone::study
