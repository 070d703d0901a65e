#include "app/clock_text.hpp"

#include <fmt/format.h>

namespace pedzone {

std::string clock_text(double seconds) {
  const long whole = static_cast<long>(seconds + 0.5);
  if (whole >= 3600)
    return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
  return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

}  // namespace pedzone
