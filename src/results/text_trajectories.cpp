#include "results/text_trajectories.hpp"

#include <fmt/format.h>

#include <iterator>

#include "results/complete_file.hpp"
#include "results/person_numbers.hpp"

namespace pedzone {
namespace {

class TextTrajectories final : public TrajectoryFile {
 public:
  TextTrajectories(const std::string& path, const std::string& option)
      : file_(path, option), ids_(person_ids_file(path), option) {}

  void begin(const TrajectoryHead& head) override;
  void row(const TrajectoryRow& row) override;
  void finish() override;

 private:
  CompleteFile file_, ids_;
  TrajectoryHead head_;
  PersonNumbers numbers_;
  std::string line_;
};

void TextTrajectories::begin(const TrajectoryHead& head) {
  head_ = head;
  // PedPy takes the first number behind `framerate`, and metres from `x/m`.
  file_.write(
      fmt::format("# description: trajectories of pedzone; frame 0 is at {} s of the simulation\n"
                  "# framerate: {} fps\n"
                  "# id frame x/m y/m z/m\n",
                  head.begin, 1.0 / head.step));
}

void TextTrajectories::row(const TrajectoryRow& row) {
  const std::int64_t frame = frame_at(head_, row.time);
  line_.clear();
  fmt::format_to(std::back_inserter(line_), "{} {} {:.4f} {:.4f} 0\n",
                 numbers_.number(row.id, frame), frame, row.x, row.y);
  file_.write(line_);
}

void TextTrajectories::finish() {
  std::string text = numbered_person_table().header();
  for (const NumberedPerson& person : numbers_.all()) numbered_person_table().append(text, person);
  ids_.write(text);
  ids_.finish();
  file_.finish();
}

}  // namespace

std::string person_ids_file(const std::string& path) {
  return path.substr(0, path.rfind(".txt")) + ".ids.csv";
}

std::unique_ptr<TrajectoryFile> make_text_trajectories(const std::string& path,
                                                       const std::string& option) {
  return std::make_unique<TextTrajectories>(path, option);
}

}  // namespace pedzone
