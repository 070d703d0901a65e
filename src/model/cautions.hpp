// How much more or less clearance to vehicles a person wants than others do, all its life.
#pragma once

#include <cstdint>
#include <vector>

#include "model/walking_model.hpp"

namespace pedzone {

/// The numbers of those in a snapshot, drawn when somebody is there for the first time.
class Cautions {
 public:
  void draw(const Snapshot& snapshot);

  /// > 0, factor of the clearance; median 1.
  double of(std::size_t person) const { return drawn_[person].factor; }

 private:
  struct Drawn {
    std::uint64_t key;  ///< of the person in this row
    double factor;
  };
  std::vector<Drawn> drawn_;
  std::uint64_t seed_ = 0;
  double spread_ = 0.0;
};

}  // namespace pedzone
