// The tables of a study as CSV.
#include <fmt/format.h>

#include "core/text.hpp"
#include "study/compare/measured.hpp"
#include "study/compare/results.hpp"
#include "study/measure/measure_list.hpp"

namespace pedzone::study {
namespace {

/// A line of CSV in the making.
class Row {
 public:
  Row& text(std::string_view value) {
    if (fields_++ > 0) line_ += ',';
    line_ += csv_field(value);
    return *this;
  }
  /// In as many digits as read back to the same bits.
  Row& number(double value) { return text(fmt::format("{}", value)); }
  Row& number(const std::optional<double>& value) { return value ? number(*value) : text(""); }
  Row& count(std::uint64_t value) { return text(fmt::format("{}", value)); }
  Row& interval(const std::optional<Interval>& value) {
    return value ? number(value->low).number(value->high) : text("").text("");
  }
  Row& truth(bool value) { return text(value ? "true" : "false"); }
  std::string end() const { return line_ + '\n'; }

 private:
  std::string line_;
  std::size_t fields_ = 0;
};

void name_condition(const Plan& plan, Row& row) {
  row.text("scenario");
  for (const Factor& factor : plan.study.factors) row.text("factor." + factor.id);
}

void put_condition(const Plan& plan, std::size_t index, Row& row) {
  const Condition& condition = plan.conditions[index];
  row.text(plan.study.scenarios[condition.scenario].id);
  for (std::size_t factor = 0; factor < plan.study.factors.size(); ++factor) {
    row.text(plan.study.factors[factor].levels[condition.levels[factor]].name);
  }
}

void name_summary(const std::string& whose, Row& row) {
  for (const char* what : {"mean", "median", "sd", "min", "quartile1", "quartile3", "max"}) {
    row.text(whose + '.' + what);
  }
}

void put_summary(const SampleSummary& summary, Row& row) {
  row.number(summary.mean).number(summary.median).number(summary.sd).number(summary.min);
  row.number(summary.quartile1).number(summary.quartile3).number(summary.max);
}

void put_difference(const PairedDifference& difference, Row& row) {
  row.number(difference.n > 0 ? std::optional(difference.mean) : std::nullopt);
  row.number(difference.n > 1 ? std::optional(difference.sd) : std::nullopt);
  row.truth(difference.all_equal);
  row.interval(difference.student).interval(difference.bootstrap);
}

std::string summary_header(const Plan& plan) {
  Row row;
  name_condition(plan, row);
  for (const char* name :
       {"model", "reference", "measure", "unit", "family", "pairs", "missing", "undefined"}) {
    row.text(name);
  }
  name_summary("reference", row);
  name_summary("model", row);
  for (const char* name : {"difference.mean", "difference.sd", "difference.allEqual", "student.low",
                           "student.high", "bootstrap.low", "bootstrap.high", "relative", "effect",
                           "p", "pHolm", "seedsNeeded", "finding"}) {
    row.text(name);
  }
  return row.end();
}

std::string summary_row(const Plan& plan, const Comparison& comparison) {
  const Measure& measure = *find_measure(comparison.measure);
  Row row;
  put_condition(plan, comparison.condition, row);
  row.text(comparison.model).text(plan.study.reference).text(comparison.measure).text(measure.unit);
  row.text(measure.primary ? "primary" : "detail").count(comparison.difference.n);
  row.count(comparison.missing).count(comparison.undefined);
  put_summary(comparison.reference, row);
  put_summary(comparison.sample, row);
  put_difference(comparison.difference, row);
  row.number(comparison.relative).number(comparison.difference.effect);
  row.number(comparison.difference.p).number(comparison.p_holm);
  if (comparison.seeds_needed > 0) {
    row.count(comparison.seeds_needed);
  } else {
    row.text("");
  }
  return row.text(finding_name(comparison.finding)).end();
}

std::string run_row(const Plan& plan, const Records& records, std::size_t condition,
                    const std::string& model, std::uint64_t seed) {
  const auto& record = records[plan.run_of(RunKind::kStudy, condition, model, seed)];
  Row row;
  put_condition(plan, condition, row);
  row.text(model).count(seed).text(table_status(record));
  for (const Measure& measure : measure_list()) {
    row.number(measured(record, std::string(measure.key)));
  }
  return row.end();
}

}  // namespace

std::string runs_csv(const Plan& plan, const Records& records) {
  Row header;
  name_condition(plan, header);
  header.text("model").text("seed").text("status");
  for (const Measure& measure : measure_list()) header.text(measure.key);
  std::string table = header.end();
  for (std::size_t condition = 0; condition < plan.conditions.size(); ++condition) {
    for (const std::string& model : plan.study.models) {
      for (const std::uint64_t seed : plan.study.seeds) {
        table += run_row(plan, records, condition, model, seed);
      }
    }
  }
  return table;
}

std::string summary_csv(const Plan& plan, const std::vector<Comparison>& comparisons) {
  std::string table = summary_header(plan);
  for (const Comparison& comparison : comparisons) table += summary_row(plan, comparison);
  return table;
}

}  // namespace pedzone::study
