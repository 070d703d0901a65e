// People against people: IMO's counterflow, and overtaking.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "verify/measures.hpp"
#include "verify/standard_test.hpp"

namespace pedzone::verify {
namespace {

// Two rooms of 10 m by 10 m, joined by a corridor of 10 m by 2 m.

constexpr double kRoom = 10.0, kLow = 4.0, kHigh = 6.0, kEnd = 30.0;  // [m]
constexpr std::size_t kHundred = 100;
constexpr std::size_t kOpposed[] = {0, 10, 50, 100};
constexpr double kMost = 600.0;  // [s] assumed: ten times what 100 people alone need

Region rooms() {
  return joined({box(0.0, 0.0, kRoom, kRoom), box(kRoom - 0.1, kLow, kEnd - kRoom + 0.1, kHigh),
                 box(kEnd - kRoom, 0.0, kEnd, kRoom)});
}

Outcome run_imo(const RunInput& input, std::size_t index) {
  const std::size_t opposed = kOpposed[index];
  Trial trial(rooms(), input);
  const double rim = kBodyRadius;
  for (const Vec2& at : places_in({rim, 0.0}, {kRoom - rim, kRoom}, kHundred, input.seed)) {
    trial.add(at, line_at_x(kEnd - 2.0, 0.5, kRoom - 0.5), 0);
  }
  if (opposed > 0) {
    for (const Vec2& at :
         places_in({kEnd - kRoom + rim, 0.0}, {kEnd - rim, kRoom}, opposed, input.seed + 1000)) {
      trial.add(at, line_at_x(2.0, 0.5, kRoom - 0.5), 1);
    }
  }
  DensityMap map({0.0, 0.0}, {kEnd, kRoom}, 0.5);
  FlowLine line({kEnd - kRoom, kHigh}, {kEnd - kRoom, kLow});
  Jolts jolts;
  trial.walk(kMost, [&] {
    line.look(trial);
    jolts.look(trial);
    map.look(trial);
  });
  Outcome outcome;
  // Of the first stream: the line is crossed from left to right only by them.
  const double time = line.count() < kHundred ? std::nan("") : line.times().back();
  outcome.figures[fmt::format("time-{}", opposed)] = time;
  outcome.figures[fmt::format("arrived-{}", opposed)] =
      static_cast<double>(trial.arrived()) / static_cast<double>(trial.people().size());
  if (opposed == kHundred) outcome.figures["jolts"] = jolts.share();
  outcome.curves["time"] = {{static_cast<double>(opposed), time}};
  if (opposed == kHundred) outcome.map = map.grid();
  return outcome;
}

void conclude_imo(Outcome& outcome) {
  double rise = 1e9, arrived = 1.0, before = 0.0;
  for (const std::size_t opposed : kOpposed) {
    const double time = outcome.figures[fmt::format("time-{}", opposed)];
    if (opposed > 0)
      rise = std::isnan(time - before) ? std::nan("") : std::min(rise, time - before);
    before = time;
    arrived = std::min(arrived, outcome.figures[fmt::format("arrived-{}", opposed)]);
  }
  outcome.figures["rise"] = rise;
  outcome.figures["arrived"] = arrived;
}

StandardTest imo_counterflow() {
  StandardTest test;
  test.id = "imo-counterflow";
  test.title = "Counterflow";
  test.source = "IMO 1533, test 8; NIST 1822; ISO 20414, test 6";
  test.setup =
      "100 people walk from one room of 10 m by 10 m through a corridor 2 m wide and 10 m long "
      "into another, against 0, 10, 50 or 100 others. Time until the last of the 100 is there.";
  test.figures = {at_least("rise", "least rise of the time with the number opposed", "s", 1, 0.0,
                           "IMO: time rises"),
                  in_every_seed(at_least("arrived", "share of people who arrive within 600 s", "",
                                         2, 1.0, "all arrive")),
                  stopped_short()};
  for (const std::size_t opposed : kOpposed) {
    test.figures.push_back(
        told(fmt::format("time-{}", opposed), fmt::format("time against {}", opposed), "s", 0));
  }
  test.charts.push_back(
      {"time", "Time until the last is there", "people opposed", "time, s", {}, {}, {}});
  test.cases = std::size(kOpposed);
  test.run = run_imo;
  test.map_of = "100 against 100.";
  test.conclude = conclude_imo;
  test.drawing.walkable = rooms();
  test.drawing.starts = {{box(0.0, 0.0, kRoom, kRoom), 0},
                         {box(kEnd - kRoom, 0.0, kEnd, kRoom), 1}};
  test.drawing.lines.push_back({{kEnd - kRoom, kLow}, {kEnd - kRoom, kHigh}});
  test.drawing.arrows = {{{8.0, 5.5}, {14.0, 5.5}, 0}, {{22.0, 4.5}, {16.0, 4.5}, 1}};
  return test;
}

// ISO 20414, test 7: whoever is slow is overtaken.

constexpr double kLong = 40.0, kWide = 2.0;  // [m]
constexpr std::size_t kFaster = 24;          // as NIST

/// Those whose bodies touch the first person's now.
void add_touching(const Trial& trial, std::set<std::size_t>& touching) {
  constexpr double kTouch = 0.01;  // [m] numerical: bodies pushed apart lie this near
  const auto& people = trial.people();
  for (std::size_t i = 1; i < people.size() && people[0].here; ++i) {
    const double distance = (people[i].at - people[0].at).norm();
    if (people[i].here && distance < 2.0 * kBodyRadius + kTouch) touching.insert(i);
  }
}

Outcome run_overtaking(const RunInput& input, std::size_t) {
  constexpr double kSlow = 0.5, kFast = 1.25;  // [m/s] NIST: 1.25 m/s; assumed: the slow one's
  constexpr double kFirst = 8.0;               // [m] where the slow one starts, ahead of the rest
  constexpr double kUntil = 120.0;             // [s]
  Trial trial(repair(box(0.0, 0.0, kLong + kOpenEnd, kWide)), input);
  const Destination end = line_at_x(kLong, 0.0, kWide);
  trial.add({kFirst, kWide / 2.0}, end, 1, kSlow);
  for (const Vec2& at : places_in({kBodyRadius, 0.0}, {kFirst - 1.0, kWide}, kFaster, input.seed)) {
    trial.add(at, end, 0, kFast);
  }
  std::set<std::size_t> touching;
  trial.walk(kUntil, [&] { add_touching(trial, touching); });
  Outcome outcome;
  double before = 0.0;
  const Participant& slow = trial.people().front();
  const double its = slow.here ? kUntil : slow.arrival;
  for (const Participant& participant : trial.people()) {
    if (participant.stream == 0 && !participant.here && participant.arrival < its) before += 1.0;
  }
  outcome.figures["before"] = before;
  outcome.figures["fast"] = trial.last_arrival(kUntil, 0);
  outcome.figures["slow"] = its;
  outcome.figures["touching"] = static_cast<double>(touching.size());
  return outcome;
}

StandardTest overtaking() {
  StandardTest test;
  test.id = "iso-overtaking";
  test.behaviour = false;
  test.title = "Overtaking somebody slow";
  test.source = "ISO 20414, test 7; NIST 1822 (without its ramp)";
  test.setup =
      "24 people with 1.25 m/s walk behind one with 0.5 m/s in a corridor 2 m wide and 40 m long.";
  test.figures = {in_every_seed(at_least("before", "faster people who are there first", "", 0,
                                         static_cast<double>(kFaster), "ISO: they overtake")),
                  told("touching", "faster people who touch the slow one", "", 0),
                  told("fast", "time of the last of them", "s", 1),
                  in_every_seed(at_most("slow", "time of the slow one", "s", 1, 90.0,
                                        "assumed: 64 s alone, and not held up by half as much"))};
  test.run = run_overtaking;
  test.drawing.walkable = repair(box(0.0, 0.0, kLong, kWide));
  test.drawing.starts = {{box(0.0, 0.0, 7.0, kWide), 0}, {box(7.6, 0.6, 8.4, 1.4), 1}};
  test.drawing.arrows.push_back({{12.0, 1.0}, {30.0, 1.0}, 0});
  return test;
}

}  // namespace

std::vector<StandardTest> counterflow_tests() { return {imo_counterflow(), overtaking()}; }

}  // namespace pedzone::verify
