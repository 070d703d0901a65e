// CSV (RFC 4180) too large to hold: rows one after the other, from a file, gzipped or not.
#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/xml_stream.hpp"

namespace pedzone {

/// A row below the header. Valid while it is visited.
class CsvRow {
 public:
  CsvRow(const std::string& file, int line, const std::vector<std::string>& header,
         std::span<const std::string> fields)
      : file_(file), line_(line), header_(header), fields_(fields) {}

  /// The field of column `column`, which must be one of the header's.
  const std::string& operator[](std::size_t column) const { return fields_[column]; }
  /// The same as a number within `range`; throws InputError where it is none.
  double number(std::size_t column, const NumberRange& range) const;
  /// The error for a field.
  InputError error(const std::string& problem, std::size_t column,
                   const std::string& allowed = "") const;

 private:
  const std::string& file_;
  int line_;
  const std::vector<std::string>& header_;
  std::span<const std::string> fields_;
};

using RowVisitor = std::function<void(const CsvRow&)>;
/// Told the first line, or nothing of an empty file. Throws InputError where it does not know it.
using HeaderVisitor = std::function<void(const std::vector<std::string>& header)>;

/// Visits all rows in their order. Throws InputError when the file is missing, cannot be
/// decompressed, has another header than `header`, or is cut off, and for a row with another number
/// of fields; passes on what a visitor throws.
void visit_rows(const std::string& file, const std::vector<std::string>& header,
                const RowVisitor& visitor, const ReadProgress& progress = {});

/// The same for any header: `found` is told it, before the first row is visited.
void visit_any_rows(const std::string& file, const HeaderVisitor& found, const RowVisitor& visitor,
                    const ReadProgress& progress = {});

}  // namespace pedzone
