#include "sumo/files/sumo_messages.hpp"

#include <string_view>

namespace pedzone {
namespace {

constexpr std::string_view kBraking = "performs emergency braking";
// ", highway", ", disconnected" or ", bidi" may follow within the brackets. SUMO counts vehicles
// that others block ("blocked") as in a jam.
constexpr std::string_view kJam = "'; waited too long (jam";
constexpr std::string_view kBlocked = "'; waited too long (blocked";
constexpr std::string_view kYield = "'; waited too long (yield";
constexpr std::string_view kWrongLane = "'; waited too long (wrong lane";
constexpr std::string_view kJammed = "is jammed on edge";

bool has(const std::string& line, std::string_view words) {
  return line.find(words) != std::string::npos;
}

}  // namespace

StreamLines::StreamLines(std::ostream& stream, std::function<void(const std::string& line)> take)
    : stream_(stream), before_(stream.rdbuf(this)), take_(std::move(take)) {}

StreamLines::~StreamLines() {
  stream_.rdbuf(before_);
  if (!line_.empty()) take_(line_);
}

StreamLines::int_type StreamLines::overflow(int_type next) {
  if (traits_type::eq_int_type(next, traits_type::eof())) return traits_type::not_eof(next);
  if (next != '\n') {
    line_ += traits_type::to_char_type(next);
    return next;
  }
  std::string line;
  line.swap(line_);
  take_(line);
  return next;
}

void WarningCounts::read(const std::string& line) {
  if (has(line, kBraking)) ++emergency_brakings;
  if (has(line, kJam) || has(line, kBlocked)) ++jam;
  if (has(line, kYield)) ++yield;
  if (has(line, kWrongLane)) ++wrong_lane;
  if (has(line, kJammed)) ++jammed_persons;
}

}  // namespace pedzone
