// The tables of a study as CSV.
#include <fmt/format.h>

#include <type_traits>

#include "results/table.hpp"
#include "study/compare/measured.hpp"
#include "study/compare/results.hpp"
#include "study/measure/measure_list.hpp"

namespace pedzone::study {
namespace {

// Fields

void put(std::string& line, std::string_view text) { line += csv_field(text); }
/// In as many digits as read back to the same bits.
void put(std::string& line, double number) { line += fmt::format("{}", number); }
void put(std::string& line, std::uint64_t count) { line += fmt::format("{}", count); }
void put(std::string& line, bool truth) { line += truth ? "true" : "false"; }
template <class Value>
void put(std::string& line, const std::optional<Value>& value) {
  if (value) put(line, *value);
}

ColumnKind kind_of(std::string_view) { return ColumnKind::kText; }
ColumnKind kind_of(double) { return ColumnKind::kNumeric; }
ColumnKind kind_of(std::uint64_t) { return ColumnKind::kNumeric; }
ColumnKind kind_of(bool) { return ColumnKind::kTruth; }
template <class Value>
ColumnKind kind_of(const std::optional<Value>&) {
  return kind_of(Value{});
}

/// A column that is only written: of what `value` gives for a row.
template <class Row, class Value>
TableColumn<Row> column(ColumnInfo info, Value value) {
  info.kind = kind_of(std::invoke_result_t<Value, const Row&>{});
  return {std::move(info), [value](std::string& line, const Row& row) { put(line, value(row)); }};
}

/// What the condition of index `row.condition` is.
template <class Row>
std::vector<TableColumn<Row>> condition_columns(const Plan& plan) {
  const auto of = [&plan](const Row& row) -> const Condition& {
    return plan.conditions[row.condition];
  };
  std::vector<TableColumn<Row>> columns;
  columns.push_back(column<Row>({"scenario", "", "id"}, [&plan, of](const Row& row) {
    return std::string_view(plan.study.scenarios[of(row).scenario].id);
  }));
  for (std::size_t f = 0; f < plan.study.factors.size(); ++f) {
    columns.push_back(
        column<Row>({kFactorColumn + plan.study.factors[f].id, "", "the factor's level"},
                    [&plan, of, f](const Row& row) {
                      const std::size_t level = of(row).levels[f];
                      return std::string_view(plan.study.factors[f].levels[level].name);
                    }));
  }
  return columns;
}

// Runs

struct RunEntry {
  std::size_t condition;
  const std::string& model;
  std::uint64_t seed;
  const std::optional<RunRecord>& record;
};

Table<RunEntry> runs_table(const Plan& plan) {
  using Row = RunEntry;
  auto columns = condition_columns<Row>(plan);
  columns.push_back(column<Row>({"model", "", "name"},
                                [](const Row& row) { return std::string_view(row.model); }));
  columns.push_back(
      column<Row>({"seed", "", "of the run"}, [](const Row& row) { return row.seed; }));
  columns.push_back(column<Row>({"status", "", "done, failed or missing"},
                                [](const Row& row) { return table_status(row.record); }));
  for (const Measure& measure : measure_list()) {
    const std::string key(measure.key);
    columns.push_back(column<Row>({key, std::string(measure.unit), std::string(measure.meaning)},
                                  [key](const Row& row) { return measured(row.record, key); }));
  }
  return Table<Row>(std::move(columns));
}

// Comparisons

using Columns = std::vector<TableColumn<Comparison>>;

template <class Value>
void add(Columns& columns, ColumnInfo info, Value value) {
  columns.push_back(column<Comparison>(std::move(info), value));
}

void add_what(Columns& columns, const Plan& plan) {
  using Row = Comparison;
  const auto measure = [](const Row& row) -> const Measure& { return *find_measure(row.measure); };
  add(columns, {"model", "", "name"}, [](const Row& row) { return std::string_view(row.model); });
  add(columns, {"reference", "", "model that it is compared with"},
      [&plan](const Row&) { return std::string_view(plan.study.reference); });
  add(columns, {"measure", "", "key"},
      [](const Row& row) { return std::string_view(row.measure); });
  add(columns, {"unit", "", "of the measure"}, [=](const Row& row) { return measure(row).unit; });
  add(columns, {"family", "", "primary or detail"}, [=](const Row& row) {
    return std::string_view(measure(row).primary ? "primary" : "detail");
  });
  add(columns, {"pairs", "", "of runs"}, [](const Row& row) { return row.difference.n; });
  add(columns, {"missing", "", "seeds without a pair: a run failed or is not there"},
      [](const Row& row) { return row.missing; });
  add(columns, {"undefined", "", "seeds without a pair: a run has no such measure"},
      [](const Row& row) { return row.undefined; });
}

void add_summary(Columns& columns, const std::string& whose, SampleSummary Comparison::*summary) {
  const auto add_one = [&](const char* what, std::optional<double> SampleSummary::*value) {
    add(columns, {whose + "." + what, "of the measure", "of the pairs"},
        [=](const Comparison& row) { return row.*summary.*value; });
  };
  add_one("mean", &SampleSummary::mean);
  add_one("median", &SampleSummary::median);
  add_one("sd", &SampleSummary::sd);
  add_one("min", &SampleSummary::min);
  add_one("quartile1", &SampleSummary::quartile1);
  add_one("quartile3", &SampleSummary::quartile3);
  add_one("max", &SampleSummary::max);
}

void add_interval(Columns& columns, const std::string& name,
                  std::optional<Interval> PairedDifference::*interval) {
  const auto add_end = [&](const char* end, double Interval::*value) {
    add(columns, {name + "." + end, "of the measure", "95 % interval of the mean difference"},
        [=](const Comparison& row) {
          const auto& found = row.difference.*interval;
          return found ? std::optional(*found.*value) : std::nullopt;
        });
  };
  add_end("low", &Interval::low);
  add_end("high", &Interval::high);
}

void add_difference(Columns& columns) {
  using Row = Comparison;
  add(columns, {"difference.mean", "of the measure", "model less reference"}, [](const Row& row) {
    return row.difference.n > 0 ? std::optional(row.difference.mean) : std::nullopt;
  });
  add(columns, {"difference.sd", "of the measure", "standard deviation"}, [](const Row& row) {
    return row.difference.n > 1 ? std::optional(row.difference.sd) : std::nullopt;
  });
  add(columns, {"difference.allEqual", "", "the differences do not vary"},
      [](const Row& row) { return row.difference.all_equal; });
  add_interval(columns, "student", &PairedDifference::student);
  add_interval(columns, "bootstrap", &PairedDifference::bootstrap);
}

void add_finding(Columns& columns) {
  using Row = Comparison;
  add(columns, {"relative", "", "mean difference over the reference's mean"},
      [](const Row& row) { return row.relative; });
  add(columns, {"effect", "", "Cohen's d with Hedges' correction"},
      [](const Row& row) { return row.difference.effect; });
  add(columns, {"p", "", "two-sided paired test"}, [](const Row& row) { return row.difference.p; });
  add(columns, {"pHolm", "", "corrected for the family"},
      [](const Row& row) { return row.p_holm; });
  add(columns, {"seedsNeeded", "", "in all, for ± 5 % of the reference's mean"},
      [](const Row& row) {
        return row.seeds_needed > 0 ? std::optional(row.seeds_needed) : std::nullopt;
      });
  add(columns, {"finding", "", "different, hint, notShown, inconclusive, same or tooFew"},
      [](const Row& row) { return finding_name(row.finding); });
  add(columns, {"bound", "", "of a difference of times: exact, atLeast or unknown, as runs end"},
      [](const Row& row) { return bound_name(row.bound); });
}

Table<Comparison> summary_table(const Plan& plan) {
  Columns columns = condition_columns<Comparison>(plan);
  add_what(columns, plan);
  add_summary(columns, "reference", &Comparison::reference);
  add_summary(columns, "model", &Comparison::sample);
  add_difference(columns);
  add_finding(columns);
  return Table<Comparison>(std::move(columns));
}

}  // namespace

std::vector<ColumnInfo> runs_columns() {
  const Plan without_factors;
  return runs_table(without_factors).infos();
}

std::vector<ColumnInfo> summary_columns() {
  const Plan without_factors;
  return summary_table(without_factors).infos();
}

std::string runs_csv(const Plan& plan, const Records& records) {
  const Table<RunEntry> table = runs_table(plan);
  std::string text = table.header();
  for (std::size_t condition = 0; condition < plan.conditions.size(); ++condition) {
    for (const std::string& model : plan.study.models) {
      for (const std::uint64_t seed : plan.study.seeds) {
        const auto& record = records[plan.run_of(RunKind::kStudy, condition, model, seed)];
        table.append(text, {condition, model, seed, record});
      }
    }
  }
  return text;
}

std::string summary_csv(const Plan& plan, const std::vector<Comparison>& comparisons) {
  const Table<Comparison> table = summary_table(plan);
  std::string text = table.header();
  for (const Comparison& comparison : comparisons) table.append(text, comparison);
  return text;
}

}  // namespace pedzone::study
