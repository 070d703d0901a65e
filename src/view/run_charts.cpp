#include "view/run_charts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <optional>

#include "core/statistics.hpp"
#include "pages/palette.hpp"
#include "view/colours.hpp"
#include "view/line_chart.hpp"
#include "view/run_map.hpp"
#include "view/vehicle_clearance.hpp"

namespace pedzone {
namespace {

constexpr double kLow = 0.05, kHigh = 0.95;  // quantiles of the band

/// A person's value at one of its moments; nothing where it has none.
using Value = std::function<std::optional<double>(const RecordedPerson&, const PersonMoment&)>;

/// Adds a point to the last piece, or to a new one after a gap.
template <class Point>
void add_point(std::vector<std::vector<Point>>& pieces, const Point& point, bool joined) {
  if (!joined || pieces.empty()) pieces.emplace_back();
  pieces.back().push_back(point);
}

std::vector<ChartLine> lines_of_persons(const Recording& recording, const Value& value) {
  const double gap = line_gap(recording);
  std::vector<ChartLine> lines;
  for (const RecordedPerson& person : recording.persons) {
    const LineLook look = line_look(lines.size());
    ChartLine line{person.id, std::string(look.colour), "", {}};
    if (!look.dashes.empty()) line.dashes = "7 4";
    double last = 0.0;
    for (const PersonMoment& moment : person.moments) {
      const auto y = value(person, moment);
      if (!y) continue;
      const double time = recording.times[moment.step];
      add_point(line.pieces, Vec2(time, *y), time - last <= gap);
      last = time;
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

/// A line that is not to be seen would be taken for one that is not there.
void tell_of_cut(const ChartLine& line, Chart& chart) {
  std::size_t all = 0, cut = 0;
  for (const Polyline& piece : line.pieces) {
    all += piece.size();
    cut += static_cast<std::size_t>(
        std::ranges::count_if(piece, [&](const Vec2& point) { return point.y() > chart.y_most; }));
  }
  if (cut == 0) return;
  chart.note = fmt::format(
      "{}: above {:g} m {}, off the axis", line.name, chart.y_most,
      cut == all ? "throughout"
                 : fmt::format("for {:.0f} % of the time",
                               100.0 * static_cast<double>(cut) / static_cast<double>(all)));
}

/// Median, band and, where asked for, the least of everybody at each step.
void add_summary(const Recording& recording, const Value& value, bool with_least, Chart& chart) {
  std::vector<std::vector<double>> values(recording.times.size());
  for (const RecordedPerson& person : recording.persons) {
    for (const PersonMoment& moment : person.moments) {
      if (const auto y = value(person, moment)) values[moment.step].push_back(*y);
    }
  }
  ChartLine median{"median", std::string(colours::kBlue.light), "", {}};
  ChartLine least{"least", std::string(colours::kVermilion.light), "", {}};
  ChartBand band{"5 to 95 %", std::string(colours::kBlue.light), {}};
  const double gap = line_gap(recording);
  double last = 0.0;
  for (std::size_t step = 0; step < values.size(); ++step) {
    if (values[step].empty()) continue;
    std::ranges::sort(values[step]);
    const double time = recording.times[step];
    const bool joined = time - last <= gap;
    last = time;
    add_point(median.pieces, Vec2(time, quantile(values[step], 0.5)), joined);
    add_point(least.pieces, Vec2(time, values[step].front()), joined);
    add_point(band.pieces, {time, quantile(values[step], kLow), quantile(values[step], kHigh)},
              joined);
  }
  tell_of_cut(median, chart);
  chart.bands.push_back(std::move(band));
  if (with_least) chart.lines.push_back(std::move(least));
  chart.lines.push_back(std::move(median));
}

std::string draw(Chart& chart, const Recording& recording, const Value& value, bool with_least) {
  chart.x_label = "time [s]";
  if (recording.persons.size() <= kLineLooks) {
    chart.lines = lines_of_persons(recording, value);
  } else {
    add_summary(recording, value, with_least, chart);
  }
  return line_chart(chart);
}

}  // namespace

std::string speed_chart(const Recording& recording, const std::string& title) {
  Chart chart;
  chart.title = title;
  chart.y_label = "speed [m/s]";
  return draw(
      chart, recording,
      [](const RecordedPerson&, const PersonMoment& moment) {
        return std::optional<double>(moment.speed);
      },
      false);
}

std::string across_chart(const Recording& recording, const std::string& title) {
  Chart chart;
  chart.title = title;
  chart.x_label = "x [m]";
  chart.y_label = "y [m], stretched";
  chart.y_has_zero = false;
  const bool few = recording.persons.size() <= kLineLooks;
  const double gap = line_gap(recording);
  for (const RecordedPerson& person : recording.persons) {
    if (few || chart.lines.empty()) {
      const LineLook look = line_look(chart.lines.size());
      const std::string name =
          few ? person.id : fmt::format("{} persons", recording.persons.size());
      chart.lines.push_back({name, std::string(look.colour), look.dashes.empty() ? "" : "7 4", {}});
    }
    for (const TrackPiece& piece : pieces_of(person.moments, recording.times, gap)) {
      Polyline& line = chart.lines.back().pieces.emplace_back();
      for (std::size_t i = piece.first; i <= piece.last; ++i) {
        line.push_back(person.moments[i].position);
      }
    }
  }
  return line_chart(chart);
}

std::string clearance_chart(const Recording& recording, const std::string& title) {
  Chart chart;
  chart.title = title;
  chart.y_label = "clearance to moving vehicles [m]";
  chart.y_most = kFarClearance;
  const VehicleClearance clearance(recording);
  return draw(
      chart, recording,
      [&](const RecordedPerson& person, const PersonMoment& moment) {
        return clearance.of(moment.position, person.radius, moment.step);
      },
      true);
}

}  // namespace pedzone
