#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "study/measure/measure_list.hpp"
#include "study/report/report_finding.hpp"
#include "study/report/report_numbers.hpp"
#include "study/report/report_parts.hpp"

namespace pedzone::study::report {
namespace {

constexpr std::size_t kMostRows = 2000;  // of the table of everything; more are in summary.csv
constexpr double kMostPercent = 100.0;   // of an axis: what is farther out gets an arrow head
constexpr double kAxes[] = {5, 10, 20, 50, kMostPercent};  // [%]

std::string p_text(const std::optional<double>& p) {
  constexpr double kLeast = 0.001;
  if (!p) return digits_text({});
  return *p < kLeast ? "< 0.001" : fmt::format("{:.3f}", *p);
}

std::string effect_text(const std::optional<double>& effect) {
  constexpr int kDecimals = 2;
  return effect ? signed_text(*effect, kDecimals) : digits_text({});
}

std::string interval_text(const std::optional<Interval>& interval, int decimals) {
  if (!interval) return digits_text({});
  return fmt::format("[{}, {}]", signed_text(interval->low, decimals),
                     signed_text(interval->high, decimals));
}

// Differences with their intervals drawn

/// An interval over an axis from -limit to +limit [%]. Holds no text from outside.
std::string forest_svg(const Comparison& one, double limit) {
  constexpr double kWidth = 220.0, kHeight = 26.0, kRoom = 12.0;
  const auto x = [&](double percent) {
    const double part = std::clamp(percent / limit, -1.0, 1.0);
    return kWidth / 2.0 + part * (kWidth / 2.0 - kRoom);
  };
  std::string svg =
      fmt::format(R"(<svg class="forest {}" viewBox="0 0 {:.0f} {:.0f}" aria-hidden="true">)",
                  finding_class(one), kWidth, kHeight);
  for (const double part : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
    svg += fmt::format(R"(<path class="{}" d="M{:.1f} 0V{:.0f}"/>)", part == 0.0 ? "zero" : "grid",
                       x(part * limit), kHeight);
  }
  const auto percent = percent_of(one);
  if (percent && one.difference.student) {
    const double scale = kMostPercent / std::abs(*one.reference.mean);
    // An interval of differences may reach beyond all there is; a share of it cannot.
    const double low = std::max(-kMostPercent, scale * one.difference.student->low);
    const double high = scale * one.difference.student->high, y = kHeight / 2.0;
    svg += fmt::format(R"(<path class="interval" d="M{:.1f} {:.0f}H{:.1f}"/>)", x(low), y, x(high));
    const auto arrow = [&](double at, double way) {
      return fmt::format(R"(<path class="arrow" d="M{:.1f} {:.0f}l{:.0f} -5v10z"/>)",
                         at + 6.0 * way, y, -6.0 * way);
    };
    if (low < -limit) svg += arrow(x(-limit), -1.0);
    if (high > limit) svg += arrow(x(limit), 1.0);
    if (std::abs(*percent) <= limit) {
      svg +=
          fmt::format(R"(<circle class="mean" cx="{:.1f}" cy="{:.0f}" r="4.5"/>)", x(*percent), y);
    }
  }
  return svg + "</svg>";
}

/// The shortest axis that holds all intervals, as far as an axis goes.
double axis_limit(const std::vector<Comparison>& comparisons) {
  double most = 0.0;
  for (const Comparison& one : comparisons) {
    if (!percent_of(one) || !one.difference.student) continue;
    const double scale = kMostPercent / std::abs(*one.reference.mean);
    most = std::max({most, std::abs(scale * one.difference.student->low),
                     std::abs(scale * one.difference.student->high)});
  }
  const auto* found = std::ranges::find_if(kAxes, [&](double axis) { return axis >= most; });
  return found == std::end(kAxes) ? kMostPercent : *found;
}

Json difference_row(const Comparison& one, double limit) {
  const Measure& measure = *find_measure(one.measure);
  const int decimals = decimals_of(one);
  const auto percent = percent_of(one);
  const bool compared = one.difference.n > 0;
  return {{"name", measure_label(measure)},
          {"unit", std::string(measure.unit)},
          {"reference", mean_text(one.reference, decimals)},
          {"sample", mean_text(one.sample, decimals)},
          {"difference", compared ? signed_text(one.difference.mean, decimals) : digits_text({})},
          {"interval", interval_text(one.difference.student, decimals)},
          {"percent", percent ? signed_percent(*percent) : digits_text({})},
          {"forest_html", forest_svg(one, limit)},
          {"effect", effect_text(one.difference.effect)},
          {"p", p_text(one.p_holm)},
          {"finding", finding_text(one)},
          {"class", finding_class(one)}};
}

Json differences(const Input& input) {
  Json tables = Json::array();
  for (std::size_t i = 0; i < input.plan.conditions.size(); ++i) {
    for (const std::string& model : others(input.plan)) {
      std::vector<Comparison> all = comparisons_of(input.comparisons, i, model);
      std::erase_if(all, [](const Comparison& one) {
        const Measure* measure = find_measure(one.measure);
        return measure == nullptr || !measure->primary;
      });
      const double limit = axis_limit(all);
      Json rows = Json::array();
      std::size_t pairs = 0;
      for (const Comparison& one : all) {
        rows.push_back(difference_row(one, limit));
        pairs = std::max(pairs, one.difference.n);
      }
      tables.push_back(
          {{"condition", input.plan.conditions[i].name},
           {"model", model},
           {"reference", input.plan.study.reference},
           {"pairs", count_text(pairs, "pair of runs", "pairs of runs")},
           {"limit", fmt::format("{:.0f} %", limit)},
           {"rows", rows},
           {"verdict",
            input.plan.conditions.size() > 1 ? condition_verdict(input, i, model) : Json(false)}});
    }
  }
  return tables;
}

// Everything

Json full_row(const Input& input, const Comparison& one, const Measure& measure) {
  const int decimals = decimals_of(one);
  const auto sample = [](const SampleSummary& of) {
    return fmt::format("{} / {} / {}", digits_text(of.mean), digits_text(of.median),
                       digits_text(of.sd));
  };
  return {{"condition", input.plan.conditions[one.condition].name},
          {"model", one.model},
          {"name", measure_label(measure)},
          {"unit", std::string(measure.unit)},
          {"reference", sample(one.reference)},
          {"sample", sample(one.sample)},
          {"pairs", one.difference.n},
          {"difference",
           one.difference.n > 0 ? signed_text(one.difference.mean, decimals) : digits_text({})},
          {"student", interval_text(one.difference.student, decimals)},
          {"bootstrap", interval_text(one.difference.bootstrap, decimals)},
          {"effect", effect_text(one.difference.effect)},
          {"p", p_text(one.difference.p)},
          {"holm", p_text(one.p_holm)},
          {"seeds", one.seeds_needed > 0 ? std::to_string(one.seeds_needed) : digits_text({})},
          {"finding", finding_text(one)},
          {"class", finding_class(one)}};
}

Json everything(const Input& input) {
  const bool all = input.comparisons.size() <= kMostRows;
  Json rows = Json::array();
  for (const Comparison& one : input.comparisons) {
    const Measure* measure = find_measure(one.measure);
    if (measure == nullptr || rows.size() >= kMostRows || !(all || measure->primary)) continue;
    rows.push_back(full_row(input, one, *measure));
  }
  return {{"rows", rows},
          {"cut", rows.size() < input.comparisons.size()},
          {"total", input.comparisons.size()},
          {"shown", rows.size()}};
}

Json glossary(const Input& input) {
  Json groups = Json::array();
  for (const Measure& one : measure_list()) {
    const bool taken = std::ranges::any_of(input.comparisons, [&](const Comparison& comparison) {
      return comparison.measure == one.key;
    });
    if (one.optional && !taken) continue;
    if (groups.empty() || groups.back()["group"] != one.group) {
      groups.push_back({{"group", std::string(one.group)}, {"measures", Json::array()}});
    }
    groups.back()["measures"].push_back({{"name", std::string(one.name)},
                                         {"unit", std::string(one.unit)},
                                         {"primary", one.primary},
                                         {"meaning", std::string(one.meaning)}});
  }
  return groups;
}

}  // namespace

Json tables_part(const Input& input) {
  return {{"differences", differences(input)},
          {"everything", everything(input)},
          {"glossary", glossary(input)}};
}

}  // namespace pedzone::study::report
