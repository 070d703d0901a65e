// Tests of people who walk alone, or as good as alone.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/random.hpp"
#include "core/statistics.hpp"
#include "verify/measures.hpp"
#include "verify/standard_test.hpp"
#include "world/profiles.hpp"

namespace pedzone::verify {
namespace {

constexpr double kBehind = 2.0;  // [m] assumed: people aim so far behind the line that is timed

/// A corridor along x from 0 to `length` [m] and kOpenEnd more at its end, `width` wide about y =
/// 0, turned by `angle` [rad] about its start.
struct Corridor {
  double length, width, angle = 0.0;

  Vec2 at(double x, double y) const { return turned(Vec2(x, y), angle); }
  Region ground() const {
    return repair(turned(Region{{box(0.0, -width / 2, length + kOpenEnd, width / 2), {}}}, angle)
                      .front()
                      .outer);
  }
  Destination end() const {
    return {at(length + kBehind, -width / 2), at(length + kBehind, width / 2)};
  }
  FlowLine line(double x) const { return {at(x, width / 2), at(x, -width / 2)}; }
};

Drawing drawing_of(const Corridor& corridor) {
  Drawing drawing;
  drawing.walkable = corridor.ground();
  drawing.arrows.push_back({corridor.at(0.3, 0.0), corridor.at(corridor.length, 0.0), 0});
  drawing.lines.push_back({corridor.at(corridor.length, -corridor.width / 2),
                           corridor.at(corridor.length, corridor.width / 2)});
  return drawing;
}

/// One person from the corridor's start to its line: time [s] and what it strays to the side.
struct Walk {
  double time = std::nan(""), drift = 0.0;
};

Walk walk(const Corridor& corridor, const RunInput& input, double speed, double start,
          bool varied = true) {
  constexpr double kMost = 100.0;  // [s]
  Trial trial(corridor.ground(), input, [&](Zone& zone) {
    if (!varied) zone.parameters.heading_noise = 0.0;
  });
  trial.add(corridor.at(kBodyRadius, 0.0), corridor.end(), 0, speed, start);
  FlowLine line = corridor.line(corridor.length + kBodyRadius);
  Walk result;
  const Vec2 side = turned(Vec2(0.0, 1.0), corridor.angle);
  trial.walk(kMost, [&] {
    line.look(trial);
    const Participant& participant = trial.people().front();
    if (line.count() == 0)
      result.drift += std::abs((participant.at - participant.before).dot(side));
  });
  if (line.count() > 0) result.time = line.times().front();
  return result;
}

StandardTest rimea_1() {
  const Corridor corridor{40.0, 2.0};
  StandardTest test;
  test.id = "rimea-1";
  test.title = "Keeping one's speed in a corridor";
  test.source = "RiMEA 4.1.1, test 1; IMO 1533, test 1; ISO 20414, test 2";
  test.setup = "One person with 1.33 m/s walks 40 m in a corridor 2 m wide, from rest.";
  test.behaviour = false;
  test.figures = {in_every_seed(between("time", "time for 40 m", "s", 1, 26.0, 34.0, "RiMEA"))};
  test.drawing = drawing_of(corridor);
  test.run = [corridor](const RunInput& input, std::size_t) {
    Outcome outcome;
    outcome.figures["time"] = walk(corridor, input, 1.33, 0.0).time;
    return outcome;
  };
  return test;
}

StandardTest free_flow() {
  const Corridor corridor{10.0, 2.0};
  StandardTest test;
  test.id = "juelich-free-flow";
  test.title = "Free walking";
  test.source = "Jülich (JuPedSim), verification 1";
  test.setup =
      "One person walks 10 m in the middle of a corridor at its 1 m/s from the start; from rest, "
      "the relaxation time of 0.5 s would use up the limit.";
  test.behaviour = false;
  test.figures = {between("time", "time for 10 m", "s", 2, 9.5, 10.5, "Jülich: 10 s ± 0.5 s")};
  test.drawing = drawing_of(corridor);
  test.run = [corridor](const RunInput& input, std::size_t) {
    Outcome outcome;
    outcome.figures["time"] = walk(corridor, input, 1.0, 1.0).time;
    return outcome;
  };
  return test;
}

StandardTest rotated() {
  static const std::vector<double> degrees{0.0, 15.0, 45.0, 90.0, 157.0};
  StandardTest test;
  test.id = "juelich-rotated";
  test.title = "A turned corridor";
  test.source = "Jülich (JuPedSim), verification 2";
  test.setup =
      "The same corridor turned by 0, 15, 45, 90 and 157 degrees, walked at 1 m/s from the start.";
  test.behaviour = false;
  test.figures = {
      in_every_seed(at_most("off", "greatest difference from 10 s", "s", 3, 0.1, "Jülich: 0.1 s"))};
  test.drawing = drawing_of({10.0, 2.0, kPi / 4.0});
  test.cases = degrees.size();
  test.run = [](const RunInput& input, std::size_t index) {
    const Corridor corridor{10.0, 2.0, degrees[index] * kPi / 180.0};
    Outcome outcome;
    const double off = std::abs(walk(corridor, input, 1.0, 1.0).time - 10.0);
    outcome.figures[fmt::format("off-{:.0f}", degrees[index])] = off;
    return outcome;
  };
  test.conclude = [](Outcome& outcome) {
    double most = 0.0;
    for (const double angle : degrees) {
      const double off = outcome.figures[fmt::format("off-{:.0f}", angle)];
      most = std::isnan(off) ? off : std::max(most, off);
    }
    outcome.figures["off"] = most;
  };
  return test;
}

StandardTest drift() {
  const Corridor corridor{10.0, 2.0};
  StandardTest test;
  test.id = "juelich-drift";
  test.title = "No drift to the side";
  test.source = "Jülich (JuPedSim)";
  test.setup =
      "As free walking, with the variation of the heading (parameter headingNoise) switched off: "
      "that is chance, and this is about the rule.";
  test.behaviour = false;
  test.figures = {in_every_seed(
      at_most("drift", "sum of steps to the side", "m", 4, 0.005, "Jülich: 0.005 m"))};
  test.drawing = drawing_of(corridor);
  test.run = [corridor](const RunInput& input, std::size_t) {
    Outcome outcome;
    outcome.figures["drift"] = walk(corridor, input, 1.0, 1.0, false).drift;
    return outcome;
  };
  return test;
}

// RiMEA 7

/// A profile, and the speeds that RiMEA gives for the people it stands for.
struct Ages {
  std::string_view profile, label;
  double least, most;  ///< [m/s]
};
constexpr Ages kAges[] = {{"teenager", "under 30 years", 0.58, 1.61},
                          {"middle-aged", "30 to 50 years", 1.41, 1.54},
                          {"senior", "over 50 years", 0.68, 1.41},
                          {"wheelchair", "impaired", 0.46, 0.76}};
constexpr std::size_t kOfEach = 50;  // RiMEA: 50 persons

/// Fifty people of one profile side by side, far enough apart to walk alone.
Outcome walk_profile(const Ages& ages, const RunInput& input) {
  constexpr double kApart = 4.0, kLong = 24.0, kFrom = 4.0, kTo = 20.0;  // [m]
  const double high = kApart * static_cast<double>(kOfEach);
  const Profiles profiles;
  const Profile* profile = profiles.find(ages.profile);
  Trial trial(repair(box(0.0, 0.0, kLong + kOpenEnd, high)), input);
  std::vector<double> wanted, walked;
  for (std::size_t k = 0; k < kOfEach; ++k) {
    const double chance = random_normal(input.seed, k + 1, 0, Purpose::kDemand);
    const double speed =
        std::clamp(profile->speed + profile->speed_deviation * chance, 0.1, profile->top_speed);
    const double y = kApart * (static_cast<double>(k) + 0.5);
    trial.add({0.5, y}, line_at_x(kLong, y - 1.0, y + 1.0), 0, speed, 1.0);
    wanted.push_back(speed);
  }
  FlowLine first({kFrom, high}, {kFrom, 0.0}), last({kTo, high}, {kTo, 0.0});
  trial.walk(400.0, [&] {
    first.look(trial);
    last.look(trial);
  });
  double off = last.count() == kOfEach ? 0.0 : std::nan("");
  for (const auto& [person, time] : last.passages()) {
    walked.push_back((kTo - kFrom) / (time - first.passages().at(person)));
    off = std::max(off, std::abs(walked.back() / wanted[person] - 1.0));
  }
  Outcome outcome;
  outcome.figures["mean-" + std::string(ages.profile)] = mean(walked);
  outcome.figures["off-" + std::string(ages.profile)] = off;
  return outcome;
}

StandardTest rimea_7() {
  StandardTest test;
  test.id = "rimea-7";
  test.title = "People of several ages";
  test.source = "RiMEA 4.1.1, test 7 (Weidmann 1993); ISO 20414, test 5";
  test.setup =
      "Fifty people of each of pedzone's profiles teenager, middle-aged, senior and wheelchair "
      "walk 16 m, four metres apart.";
  test.behaviour = false;
  const Profiles profiles;
  for (const Ages& ages : kAges) {
    const double chance = 2.0 * profiles.find(ages.profile)->speed_deviation / std::sqrt(kOfEach);
    test.figures.push_back(between("mean-" + std::string(ages.profile),
                                   fmt::format("mean speed, {} ({})", ages.label, ages.profile),
                                   "m/s", 2, ages.least - chance, ages.most + chance,
                                   "RiMEA, test 7, and two standard errors of a mean of 50"));
  }
  test.figures.push_back(at_most("off", "greatest difference from one's own speed", "share", 3,
                                 0.05, "assumed: the variation of the heading costs less"));
  test.cases = std::size(kAges);
  test.run = [](const RunInput& input, std::size_t index) {
    return walk_profile(kAges[index], input);
  };
  test.conclude = [](Outcome& outcome) {
    double most = 0.0;
    for (const Ages& ages : kAges) {
      const double off = outcome.figures["off-" + std::string(ages.profile)];
      most = std::isnan(off) ? off : std::max(most, off);
    }
    outcome.figures["off"] = most;
  };
  test.drawing.walkable = repair(box(0.0, 0.0, 24.0, 12.0));
  for (const double y : {2.0, 6.0, 10.0}) {
    test.drawing.arrows.push_back({{0.5, y}, {22.0, y}, 0});
  }
  test.drawing.lines = {{{4.0, 0.0}, {4.0, 12.0}}, {{20.0, 0.0}, {20.0, 12.0}}};
  return test;
}

}  // namespace

std::vector<StandardTest> single_walker_tests() {
  return {rimea_1(), free_flow(), rotated(), drift(), rimea_7()};
}

}  // namespace pedzone::verify
