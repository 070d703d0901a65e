#include "sumo/files/person_traits.hpp"

#include "core/xml_stream.hpp"

namespace pedzone {

void TraitReader::read(const std::string& file) {
  PersonTraits* open = nullptr;  // of the element that encloses the present one
  int depth = 0;
  visit_elements(file, "", [&](const XmlElement& element) {
    const std::string_view name = element.name();
    if (open != nullptr && element.depth() <= depth) open = nullptr;
    if (name == "vType" || name == "person" || name == "personFlow") {
      const std::string id(element.required("id"));
      depth = element.depth();
      if (name == "vType") {
        open = &types_[id];
      } else {
        Person& person = persons_[id];
        person.type = element.value("type").value_or("");
        open = &person;
      }
    } else if (name == "param" && open != nullptr && element.depth() == depth + 1) {
      const std::string value(element.value("value").value_or(""));
      const std::string_view key = element.value("key").value_or("");
      if (key == "pedzone.profile") open->profile = value;
      if (key == "pedzone.group") open->group = value;
    }
  });
}

PersonTraits TraitReader::of_person(std::string_view id) const {
  auto person = persons_.find(std::string(id));
  // SUMO numbers the persons of a flow: flow.0, flow.1 ...
  if (person == persons_.end()) person = persons_.find(std::string(id.substr(0, id.rfind('.'))));
  if (person == persons_.end()) return {};
  PersonTraits traits = person->second;
  const auto type = types_.find(person->second.type);
  if (type == types_.end()) return traits;
  if (traits.profile.empty()) traits.profile = type->second.profile;
  if (traits.group.empty()) traits.group = type->second.group;
  return traits;
}

}  // namespace pedzone
