#include "validation/evaluation_log.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "core/error.hpp"

namespace pedzone {
namespace {

std::string joined(const std::vector<double>& values) {
  return fmt::format("{}", fmt::join(values, ","));
}

}  // namespace

EvaluationLog::EvaluationLog(const std::string& path, const std::string& source,
                             const std::vector<std::string>& columns, std::size_t folds) {
  if (path.empty()) return;
  const std::array<std::string, 2> header{"# " + source,
                                          fmt::format("{}", fmt::join(columns, ","))};
  read(path, header, folds);
  // Written anew without an unfinished last line, then appended to.
  file_ = std::fopen(path.c_str(), "w");
  if (file_ == nullptr) {
    throw InputError(std::string("cannot be written: ") + std::strerror(errno),
                     {path, 0, "", "", "a file in a folder that may be written to"});
  }
  fmt::print(file_, "{}\n{}\n", header[0], header[1]);
  for (const auto& [values, misfits] : known_)
    fmt::print(file_, "{},{}\n", values, joined(misfits));
  std::fflush(file_);
}

EvaluationLog::~EvaluationLog() {
  if (file_ != nullptr) std::fclose(file_);
}

void EvaluationLog::read(const std::string& path, const std::array<std::string, 2>& header,
                         std::size_t folds) {
  std::ifstream stream(path);
  std::string line;
  for (const std::string& wanted : header) {
    if (!std::getline(stream, line)) return;
    if (line == wanted) continue;
    throw InputError(
        "is of another search, other clips or seeds: take another folder, or remove it",
        {path, 0, "header", line, wanted});
  }
  while (std::getline(stream, line) && !stream.eof()) {
    std::size_t cut = line.size();
    for (std::size_t f = 0; f < folds && cut != std::string::npos; ++f) {
      cut = cut > 0 ? line.rfind(',', cut - 1) : std::string::npos;
    }
    if (cut == std::string::npos) continue;
    std::vector<double> misfits;
    const char* at = line.c_str() + cut;
    while (*at == ',') {
      char* end = nullptr;
      misfits.push_back(std::strtod(at + 1, &end));
      at = end;
    }
    if (misfits.size() == folds) known_[line.substr(0, cut)] = std::move(misfits);
  }
}

std::vector<double> EvaluationLog::find(const std::vector<double>& values) const {
  const auto found = known_.find(joined(values));
  return found != known_.end() ? found->second : std::vector<double>();
}

void EvaluationLog::append(const std::vector<double>& values, const std::vector<double>& misfits) {
  known_[joined(values)] = misfits;
  if (file_ == nullptr) return;
  fmt::print(file_, "{},{}\n", joined(values), joined(misfits));
  std::fflush(file_);
}

}  // namespace pedzone
