// What the statistics of a study find where there is nothing to find, and where there is: two
// disjoint sets of seeds are drawn again and again from the runs of one model.
//   null_study RUNS.CSV SCENARIO OTHER
// SCENARIO against itself: nothing to find. OTHER against it: the difference of the means of all
// runs is to be found. Prints JSON; judges nothing.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>

#include "core/csv_stream.hpp"
#include "core/random.hpp"
#include "study/compare/statistics.hpp"
#include "study/measure/measure_list.hpp"

namespace pedzone::study {
namespace {

constexpr std::uint64_t kRepetitions = 200;
constexpr std::size_t kSeeds = 25;  // in a set
constexpr double kLevel = 0.05;

/// Values of one measure in one scenario, by seed.
using Values = std::map<std::uint64_t, double>;
/// By scenario and measure.
using Table = std::map<std::pair<std::string, std::string>, Values>;

Table read_table(const std::string& file) {
  std::vector<std::string> header = {"scenario", "model", "seed", "status"};
  const std::size_t first = header.size();
  for (const Measure& measure : measure_list()) header.emplace_back(measure.key);
  Table table;
  visit_rows(file, header, [&](const CsvRow& row) {
    for (std::size_t column = first; column < header.size(); ++column) {
      if (row[column].empty()) continue;
      table[{row[0], header[column]}][std::stoull(row[2])] = std::stod(row[column]);
    }
  });
  return table;
}

/// The seeds in an order by chance, another one for each repetition.
std::vector<std::uint64_t> shuffled(const Values& values, std::uint64_t repetition) {
  std::vector<std::uint64_t> seeds;
  for (const auto& [seed, value] : values) seeds.push_back(seed);
  std::ranges::sort(seeds, {}, [&](std::uint64_t seed) {
    return random_bits(repetition, seed, 0, Purpose::kTieBreak);
  });
  return seeds;
}

/// The first seeds' values against the next ones', in pairs by their order.
PairedDifference compare_sets(const Values& reference, const Values& other,
                              const std::vector<std::uint64_t>& seeds, std::uint64_t repetition) {
  std::vector<double> differences;
  for (std::size_t i = 0; i < kSeeds; ++i) {
    differences.push_back(other.at(seeds[kSeeds + i]) - reference.at(seeds[i]));
  }
  return compare_pairs(differences, repetition);
}

double mean_of(const Values& values) {
  double sum = 0.0;
  for (const auto& [seed, value] : values) sum += value;
  return sum / static_cast<double>(values.size());
}

bool holds(const Interval& interval, double value) {
  return interval.low <= value && value <= interval.high;
}

/// How often, of all repetitions, and how large the difference is.
nlohmann::ordered_json trial(const Values& reference, const Values& other) {
  const double size = mean_of(other) - mean_of(reference);
  int different = 0, within_student = 0, within_bootstrap = 0;
  for (std::uint64_t repetition = 0; repetition < kRepetitions; ++repetition) {
    const auto found = compare_sets(reference, other, shuffled(reference, repetition), repetition);
    different += *found.p < kLevel;
    within_student += holds(*found.student, size);
    within_bootstrap += holds(*found.bootstrap, size);
  }
  return {{"reference", mean_of(reference)},
          {"size", size},
          {"different", different},
          {"withinStudent", within_student},
          {"withinBootstrap", within_bootstrap}};
}

/// Repetitions in which anything of the family is called different.
int any_different(const std::vector<const Values*>& family) {
  int repetitions = 0;
  for (std::uint64_t repetition = 0; repetition < kRepetitions; ++repetition) {
    std::vector<double> p;
    for (const Values* values : family) {
      const auto seeds = shuffled(*values, repetition);
      p.push_back(*compare_sets(*values, *values, seeds, repetition).p);
    }
    const auto corrected = holm(p);
    repetitions += std::ranges::any_of(corrected, [](double each) { return each < kLevel; });
  }
  return repetitions;
}

nlohmann::ordered_json study(const Table& table, const std::string& scenario,
                             const std::string& other) {
  nlohmann::ordered_json found = {{"repetitions", kRepetitions}};
  std::vector<const Values*> family;
  for (const Measure& measure : measure_list()) {
    if (!measure.primary) continue;
    const std::string key(measure.key);
    const Values& values = table.at({scenario, key});
    family.push_back(&values);
    found["runs"][key] = values.size();
    found["null"][key] = trial(values, values);
    found["planted"][key] = trial(values, table.at({other, key}));
  }
  found["anyOfFamily"] = any_different(family);
  return found;
}

}  // namespace
}  // namespace pedzone::study

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fputs("usage: null_study RUNS.CSV SCENARIO OTHER\n", stderr);
    return 2;
  }
  try {
    const auto found = pedzone::study::study(pedzone::study::read_table(argv[1]), argv[2], argv[3]);
    std::puts(found.dump(1).c_str());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "Error: %s\n", error.what());
    return 1;
  }
}
