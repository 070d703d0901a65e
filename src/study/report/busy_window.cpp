#include "study/report/busy_window.hpp"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/error.hpp"
#include "results/run_tables.hpp"
#include "study/measure/run_series.hpp"

namespace pedzone::study {
namespace {

constexpr double kLongest = 300.0;          // [s] numerical: what fits a page and one looks at
constexpr double kMostPersonSeconds = 6e4;  // numerical: about 200 kB of a page at 2 steps a second

using PersonsByTime = std::map<double, double>;  ///< [s] where a row begins

double persons_from(const PersonsByTime& persons, double begin, double length) {
  double sum = 0.0;
  const auto last = persons.lower_bound(begin + length - kWindow / 2.0);
  for (auto row = persons.lower_bound(begin - kWindow / 2.0); row != last; ++row)
    sum += row->second;
  return sum;
}

/// The first row at which the window with most people begins.
double busiest(const PersonsByTime& persons, double length) {
  double begin = persons.begin()->first, most = -1.0;
  // Not beyond the end, unless the run is shorter.
  const double last = std::max(begin, persons.rbegin()->first + kWindow - length);
  for (const auto& [time, number] : persons) {
    if (time > last) break;
    const double here = persons_from(persons, time, length);
    if (here > most) std::tie(begin, most) = std::pair(time, here);
  }
  return begin;
}

}  // namespace

std::optional<TimeWindow> busiest_window(const std::vector<std::string>& series) try {
  PersonsByTime persons;
  for (const std::string& file : series) {
    series_table().visit(file, [&](const SeriesRow& row, const CsvRow&) {
      persons[row.time] += row.persons.value_or(0.0);
    });
  }
  double length = kLongest;
  const auto too_much = [&] {
    const double sum = persons_from(persons, busiest(persons, length), length) * kWindow;
    return sum > kMostPersonSeconds * static_cast<double>(series.size());
  };
  if (persons.empty()) return std::nullopt;
  while (length > kWindow && too_much()) length /= 2.0;
  const double begin = busiest(persons, length);
  if (persons_from(persons, begin, length) <= 0.0) return std::nullopt;
  return TimeWindow{begin, std::min(begin + length, persons.rbegin()->first + kWindow)};
} catch (const InputError&) {
  return std::nullopt;
}

}  // namespace pedzone::study
