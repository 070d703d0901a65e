#include "zone/zone_file.hpp"

#include <algorithm>
#include <functional>
#include <set>

#include "core/text.hpp"
#include "core/xml.hpp"
#include "world/model_names.hpp"

namespace pedzone {
namespace {

constexpr NumberRange kOpenSpace{kOpenSpaceLeast, kOpenSpaceMost};

/// A list attribute: words split at white space; each once, none where it is not given.
std::vector<std::string> read_list(const XmlFile& file, const pugi::xml_node& node,
                                   const char* attribute) {
  if (node.attribute(attribute).empty()) return {};
  auto words = split_words(file.required(node, attribute));
  if (words.empty()) throw file.error("is empty", node, attribute);
  std::set<std::string> known;
  for (const std::string& word : words) {
    if (!known.insert(word).second) {
      throw file.error("is named twice", node, attribute, word, "each at most once");
    }
  }
  return words;
}

std::string read_model(const XmlFile& file, const pugi::xml_node& node) {
  const std::string name = file.required(node, "model");
  if (!may_be_model(name)) {
    throw file.error("is no walking model", node, "model", name, allowed_models());
  }
  return names_plugin(name) ? file.beside(name) : name;
}

std::string parameter_keys() { return comma_list(parameter_list(), &ParameterInfo::key); }
std::string profile_keys() { return comma_list(profile_fields(), &ProfileField::key); }

void read_parameter(const XmlFile& file, const pugi::xml_node& node, Parameters& parameters) {
  file.check_names(node, {"key", "value"}, {});
  const std::string key = file.required(node, "key");
  const ParameterInfo* info = find_parameter(key);
  if (!info) throw file.error("is no parameter", node, "key", key, parameter_keys());
  parameters.*info->member = file.number(node, "value", {info->least, info->most});
}

/// What the base has, changed by the attributes.
Profile read_profile(const XmlFile& file, const pugi::xml_node& node, const Profiles& known) {
  const std::string id = file.required(node, "id");
  if (known.find(id) != nullptr) throw file.error("is used twice", node, "id", id, "a new id");
  const std::string base = node.attribute("base").empty() ? "adult" : file.required(node, "base");
  const Profile* like = known.find(base);
  if (like == nullptr) throw file.error("is no profile", node, "base", base, known.ids());
  Profile profile = *like;
  profile.id = id;
  profile.meaning = "like " + base;
  profile.share = 0.0;  // nobody is it unless somebody is said to be
  for (const pugi::xml_attribute& attribute : node.attributes()) {
    const std::string name = attribute.name();
    if (name == "id" || name == "base") continue;
    const auto field = std::ranges::find(profile_fields(), name, &ProfileField::key);
    if (field == profile_fields().end()) {
      throw file.error("is unknown", node, name, "", "id, base, " + profile_keys());
    }
    profile.*field->member = file.number(node, name.c_str(), {field->least, field->most});
  }
  return profile;
}

const Weather* read_weather(const XmlFile& file, const pugi::xml_node& node) {
  const std::string id = file.required(node, "weather");
  const Weather* weather = find_weather(id);
  if (weather == nullptr) {
    throw file.error("is no weather", node, "weather", id,
                     comma_list(weather_list(), &Weather::id));
  }
  return weather;
}

CrossingRule read_crossing(const XmlFile& file, const pugi::xml_node& node) {
  const std::string where = file.required(node, "crossing");
  if (where == "nodes") return CrossingRule::kNodes;
  if (where == "anywhere") return CrossingRule::kAnywhere;
  throw file.error("is unknown", node, "crossing", where, "nodes, anywhere");
}

ZoneSpec read_zone(const XmlFile& file, const pugi::xml_node& node) {
  file.check_names(node,
                   {"id", "edges", "edgeTypes", "lanes", "polygons", "openSpace", "crossing",
                    "weather", "model"},
                   {"param"});
  ZoneSpec zone;
  zone.id = file.required(node, "id");
  zone.file = file.file();
  zone.line = file.line(node);
  zone.edges = read_list(file, node, "edges");
  zone.edge_types = read_list(file, node, "edgeTypes");
  zone.lanes = read_list(file, node, "lanes");
  zone.polygons = read_list(file, node, "polygons");
  if (!node.attribute("openSpace").empty()) {
    zone.open_space = file.number(node, "openSpace", kOpenSpace);
  }
  if (!node.attribute("crossing").empty()) zone.crossing = read_crossing(file, node);
  if (!node.attribute("weather").empty()) zone.weather = read_weather(file, node);
  if (!node.attribute("model").empty()) zone.model = read_model(file, node);
  std::set<std::string> keys;
  for (const pugi::xml_node& child : node.children("param")) {
    read_parameter(file, child, zone.parameters);
    const std::string key = child.attribute("key").value();
    if (!keys.insert(key).second) {
      throw file.error("is given twice", child, "key", key, "each at most once in a zone");
    }
  }
  return zone;
}

}  // namespace

InputError zone_error(const ZoneSpec& zone, const std::string& problem,
                      const std::string& attribute, const std::string& value,
                      const std::string& allowed) {
  std::string element = "<zone id=\"" + zone.id + "\">";
  if (!attribute.empty()) element += " attribute " + attribute;
  return InputError(problem, {zone.file, zone.line, element, value, allowed});
}

ZoneFile read_zone_file(const std::string& path) {
  const XmlFile file(path, {"zones"});
  file.check_names(file.root(), {}, {"profile", "path", "zone", "pedestrians", "vehiclePath"});
  ZoneFile read;
  for (const pugi::xml_node& node : file.root().children("profile")) {
    read.profiles.add(read_profile(file, node, read.profiles));
  }
  for (const pugi::xml_node& node : file.root().children("path")) {
    PathSpec spec = read_path(file, node);
    if (std::ranges::find(read.paths, spec.id, &PathSpec::id) != read.paths.end()) {
      throw file.error("is used twice", node, "id", spec.id, "a new id");
    }
    read.paths.push_back(std::move(spec));
  }
  for (const pugi::xml_node& node : file.root().children("zone")) {
    read.zones.push_back(read_zone(file, node));
    const bool known =
        std::any_of(read.zones.begin(), read.zones.end() - 1,
                    [&](const ZoneSpec& other) { return other.id == read.zones.back().id; });
    if (known) throw file.error("is used twice", node, "id", read.zones.back().id, "a new id");
  }
  read.panels = read_panels(file, read.profiles, read.paths);
  read.vehicle_paths = read_vehicle_path_specs(file);
  if (!file.root().first_child()) {
    throw file.error("has no <zone>", file.root(), "", "", "one <zone> or more");
  }
  return read;
}

}  // namespace pedzone
