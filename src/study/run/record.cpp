#include "study/run/record.hpp"

#include <array>
#include <cmath>
#include <fstream>
#include <utility>

#include "core/error.hpp"

namespace pedzone::study {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::pair<RunStatus, const char*>, 3> kStatuses = {
    {{RunStatus::kDone, "done"}, {RunStatus::kFailed, "failed"}, {RunStatus::kKilled, "killed"}}};

RunStatus status_of(const std::string& name) {
  for (const auto& [status, known] : kStatuses) {
    if (name == known) return status;
  }
  throw std::invalid_argument("status '" + name + "' is not known");
}

RunRecord from_json(const Json& json) {
  RunRecord record;
  json.at("id").get_to(record.id);
  record.status = status_of(json.at("status").get<std::string>());
  json.at("failure").get_to(record.failure);
  record.definition = json.at("definition");
  json.at("inputs").get_to(record.inputs);
  json.at("versions").get_to(record.versions);
  json.at("commands").get_to(record.commands);
  json.at("measures").get_to(record.measures);
  json.at("demand").get_to(record.demand);
  json.at("attempts").get_to(record.attempts);
  json.at("wall_s").get_to(record.wall_s);
  return record;
}

}  // namespace

const char* status_name(RunStatus status) {
  for (const auto& [known, name] : kStatuses) {
    if (status == known) return name;
  }
  return "";
}

std::string record_text(const RunRecord& record) {
  Json measures = Json::object();
  for (const auto& [key, value] : record.measures) {
    if (std::isfinite(value)) measures[key] = value;  // JSON has no other numbers
  }
  Json json;
  json["format"] = kStudyFormat;
  json["id"] = record.id;
  json["status"] = status_name(record.status);
  json["failure"] = record.failure;
  json["definition"] = record.definition;
  json["inputs"] = record.inputs;
  json["versions"] = record.versions;
  json["commands"] = record.commands;
  json["measures"] = std::move(measures);
  json["demand"] = record.demand;
  json["attempts"] = record.attempts;
  json["wall_s"] = record.wall_s;
  // Logs and file names need not be UTF-8.
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

RunRecord read_record(const std::string& file) {
  const auto refuse = [&file](const std::string& problem) {
    return InputError(problem, {.file = file, .allowed = "a record written by pedzone study run"});
  };
  std::ifstream in(file);
  if (!in) throw refuse("cannot be read");
  try {
    const Json json = Json::parse(in);
    const int format = json.at("format");
    if (format != kStudyFormat) {
      throw InputError("is of another format",
                       {file, 0, "format", std::to_string(format), std::to_string(kStudyFormat)});
    }
    return from_json(json);
  } catch (const Json::exception& error) {
    throw refuse(std::string("is no record (") + error.what() + ")");
  } catch (const std::invalid_argument& error) {
    throw refuse(std::string("is no record (") + error.what() + ")");
  }
}

}  // namespace pedzone::study
