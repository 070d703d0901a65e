#include "results/conflict_writer.hpp"

#include <fmt/format.h>

#include "core/text.hpp"
#include "results/conflict_table.hpp"

namespace pedzone {
namespace {

constexpr std::size_t kBuffer = 1 << 20;  // [bytes] numerical: written in pieces of this size

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
        "personSpeed=\"{:.2f}\" vehicleSpeed=\"{:.2f}\" relativeSpeed=\"{:.2f}\" "
        "closingSpeed=\"{:.2f}\"/>\n",
        measure.name, extreme->time, extreme->position.x(), extreme->position.y(),
        name_of(extreme->type), extreme->value, extreme->person_speed, extreme->vehicle_speed,
        extreme->relative_speed, extreme->closing_speed);
  }
  for (const auto& [name, meaning, reaction] : reactions_of(conflict)) {
    if (!reaction) continue;
    text += fmt::format("        <{} time=\"{:.2f}\" value=\"{:.2f}\"/>\n", name, reaction->time,
                        reaction->value);
  }
  return text + "    </conflict>\n";
}

}  // namespace

ConflictWriter::ConflictWriter(const Paths& paths) {
  if (!paths.xml.empty()) {
    xml_.file = std::make_unique<CompleteFile>(paths.xml, paths.xml_option);
    xml_.buffer = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<conflicts>\n";
  }
  if (!paths.csv.empty()) {
    csv_.file = std::make_unique<CompleteFile>(paths.csv, paths.csv_option);
    csv_.buffer = conflict_table().header();
  }
}

void ConflictWriter::write(const Conflict& conflict) {
  if (xml_.file) xml_.buffer += xml_of(conflict);
  if (csv_.file) conflict_table().append(csv_.buffer, conflict);
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
