// What one person is aware of, as the lists that the direction kernel reads.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "model/direction_kernel.hpp"
#include "model/obstacle_lists.hpp"
#include "model/person_grid.hpp"
#include "model/vehicle_view.hpp"
#include "model/walker.hpp"
#include "model/wall_tiles.hpp"

namespace pedzone {

/// Refilled for each person; no allocation once sizes have settled.
class Surroundings {
 public:
  /// Everybody, with straight shoulders.
  void see_persons(const Walker& walker, const Senses& senses, const PersonGrid& grid,
                   const DirectionKernel& kernel);
  /// The same people anew, as they are in the way of somebody who holds its shoulders so, and of
  /// these whoever may be touched within `horizon` [s], at most that of before.
  void see_again(const Walker& walker, const Senses& senses, const Shoulders& shoulders,
                 float horizon, const PersonGrid& grid, const DirectionKernel& kernel);
  void see_walls(const Walker& walker, const WallTiles& walls);
  /// The walls anew, as they are in the way of somebody who has turned its shoulders, and with them
  /// the vehicles that stand.
  void see_walls_turned(const Walker& walker, const WallTiles& walls);
  /// `near`: indices into `vehicles` of those that may matter; `soon` [s]: see threatened();
  /// `minds(index)`: whether the person minds that one, if it perceives it. To be called last.
  template <class Minds>
  void notice_vehicles(const Walker& walker, const Senses& senses,
                       std::span<const VehicleShape> vehicles, std::span<const std::uint32_t> near,
                       float soon, const Minds& minds) {
    forget_vehicles();
    for (const std::uint32_t v : near) {
      if (minds(v)) notice(walker, senses, vehicles[v], soon);
    }
    add_standing(walker);
  }

  /// Lets the task know of everything.
  void fill(DirectionTask& task) const;

  /// Moving vehicles that the person is aware of and that do not let it go first.
  std::span<const VehicleView> vehicles() const { return vehicles_; }
  /// [m] to the nearest vehicle that nobody gives way to, since it stands or lets people go first;
  /// infinity: none.
  float nearest_bar() const { return nearest_bar_; }
  /// Some of them are outside the field of view.
  bool hears_vehicle() const { return hears_vehicle_; }
  /// One of them would run into the person within `soon` if it stood still.
  bool threatened() const { return threatened_; }

  DiscView still_discs() const { return still_discs_.view(); }
  FaceView still_faces() const { return still_faces_.view(); }

 private:
  void forget_vehicles();
  void add_standing(const Walker& walker);
  void notice(const Walker& walker, const Senses& senses, const VehicleShape& vehicle, float soon);

  /// A wall relative to the person.
  struct Segment {
    float h, x;       ///< [m] the person's distance from the line (< 0: behind it), and its foot
                      ///< point along it, counted from its middle
    float distance2;  ///< [m²]
  };
  static Segment segment_of(const WallFace& wall, const LatticePoint& at);
  void add_wall(const Walker& walker, const WallFace& wall, const Segment& segment, float contact);

  /// Room for persons while they are picked out.
  struct Room {
    std::vector<float> x, y, vx, vy, radius, turned, hx, hy;
    SeenSpace space(std::size_t persons, DiscList& discs);
  };

  Seen see(const PersonGrid& grid, std::span<const SlotGroup> groups, const Sight& sight,
           const DirectionKernel& kernel, SlotGroup* met);

  Room near_room_, far_room_;
  DiscList near_persons_, far_persons_, vehicle_discs_, still_discs_;
  FaceList vehicle_faces_, still_faces_;
  std::vector<SlotGroup> groups_;
  std::size_t met_ = 0;  ///< of the groups, after see_persons(): those with anybody to be minded
  std::vector<Segment> segments_;
  std::vector<VehicleView> vehicles_;
  std::vector<VehicleView> standing_;  ///< vehicles in reach
  float nearest_bar_ = std::numeric_limits<float>::infinity();
  bool hears_vehicle_ = false, threatened_ = false;
};

}  // namespace pedzone
