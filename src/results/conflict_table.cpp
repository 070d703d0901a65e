#include "results/conflict_table.hpp"

#include <initializer_list>

namespace pedzone {
namespace {

using Column = TableColumn<Conflict>;
constexpr int kDigits = 2;  // of all numbers

/// The value of an enum that a field names.
template <class Enum>
Enum named(const CsvRow& fields, std::size_t column, std::initializer_list<Enum> values) {
  for (const Enum value : values) {
    if (fields[column] == name_of(value)) return value;
  }
  throw fields.error("is not known", column,
                     comma_list(values, [](Enum value) { return name_of(value); }));
}

EncounterType type_of(const CsvRow& fields, std::size_t column) {
  using enum EncounterType;
  return named(fields, column,
               {kHeadOn, kFromBehind, kFollowing, kCrossingLeft, kCrossingRight, kParked});
}

void put(std::string& line, double value) { append_number(line, value, kDigits); }

/// Columns of the encounter as a whole.
std::vector<Column> common_columns() {
  return {
      text_column({"person", "", "id"}, &Conflict::person),
      text_column({"vehicle", "", "id"}, &Conflict::vehicle),
      number_column({"begin", "s", "first moment in which it mattered"}, &Conflict::begin, kDigits),
      number_column({"end", "s", "last moment"}, &Conflict::end, kDigits),
      {{"type", "", "how the two move to each other", ColumnKind::kText},
       [](std::string& line, const Conflict& one) { line += name_of(one.type); },
       [](Conflict& one, const CsvRow& fields, std::size_t c) { one.type = type_of(fields, c); }},
      {{"first", "", "who was first at the place of the PET", ColumnKind::kText},
       [](std::string& line, const Conflict& one) { line += name_of(one.first); },
       [](Conflict& one, const CsvRow& fields, std::size_t c) {
         one.first = named(fields, c, {First::kUnknown, First::kPerson, First::kVehicle});
       }},
      {{"aware", "", "the person had noticed the vehicle in time", ColumnKind::kTruth},
       [](std::string& line, const Conflict& one) {
         if (one.aware) line += *one.aware ? "true" : "false";
       },
       [](Conflict& one, const CsvRow& fields, std::size_t c) {
         if (!fields[c].empty()) one.aware = fields[c] == "true";
       }}};
}

/// A number of a measure's extreme, empty where there is none. `value` gives a reference to it.
template <class Value>
Column extreme_column(const ConflictMeasure& measure, const char* part, ColumnInfo info,
                      Value value) {
  info.name = std::string(measure.name) + part;
  const auto extreme = measure.extreme;
  return {std::move(info),
          [=](std::string& line, const Conflict& one) {
            if (const auto& found = one.*extreme) put(line, value(*found));
          },
          [=](Conflict& one, const CsvRow& fields, std::size_t c) {
            if (auto& found = one.*extreme) value(*found) = fields.number(c, kAnyNumber);
          }};
}

void add_measure(std::vector<Column>& columns, const ConflictMeasure& measure) {
  const auto extreme = measure.extreme;
  const auto add = [&](const char* part, const char* unit, const char* meaning, auto value) {
    columns.push_back(extreme_column(measure, part, {"", unit, meaning}, value));
  };
  add(
      "", measure.unit, measure.meaning, [](auto& at) -> auto& { return at.value; });
  // Where it has a value there is an extreme, which the columns after it fill.
  columns.back().read = [extreme](Conflict& one, const CsvRow& fields, std::size_t c) {
    if (!fields[c].empty()) (one.*extreme).emplace().value = fields.number(c, kAnyNumber);
  };
  add(
      "_time", "s", "when", [](auto& at) -> auto& { return at.time; });
  add(
      "_x", "m", "where", [](auto& at) -> auto& { return at.position.x(); });
  add(
      "_y", "m", "the same", [](auto& at) -> auto& { return at.position.y(); });
  columns.push_back({{std::string(measure.name) + "_type", "", "`type` then", ColumnKind::kText},
                     [extreme](std::string& line, const Conflict& one) {
                       if (one.*extreme) line += name_of((one.*extreme)->type);
                     },
                     [extreme](Conflict& one, const CsvRow& fields, std::size_t c) {
                       if (one.*extreme) (one.*extreme)->type = type_of(fields, c);
                     }});
  add(
      "_personSpeed", "m/s", "then", [](auto& at) -> auto& { return at.person_speed; });
  add(
      "_vehicleSpeed", "m/s", "then", [](auto& at) -> auto& { return at.vehicle_speed; });
  add(
      "_relativeSpeed", "m/s", "then", [](auto& at) -> auto& { return at.relative_speed; });
  add(
      "_closingSpeed", "m/s", "then, along the line between the bodies",
      [](auto& at) -> auto& { return at.closing_speed; });
}

/// `kept`: where the reaction stands when it is read; null: it follows from a measure.
void add_reaction(std::vector<Column>& columns, std::size_t index,
                  std::optional<Reaction> Conflict::*kept) {
  const ConflictReaction named = reactions_of({})[index];
  const auto reaction = [index](const Conflict& one) { return reactions_of(one)[index].reaction; };
  columns.push_back(
      {{named.name, "s", named.meaning}, [reaction](std::string& line, const Conflict& one) {
         if (const auto found = reaction(one)) put(line, found->value);
       }});
  columns.push_back({{std::string(named.name) + "_time", "s", "when"},
                     [reaction](std::string& line, const Conflict& one) {
                       if (const auto found = reaction(one)) put(line, found->time);
                     }});
  if (kept == nullptr) return;
  columns[columns.size() - 2].read = [kept](Conflict& one, const CsvRow& fields, std::size_t c) {
    if (!fields[c].empty()) (one.*kept).emplace().value = fields.number(c, kAnyNumber);
  };
  columns.back().read = [kept](Conflict& one, const CsvRow& fields, std::size_t c) {
    if (one.*kept) (one.*kept)->time = fields.number(c, kAnyNumber);
  };
}

}  // namespace

std::array<ConflictReaction, 3> reactions_of(const Conflict& conflict) {
  const auto least = conflict.ttc ? std::optional(Reaction{conflict.ttc->value, conflict.ttc->time})
                                  : std::nullopt;
  return {{{"PCT", "TTC when first on a collision course", conflict.detection},
           {"TBT", "TTC when the vehicle first braked", conflict.braking},
           {"TMT", "TTC at its least", least}}};
}

const Table<Conflict>& conflict_table() {
  static const Table<Conflict> table{[] {
    std::vector<Column> columns = common_columns();
    for (const ConflictMeasure& measure : kConflictMeasures) add_measure(columns, measure);
    add_reaction(columns, 0, &Conflict::detection);
    add_reaction(columns, 1, &Conflict::braking);
    add_reaction(columns, 2, nullptr);
    return columns;
  }()};
  return table;
}

}  // namespace pedzone
