// Conflicts in the manner of SUMO's SSM device, and as a table.
#pragma once

#include <memory>
#include <string>

#include "conflict/conflict.hpp"
#include "results/complete_file.hpp"

namespace pedzone {

/// XML: `<conflicts>` with a `<conflict>` each and in it one element for each measure that it has.
/// CSV: a row each, fields empty where it has no such measure. Units are those of Conflict.
class ConflictWriter {
 public:
  /// Files to write and the options that the user named them with; an empty path: not written.
  struct Paths {
    std::string xml, xml_option, csv, csv_option;
  };
  /// Throws InputError when a file cannot be written.
  explicit ConflictWriter(const Paths& paths);

  void write(const Conflict& conflict);
  std::size_t written() const { return written_; }
  void finish();

 private:
  /// One of the two files.
  struct Sink {
    std::unique_ptr<CompleteFile> file;
    std::string buffer;
    void flush();
  };
  Sink xml_, csv_;
  std::size_t written_ = 0;
};

}  // namespace pedzone
