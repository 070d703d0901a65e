#include "study/plan/study_file.hpp"

#include <algorithm>
#include <bit>
#include <filesystem>
#include <set>

#include "core/text.hpp"
#include "core/xml.hpp"
#include "study/plan/factors.hpp"
#include "study/plan/seed_list.hpp"
#include "study/plan/sumo_options.hpp"
#include "sumo/files/scenario.hpp"
#include "world/model_names.hpp"
#include "zone/zone_file.hpp"

namespace pedzone::study {
namespace {

namespace fs = std::filesystem;

constexpr NumberRange kEnds{0.001, 1e9};      // [s] simulated
constexpr NumberRange kTimeLimits{1.0, 1e7};  // [s] wall clock
constexpr const char* kDefaultSeeds = "1-10";
constexpr const char* kDefaultModels = "striping heuristic";

/// A file's name without folder and endings: "old-town" of "a/old-town.study.xml".
std::string stem_of(const std::string& path) {
  const std::string name = fs::path(path).filename().string();
  return name.substr(0, name.find('.', 1));
}

/// Whether the bytes are UTF-8 (RFC 3629) by their leading ones: no byte of a character missing,
/// none too many.
bool is_utf8(std::string_view text) {
  int more = 0;  // bytes of the character that are still to come
  for (const char c : text) {
    const int ones = std::countl_one(static_cast<unsigned char>(c));
    if ((ones == 1) != (more > 0) || ones > 4) return false;
    more = ones == 1 ? more - 1 : std::max(0, ones - 1);
  }
  return more == 0;
}

/// Reads one study file.
class Reader {
 public:
  Reader(const std::string& file, const std::string& folder, const std::string& id)
      : file_(file, {"study"}) {
    study_.file = file;
    study_.id = id.empty() ? stem_of(file) : id;
    const fs::path place = folder.empty() ? fs::absolute(file).parent_path() : fs::absolute(folder);
    study_.folder = place.lexically_normal().string();
  }

  Study read() {
    const pugi::xml_node root = file_.root();
    check_encoding();
    file_.check_names(
        root, {"id", "title", "question", "seeds", "models", "reference", "end", "timeLimit"},
        {"scenario", "factor", "combination"});
    study_.id = word(root, "id", study_.id);
    study_.title = root.attribute("title").value();
    study_.question = root.attribute("question").value();
    read_seeds(root);
    read_models(root);
    if (root.attribute("end")) study_.end = file_.number(root, "end", kEnds);
    study_.time_limit = file_.number(root, "timeLimit", kTimeLimits, study_.time_limit);
    for (const pugi::xml_node& node : root.children("scenario")) read_scenario_of(node);
    if (study_.scenarios.empty()) {
      throw file_.error("has no <scenario>", root, "", "", "one <scenario file=\"...\"/> or more");
    }
    read_factors(file_, study_);
    limit_runs();
    return study_;
  }

 private:
  std::string word(const pugi::xml_node& node, const char* attribute,
                   const std::string& otherwise) const {
    return node.attribute(attribute) ? file_.required(node, attribute) : otherwise;
  }

  /// Everything ends up in JSON and HTML, which know no other encoding.
  void check_encoding() const {
    struct Visitor : pugi::xml_tree_walker {
      const XmlFile& file;
      explicit Visitor(const XmlFile& of) : file(of) {}
      bool for_each(pugi::xml_node& node) override {
        for (const pugi::xml_attribute& attribute : node.attributes()) {
          if (!is_utf8(attribute.value())) {
            throw file.error("is no text", node, attribute.name(), "", "UTF-8");
          }
        }
        return true;
      }
    } visitor(file_);
    pugi::xml_node root = file_.root();
    visitor.for_each(root);
    root.traverse(visitor);
  }

  void read_seeds(const pugi::xml_node& root) {
    try {
      study_.seeds =
          parse_seeds(root.attribute("seeds") ? root.attribute("seeds").value() : kDefaultSeeds);
    } catch (const SeedListError& error) {
      throw file_.error(error.problem, root, "seeds", error.value, error.allowed);
    }
  }

