// One person's recorded and walked way drawn with the vehicle, on a clock of seconds.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "pages/palette.hpp"
#include "validation/page_parts.hpp"
#include "view/axis.hpp"
#include "view/label_places.hpp"

namespace pedzone::page {
namespace {

constexpr double kWidth = 480.0, kMostHeight = 420.0, kLeastHeight = 200.0;  // of a picture
constexpr double kFoot = 30.0;       // below it, for the scale bar
constexpr double kAround = 1.5;      // [m] shown around the ways
constexpr double kMostScale = 60.0;  // pixels per metre: short ways are not blown up
constexpr double kStill = 0.2;       // [m] a vehicle that moved less is not drawn again
constexpr int kSecond = 10;          // frames

/// From metres to the picture: the person's line from start to goal points right.
class View {
 public:
  explicit View(const DrawnCase& drawn) {
    if (drawn.recorded.empty()) return;
    const Vec2 line = drawn.recorded.back() - drawn.recorded.front();
    if (line.norm() > 0.0) along_ = line.normalized();
    Box box;
    for (const Polyline* way : {&drawn.recorded, &drawn.walked}) {
      for (const Vec2& place : *way) box.extend(turned(place));
    }
    for (const Polyline* way : {&drawn.recorded, &drawn.walked})
      extend_by_meeting(drawn, *way, box);
    fit(Box(box.min() - Vec2::Constant(kAround), box.max() + Vec2::Constant(kAround)));
  }

  Vec2 operator()(const Vec2& place) const {
    const Vec2 p = turned(place) - corner_;
    return {p.x() * scale_, height_ - p.y() * scale_};
  }
  double scale() const { return scale_; }    ///< pixels per metre
  double height() const { return height_; }  ///< of the picture without its foot

 private:
  Vec2 turned(const Vec2& p) const { return {p.dot(along_), p.dot(left_of(along_))}; }

  /// Shows the vehicle whole where it is nearest to somebody on this way.
  void extend_by_meeting(const DrawnCase& drawn, const Polyline& way, Box& box) const;

  void fit(const Box& box) {
    const Vec2 size = box.sizes();
    scale_ = std::min({kWidth / size.x(), kMostHeight / size.y(), kMostScale});
    height_ = std::max(size.y() * scale_, kLeastHeight);
    corner_ = box.center() - 0.5 / scale_ * Vec2(kWidth, height_);
  }

  Vec2 along_ = Vec2::UnitX(), corner_ = Vec2::Zero();
  double scale_ = 1.0, height_ = kLeastHeight;
};

std::array<Vec2, 4> corners_of(const VehicleState& vehicle) {
  const Vec2 front = 0.5 * vehicle.length * unit(vehicle.heading);
  const Vec2 left = 0.5 * vehicle.width * left_of(unit(vehicle.heading));
  const Vec2& c = vehicle.centre;
  return {c + front + left, c - front + left, c - front - left, c + front - left};
}

void View::extend_by_meeting(const DrawnCase& drawn, const Polyline& way, Box& box) const {
  const VehicleState* nearest = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const auto& [frame, state] : drawn.vehicle) {
    const int at = frame - drawn.first;
    if (at < 0 || at >= static_cast<int>(way.size())) continue;
    const double clearance = signed_clearance(state, way[static_cast<std::size_t>(at)]);
    if (clearance < least) nearest = &state;
    least = std::min(least, clearance);
  }
  if (nearest == nullptr) return;
  for (const Vec2& corner : corners_of(*nearest)) box.extend(turned(corner));
}

/// Of the clock: its colour at `part` [0, 1] of its run.
std::string clock_colour(double part) {
  using namespace colours;
  const double at = 2.0 * std::clamp(part, 0.0, 1.0);
  return at < 1.0 ? mixed_colour(kBlue.light, kPink.light, at)
                  : mixed_colour(kPink.light, kOrange.light, at - 1.0);
}

/// A length or place in the picture.
std::string pixels(double value) { return fmt::format("{:.1f}", value); }

Json point(const Vec2& at) { return {{"x", pixels(at.x())}, {"y", pixels(at.y())}}; }

/// Where a text belongs.
struct Mark {
  Vec2 at;
  double distance;        ///< from there, to any side; 0: right there
  std::string_view kind;  ///< "driven" of the vehicle
};

/// Puts texts where nothing else is; those that fit nowhere are left out.
class Labels {
 public:
  explicit Labels(double height) : places_(Box(Vec2(0, 0), Vec2(kWidth, height))) {}

  void keep_free(const Vec2& at, double radius) { places_.keep_free(grown(Box(at, at), radius)); }

  void put(const Mark& mark, const std::string& text) {
    constexpr double kLetter = 6.8, kLine = 11.0, kApart = 3.0;  // pixels of letters
    const Vec2 size(kLetter * static_cast<double>(text.size()) + kApart, kLine);
    const auto centre = places_.take(mark.at, mark.distance, size);
    if (!centre) return;
    Json label = point(*centre);
    label["kind"] = mark.kind;
    label["text"] = text;
    all_.push_back(std::move(label));
  }
  const Json& all() const { return all_; }

 private:
  LabelPlaces places_;
  Json all_ = Json::array();
};

/// What the parts of one picture share.
struct Picture {
  const DrawnCase& drawn;
  View view;
  Labels labels;

