// libtraci with a memory. Each call of libtraci's is a message to SUMO and its answer, so what is
// asked in every step is subscribed to when it is asked for the first time: SUMO then sends it
// with the step. What does not change is asked once. The names are those of libtraci.
//
// A subscription lapses by itself after a while, since to end one would end another client's of
// the same object, too.
#pragma once

#include <libsumo/libtraci.h>

#include <string>
#include <vector>

#include "sumo/files/desired_speeds.hpp"

namespace pedzone::remembered {

/// From now on, of the types that persons have.
void know(const DesiredSpeeds& speeds);

struct Person : libtraci::Person {
  static libsumo::TraCIPosition getPosition(const std::string& id);
  static double getAngle(const std::string& id);
  static double getSpeed(const std::string& id);
  static std::string getRoadID(const std::string& id);
  static std::string getVehicle(const std::string& id);
  static int getRemainingStages(const std::string& id);
  /// Its own; SUMO sends its type's.
  static double getMaxSpeed(const std::string& id);
  /// With the next step, all in one message.
  static void moveToXY(const std::string& id, const std::string& edge, double x, double y,
                       double angle, int keep_route, double match_threshold);
  static double getLength(const std::string& id);
  static double getWidth(const std::string& id);
};

struct Vehicle : libtraci::Vehicle {
  static libsumo::TraCIPosition getPosition(const std::string& id);
  static double getAngle(const std::string& id);
  static double getSpeed(const std::string& id);
  static double getSpeedWithoutTraCI(const std::string& id);
  static double getAllowedSpeed(const std::string& id);
  static double getTimeLoss(const std::string& id);
  static std::string getLaneID(const std::string& id);
  static std::string getRouteID(const std::string& id);
  static double getLateralLanePosition(const std::string& id);
  static int getRouteIndex(const std::string& id);
  static int getStopState(const std::string& id);
  static std::string getTypeID(const std::string& id);
};

struct VehicleType : libtraci::VehicleType {
  /// As it was when it was asked for first.
  static std::string getParameter(const std::string& id, const std::string& key);
};

struct Simulation : libtraci::Simulation {
  static void step();
  static double getTime();
  static int getMinExpectedNumber();
  static int getDepartedPersonNumber();
  static int getArrivedPersonNumber();
  static int getStartingTeleportNumber();
  static int getEmergencyStoppingVehiclesNumber();
  /// libtraci's own tells of none. SUMO tells the two of each that begins, one after the other.
  static std::vector<libsumo::TraCICollision> getCollisions();
  static std::vector<std::string> getDepartedIDList();
  static std::vector<std::string> getEndingTeleportIDList();
  static std::vector<std::string> getArrivedIDList();
  static std::vector<std::string> getPendingVehicles();
};

}  // namespace pedzone::remembered