  void read_models(const pugi::xml_node& root) {
    study_.models = split_words(word(root, "models", kDefaultModels));
    if (study_.models.empty()) throw file_.error("names no model", root, "models");
    std::set<std::string> known;
    for (const std::string& model : study_.models) {
      if (!is_sumo_model(model) && !may_be_model(model)) {
        throw file_.error(
            "is no walking model", root, "models", model,
            std::string(kStriping) + ", " + kNonInteracting + ", " + allowed_models());
      }
      if (names_plugin(model) && !fs::is_regular_file(study_.resolve(model))) {
        throw file_.error("does not exist", root, "models", study_.resolve(model),
                          "a shared library with a walking model");
      }
      if (!known.insert(model).second) {
        throw file_.error("is named twice", root, "models", model, "each model once");
      }
    }
    const bool striping = known.contains(kStriping);
    study_.reference = word(root, "reference", striping ? kStriping : study_.models.front());
    if (!known.contains(study_.reference)) {
      throw file_.error("is none of the study's models", root, "reference", study_.reference,
                        comma_list(study_.models));
    }
  }

  void read_scenario_of(const pugi::xml_node& node) {
    file_.check_names(node, {"id", "file", "zone", "options", "client"}, {});
    StudyScenario scenario;
    scenario.file = file_.required(node, "file");
    scenario.id = word(node, "id", stem_of(scenario.file));
    for (const StudyScenario& other : study_.scenarios) {
      if (other.id != scenario.id) continue;
      throw file_.error("is used twice", node, "id", scenario.id, "a new id");
    }
    require_file(node, "file", scenario.file);
    scenario.zone_file = word(node, "zone", "");
    if (!scenario.zone_file.empty()) {
      require_file(node, "zone", scenario.zone_file);
      read_zone_file(study_.resolve(scenario.zone_file));  // for what it refuses
    }
    try {
      const auto words = split_words(node.attribute("options").value());
      scenario.sumo_options = parse_sumo_options(words).words();
    } catch (const SumoOptionError& error) {
      throw file_.error(error.problem, node, "options", error.value, error.allowed);
    }
    scenario.client = word(node, "client", "");
    if (!scenario.client.empty()) require_own_models(node);
    require_end(node, scenario);
    study_.scenarios.push_back(std::move(scenario));
  }

  void require_file(const pugi::xml_node& node, const char* attribute,
                    const std::string& path) const {
    if (fs::is_regular_file(study_.resolve(path))) return;
    throw file_.error("does not exist", node, attribute, study_.resolve(path),
                      "a file, relative to " + study_.folder);
  }

  /// It is pedzone that starts clients.
  void require_own_models(const pugi::xml_node& node) const {
    const auto of_sumo = std::ranges::find_if(study_.models, is_sumo_model);
    if (of_sumo == study_.models.end()) return;
    throw file_.error("is started by pedzone's models only, and the study has " + *of_sumo, node,
                      "client", node.attribute("client").value(),
                      "<study models=\"heuristic\"> and the like");
  }

  /// People who jam would keep a run without one going for ever.
  void require_end(const pugi::xml_node& node, const StudyScenario& scenario) const {
    const XmlFile config(study_.resolve(scenario.file));
    if (study_.end) return;
    const pugi::xml_node end = config.root().find_node([](const pugi::xml_node& inner) {
      return inner.name() == std::string_view("end") || inner.name() == std::string_view("e");
    });
    double number = 0.0;
    const std::string value = end.attribute("value").value();
    if (end && !(parse_number(value, number) && number <= 0.0)) return;
    throw file_.error("does not end", node, "file", scenario.file,
                      "a scenario with <end value=\"...\"/>, or attribute end of <study>");
  }

  void limit_runs() const {
    const double runs = static_cast<double>(study_.combinations.size()) *
                        static_cast<double>(study_.scenarios.size()) *
                        static_cast<double>(study_.models.size()) *
                        static_cast<double>(study_.seeds.size());
    if (runs <= static_cast<double>(kMostRuns)) return;
    throw file_.error("asks for too many runs", file_.root(), "", "",
                      std::to_string(kMostRuns) + " in all: fewer seeds, models or levels");
  }

  XmlFile file_;
  Study study_;
};

}  // namespace

bool is_sumo_model(const std::string& model) {
  return model == kStriping || model == kNonInteracting;
}

std::string Study::resolve(const std::string& path) const {
  return (fs::path(folder) / path).lexically_normal().string();
}

Study read_study(const std::string& file, const std::string& folder, const std::string& id) {
  return Reader(file, folder, id).read();
}

}  // namespace pedzone::study
