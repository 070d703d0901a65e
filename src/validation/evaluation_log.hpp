// What a calibration has scored so far, in a file, so that a broken-off one goes on.
#pragma once

#include <array>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

namespace pedzone {

/// A CSV file, after a line that tells of what it is: values of the searched parameters, then one
/// misfit for each fold; one evaluation a line, flushed at once. An unfinished last line is
/// dropped.
class EvaluationLog {
 public:
  /// `path` empty: nothing is kept. `source`: another one for other clips or seeds. Throws
  /// InputError when the file has another source or other columns (another search), or cannot be
  /// written.
  EvaluationLog(const std::string& path, const std::string& source,
                const std::vector<std::string>& columns, std::size_t folds);
  ~EvaluationLog();
  EvaluationLog(const EvaluationLog&) = delete;
  EvaluationLog& operator=(const EvaluationLog&) = delete;

  /// Misfits of these values; empty where unknown.
  std::vector<double> find(const std::vector<double>& values) const;
  void append(const std::vector<double>& values, const std::vector<double>& misfits);

 private:
  /// `header`: its first two lines.
  void read(const std::string& path, const std::array<std::string, 2>& header, std::size_t folds);

  std::map<std::string, std::vector<double>> known_;
  std::FILE* file_ = nullptr;
};

}  // namespace pedzone
