#include "view/time_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "pages/palette.hpp"
#include "view/axis.hpp"
#include "view/colours.hpp"
#include "view/label_places.hpp"
#include "view/run_map.hpp"
#include "view/zone_map.hpp"
#include "zone/simplify.hpp"

namespace pedzone {
namespace {

constexpr double kMoments = 20.0;          // shown at most, where the user does not say
constexpr std::size_t kNamedPersons = 12;  // more are not named in the map
constexpr double kHead = 5.5;              // [units] of the panel, for the colour bar
constexpr double kBarLeft = 2.0, kBarWidth = 37.0, kBarTop = 1.2, kBarHeight = 1.3;  // [units]
constexpr int kBarPieces = 100;
constexpr double kLeastDisc = 0.28;         // [units] radius: smaller ones would not be seen
constexpr double kThinning = 0.02;          // [units] corners of lines are left out so far
constexpr double kLetter = 0.62;            // width of a letter over its height
constexpr double kSlack = 1e-6;             // [s] numerical
constexpr std::size_t kMarkedVehicles = 3;  // of more, starts and goals are not marked

class TimePlot {
 public:
  TimePlot(const Recording& recording, const Place* place, const TimePlotOptions& options)
      : recording_(recording),
        place_(place),
        options_(options),
        box_(shown_box(recording, place, options.area)),
        panel_(box_.sizes(), legend(), options.narrow, kHead),
        page_(box_, options.legend ? panel_.height() : 0.0),
        gap_(line_gap(recording)),
        unit_(panel_.unit()) {
    find_span();
    find_moments();
  }

  std::string draw() {
    draw_ground(page_, place_, unit_);
    draw_vehicle_ways(page_, recording_, unit_);
    draw_waypoints(page_, place_, unit_);
    draw_outlines();
    draw_lines();
    draw_discs();
    draw_texts();
    if (options_.legend) {
      panel_.draw(page_);
      draw_colour_bar();
    }
    return page_.finish(options_.title);
  }

 private:
  /// A moment at which everybody is drawn.
  struct Moment {
    double time;         ///< [s]
    std::uint32_t step;  ///< the first not before it
  };

  std::vector<LegendEntry> legend() const {
    std::vector<LegendEntry> entries = ground_legend(place_, box_);
    const std::string colour = scale_colour(0.5);
    entries.push_back({"person, coloured by time", [colour](SvgPage& page, const Box& at) {
                         page.circle(at.center(), 0.4 * at.sizes().y(), filled(colour));
                       }});
    if (any_by_sumo(recording_, box_)) {
      entries.push_back({"the same, walked by SUMO", [colour](SvgPage& page, const Box& at) {
                           page.circle(
                               at.center(), 0.4 * at.sizes().y(),
                               fmt::format("fill=\"{}\" fill-opacity=\"{}\"", colour, kPale));
                         }});
    }
    if (recording_.vehicles.empty()) return entries;
    entries.push_back(area_entry("vehicle at the same times",
                                 "fill=\"none\" " + stroke(colour, 0.0015 * box_.sizes().x())));
    for (LegendEntry& entry : vehicle_legend(recording_)) entries.push_back(std::move(entry));
    return entries;
  }

  /// From the first to the last moment of a person in the map.
  void find_span() {
    begin_ = std::numeric_limits<double>::infinity();
    end_ = -begin_;
    for (const RecordedPerson& person : recording_.persons) {
      for (const PersonMoment& moment : person.moments) {
        if (!box_.contains(moment.position)) continue;
        begin_ = std::min(begin_, recording_.times[moment.step]);
        end_ = std::max(end_, recording_.times[moment.step]);
      }
    }
  }

  void find_moments() {
    if (options_.at) {
      const auto at = std::ranges::lower_bound(recording_.times, *options_.at - kSlack);
      const bool over = at == recording_.times.end();
      moments_.push_back({*options_.at, static_cast<std::uint32_t>(at - recording_.times.begin() -
                                                                   (over ? 1 : 0))});
      return;
    }
    const double every = options_.every.value_or(round_step(end_ - begin_, kMoments));
    const auto& times = recording_.times;
    // + 0.0: none is -0.
    for (double k = std::ceil(begin_ / every - kSlack); k * every <= end_ + kSlack; ++k) {
      const auto at = std::ranges::lower_bound(times, k * every - kSlack);
      if (at == times.end() || *at - k * every > 0.5 * every) continue;
      moments_.push_back({k * every + 0.0, static_cast<std::uint32_t>(at - times.begin())});
    }
    if (moments_.empty()) {
      const auto at = std::ranges::lower_bound(times, begin_);
      moments_.push_back({begin_, static_cast<std::uint32_t>(at - times.begin())});
    }
  }

  std::string colour(double time) const {
    return scale_colour(end_ > begin_ ? (time - begin_) / (end_ - begin_) : 0.0);
  }
  double time_of(const auto& moment) const { return recording_.times[moment.step]; }

