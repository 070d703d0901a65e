// Rooms that a crowd leaves.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "verify/measures.hpp"
#include "verify/standard_test.hpp"

namespace pedzone::verify {
namespace {

constexpr double kWall = 0.2;  // [m] assumed: thickness of a wall with a door
constexpr double kAway = 3.0;  // [m] assumed: people leave so far behind an exit

/// [m] how far the ground goes on behind an exit.
double behind(bool open) { return kAway + (open ? kOpenEnd : 0.0); }

// RiMEA 9: 30 m by 20 m, a door of 1 m in each half of the long sides.

constexpr double kLong = 30.0, kDeep = 20.0, kDoor = 1.0;  // [m]
constexpr std::size_t kThousand = 1000;
constexpr double kDoorsAt[] = {7.5, 22.5};  // [m] assumed: middles of the doors

/// All grounds: `open` with the open ends behind where people leave, which drawings leave out.
Region big_room(bool open) {
  Region ground = repair(box(0.0, 0.0, kLong, kDeep));
  for (const double x : kDoorsAt) {
    for (const bool top : {false, true}) {
      const double wall = top ? kDeep : -kWall;
      const double out = top ? kDeep + kWall : -kWall - behind(open);
      const double half = kDoor / 2.0;
      ground = unite(ground, repair(box(x - half, wall - 0.1, x + half, wall + kWall + 0.1)));
      ground = unite(ground, repair(box(x - 3.0, out, x + 3.0, out + behind(open))));
    }
  }
  return ground;
}

/// Behind the nearest of the doors that are open: all four, or the two of the lower side.
Destination exit_of(const Vec2& at, bool all) {
  const double x = at.x() < kLong / 2.0 ? kDoorsAt[0] : kDoorsAt[1];
  const bool top = all && at.y() > kDeep / 2.0;
  const double y = top ? kDeep + kWall + kAway : -kWall - kAway;
  return line_at_y(y, x - 2.5, x + 2.5);
}

Outcome run_rimea_9(const RunInput& input, std::size_t index) {
  constexpr double kMost = 1500.0;  // [s]
  const bool all = index == 0;
  Trial trial(big_room(true), input);
  for (const Vec2& at :
       places_in({kBodyRadius, 0.0}, {kLong - kBodyRadius, kDeep}, kThousand, input.seed)) {
    trial.add(at, exit_of(at, all));
  }
  DensityMap map({0.0, -4.0}, {kLong, kDeep + 4.0}, 0.5);
  trial.walk(kMost, [&] { map.look(trial); });
  Outcome outcome;
  outcome.figures[all ? "four" : "two"] = trial.last_arrival(kMost);
  outcome.figures[all ? "arrived-four" : "arrived-two"] = static_cast<double>(trial.arrived());
  if (!all) outcome.map = map.grid();
  return outcome;
}

StandardTest rimea_9() {
  StandardTest test;
  test.id = "rimea-9";
  test.behaviour = false;
  test.title = "A thousand people leave a room";
  test.source = "RiMEA 4.1.1, test 9; IMO 1533, test 9";
  test.setup =
      "1,000 people in a room of 30 m by 20 m, each to the nearest open exit of 1 m: four are "
      "open, then the two of one side.";
  test.figures = {between("ratio", "time with two exits over time with four", "", 2, 1.6, 2.4,
                          "RiMEA: about twice; its authors take it as a description of the model"),
                  in_every_seed(at_least("arrived", "people who get out within 1,500 s, fewest", "",
                                         0, static_cast<double>(kThousand), "nobody is stuck")),
                  told("four", "time with four exits", "s", 0),
                  told("two", "time with two exits", "s", 0)};
  test.cases = 2;
  test.run = run_rimea_9;
  test.map_of = "Two exits.";
  test.conclude = [](Outcome& outcome) {
    auto& figures = outcome.figures;
    figures["ratio"] = figures["two"] / figures["four"];
    figures["arrived"] = std::min(figures["arrived-two"], figures["arrived-four"]);
  };
  test.drawing.walkable = big_room(false);
  test.drawing.starts.push_back({box(0.0, 0.0, kLong, kDeep), 0});
  for (const double x : kDoorsAt) {
    test.drawing.arrows.push_back({{x, 3.0}, {x, -3.0}, 0});
    test.drawing.arrows.push_back({{x, kDeep - 3.0}, {x, kDeep + 3.0}, 0});
  }
  return test;
}

// RiMEA 12: a room, a corridor of 1 m by 5 m, a second room with an exit of 1 m.

constexpr double kRoom = 10.0, kNeck = 5.0, kNeckWide = 1.0;  // [m]
constexpr double kSecond = kRoom + kNeck, kExit = kSecond + kRoom;
constexpr std::size_t kCrowd = 150;

Region two_rooms(bool open) {
  const double low = (kRoom - kNeckWide) / 2.0, high = (kRoom + kNeckWide) / 2.0;
  return joined({box(0.0, 0.0, kRoom, kRoom), box(kRoom - 0.1, low, kSecond + 0.1, high),
                 box(kSecond, 0.0, kExit, kRoom), box(kExit - 0.1, low, kExit + kWall + 0.1, high),
                 box(kExit + kWall, 0.0, kExit + kWall + behind(open), kRoom)});
}

Outcome run_rimea_12(const RunInput& input, std::size_t) {
  Trial trial(two_rooms(true), input);
  const double low = (kRoom - kNeckWide) / 2.0, high = (kRoom + kNeckWide) / 2.0;
  const Destination end = line_at_x(kExit + kWall + kAway, 0.5, kRoom - 0.5);
  for (const Vec2& at : places_in({kBodyRadius, 0.0}, {kRoom / 2.0, kRoom}, kCrowd, input.seed)) {
    trial.add(at, end);
  }
  FlowLine neck({kRoom + 0.1, high}, {kRoom + 0.1, low});
  FlowLine exit({kExit + 0.1, high}, {kExit + 0.1, low});
  AreaMeasure before(box(kRoom - 2.0, 4.0, kRoom, 6.0), 20.0);
  AreaMeasure behind(box(kExit - 2.0, 4.0, kExit, 6.0), 20.0);
  DensityMap map({0.0, 0.0}, {kExit + 2.0, kRoom}, 0.5);
  trial.walk(600.0, [&] {
    neck.look(trial);
    exit.look(trial);
    map.look(trial);
    if (trial.time() > 80.0) return;  // while the first room is full
    before.look(trial);
    behind.look(trial);
  });
  Outcome outcome;
  outcome.figures["neck"] = neck.flow();
  outcome.figures["exit"] = exit.flow();
  outcome.figures["ratio"] = neck.flow() / exit.flow();
  outcome.figures["before"] = before.density();
  outcome.figures["behind"] = behind.density();
  outcome.figures["jam"] = before.density() - behind.density();
  outcome.figures["arrived"] = static_cast<double>(trial.arrived());
  outcome.map = map.grid();
  return outcome;
}

StandardTest rimea_12() {
  StandardTest test;
  test.id = "rimea-12";
  test.behaviour = false;
  test.title = "The effect of a bottleneck";
  test.source = "RiMEA 4.1.1, test 12";
  test.setup =
      "150 people in one half of a room of 10 m by 10 m go through a corridor 1 m wide and 5 m "
      "long into a second room and out by an exit of 1 m. People jam in the first room only.";
  test.figures = {
      at_least("ratio", "flow into the corridor over flow out of the exit", "", 2, 0.95,
               "RiMEA: not below it; 5 % for chance (assumed)"),
      at_least("jam", "density before the corridor less that before the exit", "/m²", 2, 1.0,
               "RiMEA: a jam in the first room only; assumed: at least one person per m²"),
      in_every_seed(at_least("arrived", "people who get out within 600 s", "", 0,
                             static_cast<double>(kCrowd), "nobody is stuck")),
      told("neck", "flow into the corridor", "/s", 2),
      told("exit", "flow out of the exit", "/s", 2),
      told("before", "density before the corridor", "/m²", 2),
      told("behind", "density before the exit", "/m²", 2)};
  test.run = run_rimea_12;
  test.drawing.walkable = two_rooms(false);
  test.drawing.starts.push_back({box(0.0, 0.0, kRoom / 2.0, kRoom), 0});
  test.drawing.measured = {box(kRoom - 2.0, 4.0, kRoom, 6.0), box(kExit - 2.0, 4.0, kExit, 6.0)};
  test.drawing.lines = {{{kRoom + 0.1, 4.5}, {kRoom + 0.1, 5.5}},
                        {{kExit + 0.1, 4.5}, {kExit + 0.1, 5.5}}};
  test.drawing.arrows.push_back({{6.0, 5.0}, {kExit + 3.0, 5.0}, 0});
  return test;
}

// RiMEA 13, its first half: a room and a corridor of 2 m, which leads to stairs that are left out.

constexpr double kHall = 8.0, kPassage = 12.0, kPassageWide = 2.0;  // [m]

Region hall(bool open) {
  const double low = (kHall - kPassageWide) / 2.0, high = (kHall + kPassageWide) / 2.0;
  const double end = kHall + kPassage + (open ? kOpenEnd : 0.0);
  return joined({box(0.0, 0.0, kHall, kHall), box(kHall - 0.1, low, end, high)});
}

Outcome run_rimea_13(const RunInput& input, std::size_t) {
  const double low = (kHall - kPassageWide) / 2.0, high = (kHall + kPassageWide) / 2.0;
  Trial trial(hall(true), input);
  for (const Vec2& at :
       places_in({kBodyRadius, 0.0}, {kHall - kBodyRadius, kHall}, kCrowd, input.seed)) {
    trial.add(at, line_at_x(kHall + kPassage, low, high));
  }
  FlowLine line({kHall + 0.1, high}, {kHall + 0.1, low});
  AreaMeasure before(box(kHall - 2.0, low, kHall, high), 10.0);
  AreaMeasure inside(box(kHall + 4.0, low, kHall + 8.0, high), 10.0);
  DensityMap map({0.0, 0.0}, {kHall + kPassage, kHall}, 0.25);
  trial.walk(300.0, [&] {
    line.look(trial);
    map.look(trial);
    if (trial.time() > 35.0) return;  // while the room is full
    before.look(trial);
    inside.look(trial);
  });
  Outcome outcome;
  outcome.figures["jam"] = before.density() - inside.density();
  outcome.figures["before"] = before.density();
  outcome.figures["inside"] = inside.density();
  outcome.figures["flow"] = line.flow() / kPassageWide;
  outcome.figures["arrived"] = static_cast<double>(trial.arrived());
  outcome.map = map.grid();
  return outcome;
}

StandardTest rimea_13() {
  const double low = (kHall - kPassageWide) / 2.0, high = (kHall + kPassageWide) / 2.0;
  StandardTest test;
  test.id = "rimea-13";
  test.title = "A jam before a corridor";
  test.source = "RiMEA 3.0, test 13, without its stairs; ISO 20414, test 10";
  test.setup =
      "150 people in a room of 8 m by 8 m leave by a corridor 2 m wide and 12 m long. They jam "
      "before it, not in it. The stairs behind it are left out: a zone has one level.";
  test.figures = {
      at_least("jam", "density before the corridor less that inside", "/m²", 2, 0.0, "RiMEA"),
      between("flow", "flow into the corridor", "/(m·s)", 2, 1.3, 1.9, "as doors of 2 m"),
      in_every_seed(at_least("arrived", "people who get out within 300 s", "", 0,
                             static_cast<double>(kCrowd), "nobody is stuck")),
      told("before", "density before the corridor", "/m²", 2),
      told("inside", "density inside", "/m²", 2)};
  test.run = run_rimea_13;
  test.drawing.walkable = hall(false);
  test.drawing.starts.push_back({box(0.0, 0.0, kHall, kHall), 0});
  test.drawing.measured = {box(kHall - 2.0, low, kHall, high),
                           box(kHall + 4.0, low, kHall + 8.0, high)};
  test.drawing.lines.push_back({{kHall + 0.1, low}, {kHall + 0.1, high}});
  test.drawing.arrows.push_back({{5.0, 4.0}, {kHall + kPassage - 1.0, 4.0}, 0});
  return test;
}

// RiMEA 8 and the exit of IMO and ISO: 100 people in a room of 8 m by 5 m, an exit of 1 m.

constexpr double kSmallLong = 8.0, kSmallDeep = 5.0;  // [m]
constexpr std::size_t kHundred = 100;

Region small_room(bool open) {
  const double low = kSmallDeep / 2.0 - 0.5, high = kSmallDeep / 2.0 + 0.5;
  return joined({box(0.0, 0.0, kSmallLong, kSmallDeep),
                 box(kSmallLong - 0.1, low, kSmallLong + kWall + 0.1, high),
                 box(kSmallLong + kWall, 0.0, kSmallLong + kWall + behind(open), kSmallDeep)});
}

/// Time [s] of the last passage, and the flow [1/s] from the first to the last. `speed`:
/// everybody's.
std::pair<double, double> leave(const RunInput& input, std::optional<double> speed) {
  Trial trial(small_room(true), input);
  const Destination end = line_at_x(kSmallLong + kWall + kAway, 0.5, kSmallDeep - 0.5);
  for (const Vec2& at : places_in({kBodyRadius, 0.0}, {kSmallLong - kBodyRadius, kSmallDeep},
                                  kHundred, input.seed)) {
    trial.add(at, end, 0, speed);
  }
  const double x = kSmallLong + kWall / 2.0;
  FlowLine line({x, kSmallDeep / 2.0 + 0.5}, {x, kSmallDeep / 2.0 - 0.5});
  constexpr double kMost = 400.0;
  trial.walk(kMost, [&] { line.look(trial); });
  const double last = line.count() == kHundred ? line.times().back() : std::nan("");
  return {last, line.flow(0.0, 1.0)};
}

Drawing small_drawing() {
  Drawing drawing;
  drawing.walkable = small_room(false);
  drawing.starts.push_back({box(0.0, 0.0, kSmallLong, kSmallDeep), 0});
  const double x = kSmallLong + kWall / 2.0, y = kSmallDeep / 2.0;
  drawing.lines.push_back({{x, y - 0.5}, {x, y + 0.5}});
  drawing.arrows.push_back({{x - 3.0, y}, {x + 3.0, y}, 0});
  return drawing;
}

constexpr double kSpeeds[] = {0.6, 0.9, 1.34, 1.8};  // [m/s]

StandardTest rimea_8() {
  StandardTest test;
  test.id = "rimea-8";
  test.title = "What the preferred speed changes";
  test.source = "RiMEA 4.1.1, test 8 (on one level)";
  test.setup =
      "100 people who all want to walk at 0.6, 0.9, 1.34 or 1.8 m/s leave a room of 8 m by 5 m by "
      "an exit of 1 m.";
  test.behaviour = false;
  test.figures = {at_least("least-fall", "least fall of the time from 0.6 over 0.9 to 1.34 m/s",
                           "s", 1, 0.0, "RiMEA: to be described; faster people are out sooner")};
  for (const double speed : kSpeeds) {
    test.figures.push_back(
        told(fmt::format("time-{:g}", speed), fmt::format("time at {:g} m/s", speed), "s", 0));
  }
  test.charts.push_back(
      {"time", "Time until the room is empty", "preferred speed, m/s", "time, s", {}, {}, {}});
  test.cases = std::size(kSpeeds);
  test.run = [](const RunInput& input, std::size_t index) {
    Outcome outcome;
    const double time = leave(input, kSpeeds[index]).first;
    outcome.figures[fmt::format("time-{:g}", kSpeeds[index])] = time;
    outcome.curves["time"] = {{kSpeeds[index], time}};
    return outcome;
  };
  test.conclude = [](Outcome& outcome) {
    auto& figures = outcome.figures;
    const double first = figures["time-0.6"] - figures["time-0.9"];
    const double second = figures["time-0.9"] - figures["time-1.34"];
    figures["least-fall"] = std::isnan(second) ? second : std::min(first, second);
  };
  test.drawing = small_drawing();
  return test;
}

StandardTest exit_flow() {
  StandardTest test;
  test.id = "imo-exit";
  test.title = "Flow out of a room";
  test.source = "IMO 1533, test 4; NIST 1822 and ISO 20414, test 11";
  test.setup = "100 people leave a room of 8 m by 5 m by an exit of 1 m.";
  test.figures = {
      told("flow", "flow from the first to the last", "persons/s", 2,
           "IMO: at most 1.33 as a rule of design; NIST and ISO leave the value to the user; "
           "measured flows are 1.3 to 1.9, see doors"),
      in_every_seed(at_most("time", "time of the last", "s", 0, 399.0, "everybody gets out"))};
  test.behaviour = false;
  test.run = [](const RunInput& input, std::size_t) {
    const auto [time, flow] = leave(input, {});
    Outcome outcome;
    outcome.figures["flow"] = flow;
    outcome.figures["time"] = time;
    return outcome;
  };
  test.drawing = small_drawing();
  return test;
}

}  // namespace

std::vector<StandardTest> room_tests() {
  return {rimea_8(), rimea_9(), rimea_12(), rimea_13(), exit_flow()};
}

}  // namespace pedzone::verify
