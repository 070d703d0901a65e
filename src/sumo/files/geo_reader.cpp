#include "sumo/files/geo_reader.hpp"

#include "core/error.hpp"
#include "core/xml_stream.hpp"

namespace pedzone {
namespace {

Vec2 read_offset(const XmlElement& location) {
  const std::string text(location.required("netOffset"));
  const std::vector<std::string> words = split_words(text, ',');
  Vec2 offset;
  if (words.size() != 2 || !parse_number(words[0], offset.x()) ||
      !parse_number(words[1], offset.y())) {
    throw location.error("is no offset", "netOffset", text, "x,y in m");
  }
  return offset;
}

}  // namespace

GeoReference read_geo_reference(const std::string& net_file) {
  GeoReference geo;
  geo.file = net_file;
  visit_elements(net_file, "net", [&](const XmlElement& element) {
    if (element.depth() != 1 || element.name() != "location") return;
    geo.projection = element.value("projParameter").value_or("");
    geo.offset = read_offset(element);
  });
  return geo;
}

std::optional<Vec2> GeoPlaces::at(const Vec2& lon_lat) {
  if (!is_read_) {
    is_read_ = true;
    try {
      frame_.emplace(read_geo_reference(net_file_));
    } catch (const InputError&) {
      // No projection: SUMO runs such a scenario, too.
    }
  }
  return frame_ ? frame_->place(lon_lat) : std::nullopt;
}

}  // namespace pedzone
