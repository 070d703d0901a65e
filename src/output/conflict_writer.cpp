#include "output/conflict_writer.hpp"

#include <fmt/format.h>

#include <array>

#include "core/text.hpp"
#include "output/conflict_columns.hpp"

namespace pedzone {
namespace {

constexpr std::size_t kBuffer = 1 << 20;  // [bytes] numerical: written in pieces of this size

struct NamedReaction {
  const char* name;
  std::optional<Reaction> reaction;
};

/// For testing a protection system: TTC at first detection, at first braking, and at its least.
std::array<NamedReaction, 3> reactions(const Conflict& conflict) {
  const auto least = conflict.ttc ? std::optional(Reaction{conflict.ttc->value, conflict.ttc->time})
                                  : std::nullopt;
  return {{{"PCT", conflict.detection}, {"TBT", conflict.braking}, {"TMT", least}}};
}

const char* yes_or_no(bool value) { return value ? "true" : "false"; }

std::string xml_of(const Conflict& conflict) {
  std::string text = fmt::format(
      "    <conflict begin=\"{:.2f}\" end=\"{:.2f}\" person=\"{}\" vehicle=\"{}\" type=\"{}\" "
      "first=\"{}\"",
      conflict.begin, conflict.end, xml_value(conflict.person), xml_value(conflict.vehicle),
      name_of(conflict.type), name_of(conflict.first));
  if (conflict.aware) text += fmt::format(" aware=\"{}\"", yes_or_no(*conflict.aware));
  text += ">\n";
  for (const ConflictMeasure& measure : kConflictMeasures) {
    const std::optional<Extreme>& extreme = conflict.*measure.extreme;
    if (!extreme) continue;
    text += fmt::format(
        "        <{} time=\"{:.2f}\" position=\"{:.2f},{:.2f}\" type=\"{}\" value=\"{:.2f}\" "
        "personSpeed=\"{:.2f}\" vehicleSpeed=\"{:.2f}\" relativeSpeed=\"{:.2f}\"/>\n",
        measure.name, extreme->time, extreme->position.x(), extreme->position.y(),
        name_of(extreme->type), extreme->value, extreme->person_speed, extreme->vehicle_speed,
        extreme->relative_speed);
  }
  for (const auto& [name, reaction] : reactions(conflict)) {
    if (!reaction) continue;
    text += fmt::format("        <{} time=\"{:.2f}\" value=\"{:.2f}\"/>\n", name, reaction->time,
                        reaction->value);
  }
  return text + "    </conflict>\n";
}

std::string csv_header() {
  std::string text;
  for (const std::string& column : conflict_columns()) text += (text.empty() ? "" : ",") + column;
  return text + "\n";
}

std::string csv_of(const Conflict& conflict) {
  std::string text =
      fmt::format("{},{},{:.2f},{:.2f},{},{},{}", csv_field(conflict.person),
                  csv_field(conflict.vehicle), conflict.begin, conflict.end, name_of(conflict.type),
                  name_of(conflict.first), conflict.aware ? yes_or_no(*conflict.aware) : "");
  for (const ConflictMeasure& measure : kConflictMeasures) {
    const std::optional<Extreme>& extreme = conflict.*measure.extreme;
    if (!extreme) {
      text += ",,,,,,,,";
      continue;
    }
    text += fmt::format(",{:.2f},{:.2f},{:.2f},{:.2f},{},{:.2f},{:.2f},{:.2f}", extreme->value,
                        extreme->time, extreme->position.x(), extreme->position.y(),
                        name_of(extreme->type), extreme->person_speed, extreme->vehicle_speed,
                        extreme->relative_speed);
  }
  for (const auto& [name, reaction] : reactions(conflict)) {
    text += reaction ? fmt::format(",{:.2f},{:.2f}", reaction->value, reaction->time) : ",,";
  }
  return text + "\n";
}

}  // namespace

ConflictWriter::ConflictWriter(const Paths& paths) {
  if (!paths.xml.empty()) {
    xml_.file = std::make_unique<CompleteFile>(paths.xml, paths.xml_option);
    xml_.buffer = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<conflicts>\n";
  }
  if (!paths.csv.empty()) {
    csv_.file = std::make_unique<CompleteFile>(paths.csv, paths.csv_option);
    csv_.buffer = csv_header();
  }
}

void ConflictWriter::write(const Conflict& conflict) {
  if (xml_.file) xml_.buffer += xml_of(conflict);
  if (csv_.file) csv_.buffer += csv_of(conflict);
  for (Sink* sink : {&xml_, &csv_}) {
    if (sink->buffer.size() > kBuffer) sink->flush();
  }
  ++written_;
}

void ConflictWriter::Sink::flush() {
  file->write(buffer);
  buffer.clear();
}

void ConflictWriter::finish() {
  if (xml_.file) xml_.buffer += "</conflicts>\n";
  for (Sink* sink : {&xml_, &csv_}) {
    if (sink->file) sink->flush();
  }
  for (Sink* sink : {&xml_, &csv_}) {
    if (sink->file) sink->file->finish();
  }
}

}  // namespace pedzone
