#include "sumo/files/body_sizes.hpp"

#include <algorithm>
#include <cmath>

#include "core/vec.hpp"
#include "core/xml_stream.hpp"

namespace pedzone {
namespace {

constexpr NumberRange kSizes{0.01, 1000.0};  // [m] what a body may measure
constexpr NumberRange kGaps{0.0, 1000.0};    // [m] between two carriages

struct ClassSize {
  std::string_view name;  ///< vClass
  BodySize size;
};
/// What SUMO 1.15 gives to types of a vClass that leave their size open (read from
/// libsumo::VehicleType); all others are as large as a passenger car.
constexpr ClassSize kClassSizes[] = {
    {"pedestrian", {0.215, 0.478}}, {"bicycle", {1.6, 0.65}},
    {"moped", {2.1, 0.78}},         {"motorcycle", {2.2, 0.9}},
    {"truck", {7.1, 2.4}},          {"trailer", {16.5, 2.55}},
    {"bus", {12.0, 2.5}},           {"coach", {14.0, 2.6}},
    {"delivery", {6.5, 2.16}},      {"emergency", {6.5, 2.16}},
    {"tram", {22.0, 2.4}},          {"rail_urban", {109.5, 3.0}},
    {"rail", {135.0, 2.84}},        {"rail_electric", {200.0, 2.95}},
    {"rail_fast", {200.0, 2.95}},   {"ship", {17.0, 4.0}},
};
constexpr BodySize kPassenger{5.0, 1.8};
constexpr const char* kUsualClass = "passenger";

BodySize class_size(std::string_view name) {
  const auto found = std::find_if(std::begin(kClassSizes), std::end(kClassSizes),
                                  [&](const ClassSize& known) { return known.name == name; });
  return found == std::end(kClassSizes) ? kPassenger : found->size;
}

}  // namespace

double disc_radius(const BodySize& size) {
  const double disc = std::sqrt(std::max(0.0, size.width * size.length) / kPi);
  return std::clamp(std::max(0.5 * size.width, disc), 0.1, 1.0);
}

BodySizes::BodySizes() {
  types_ = {{"DEFAULT_VEHTYPE", {kPassenger, kUsualClass}},
            {"DEFAULT_TAXITYPE", {kPassenger, "taxi"}},
            {"DEFAULT_PEDTYPE", {class_size("pedestrian"), "pedestrian"}},
            {"DEFAULT_BIKETYPE", {class_size("bicycle"), "bicycle"}},
            {"DEFAULT_CONTAINERTYPE", {{6.1, 2.4}, "container"}}};
}

void BodySizes::read(const std::string& file) {
  visit_elements(file, "", [&](const XmlElement& element) { visit(element); });
}

void BodySizes::visit(const XmlElement& element) {
  if (element.depth() <= distribution_depth_) distribution_.clear();
  if (element.depth() <= visited_depth_) visited_depth_ = -1;
  const std::string_view name = element.name();
  if (name == "vTypeDistribution") {
    distribution_ = element.required("id");
    distribution_depth_ = element.depth();
    const auto members = split_words(element.value("vTypes").value_or(""));
    for (const std::string_view member : members) members_of_[distribution_].emplace_back(member);
  } else if (name == "vType") {
    const std::string id(element.required("id"));
    const std::string_view vclass = element.value("vClass").value_or(kUsualClass);
    BodySize size = class_size(vclass);
    if (element.value("length")) size.length = element.number("length", kSizes);
    if (element.value("width")) size.width = element.number("width", kSizes);
    visited_ = &(types_[id] = {size, std::string(vclass)});
    visited_->shape = element.value("guiShape").value_or("");
    visited_depth_ = element.depth();
    if (!distribution_.empty()) members_of_[distribution_].push_back(id);
  } else if (name == "param" && element.depth() == visited_depth_ + 1) {
    visit_parameter(element);
  } else if (name == "person" || name == "personFlow" || name == "personinfo") {
    const auto type = element.value("type");
    if (type) persons_[std::string(element.required("id"))] = *type;
  }
}

/// Of the type that encloses it.
void BodySizes::visit_parameter(const XmlElement& element) {
  const std::string_view key = element.value("key").value_or("");
  CarriageLengths& lengths = visited_->carriages;
  if (key == "locomotiveLength") lengths.locomotive = element.number("value", kSizes);
  if (key == "carriageLength") lengths.carriage = element.number("value", kSizes);
  if (key == "carriageGap") lengths.gap = element.number("value", kGaps);
}

const BodySizes::Type* BodySizes::find(std::string_view type) const {
  std::string name(type);
  if (const auto distribution = members_of_.find(name); distribution != members_of_.end()) {
    name = distribution->second.front();
  }
  auto found = types_.find(name);
  if (found == types_.end()) found = types_.find(name.substr(0, name.rfind('@')));
  return found == types_.end() ? nullptr : &found->second;
}

std::vector<std::string> BodySizes::members(std::string_view type) const {
  const auto found = members_of_.find(std::string(type));
  return found == members_of_.end() ? std::vector{std::string(type)} : found->second;
}

std::optional<BodySize> BodySizes::of_type(std::string_view type) const {
  const Type* const found = find(type);
  return found == nullptr ? std::nullopt : std::optional(found->size);
}

VehicleParts BodySizes::parts_of_type(std::string_view type, double length) const {
  const Type* const found = find(type);
  if (found == nullptr) return {};
  const std::string_view shape =
      found->shape.empty() ? bending_shape_of(found->vclass) : std::string_view(found->shape);
  return parts_of(shape, found->vclass, length, found->carriages);
}

std::string_view BodySizes::class_of(std::string_view type) const {
  const Type* const found = find(type);
  return found == nullptr ? kUsualClass : std::string_view(found->vclass);
}

std::string BodySizes::guessed() const {
  for (const auto& [person, type] : persons_) {
    const auto members = members_of_.find(type);
    // Of a flow's persons each is named where anything tells their types.
    const auto next = persons_.lower_bound(person + ".");
    const bool told = next != persons_.end() && next->first.starts_with(person + ".");
    if (members == members_of_.end() || told) continue;
    const auto differs = [&](const std::string& member) {
      const auto one = of_type(member), first = of_type(type);
      return one && first && (one->length != first->length || one->width != first->width);
    };
    if (std::ranges::any_of(members->second, differs)) return type;
  }
  return {};
}

BodySize BodySizes::of_person(std::string_view person) const {
  auto found = persons_.find(std::string(person));
  // SUMO numbers the persons of a flow: flow.0, flow.1 ...
  if (found == persons_.end())
    found = persons_.find(std::string(person.substr(0, person.rfind('.'))));
  const auto size = found == persons_.end() ? std::nullopt : of_type(found->second);
  return size.value_or(types_.at("DEFAULT_PEDTYPE").size);
}

}  // namespace pedzone
