#include "output/trajectory_writer.hpp"

#include <fmt/format.h>

#include <iterator>

namespace pedzone {
namespace {

constexpr std::size_t kBuffer = 1 << 20;  // [bytes] numerical: written in pieces of this size

std::string quoted(std::string_view text) {
  if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"') out += '"';
    out += c;
  }
  return out + "\"";
}

}  // namespace

TrajectoryWriter::TrajectoryWriter(const std::string& path, const std::string& option)
    : file_(path, option) {
  buffer_ = "time,id,x,y,vx,vy,heading,activity\n";
}

void TrajectoryWriter::row(double time, std::string_view id, const PersonView& person) {
  fmt::format_to(std::back_inserter(buffer_), "{:.2f},{},{:.3f},{:.3f},{:.3f},{:.3f},{:.3f},{}\n",
                 time, quoted(id), person.position.x(), person.position.y(), person.velocity.x(),
                 person.velocity.y(), person.heading, name_of(person.activity));
  if (buffer_.size() > kBuffer) flush();
}

void TrajectoryWriter::flush() {
  file_.write(buffer_);
  buffer_.clear();
}

void TrajectoryWriter::finish() {
  flush();
  file_.finish();
}

}  // namespace pedzone