  void draw_outlines() {
    page_.begin_group(fmt::format(
        "id=\"vehicles\" fill=\"none\" stroke-linejoin=\"round\" stroke-width=\"{:.3f}\"",
        0.2 * unit_));
    for (const Moment& moment : moments_) {
      for (const RecordedVehicle& vehicle : recording_.vehicles) {
        const VehicleMoment* at = there_at(vehicle.moments, moment.step, recording_.times, gap_);
        if (at == nullptr) continue;
        const Ring corners = outline(vehicle, *at);
        if (!box_.intersects(box_of(corners))) continue;
        const Vec2 back = 0.5 * vehicle.width * unit(at->heading);
        const Vec2 front = 0.5 * (corners[0] + corners[3]);
        const std::string attributes = fmt::format("stroke=\"{}\"", colour(moment.time));
        page_.region({{corners, {}}}, "class=\"outline\" " + attributes,
                     fmt::format("{} at {:g} s", vehicle.id, moment.time));
        if (vehicle.part > 0) continue;
        page_.line({corners[0] - back, front, corners[3] - back}, attributes);
      }
    }
    page_.end_group();
  }

  /// Everybody's way, in pieces from moment to moment.
  void draw_lines() {
    page_.begin_group(fmt::format(
        "id=\"ways\" stroke-linejoin=\"round\" stroke-linecap=\"round\" stroke-width=\"{:.3f}\"",
        0.14 * unit_));
    for (const RecordedPerson& person : recording_.persons) {
      for (const TrackPiece& piece : pieces_by_walker(person, recording_.times, gap_)) {
        draw_piece(person, piece);
      }
    }
    page_.end_group();
  }

  void draw_piece(const RecordedPerson& person, const TrackPiece& piece) {
    const std::string pale =
        person.moments[piece.first].by_sumo ? fmt::format(" stroke-opacity=\"{}\"", kPale) : "";
    Polyline line;
    double since = time_of(person.moments[piece.first]);
    auto next = std::ranges::upper_bound(moments_, since, {}, &Moment::time);
    for (std::size_t i = piece.first; i <= piece.last; ++i) {
      line.push_back(person.moments[i].position);
      const double now = time_of(person.moments[i]);
      if (options_.at && now > *options_.at + kSlack) return;
      const bool over = next != moments_.end() && now >= next->time;
      if (!over && i < piece.last) continue;
      if (box_.intersects(box_of(line))) {
        page_.line(simplified(line, kThinning * unit_),
                   fmt::format("stroke=\"{}\"{}", colour(0.5 * (since + now)), pale));
      }
      line = {person.moments[i].position};
      since = now;
      while (next != moments_.end() && next->time <= now) ++next;
    }
  }

  void draw_discs() {
    page_.begin_group(fmt::format("id=\"persons\" stroke=\"{}\" stroke-width=\"{:.3f}\"",
                                  colours::kPaper, 0.05 * unit_));
    for (const Moment& moment : moments_) {
      const std::string fill = filled(colour(moment.time));
      const std::string pale = fmt::format(" fill-opacity=\"{}\"", kPale);
      for (const RecordedPerson& person : recording_.persons) {
        const PersonMoment* at = there_at(person.moments, moment.step, recording_.times, gap_);
        if (at == nullptr || !box_.contains(at->position)) continue;
        page_.circle(at->position, std::max(person.radius, kLeastDisc * unit_),
                     at->by_sumo ? fill + pale : fill,
                     fmt::format("{} at {:g} s", person.id, moment.time));
      }
    }
    page_.end_group();
  }

  /// Names, times, and where vehicles begin and end: of a few, or they would cover the map.
  void draw_texts() {
    LabelPlaces places(box_);
    if (recording_.vehicles.size() <= kMarkedVehicles) mark_ends(places);
    if (recording_.persons.size() > kNamedPersons) return;
    for (const RecordedPerson& person : recording_.persons) {
      for (const PersonMoment& moment : person.moments) {
        places.keep_free(grown(Box(moment.position, moment.position), 0.1 * unit_));
      }
    }
    draw_names(places);
    draw_times(places);
  }

  void label(LabelPlaces& places, const Vec2& at, double distance, double size,
             const std::string& text, const std::string& attributes) {
    const Vec2 room(kLetter * size * static_cast<double>(text.size()), size);
    const auto place = places.take(at, distance, room);
    if (!place) return;
    page_.text(*place - Vec2(0.0, 0.35 * size), size, text,
               fmt::format("{} text-anchor=\"middle\" stroke=\"{}\" stroke-width=\"{:.3f}\" "
                           "paint-order=\"stroke\"",
                           attributes, colours::kPaper, 0.2 * unit_));
  }

