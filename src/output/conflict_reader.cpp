#include "output/conflict_reader.hpp"

#include <initializer_list>
#include <limits>

#include "core/csv_stream.hpp"
#include "core/text.hpp"
#include "output/conflict_columns.hpp"

namespace pedzone {
namespace {

/// Whatever was written: DRAC knows no bound where the way left is next to nothing.
constexpr NumberRange kNumbers{std::numeric_limits<double>::lowest(),
                               std::numeric_limits<double>::max()};
enum Column { kPerson, kVehicle, kBegin, kEnd, kType, kFirst, kAware, kMeasures };
/// After the first column of a measure.
enum Part { kValue, kTime, kX, kY, kTypeThen, kPersonSpeed, kVehicleSpeed, kRelativeSpeed, kParts };

/// The value of an enum that a field names.
template <class Enum>
Enum named(const CsvRow& row, std::size_t column, std::initializer_list<Enum> values) {
  for (const Enum value : values) {
    if (row[column] == name_of(value)) return value;
  }
  throw row.error("is not known", column,
                  comma_list(values, [](Enum value) { return name_of(value); }));
}

EncounterType type_of(const CsvRow& row, std::size_t column) {
  using enum EncounterType;
  return named(row, column,
               {kHeadOn, kFromBehind, kFollowing, kCrossingLeft, kCrossingRight, kParked});
}

std::optional<Extreme> extreme_of(const CsvRow& row, std::size_t first) {
  if (row[first].empty()) return std::nullopt;
  const auto number = [&](Part part) { return row.number(first + part, kNumbers); };
  return Extreme{number(kValue),           number(kTime),
                 {number(kX), number(kY)}, type_of(row, first + kTypeThen),
                 number(kPersonSpeed),     number(kVehicleSpeed),
                 number(kRelativeSpeed)};
}

std::optional<Reaction> reaction_of(const CsvRow& row, std::size_t first) {
  if (row[first].empty()) return std::nullopt;
  return Reaction{row.number(first, kNumbers), row.number(first + 1, kNumbers)};
}

Conflict conflict_of(const CsvRow& row) {
  Conflict conflict;
  conflict.person = row[kPerson];
  conflict.vehicle = row[kVehicle];
  conflict.begin = row.number(kBegin, kNumbers);
  conflict.end = row.number(kEnd, kNumbers);
  conflict.type = type_of(row, kType);
  conflict.first = named(row, kFirst, {First::kUnknown, First::kPerson, First::kVehicle});
  if (!row[kAware].empty()) conflict.aware = row[kAware] == "true";
  std::size_t column = kMeasures;
  for (const ConflictMeasure& measure : kConflictMeasures) {
    conflict.*measure.extreme = extreme_of(row, column);
    column += kParts;
  }
  conflict.detection = reaction_of(row, column);
  conflict.braking = reaction_of(row, column + 2);
  return conflict;
}

}  // namespace

void visit_conflicts(const std::string& file, const std::function<void(const Conflict&)>& visitor) {
  visit_rows(file, conflict_columns(), [&](const CsvRow& row) { visitor(conflict_of(row)); });
}

}  // namespace pedzone
