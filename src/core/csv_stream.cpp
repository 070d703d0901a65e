#include "core/csv_stream.hpp"

#include <algorithm>

#include "core/text.hpp"

namespace pedzone {
namespace {

/// As the first line of a file has it.
std::string header_line(const std::vector<std::string>& names) {
  return separated_list(names, ",");
}

/// Cuts characters into fields and rows.
class RowCutter {
 public:
  RowCutter(const std::string& file, const HeaderVisitor& found, const RowVisitor& visitor)
      : file_(file), found_(found), visitor_(visitor), fields_(1) {}

  void take(char c) {
    if (quoted_) {
      if (c == '\n') ++line_;
      if (c == '"') {
        quoted_ = false;
        after_quote_ = true;
      } else {
        fields_[count_] += c;
      }
      return;
    }
    if (c == '"' && (after_quote_ || fields_[count_].empty())) {
      if (after_quote_) fields_[count_] += c;  // "" is one quote
      quoted_ = true;
    } else if (c == ',') {
      next_field();
    } else if (c == '\n') {
      end_row();
      ++line_;
    } else if (c != '\r') {
      fields_[count_] += c;
    }
    after_quote_ = false;
  }

  void finish() {
    const bool row_open = count_ > 0 || !fields_[0].empty();
    if (quoted_ || (row_open && header_read_ && count_ + 1 < header_.size())) {
      throw error("is cut off: its last row is incomplete", header_line(header_));
    }
    if (row_open) end_row();
    if (!header_read_) found_({});
  }

 private:
  void next_field() {
    ++count_;
    if (count_ == fields_.size()) fields_.emplace_back();
    fields_[count_].clear();
  }

  void end_row() {
    const std::span<const std::string> row(fields_.data(), count_ + 1);
    if (!header_read_) {
      header_.assign(row.begin(), row.end());
      header_[0].erase(0, mark_length(header_[0]));
      found_(header_);
      header_read_ = true;
    } else if (row.size() != header_.size()) {
      throw error("has " + std::to_string(row.size()) + " fields",
                  std::to_string(header_.size()) + " fields: " + header_line(header_));
    } else {
      visitor_(CsvRow(file_, line_, header_, row));
    }
    count_ = 0;
    fields_[0].clear();
  }

  InputError error(const std::string& problem, const std::string& allowed) const {
    return InputError(problem, {file_, line_, "", "", allowed});
  }

  const std::string& file_;
  const HeaderVisitor& found_;
  const RowVisitor& visitor_;
  std::vector<std::string> header_;
  std::vector<std::string> fields_;  ///< kept from row to row for their memory
  std::size_t count_ = 0;            ///< the field that is being read
  int line_ = 1;
  bool header_read_ = false, quoted_ = false, after_quote_ = false;
};

}  // namespace

double CsvRow::number(std::size_t column, const NumberRange& range) const {
  double result = 0.0;
  if (!parse_number(fields_[column], result)) {
    throw error("is not a number", column, describe(range));
  }
  if (result < range.least || result > range.most) {
    throw error("is out of range", column, describe(range));
  }
  return result;
}

InputError CsvRow::error(const std::string& problem, std::size_t column,
                         const std::string& allowed) const {
  return InputError(problem, {file_, line_, "column " + header_[column], fields_[column], allowed});
}

void visit_rows(const std::string& file, const std::vector<std::string>& header,
                const RowVisitor& visitor, const ReadProgress& progress) {
  const auto compare = [&](const std::vector<std::string>& found) {
    if (found == header) return;
    if (found.empty()) {
      throw InputError("is empty", {file, 1, "", "", "a first line '" + header_line(header) + "'"});
    }
    throw InputError(
        "is another header than expected",
        {file, 1, "first line", header_line(found).substr(0, 80), header_line(header)});
  };
  visit_any_rows(file, compare, visitor, progress);
}

void visit_any_rows(const std::string& file, const HeaderVisitor& found, const RowVisitor& visitor,
                    const ReadProgress& progress) {
  GzipFile input(file);
  RowCutter cutter(file, found, visitor);
  std::vector<char> piece(GzipFile::kPiece);
  for (int got = GzipFile::kPiece; got == GzipFile::kPiece;) {
    got = input.read(piece.data(), GzipFile::kPiece);
    std::for_each(piece.begin(), piece.begin() + got, [&](char c) { cutter.take(c); });
    input.tell(progress);
  }
  cutter.finish();
}

}  // namespace pedzone
