#include "study/compare/measured.hpp"

#include <cmath>

namespace pedzone::study {

bool is_done(const std::optional<RunRecord>& record) {
  return record && record->status == RunStatus::kDone;
}

std::string_view table_status(const std::optional<RunRecord>& record) {
  if (is_done(record)) return "done";
  return record && record->status == RunStatus::kFailed ? "failed" : "missing";
}

std::optional<double> measured(const std::optional<RunRecord>& record, const std::string& key) {
  if (!is_done(record)) return std::nullopt;
  const auto found = record->measures.find(key);
  if (found == record->measures.end() || !std::isfinite(found->second)) return std::nullopt;
  return found->second;
}

}  // namespace pedzone::study
