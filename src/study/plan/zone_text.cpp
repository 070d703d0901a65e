// The zone file of a condition.
#include <functional>
#include <pugixml.hpp>

#include "core/xml.hpp"
#include "study/plan/plan.hpp"
#include "study/plan/setting.hpp"
#include "zone/zone_file.hpp"

namespace pedzone::study {
namespace {

void set_attribute(pugi::xml_node node, const Setting& setting) {
  pugi::xml_attribute attribute = node.attribute(setting.key.c_str());
  if (!attribute) attribute = node.append_attribute(setting.key.c_str());
  attribute.set_value(setting.value.c_str());
}

void set_parameter(pugi::xml_node zone, const Setting& setting) {
  pugi::xml_node param = zone.find_child_by_attribute("param", "key", setting.key.c_str());
  if (!param) {
    param = zone.append_child("param");
    param.append_attribute("key") = setting.key.c_str();
    param.append_attribute("value");
  }
  param.attribute("value").set_value(setting.value.c_str());
}

/// The zones; the one that is found by itself where the file has none.
std::vector<pugi::xml_node> zones_of(pugi::xml_node root) {
  std::vector<pugi::xml_node> zones;
  for (const pugi::xml_node& zone : root.children("zone")) zones.push_back(zone);
  if (!zones.empty()) return zones;
  pugi::xml_node before;  // the schema's order: profiles, paths, zones, ...
  for (const char* name : {"profile", "path"}) {
    for (const pugi::xml_node& node : root.children(name)) before = node;
  }
  pugi::xml_node zone =
      before ? root.insert_child_after("zone", before) : root.prepend_child("zone");
  zone.append_attribute("id") = ZoneSpec().id.c_str();
  return {zone};
}

void add_panel_element(pugi::xml_node root, const std::vector<const Setting*>& settings) {
  pugi::xml_node before = root.child("vehiclePath");
  pugi::xml_node panel =
      before ? root.insert_child_before("pedestrians", before) : root.append_child("pedestrians");
  for (const Setting* setting : settings) set_attribute(panel, *setting);
}

void apply(pugi::xml_node root, const std::vector<Setting>& settings) {
  std::vector<const Setting*> panel;
  for (const Setting& setting : settings) {
    if (setting.kind == SettingKind::kPanel) panel.push_back(&setting);
    if (setting.kind == SettingKind::kZone) {
      for (const pugi::xml_node& zone : zones_of(root)) set_attribute(zone, setting);
    }
    if (setting.kind == SettingKind::kParameter) {
      for (const pugi::xml_node& zone : zones_of(root)) set_parameter(zone, setting);
    }
  }
  if (!panel.empty()) add_panel_element(root, panel);
}

std::string text_of(const Study& study, const StudyScenario& scenario,
                    const std::vector<Setting>& settings,
                    const std::function<void(pugi::xml_node)>& change) {
  pugi::xml_document document;
  pugi::xml_node root;
  if (scenario.zone_file.empty()) {
    root = document.append_child("zones");
  } else {
    const XmlFile file(study.resolve(scenario.zone_file), {"zones"});
    root = document.append_copy(file.root());
    root.remove_attribute("xsi:noNamespaceSchemaLocation");  // is relative to the old place
    for (const pugi::xml_node& node : root.children("vehiclePath")) {
      node.attribute("file").set_value(file.beside(node.attribute("file").value()).c_str());
    }
    for (pugi::xml_node node : root.children("zone")) {
      node.remove_attribute("model");  // is the run's
    }
  }
  apply(root, settings);
  change(root);
  if (!root.first_child()) return "";
  return xml_text(document);
}

}  // namespace

std::string zone_text(const Plan& plan, std::size_t condition) {
  const Condition& of = plan.conditions[condition];
  return text_of(plan.study, plan.study.scenarios[of.scenario], settings_of(plan.study, of),
                 [](const pugi::xml_node&) {});
}

std::string zone_text(const Plan& plan, const PlannedRun& run) {
  const Condition& condition = plan.conditions[run.condition];
  const std::vector<Setting> settings = known_settings(plan, run);
  return text_of(plan.study, plan.study.scenarios[condition.scenario], settings,
                 [&](pugi::xml_node root) {
                   if (run.kind != RunKind::kFreeSpeed) return;
                   while (root.remove_child("pedestrians") || root.remove_child("vehiclePath")) {
                   }
                 });
}

}  // namespace pedzone::study
