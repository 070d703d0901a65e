#include "view/animation.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/error.hpp"
#include "core/text.hpp"
#include "pages/palette.hpp"
#include "view/animation_parts.hpp"
#include "view/level_of_service.hpp"

namespace pedzone {

extern const std::string_view kAnimationPage;  // made from view/animation by the build

namespace animation {

namespace {

/// Puts a text into the place of a mark.
void put(std::string& page, std::string_view mark, const std::string& text) {
  page.replace(page.find(mark), mark.size(), text);
}

constexpr double kFarthest = 2e7;  // [m] half the Earth's circumference; 32 bits hold it in cm

}  // namespace

std::int32_t centimetres(double metres) {
  if (!(std::abs(metres) <= kFarthest)) {
    throw InputError("is too far away to be shown",
                     {.element = "a coordinate",
                      .value = fmt::format("{}", metres),
                      .allowed = fmt::format("-{0:g} to {0:g} m", kFarthest)});
  }
  return static_cast<std::int32_t>(std::lround(100.0 * metres));
}

Box where_anybody_is(const std::vector<AnimatedRun>& runs) {
  Box box;
  for (const AnimatedRun& run : runs) {
    for (const RecordedPerson& person : run.recording->persons) {
      for (const PersonMoment& moment : person.moments) box.extend(moment.position);
    }
    for (const RecordedVehicle& vehicle : run.recording->vehicles) {
      for (const VehicleMoment& moment : vehicle.moments) box.extend(moment.centre);
    }
  }
  return box;
}

Box extent(const std::vector<AnimatedRun>& runs, const Place* place) {
  Box box;
  if (place != nullptr) {
    for (const Zone& zone : place->zones) box.extend(box_of(zone.walkable));
  }
  const Box anybody = where_anybody_is(runs);
  if (!box.intersects(anybody)) box.extend(anybody);
  constexpr double kMargin = 3.0;  // [m] so that nobody is at the picture's edge
  return grown(box, kMargin);
}

}  // namespace animation

namespace {

/// What the density is coloured by.
std::string levels() {
  std::string text;
  for (std::size_t i = 0; i < kServiceLevels.size(); ++i) {
    text += fmt::format(R"({}{{"least":{:.4f},"colour":"{}","text":"{}"}})", i == 0 ? "" : ",",
                        kServiceLevels[i].least, service_colour(i), service_text(i));
  }
  return '[' + text + ']';
}

}  // namespace

std::string animation_page(const std::vector<AnimatedRun>& runs, const Place* place,
                           const AnimationOptions& options) {
  const Box box = options.area.isEmpty() ? animation::extent(runs, place) : options.area;
  Box ground = box;
  if (options.area.isEmpty()) ground.extend(animation::where_anybody_is(runs));
  std::string data = fmt::format(
      R"({{"title":{},"selected":{},"box":[{:.2f},{:.2f},{:.2f},{:.2f}],"step":{:.6g},)"
      R"("levels":{},"scenery":{},"runs":[)",
      json_string(options.title), json_string(options.selected), box.min().x(), box.min().y(),
      box.max().x(), box.max().y(), animation::least_step(runs, options.rate), levels(),
      animation::scenery(place, ground));
  for (const AnimatedRun& run : runs) {
    if (&run != &runs.front()) data += ',';
    data += animation::run(run, options.rate);
  }
  data += "]}";
  std::string page(kAnimationPage);
  animation::put(page, "@palette@",
                 ":root{" + palette_variables(false) + "}:root[data-theme=\"dark\"]{" +
                     palette_variables(true) + "}");
  animation::put(page, "@data@", data);
  return page;
}

}  // namespace pedzone
