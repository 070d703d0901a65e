#include "view/level_of_service.hpp"

#include <fmt/format.h>

#include "view/colours.hpp"

namespace pedzone {

std::size_t service_level(double density) {
  std::size_t level = 0;
  while (level + 1 < kServiceLevels.size() && density >= kServiceLevels[level + 1].least) ++level;
  return level;
}

std::string service_colour(std::size_t level) {
  return scale_colour(1.0 - static_cast<double>(level) / (kServiceLevels.size() - 1.0));
}

std::string service_text(std::size_t level) {
  const ServiceLevel& one = kServiceLevels[level];
  if (level + 1 == kServiceLevels.size()) {
    return fmt::format("{}: {:.2f} and more", one.name, one.least);
  }
  const double most = kServiceLevels[level + 1].least;
  if (level == 0) return fmt::format("{}: below {:.2f}", one.name, most);
  return fmt::format("{}: {:.2f} to {:.2f}", one.name, one.least, most);
}

}  // namespace pedzone
