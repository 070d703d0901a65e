#include "output/trajectory_writer.hpp"

#include <fmt/format.h>

#include <iterator>

#include "core/text.hpp"

namespace pedzone {
namespace {

constexpr std::size_t kBuffer = 1 << 20;  // [bytes] numerical: written in pieces of this size

}  // namespace

TrajectoryWriter::TrajectoryWriter(const std::string& path, const std::string& option)
    : file_(path, option) {
  buffer_ = "time,id,x,y,vx,vy,heading,motion,activity\n";
}

void TrajectoryWriter::row(double time, std::string_view id, const PersonView& person) {
  fmt::format_to(std::back_inserter(buffer_),
                 "{:.2f},{},{:.3f},{:.3f},{:.3f},{:.3f},{:.3f},{},{}\n", time, csv_field(id),
                 person.position.x(), person.position.y(), person.velocity.x(), person.velocity.y(),
                 person.heading, name_of(person.motion), info_of(person.activity).id);
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
