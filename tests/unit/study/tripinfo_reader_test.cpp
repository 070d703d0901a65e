#include "study/measure/tripinfo_reader.hpp"

#include <gmock/gmock.h>

#include "core/error.hpp"
#include "study/measure/demand_signature.hpp"
#include "study/measure/trip_measures.hpp"
#include "study/plan/checksum.hpp"
#include "temporary_file.hpp"

namespace pedzone::study {
namespace {

/// As SUMO 1.15 writes it (attributes that are not read left out), the run ended at 40 s: a person
/// at its destination, one under way with a ride to come, one that has come to its last stop, one
/// that was not due before the end; a vehicle that arrived, one under way, one that found no room
/// to depart.
constexpr const char* kTripinfo = R"(<tripinfos>
  <personinfo id="p2" depart="3.000" type="adult" speedFactor="1.01">
    <walk depart="3.000" arrival="10.900" duration="7.900" timeLoss="0.774" maxSpeed="1.4"/>
    <stop duration="5.000" arrival="15.900" arrivalPos="10" actType="waiting"/>
    <walk depart="15.900" arrival="39.800" duration="23.900" timeLoss="2.522" maxSpeed="1.4"/>
  </personinfo>
  <personinfo id="p0" depart="0.467" type="senior@p0" speedFactor="1.06">
    <walk depart="0.500" arrival="-1" duration="39.500" timeLoss="0" maxSpeed="1.5"/>
    <ride waitingTime="-1" vehicle="NULL" depart="-1" arrival="-1" duration="-1"/>
    <walk depart="-1" arrival="-1" duration="-1" timeLoss="0" maxSpeed="1.5"/>
  </personinfo>
  <personinfo id="p3" depart="5.000" type="adult" speedFactor="1">
    <walk depart="5.000" arrival="30.000" duration="25.000" timeLoss="1.000" maxSpeed="1.2"/>
    <stop duration="10.000" arrival="-0.001" arrivalPos="10" actType="waiting"/>
  </personinfo>
  <personinfo id="p1" depart="40.000" type="adult" speedFactor="1.1"/>
  <tripinfo id="v0" depart="5.200" departDelay="0.200" arrival="25.000" timeLoss="4.800"
            vType="bus@v0" vaporized=""/>
  <tripinfo id="v1" depart="6.000" departDelay="0.000" arrival="20.000" timeLoss="3.000"
            vType="van" vaporized="collision"/>
  <tripinfo id="v2" depart="-1" departDelay="33.000" arrival="-1.000" timeLoss="0.000"
            vType="van"/>
</tripinfos>)";

TEST(Tripinfo, tells_who_was_to_travel_when_and_what_became_of_it) {
  const TemporaryFile file("xml", kTripinfo);
  const Trips trips = read_tripinfo(file.path());
  ASSERT_EQ(trips.persons.size(), 4U);
  const PersonTrip &under_way = trips.persons[0], &there = trips.persons[2];
  EXPECT_EQ(under_way.id, "p0");
  EXPECT_EQ(under_way.type, "senior") << "SUMO's name for what a program changed in one person";
  EXPECT_EQ(under_way.due, 0.467) << "not when the step came";
  EXPECT_FALSE(under_way.arrival);
  ASSERT_EQ(under_way.walks.size(), 1U) << "the walk after the ride was not begun";
  EXPECT_FALSE(under_way.walks[0].arrival);
  EXPECT_EQ(there.arrival, 39.8);
  EXPECT_EQ(trips.persons[3].arrival, 30.0) << "a stop at the end is no travel";
  ASSERT_EQ(there.walks.size(), 2U);
  EXPECT_EQ(there.walks[1].depart, 15.9);
  EXPECT_EQ(there.walks[1].arrival, 39.8);
  EXPECT_EQ(there.walks[1].max_speed, 1.4);
}

TEST(Tripinfo, who_was_due_before_the_end_counts_departed_or_not) {
  const TemporaryFile file("xml", kTripinfo);
  Trips trips = read_tripinfo(file.path());
  settle(trips, 40.0);
  ASSERT_EQ(trips.persons.size(), 3U) << "p1 was due at the end";
  ASSERT_EQ(trips.vehicles.size(), 3U);
  EXPECT_DOUBLE_EQ(trips.vehicles[0].due, 5.0);
  EXPECT_DOUBLE_EQ(trips.vehicles[2].due, 7.0);

  std::map<std::string, double> values;
  measure_trips(trips, 40.0, values);
  EXPECT_EQ(values["person.count"], 3.0);
  EXPECT_DOUBLE_EQ(values["person.arrived"], 2.0 / 3);
  EXPECT_DOUBLE_EQ(values["person.travelTime"], ((40.0 - 0.467) + (39.8 - 3.0) + (30 - 5)) / 3);
  // Of 25, 36.8 and 39.533 s: the 85th percentile is 0.7 of the way between the last two.
  EXPECT_NEAR(values["person.travelTime85"], 36.8 + 0.7 * (39.533 - 36.8), 1e-9);
  EXPECT_NEAR(values["person.travelTime95"], 36.8 + 0.9 * (39.533 - 36.8), 1e-9);
  EXPECT_EQ(values["vehicle.count"], 3.0);
  EXPECT_DOUBLE_EQ(values["vehicle.arrived"], 1.0 / 3);
  EXPECT_DOUBLE_EQ(values["vehicle.travelTime"], ((25 - 5) + (40 - 6) + (40 - 7)) / 3.0);
  EXPECT_DOUBLE_EQ(values["vehicle.delay"], ((0.2 + 4.8) + 3 + 33) / 3.0);
}

TEST(Tripinfo, demand_is_the_same_whatever_became_of_it) {
  const TemporaryFile file("xml", kTripinfo);
  Trips trips = read_tripinfo(file.path());
  settle(trips, 40.0);
  const auto demand = demand_signature(trips);
  EXPECT_EQ(demand.at("persons"), sha256_hex("p0,senior,0.467\np2,adult,3.000\np3,adult,5.000\n"));
  EXPECT_EQ(demand.at("vehicles"), sha256_hex("v0,bus,5.000\nv1,van,6.000\nv2,van,7.000\n"));
}

TEST(Tripinfo, a_run_without_vehicles_has_no_mean_of_them) {
  std::map<std::string, double> values;
  measure_trips({}, 40.0, values);
  EXPECT_THAT(values, testing::UnorderedElementsAre(testing::Pair("person.count", 0.0),
                                                    testing::Pair("vehicle.count", 0.0)));
}

TEST(Tripinfo, a_file_that_is_cut_off_is_refused) {
  const std::string text = kTripinfo;
  const TemporaryFile file("xml", text.substr(0, text.size() / 2));
  EXPECT_THROW(read_tripinfo(file.path()), InputError);
  EXPECT_THROW(read_tripinfo(file.path() + ".none"), InputError);
  const TemporaryFile other("other", "<fcd-export/>");
  EXPECT_THROW(read_tripinfo(other.path()), InputError);
}

}  // namespace
}  // namespace pedzone::study
