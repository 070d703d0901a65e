#include "results/crossing_table.hpp"

namespace pedzone {
namespace {

constexpr int kDigits = 2;  // of all numbers

std::vector<TableColumn<StreetCrossed>> walked_columns() {
  using Row = StreetCrossed;
  return {number_column({"time", "s", "when it stepped out"}, &Row::time, kDigits),
          text_column({"person", "", "id"}, &Row::person),
          text_column({"zone", "", "id"}, &Row::zone),
          text_column({"street", "", "id of its first edge"}, &Row::street),
          number_column({"x", "m", "where it stepped out"}, &Row::x, kDigits),
          number_column({"y", "m", "where it stepped out"}, &Row::y, kDigits),
          number_column({"pos", "m", "the same, along the street"}, &Row::pos, kDigits),
          number_column({"width", "m", "of the carriageway"}, &Row::width, kDigits),
          number_column({"waited", "s", "at the kerb"}, &Row::waited, kDigits),
          number_column({"gap", "s", "until the next vehicle came; empty where none was seen"},
                        &Row::gap, kDigits),
          number_column({"needed", "s", "critical gap: width / speed + start-up + margin"},
                        &Row::needed, kDigits),
          {{"looked", "", "false: stepped out without looking", ColumnKind::kTruth},
           [](std::string& line, const Row& row) { line += row.looked ? "true" : "false"; },
           [](Row& row, const CsvRow& fields, std::size_t c) { row.looked = fields[c] == "true"; }},
          list_column({"rejected", "s", "gaps that it had let pass, one after the other"},
                      &Row::rejected, kDigits)};
}

std::vector<TableColumn<SeenCrossing>> seen_columns() {
  using Row = SeenCrossing;
  return {
      text_column({"person", "", "id"}, &Row::person),
      {{"place", "", "`between` the junctions, or at a `junction`", ColumnKind::kText},
       [](std::string& line, const Row& row) { line += row.between ? "between" : "junction"; },
       [](Row& row, const CsvRow& fields, std::size_t c) { row.between = fields[c] == "between"; }},
      number_column({"begin", "s", "when it came to the one side"}, &Row::begin, kDigits),
      number_column({"end", "s", "when it came to the other"}, &Row::end, kDigits),
      number_column({"waited", "s", "standing at the kerb"}, &Row::waited, kDigits),
      number_column({"gap", "s", "that was taken; empty: no vehicle came after"}, &Row::gap,
                    kDigits),
      list_column({"let_pass", "s", "gaps, one after the other"}, &Row::let_pass, kDigits),
      number_column({"near_conflicts", "",
                     "with moving vehicles, on the half of the carriageway that it came to first"},
                    &Row::near_conflicts, 0),
      number_column({"far_conflicts", "", "the same on the other half"}, &Row::far_conflicts, 0)};
}

}  // namespace

const Table<StreetCrossed>& crossing_table() {
  static const Table<StreetCrossed> table(walked_columns());
  return table;
}

const Table<SeenCrossing>& seen_crossing_table() {
  static const Table<SeenCrossing> table(seen_columns());
  return table;
}

}  // namespace pedzone
