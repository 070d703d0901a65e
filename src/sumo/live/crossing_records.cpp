#include "sumo/live/crossing_records.hpp"

#include <cmath>

namespace pedzone {

CrossingTotals totals_of(const std::vector<StreetCrossed>& crossings) {
  CrossingTotals totals;
  std::vector<GapChoice> choices;
  for (const StreetCrossed& one : crossings) {
    ++totals.crossings;
    totals.mean_wait_s += one.waited;
    if (!one.looked) {
      ++totals.without_looking;
      continue;
    }
    if (one.gap) choices.push_back({*one.gap, true});
    for (const float gap : one.rejected) choices.push_back({gap, false});
  }
  if (totals.crossings > 0) totals.mean_wait_s /= static_cast<double>(totals.crossings);
  totals.gaps = fit_gap_acceptance(choices);
  return totals;
}

void CrossingRecords::take(double time) {
  for (std::size_t z = 0; z < crowds_.size(); ++z) {
    for (const CrossingBegun& begun : crowds_[z]->crossings()) {
      const Guest* const guest = takeover_.guest(z, begun.handle);
      if (guest == nullptr) continue;
      const Street& street = zones_[z].streets[begun.street];
      StreetCrossed row;
      row.time = time;
      row.person = guest->id;
      row.zone = zones_[z].id;
      row.street = street.id;
      row.x = begun.position.x();
      row.y = begun.position.y();
      row.pos = begun.s;
      row.width = begun.width;
      row.waited = begun.waited;
      if (std::isfinite(begun.gap)) row.gap = begun.gap;
      row.needed = begun.needed;
      row.looked = begun.looked;
      row.rejected = begun.rejected;
      all_.push_back(std::move(row));
    }
  }
}

}  // namespace pedzone