  explicit Picture(const DrawnCase& d) : drawn(d), view(d), labels(view.height()) {
    for (const Polyline* way : {&d.recorded, &d.walked}) {
      for (std::size_t i = 0; i < way->size(); i += kSecond) labels.keep_free(view((*way)[i]), 4.0);
    }
  }

  std::string colour(int frames) const {
    const double all = std::max(1.0, static_cast<double>(drawn.recorded.size()) - 1.0);
    return clock_colour(frames / all);
  }
};

std::string path_of(const View& view, std::span<const Vec2> points) {
  std::string path;
  for (const Vec2& place : points) {
    const Vec2 at = view(place);
    path += fmt::format("{}{:.1f} {:.1f}", path.empty() ? 'M' : 'L', at.x(), at.y());
  }
  return path;
}

/// The vehicle where it was, a second apart.
std::vector<std::pair<int, const VehicleState*>> vehicle_moments(const DrawnCase& drawn) {
  std::vector<std::pair<int, const VehicleState*>> moments;
  for (const auto& [frame, state] : drawn.vehicle) {
    const int since = frame - drawn.first;
    if (since % kSecond != 0) continue;
    if (!moments.empty() && (state.centre - moments.back().second->centre).norm() < kStill)
      continue;
    moments.emplace_back(since, &state);
  }
  return moments;
}

/// Its outlines, each with an arrow to its front.
Json outlines(const Picture& picture) {
  Json all = Json::array();
  for (const auto& [since, state] : vehicle_moments(picture.drawn)) {
    const auto corners = corners_of(*state);
    const Vec2 back = 0.5 * state->width * unit(state->heading);
    const std::array<Vec2, 3> arrow{corners[0] - back, 0.5 * (corners[0] + corners[3]),
                                    corners[3] - back};
    all.push_back({{"colour", picture.colour(since)},
                   {"path", path_of(picture.view, corners) + "Z" + path_of(picture.view, arrow)}});
  }
  return all;
}

Json dots(const Picture& picture) {
  Json all = Json::array();
  const auto add = [&](const Polyline& way, bool walked) {
    for (std::size_t i = 0; i < way.size(); i += kSecond) {
      Json dot = point(picture.view(way[i]));
      dot["way"] = walked ? "walked" : "recorded";
      dot["edge"] = walked;
      dot["colour"] = picture.colour(static_cast<int>(i));
      all.push_back(std::move(dot));
    }
  };
  add(picture.drawn.recorded, false);
  add(picture.drawn.walked, true);
  return all;
}

/// But the first, which is the start.
void number_dots(Picture& picture, const Polyline& way) {
  for (std::size_t i = kSecond; i < way.size(); i += kSecond) {
    picture.labels.put({picture.view(way[i]), 5.0, ""}, fmt::format("{}", i / kSecond));
  }
}

void put_labels(Picture& picture, const Vec2& start, const Vec2& goal) {
  picture.labels.put({start, 9.0, ""}, "start");
  picture.labels.put({goal, 9.0, ""}, "goal");
  number_dots(picture, picture.drawn.recorded);
  number_dots(picture, picture.drawn.walked);
  for (const auto& [since, state] : vehicle_moments(picture.drawn)) {
    picture.labels.put({picture.view(state->centre), 0.0, "driven"},
                       fmt::format("{}", since / kSecond));
  }
}

Json picture_of(const DrawnCase& drawn) {
  Picture picture(drawn);
  const Vec2 start = picture.view(drawn.recorded.front());
  const Vec2 goal = picture.view(drawn.recorded.back());
  put_labels(picture, start, goal);
  const double metres = round_step(80.0 / picture.view.scale(), 1.0);
  const double height = picture.view.height();
  return {{"width", fmt::format("{:.0f}", kWidth)},
          {"height", fmt::format("{:.0f}", height + kFoot)},
          {"outlines", outlines(picture)},
          {"start", point(start)},
          {"goal", point(goal)},
          {"recorded", path_of(picture.view, drawn.recorded)},
          {"walked", path_of(picture.view, drawn.walked)},
          {"dots", dots(picture)},
          {"marks", picture.labels.all()},
          {"foot", pixels(height)},
          {"bar", pixels(height + 0.5 * kFoot)},
          {"bar_length", pixels(metres * picture.view.scale())},
          {"bar_metres", fmt::format("{:g}", metres)}};
}

}  // namespace

Json clock_stops() {
  Json stops = Json::array();
  for (const double part : {0.0, 0.5, 1.0}) {
    stops.push_back({{"offset", part}, {"colour", clock_colour(part)}});
  }
  return stops;
}

Json drawn_case(const DrawnCase& drawn) {
  const Measures &was = drawn.was, &became = drawn.became;
  const auto row = [](std::string_view title, double before, double after) {
    return Json{{"title", title}, {"was", number(before, 2)}, {"became", number(after, 2)}};
  };
  return {{"person", drawn.person},
          {"clip", drawn.clip},
          {"group", drawn.group},
          {"model", drawn.model},
          {"picture", drawn.recorded.empty() ? Json(false) : picture_of(drawn)},
          {"measures",
           {row("smallest clearance [m]", was.clearance, became.clearance),
            row("lateral deviation [m]", was.deviation, became.deviation),
            row("least speed [m/s]", was.least_speed, became.least_speed),
            row("mean distance to the recording [m]", std::nan(""), became.ade)}}};
}

}  // namespace pedzone::page
