// Those who take part, found again under their ids from step to step.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "core/text_hash.hpp"

namespace pedzone {

/// What every body in a cast has.
struct CastMember {
  std::string id;
  std::uint64_t serial = 0;  ///< number of the body, never used again; 0: nobody
  std::uint64_t seen = 0;    ///< number of the step in which it was seen last
  std::size_t sample = 0;    ///< index among that step's samples
  std::uint32_t next = 0;    ///< place of the one that came after it in the samples
};

/// Bodies of one kind. Each has a place while it is there; places are used again. Body is a
/// CastMember.
template <typename Body>
class Cast {
 public:
  std::vector<Body> bodies;  ///< by place

  void begin_step() {
    ++step_;
    seen_ = 0;
  }

  /// The place of a body that is there in this step, as sample number `sample`. Samples mostly keep
  /// their order, so that a look at who came next the last time spares the search.
  std::uint32_t take(std::string_view id, std::size_t sample) {
    const bool known = last_ < bodies.size() && bodies[last_].next < bodies.size();
    const std::uint32_t guess = known ? bodies[last_].next : 0;
    const std::uint32_t place = known && bodies[guess].id == id ? guess : search(id);
    if (last_ < bodies.size()) bodies[last_].next = place;
    last_ = place;
    Body& body = bodies[place];
    if (body.seen != step_) ++seen_;
    body.seen = step_;
    body.sample = sample;
    return place;
  }

  bool is_here(std::uint32_t place) const {
    return bodies[place].serial != 0 && bodies[place].seen == step_;
  }

  /// The body of that id, or nullptr; `place` is set to its place.
  const Body* find(std::string_view id, std::uint32_t& place) const {
    const auto known = places_.find(id);
    if (known == places_.end()) return nullptr;
    place = known->second;
    return &bodies[place];
  }

  /// Ends the step: those who were not seen in it are gone.
  void forget_gone() {
    if (seen_ == places_.size()) return;
    for (auto known = places_.begin(); known != places_.end();) {
      if (is_here(known->second)) {
        ++known;
        continue;
      }
      bodies[known->second] = {};
      unused_.push_back(known->second);
      known = places_.erase(known);
    }
  }

 private:
  std::uint32_t search(std::string_view id) {
    const auto known = places_.find(id);
    if (known != places_.end()) return known->second;
    auto place = static_cast<std::uint32_t>(bodies.size());
    if (unused_.empty()) {
      bodies.emplace_back();
    } else {
      place = unused_.back();
      unused_.pop_back();
    }
    bodies[place].id = id;
    bodies[place].serial = ++serials_;
    places_.emplace(std::string(id), place);
    return place;
  }

  std::vector<std::uint32_t> unused_;
  std::unordered_map<std::string, std::uint32_t, TextHash, std::equal_to<>> places_;
  std::uint64_t step_ = 0, serials_ = 0;
  std::uint32_t last_ = 0;  ///< place that was taken last
  std::size_t seen_ = 0;    ///< in this step
};

}  // namespace pedzone
