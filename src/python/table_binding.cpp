#include <pybind11/numpy.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <filesystem>
#include <limits>
#include <unordered_map>
#include <vector>

#include "python/arrays.hpp"
#include "python/bindings.hpp"
#include "python/table_reader.hpp"
#include "results/conflict_table.hpp"
#include "results/crossing_table.hpp"
#include "results/run_tables.hpp"
#include "results/trajectories.hpp"
#include "study/compare/results.hpp"

namespace py = pybind11;
using namespace py::literals;

namespace pedzone {
namespace {

using Columns = std::vector<ColumnInfo>;

bool is_factor(const std::string& column) { return column.starts_with(study::kFactorColumn); }

/// What a file of that header holds. Throws InputError where it is none of pedzone's tables.
Columns columns_of(const std::string& file, const std::vector<std::string>& header) {
  std::vector<std::string> names = header;
  std::erase_if(names, is_factor);
  for (const Columns& known :
       {trajectory_table().infos(), conflict_table().infos(), series_table().infos(),
        density_table().infos(), seen_crossing_table().infos(), study::runs_columns(),
        study::summary_columns()}) {
    if (!std::ranges::equal(names, known, {}, {}, &ColumnInfo::name)) continue;
    Columns columns;
    auto next = known.begin();
    for (const std::string& name : header) {
      columns.push_back(is_factor(name)
                            ? ColumnInfo{name, "", "the factor's level", ColumnKind::kText}
                            : *next++);
    }
    return columns;
  }
  throw InputError(
      "is none of pedzone's tables",
      {.file = file,
       .line = 1,
       .allowed = "trajectories, conflicts, series, density, crossings that were seen, "
                  "runs or summary as CSV"});
}

/// What is read of a column. Texts are kept once each: most are repeated in many rows.
struct Column {
  std::vector<double> numbers;
  std::vector<std::uint32_t> text;  ///< of each row, in `texts`
  std::vector<std::string> texts;
  std::unordered_map<std::string, std::uint32_t> index;

  void add_number(const CsvRow& row, std::size_t c) {
    numbers.push_back(row[c].empty() ? std::numeric_limits<double>::quiet_NaN()
                                     : row.number(c, kAnyNumber));
  }
  void add_text(const std::string& field) {
    const auto [at, is_new] = index.emplace(field, static_cast<std::uint32_t>(texts.size()));
    if (is_new) texts.push_back(field);
    text.push_back(at->second);
  }
};

struct ReadTable {
  Columns infos;
  std::vector<Column> columns;
};

ReadTable read(const std::string& file) {
  ReadTable table;
  visit_any_rows(
      file,
      [&](const std::vector<std::string>& header) {
        table.infos = columns_of(file, header);
        table.columns.resize(header.size());
      },
      [&](const CsvRow& row) {
        for (std::size_t c = 0; c < table.columns.size(); ++c) {
          if (table.infos[c].kind == ColumnKind::kNumeric) {
            table.columns[c].add_number(row, c);
          } else {
            table.columns[c].add_text(row[c]);
          }
        }
      });
  return table;
}

py::object truth_of(const std::string& text) {
  if (text.empty()) return py::none();
  return py::bool_(text == "true");
}

/// An array of objects: texts, or True, False and None.
py::array objects_of(const Column& column, ColumnKind kind) {
  std::vector<py::object> values;
  for (const std::string& text : column.texts) {
    values.push_back(kind == ColumnKind::kTruth ? truth_of(text) : py::object(py::str(text)));
  }
  py::list all(column.text.size());
  for (std::size_t i = 0; i < column.text.size(); ++i) all[i] = values[column.text[i]];
  // Of an empty list NumPy cannot tell what it is of.
  return py::module_::import("numpy").attr("array")(all, "dtype"_a = "object");
}

}  // namespace

py::dict read_table(const std::string& file) {
  ReadTable table;
  {
    const py::gil_scoped_release unlocked;
    table = read(file);
  }
  py::dict arrays;
  for (std::size_t c = 0; c < table.infos.size(); ++c) {
    const ColumnInfo& info = table.infos[c];
    const Column& column = table.columns[c];
    arrays[py::str(info.name)] = info.kind == ColumnKind::kNumeric
                                     ? py::array(array_of(column.numbers))
                                     : objects_of(column, info.kind);
  }
  return arrays;
}

py::list table_columns(const std::string& file) {
  struct Enough {};
  py::list described;
  try {
    visit_any_rows(
        file,
        [&](const std::vector<std::string>& header) {
          for (const ColumnInfo& info : columns_of(file, header)) {
            described.append(py::make_tuple(info.name, info.unit, info.meaning));
          }
          throw Enough();
        },
        [](const CsvRow&) {});
  } catch (const Enough&) {  // the first line is all that is wanted
  }
  return described;
}

void bind_tables(py::module_& module) {
  module.def(
      "read_table", [](const std::filesystem::path& file) { return read_table(file.string()); },
      "file"_a,
      "A table that pedzone has written as CSV (.csv, .csv.gz): a dict of arrays of shape (n,).\n\n"
      "Trajectories, conflicts, and a study's series.csv, density.csv, runs.csv and summary.csv;\n"
      "which one it is, its header tells. Numbers are float64, NaN where a field is empty; texts\n"
      "are str; true and false are True, False, and None where a field is empty.\n"
      "pandas.DataFrame(read_table(file)) is a data frame. Raises InputError.");
  module.def(
      "table_columns",
      [](const std::filesystem::path& file) { return table_columns(file.string()); }, "file"_a,
      "What the columns of such a file are: a list of (name, unit, meaning). Raises InputError.");
}

}  // namespace pedzone
