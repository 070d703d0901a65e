#include "model/cautions.hpp"

#include <cmath>

#include "core/random.hpp"
#include "world/parameters.hpp"

namespace pedzone {

void Cautions::draw(const Snapshot& snapshot) {
  const Persons& persons = *snapshot.persons;
  const double spread = snapshot.parameters->margin_spread;
  if (seed_ != snapshot.seed || spread_ != spread) drawn_.clear();
  seed_ = snapshot.seed;
  spread_ = spread;
  const std::size_t known = drawn_.size();
  drawn_.resize(persons.size());
  for (std::size_t i = 0; i < drawn_.size(); ++i) {
    if (i < known && drawn_[i].key == persons.key[i]) continue;
    const double z = random_normal(seed_, persons.key[i], 0, Purpose::kCaution);
    drawn_[i] = {persons.key[i], std::exp(spread * z)};
  }
}

}  // namespace pedzone