  /// A ring where a vehicle's way begins in the map, a square where it ends.
  void mark_ends(LabelPlaces& places) {
    for (const RecordedVehicle& vehicle : recording_.vehicles) {
      if (vehicle.part > 0) continue;
      const auto inside = [&](const VehicleMoment& one) { return box_.contains(one.centre); };
      const auto first = std::ranges::find_if(vehicle.moments, inside);
      if (first == vehicle.moments.end()) continue;
      const auto last = std::find_if(vehicle.moments.rbegin(), vehicle.moments.rend(), inside);
      const std::string look = filled(colours::kPaper) + " " + stroke(colours::kInk, 0.25 * unit_);
      const Vec2 half = Vec2::Constant(0.6 * unit_), other(half.x(), -half.y());
      page_.circle(first->centre, 0.6 * unit_, "class=\"start\" " + look);
      page_.region(
          {{{last->centre - half, last->centre + other, last->centre + half, last->centre - other},
            {}}},
          "class=\"goal\" " + look);
      label(places, first->centre, 0.9 * unit_, 1.2 * unit_, "start", filled(colours::kInk));
      label(places, last->centre, 0.9 * unit_, 1.2 * unit_, "goal", filled(colours::kInk));
    }
  }

  /// Beside whoever has room: each moment once at a person, and once at each vehicle.
  void draw_times(LabelPlaces& places) {
    const double size = 1.1 * unit_;
    for (const Moment& moment : moments_) {
      const std::string text = fmt::format("{:g} s", moment.time);
      const std::string look = fmt::format(
          "class=\"time\" fill=\"{}\"", mixed_colour(colour(moment.time), colours::kShade, 0.35));
      for (const RecordedPerson& person : recording_.persons) {
        const PersonMoment* at = there_at(person.moments, moment.step, recording_.times, gap_);
        if (at == nullptr || !box_.contains(at->position)) continue;
        label(places, at->position, person.radius + 0.3 * unit_, size, text, look);
        break;
      }
      for (const RecordedVehicle& vehicle : recording_.vehicles) {
        if (vehicle.part > 0) continue;
        const VehicleMoment* at = there_at(vehicle.moments, moment.step, recording_.times, gap_);
        if (at == nullptr || !box_.contains(at->centre)) continue;
        label(places, at->centre, 0.5 * vehicle.width + 0.3 * unit_, size, text, look);
      }
    }
  }

  /// At the first place of theirs in the map.
  void draw_names(LabelPlaces& places) {
    const double size = 1.2 * unit_;
    for (const RecordedPerson& person : recording_.persons) {
      const auto first = std::ranges::find_if(person.moments, [&](const PersonMoment& moment) {
        return box_.contains(moment.position);
      });
      if (first == person.moments.end()) continue;
      const std::string name = shortened(person.id, 24);
      label(places, first->position, 0.6 * unit_, size, name, filled(colours::kInk));
    }
  }

  void draw_colour_bar() {
    const auto right = [&](double part) { return unit_ * (kBarLeft + kBarWidth * part); };
    // Each piece reaches to the end, so that no seams show.
    for (int k = 0; k < kBarPieces; ++k) {
      const Vec2 low = page_.panel_point(right(k / static_cast<double>(kBarPieces)),
                                         unit_ * (kBarTop + kBarHeight));
      const Vec2 high = page_.panel_point(right(1.0), unit_ * kBarTop);
      const double part = (k + 0.5) / kBarPieces;
      page_.region({{{low, {high.x(), low.y()}, high, {low.x(), high.y()}}, {}}},
                   fmt::format("class=\"scale\" fill=\"{}\"", scale_colour(part)));
    }
    const double step = round_step(end_ - begin_, 8.0);
    const Axis axis = Axis::over(begin_, end_, 8.0);
    for (double k = std::ceil(begin_ / step); end_ > begin_ && k * step <= end_; ++k) {
      const double at = right((k * step - begin_) / (end_ - begin_));
      const double top = unit_ * (kBarTop + kBarHeight);
      page_.line({page_.panel_point(at, top), page_.panel_point(at, top + 0.4 * unit_)},
                 stroke(colours::kInk, 0.12 * unit_));
      page_.text(page_.panel_point(at, top + 1.8 * unit_), 1.3 * unit_, axis.label(k * step),
                 "class=\"tick\" text-anchor=\"middle\"");
    }
    page_.text(page_.panel_point(right(1.0) + unit_, unit_ * (kBarTop + 1.1)), 1.4 * unit_,
               "time [s]");
  }

  const Recording& recording_;
  const Place* place_;
  const TimePlotOptions& options_;
  Box box_;
  MapPanel panel_;
  SvgPage page_;
  double gap_;                      ///< [s]
  double unit_;                     ///< [m]
  double begin_ = 0.0, end_ = 0.0;  ///< [s]
  std::vector<Moment> moments_;
};

}  // namespace

std::string time_plot(const Recording& recording, const Place* place,
                      const TimePlotOptions& options) {
  return TimePlot(recording, place, options).draw();
}

}  // namespace pedzone
