// One person's recorded and walked way drawn with the vehicle, on a clock of seconds.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "validation/page_parts.hpp"
#include "view/axis.hpp"
#include "view/label_places.hpp"
#include "view/svg.hpp"

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

/// Colour of the clock at `part` [0, 1] of its run; `clock` in the style sheet has the same stops.
std::string clock_colour(double part) {
  constexpr std::array<std::array<double, 3>, 3> kStops{
      {{30, 136, 205}, {204, 121, 167}, {230, 159, 0}}};
  const double at = std::clamp(part, 0.0, 1.0) * 2.0;
  const int from = at < 1.0 ? 0 : 1;
  std::string colour = "#";
  for (std::size_t c = 0; c < 3; ++c) {
    const double value = std::lerp(kStops[from][c], kStops[from + 1][c], at - from);
    add(colour, "{:02x}", static_cast<int>(std::lround(value)));
  }
  return colour;
}

/// Where a text belongs.
struct Mark {
  Vec2 at;
  double distance;  ///< from there, to any side; 0: right there
  std::string_view look;
};

/// Puts texts where nothing else is; those that fit nowhere are left out.
class Labels {
 public:
  explicit Labels(double height) : places_(Box(Vec2(0, 0), Vec2(kWidth, height))) {}

  void keep_free(const Vec2& at, double radius) { places_.keep_free(grown(Box(at, at), radius)); }

  void put(std::string& svg, const Mark& mark, const std::string& text) {
    constexpr double kLetter = 6.8, kLine = 11.0, kApart = 3.0;  // pixels of letters
    const Vec2 size(kLetter * static_cast<double>(text.size()) + kApart, kLine);
    const auto centre = places_.take(mark.at, mark.distance, size);
    if (!centre) return;
    add(svg, "<text class=\"{}\" text-anchor=\"middle\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n",
        mark.look, centre->x(), centre->y() + 4.0, escaped(text));
  }

 private:
  LabelPlaces places_;
};

/// What the parts of one picture share.
struct Picture {
  const DrawnCase& drawn;
  View view;
  Labels labels;
  std::string shapes, texts;  ///< texts lie on top

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
  for (const Vec2& point : points) {
    const Vec2 at = view(point);
    add(path, "{}{:.1f} {:.1f}", path.empty() ? 'M' : 'L', at.x(), at.y());
  }
  return path;
}

void draw_way(Picture& picture, const Polyline& way, std::string_view look) {
  add(picture.shapes, "<path class=\"line {}\" d=\"{}\"/>\n", look, path_of(picture.view, way));
}

/// The outline with an arrow to its front.
void draw_outline(Picture& picture, const VehicleState& state, int since) {
  const auto corners = corners_of(state);
  const Vec2 back = 0.5 * state.width * unit(state.heading);
  const std::array<Vec2, 3> arrow{corners[0] - back, 0.5 * (corners[0] + corners[3]),
                                  corners[3] - back};
  add(picture.shapes, "<path class=\"vehicle\" stroke=\"{}\" d=\"{}Z{}\"/>\n",
      picture.colour(since), path_of(picture.view, corners), path_of(picture.view, arrow));
}

/// Outlines or numbers, a second apart.
void draw_vehicle(Picture& picture, bool numbers) {
  const VehicleState* last = nullptr;
  for (const auto& [frame, state] : picture.drawn.vehicle) {
    const int since = frame - picture.drawn.first;
    if (since % kSecond != 0) continue;
    if (last != nullptr && (state.centre - last->centre).norm() < kStill) continue;
    last = &state;
    if (numbers) {
      const Mark mark{picture.view(state.centre), 0.0, "mark driven"};
      picture.labels.put(picture.texts, mark, fmt::format("{}", since / kSecond));
    } else {
      draw_outline(picture, state, since);
    }
  }
}

void draw_dots(Picture& picture, const Polyline& way, std::string_view look) {
  for (std::size_t i = 0; i < way.size(); i += kSecond) {
    const Vec2 at = picture.view(way[i]);
    add(picture.shapes,
        "<circle class=\"place {}\" fill=\"{}\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"4.5\"/>\n", look,
        picture.colour(static_cast<int>(i)), at.x(), at.y());
  }
}

