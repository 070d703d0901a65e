#include "study/measure/demand_signature.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/text.hpp"
#include "study/plan/checksum.hpp"

namespace pedzone::study {
namespace {

template <typename Trip>
std::string signature(const std::vector<Trip>& trips) {
  std::vector<std::string> lines;
  for (const Trip& trip : trips) {
    // SUMO counts whole milliseconds.
    lines.push_back(
        fmt::format("{},{},{:.3f}\n", csv_field(trip.id), csv_field(trip.type), trip.due));
  }
  std::ranges::sort(lines);
  std::string text;
  for (const std::string& line : lines) text += line;
  return sha256_hex(text);
}

}  // namespace

std::map<std::string, std::string> demand_signature(const Trips& trips) {
  return {{"persons", signature(trips.persons)}, {"vehicles", signature(trips.vehicles)}};
}

}  // namespace pedzone::study
