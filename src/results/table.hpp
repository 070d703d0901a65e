// A table as CSV: one list of columns says what is in it, writes it and reads it.
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/csv_stream.hpp"
#include "core/text.hpp"
#include "core/xml.hpp"

namespace pedzone {

/// Any number that a double holds.
inline constexpr NumberRange kAnyNumber{std::numeric_limits<double>::lowest(),
                                        std::numeric_limits<double>::max()};

/// What the fields of a column are; any may be empty where there is no value.
enum class ColumnKind { kNumeric, kText, kTruth };

/// What a column is, for people and for programs that read any table.
struct ColumnInfo {
  std::string name, unit, meaning;
  ColumnKind kind = ColumnKind::kNumeric;
};

/// One column of a table whose rows are `Row`s.
template <class Row>
struct TableColumn {
  ColumnInfo info;
  std::function<void(std::string& line, const Row& row)> write;  ///< appends the field
  /// Takes the value from the field of that index; may be empty where a table is only written.
  std::function<void(Row& row, const CsvRow& fields, std::size_t index)> read = {};
};

/// A number with so many digits behind the point.
void append_number(std::string& line, double number, int digits);

/// The columns as a table of Markdown.
std::string described(const std::vector<ColumnInfo>& columns);

template <class Row>
class Table {
 public:
  /// Called for each row with its fields, which name file and line in errors.
  using Visitor = std::function<void(const Row& row, const CsvRow& fields)>;

  explicit Table(std::vector<TableColumn<Row>> columns) : columns_(std::move(columns)) {
    for (const TableColumn<Row>& column : columns_) names_.push_back(column.info.name);
  }

  const std::vector<std::string>& names() const { return names_; }

  /// The first line.
  std::string header() const { return comma_separated(names_) + '\n'; }

  void append(std::string& text, const Row& row) const {
    const char* comma = "";
    for (const TableColumn<Row>& column : columns_) {
      text += std::exchange(comma, ",");
      column.write(text, row);
    }
    text += '\n';
  }

  /// Visits all rows of a file. Throws InputError as visit_rows(), and where a field is not what
  /// its column holds.
  void visit(const std::string& file, const Visitor& visitor,
             const ReadProgress& progress = {}) const {
    visit_rows(
        file, names_,
        [&](const CsvRow& fields) {
          Row row{};
          for (std::size_t c = 0; c < columns_.size(); ++c) {
            if (columns_[c].read) columns_[c].read(row, fields, c);
          }
          visitor(row, fields);
        },
        progress);
  }

  std::vector<ColumnInfo> infos() const {
    std::vector<ColumnInfo> all;
    for (const TableColumn<Row>& column : columns_) all.push_back(column.info);
    return all;
  }

 private:
  static std::string comma_separated(const std::vector<std::string>& names) {
    return separated_list(names, ",", csv_field);
  }

  std::vector<TableColumn<Row>> columns_;
  std::vector<std::string> names_;
};

// Columns of common kinds

/// Text, quoted where it has to be.
template <class Row, class Text>
TableColumn<Row> text_column(ColumnInfo info, Text Row::*member) {
  info.kind = ColumnKind::kText;
  return {std::move(info),
          [member](std::string& line, const Row& row) { line += csv_field(row.*member); },
          [member](Row& row, const CsvRow& fields, std::size_t c) { row.*member = fields[c]; }};
}

/// A number with so many digits behind the point.
template <class Row>
TableColumn<Row> number_column(ColumnInfo info, double Row::*member, int digits,
                               NumberRange range = kAnyNumber) {
  return {std::move(info),
          [=](std::string& line, const Row& row) { append_number(line, row.*member, digits); },
          [=](Row& row, const CsvRow& fields, std::size_t c) {
            row.*member = fields.number(c, range);
          }};
}

/// Numbers, one after the other with blanks between.
template <class Row, class Number>
TableColumn<Row> list_column(ColumnInfo info, std::vector<Number> Row::*member, int digits) {
  info.kind = ColumnKind::kText;
  return {std::move(info),
          [=](std::string& line, const Row& row) {
            const char* blank = "";
            for (const Number number : row.*member) {
              line += std::exchange(blank, " ");
              append_number(line, static_cast<double>(number), digits);
            }
          },
          [=](Row& row, const CsvRow& fields, std::size_t c) {
            for (const std::string& word : split_words(fields[c])) {
              double number = 0.0;
              if (!parse_number(word, number)) {
                throw fields.error("is no list of numbers", c, "numbers with blanks between");
              }
              (row.*member).push_back(static_cast<Number>(number));
            }
          }};
}

/// The same; the field is empty where there is no number.
template <class Row>
TableColumn<Row> number_column(ColumnInfo info, std::optional<double> Row::*member, int digits,
                               NumberRange range = kAnyNumber) {
  return {std::move(info),
          [=](std::string& line, const Row& row) {
            if (const auto& value = row.*member) append_number(line, *value, digits);
          },
          [=](Row& row, const CsvRow& fields, std::size_t c) {
            if (!fields[c].empty()) row.*member = fields.number(c, range);
          }};
}

}  // namespace pedzone
