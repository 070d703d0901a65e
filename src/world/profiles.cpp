#include "world/profiles.hpp"

#include <algorithm>
#include <array>

#include "core/text.hpp"

namespace pedzone {
namespace {

using P = Profile;

constexpr ProfileField kFields[] = {
    {"speed", &P::speed, 0.1, 5.0, "m/s", "preferred walking speed, mean"},
    {"speedDeviation", &P::speed_deviation, 0.0, 2.0, "m/s", "its standard deviation"},
    {"topSpeed", &P::top_speed, 0.1, 5.0, "m/s", "fastest, when running"},
    {"length", &P::length, 0.1, 2.0, "m", "body along its heading"},
    {"width", &P::width, 0.1, 1.5, "m", "body across its heading"},
    {"turnedWidth", &P::turned_width, 0.45, 1.0, "",
     "width with the shoulders turned, over the full one; 1: cannot turn"},
    {"reactionTime", &P::reaction_time, 0.0, 5.0, "s", "until a newly perceived vehicle counts"},
    {"fieldOfView", &P::field_of_view, 10.0, 180.0, "deg", "half angle of sight"},
    {"hearing", &P::hearing, 0.0, 50.0, "m", "how far a moving car is heard"},
    {"awareness", &P::awareness, 0.0, 1.0, "", "share of people who mind vehicles"},
    {"caution", &P::caution, 0.1, 5.0, "", "factor of the clearance wanted to vehicles"},
    {"impulsiveness", &P::impulsiveness, 0.0, 60.0, "1/min",
     "rate of running in front of a vehicle that is near"},
    {"patience", &P::patience, 1.0, 600.0, "s", "blocked for so long, goes on elsewhere"},
    {"share", &P::share, 0.0, 1.0, "",
     "of people made by <pedestrians>, if its `profiles` does not say otherwise"},
    {"guarded", &P::guarded, 0.0, 1.0, "", "1: never alone, in a group with somebody who may be"},
};
constexpr std::size_t kFieldCount = std::size(kFields);

constexpr std::string_view kAssumed = "assumed";
constexpr std::string_view kWeidmann = "Weidmann 1993";
constexpr std::string_view kBohannon = "Bohannon 1997";
constexpr std::string_view kGates = "Gates 2006";
constexpr std::string_view kSumo = "SUMO's person";
constexpr std::string_view kRimea = "RiMEA, impaired";
constexpr std::string_view kModel = "parameter";  // as the parameter of the same name

struct Number {
  double value;
  std::string_view source = kAssumed;
};

struct Row {
  std::string_view id, meaning;
  std::array<Number, kFieldCount> numbers;  ///< in the order of kFields
};

// Means and deviations of speed: Weidmann for young adults; Bohannon's means of people in their
// 40s to 60s; Gates' mean and 15th percentile (1.16 and 0.92 m/s) over 65; RiMEA test 7 for
// wheelchairs (0.46 to 0.76 m/s, taken as mean ± 1.5 deviations). Shares: about those of Germany's
// population (rounded), wheels and prams by guess.
constexpr Row kRows[] = {
    {"infant",
     "0 to 4 years, by the hand of an adult",
     {{{0.8},
       {0.15},
       {1.5},
       {0.2},
       {0.28},
       {0.5, kModel},
       {1.5},
       {60.0},
       {5.0},
       {0.3},
       {1.0},
       {0.0},
       {5.0},
       {0.03},
       {1.0}}}},
    {"child",
     "5 to 12 years",
     {{{1.2},
       {0.2},
       {3.0},
       {0.2},
       {0.35},
       {0.5, kModel},
       {1.2},
       {70.0},
       {8.0, kModel},
       {0.7},
       {0.8},
       {0.0},
       {5.0},
       {0.07},
       {0.0}}}},
    {"preteen",
     "13 and 14 years",
     {{{1.35},
       {0.2},
       {3.5},
       {0.2},
       {0.42},
       {0.5, kModel},
       {0.9},
       {80.0},
       {8.0, kModel},
       {0.9},
       {0.9},
       {0.0},
       {8.0},
       {0.02},
       {0.0}}}},
    {"teenager",
     "15 to 18 years",
     {{{1.4},
       {0.22},
       {4.0},
       {0.215, kSumo},
       {0.45},
       {0.5, kModel},
       {0.7},
       {90.0, kModel},
       {8.0, kModel},
       {0.9},
       {0.9},
       {0.0},
       {10.0},
       {0.04},
       {0.0}}}},
    {"adult",
     "19 to 40 years",
     {{{1.34, kWeidmann},
       {0.26, kWeidmann},
       {3.0},
       {0.215, kSumo},
       {0.478, kSumo},
       {0.5, kModel},
       {0.7},
       {90.0, kModel},
       {8.0, kModel},
       {0.97},
       {1.0, "calibrated"},
       {0.0},
       {10.0, kModel},
       {0.27},
       {0.0}}}},
    {"middle-aged",
     "41 to 65 years",
     {{{1.41, kBohannon},
       {0.18, kBohannon},
       {2.5},
       {0.215, kSumo},
       {0.478, kSumo},
       {0.5, kModel},
       {0.8},
       {90.0, kModel},
       {7.5},
       {0.98},
       {1.0},
       {0.0},
       {12.0},
       {0.34},
       {0.0}}}},
    {"senior",
     "over 65 years",
     {{{1.16, kGates},
       {0.23, kGates},
       {1.9, kBohannon},
       {0.215, kSumo},
       {0.478, kSumo},
       {0.5, kModel},
       {1.2},
       {75.0},
       {4.5},
       {0.97},
       {1.25},
       {0.0},
       {15.0},
       {0.19},
       {0.0}}}},
    {"wheelchair",
     "in a wheelchair",
     {{{0.61, kRimea},
       {0.1, kRimea},
       {1.5},
       {1.1},
       {0.7},
       {1.0},
       {1.0},
       {80.0},
       {7.0},
       {0.98},
       {1.2},
       {0.0},
       {15.0},
       {0.01},
       {0.0}}}},
    {"pram",
     "an adult who pushes a pram",
     {{{1.2},
       {0.2},
       {2.0},
       {1.3},
       {0.6},
       {1.0},
       {0.8},
       {80.0},
       {7.5},
       {0.98},
       {1.4},
       {0.0},
       {12.0},
       {0.02},
       {0.0}}}},
    {"cyclist",
     "an adult who walks beside a bicycle",
     {{{1.25},
       {0.2},
       {2.5},
       {1.7},
       {0.8},
       {1.0},
       {0.7},
       {90.0, kModel},
       {8.0, kModel},
       {0.98},
       {1.1},
       {0.0},
       {10.0},
       {0.01},
       {0.0}}}},
};

Profile profile_of(const Row& row) {
  Profile profile;
  profile.id = row.id;
  profile.meaning = row.meaning;
  for (std::size_t f = 0; f < kFieldCount; ++f) {
    profile.*kFields[f].member = row.numbers[f].value;
  }
  return profile;
}

}  // namespace

std::span<const ProfileField> profile_fields() { return kFields; }

Profiles::Profiles() {
  for (const Row& row : kRows) all_.push_back(profile_of(row));
}

const Profile* Profiles::find(std::string_view id) const {
  const auto found = std::find_if(all_.begin(), all_.end(),
                                  [&](const Profile& profile) { return profile.id == id; });
  return found == all_.end() ? nullptr : &*found;
}

std::string Profiles::ids() const { return comma_list(all_, &Profile::id); }

std::string_view source_of(const Profile& profile, const ProfileField& field) {
  for (const Row& row : kRows) {
    if (row.id != profile.id) continue;
    return row.numbers[static_cast<std::size_t>(&field - kFields)].source;
  }
  return "the zone file";
}

}  // namespace pedzone