/// But the first, which is the start.
void number_dots(Picture& picture, const Polyline& way) {
  for (std::size_t i = kSecond; i < way.size(); i += kSecond) {
    const Mark mark{picture.view(way[i]), 5.0, "mark"};
    picture.labels.put(picture.texts, mark, fmt::format("{}", i / kSecond));
  }
}

void draw_ends(Picture& picture) {
  const Vec2 start = picture.view(picture.drawn.recorded.front());
  const Vec2 goal = picture.view(picture.drawn.recorded.back());
  add(picture.shapes, "<circle class=\"ends\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"7\"/>\n", start.x(),
      start.y());
  add(picture.shapes,
      "<rect class=\"ends\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"13\" height=\"13\"/>\n",
      goal.x() - 6.5, goal.y() - 6.5);
  picture.labels.put(picture.texts, {start, 9.0, "mark"}, "start");
  picture.labels.put(picture.texts, {goal, 9.0, "mark"}, "goal");
}

void draw_scale(Picture& picture) {
  const double metres = round_step(80.0 / picture.view.scale(), 1.0);
  const double y = picture.view.height() + 0.5 * kFoot, width = metres * picture.view.scale();
  add(picture.shapes, "<rect class=\"foot\" y=\"{:.1f}\" width=\"{}\" height=\"{}\"/>\n",
      picture.view.height(), kWidth, kFoot + 1.0);
  add(picture.shapes, "<path class=\"scale\" d=\"M10 {0}v8M10 {1}H{2:.1f}M{2:.1f} {0}v8\"/>\n",
      y - 4.0, y, 10.0 + width);
  add(picture.texts, "<text class=\"tick\" x=\"{:.1f}\" y=\"{}\">{:g} m</text>\n", 16.0 + width,
      y + 4.0, metres);
}

std::string caption(const DrawnCase& drawn) {
  const Measures &was = drawn.was, &became = drawn.became;
  std::string out = "<figcaption>";
  add(out, "<b>Person {} in clip {}</b><br/><span class=\"sub\">{}; model: {}</span>",
      escaped(drawn.person), escaped(drawn.clip), escaped(drawn.group), escaped(drawn.model));
  out += "<table><thead><tr><th></th><th>recorded</th><th>walked</th></tr></thead><tbody>\n";
  const auto row = [&](std::string_view title, double before, double after) {
    add(out, "<tr><th>{}</th><td>{}</td><td>{}</td></tr>\n", title, number(before, 2),
        number(after, 2));
  };
  row("smallest clearance [m]", was.clearance, became.clearance);
  row("lateral deviation [m]", was.deviation, became.deviation);
  row("least speed [m/s]", was.least_speed, became.least_speed);
  row("mean distance to the recording [m]", std::nan(""), became.ade);
  return out + "</tbody></table></figcaption>";
}

}  // namespace

std::string clock_legend() {
  return "<span class=\"key\">first second <span class=\"clock\"></span> last</span>";
}

std::string drawn_case(const DrawnCase& drawn) {
  std::string out = "<figure class=\"case\">";
  if (!drawn.recorded.empty()) {
    Picture picture(drawn);
    draw_vehicle(picture, false);
    draw_ends(picture);
    draw_way(picture, drawn.recorded, "recorded");
    draw_way(picture, drawn.walked, "main walked");
    draw_dots(picture, drawn.recorded, "");
    draw_dots(picture, drawn.walked, "walked");
    number_dots(picture, drawn.recorded);
    number_dots(picture, drawn.walked);
    draw_vehicle(picture, true);
    draw_scale(picture);
    add(out, "<svg viewBox=\"0 0 {} {:.0f}\" role=\"img\" aria-label=\"{}\">\n{}{}</svg>\n", kWidth,
        picture.view.height() + kFoot,
        escaped(fmt::format("ways of person {} in clip {}", drawn.person, drawn.clip)),
        picture.shapes, picture.texts);
  }
  return out + caption(drawn) + "</figure>\n";
}

}  // namespace pedzone::page
