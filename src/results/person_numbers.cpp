#include "results/person_numbers.hpp"

namespace pedzone {

const Table<NumberedPerson>& numbered_person_table() {
  constexpr NumberRange kNumbers{1.0, 9e15};
  static const Table<NumberedPerson> table{{
      number_column({"id", "", "whole number in the trajectories"}, &NumberedPerson::number, 0,
                    kNumbers),
      text_column({"person", "", "its id in SUMO"}, &NumberedPerson::person),
  }};
  return table;
}

std::int64_t PersonNumbers::number(std::string_view person, std::int64_t frame) {
  Stay& stay = stays_[std::string(person)];
  if (stay.number == 0 || frame > stay.frame + 1) {
    all_.push_back({static_cast<double>(all_.size() + 1), std::string(person)});
    stay.number = static_cast<std::int64_t>(all_.size());
  }
  stay.frame = frame;
  return stay.number;
}

}  // namespace pedzone
