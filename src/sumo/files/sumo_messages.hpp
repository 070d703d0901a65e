// What SUMO prints, line by line. It shares std::cerr and std::cout with whoever runs it.
#pragma once

#include <functional>
#include <ostream>
#include <streambuf>
#include <string>

namespace pedzone {

/// From now until its end, what is written to a stream goes to `take`, one line at a time and
/// without the line's end. To be nested, not to overlap.
class StreamLines : private std::streambuf {
 public:
  StreamLines(std::ostream& stream, std::function<void(const std::string& line)> take);
  ~StreamLines() override;
  StreamLines(const StreamLines&) = delete;
  StreamLines& operator=(const StreamLines&) = delete;

 private:
  int_type overflow(int_type next) override;

  std::ostream& stream_;
  std::streambuf* before_;
  std::function<void(const std::string& line)> take_;
  std::string line_;
};

/// What SUMO tells in warnings and nowhere else. (With its options --no-warnings and
/// --aggregate-warnings not even there.)
struct WarningCounts {
  long emergency_brakings = 0;
  long jam = 0, yield = 0, wrong_lane = 0;  ///< teleports of vehicles that waited too long, by why
  long jammed_persons = 0;                  ///< whom striping lets squeeze through

  /// Takes one line of SUMO's in.
  void read(const std::string& line);
};

}  // namespace pedzone
