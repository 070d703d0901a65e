#include "zone/zone_file.hpp"

#include <algorithm>
#include <set>

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
  const auto& known = kModelNames;
  if (std::find(std::begin(known), std::end(known), name) == std::end(known)) {
    std::string allowed;
    for (const auto model : known) allowed += (allowed.empty() ? "" : ", ") + std::string(model);
    throw file.error("is no walking model", node, "model", name, allowed);
  }
  return name;
}

std::string parameter_keys() {
  std::string keys;
  for (const ParameterInfo& info : parameter_list()) {
    keys += (keys.empty() ? "" : ", ") + std::string(info.key);
  }
  return keys;
}

void read_parameter(const XmlFile& file, const pugi::xml_node& node, Parameters& parameters) {
  file.check_names(node, {"key", "value"}, {});
  const std::string key = file.required(node, "key");
  const ParameterInfo* info = find_parameter(key);
  if (!info) throw file.error("is no parameter", node, "key", key, parameter_keys());
  parameters.*info->member = file.number(node, "value", {info->least, info->most});
}

ZoneSpec read_zone(const XmlFile& file, const pugi::xml_node& node) {
  file.check_names(node, {"id", "edges", "edgeTypes", "lanes", "polygons", "openSpace", "model"},
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

std::vector<ZoneSpec> read_zone_file(const std::string& path) {
  const XmlFile file(path, {"zones"});
  file.check_names(file.root(), {}, {"zone"});
  std::vector<ZoneSpec> zones;
  for (const pugi::xml_node& node : file.root().children("zone")) {
    zones.push_back(read_zone(file, node));
    const bool known = std::any_of(zones.begin(), zones.end() - 1, [&](const ZoneSpec& other) {
      return other.id == zones.back().id;
    });
    if (known) throw file.error("is used twice", node, "id", zones.back().id, "a new id");
  }
  if (zones.empty()) throw file.error("has no <zone>", file.root(), "", "", "one <zone> or more");
  return zones;
}

}  // namespace pedzone
