// What one person must not walk into, as the arrays that the direction kernel reads. Every
// obstacle is made of two things, discs and faces: a person is a disc, a wall is a face with a disc
// at either end, a vehicle four faces and four discs (the rounded Minkowski sum of its rectangle
// with the walker's body).
//
// The kernel works with u = 1/t, the inverse of the time t [s] until a contact: the first contact
// is the largest u, anything negative or not a number is no contact, and no division is needed.
//
//   disc: relative position p, velocity v, distance R of contact; walker's velocity E, |E| = V
//         γ = 1/max(p² − R², gap),  β = γ·p·(E − v),  α = γ·|E − v|²
//         u = β + √(β² − α)
//   face: l metres to both sides of o along d, outward normal n, gap h − R to the walker's body
//         u = n·(v − E)/gap, a contact where |x·u + d·(E − v)| ≤ l·u
//
//         walker ·
//              h |        n
//         o -----+--------^------ l        x = distance of the walker's foot point from o
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

namespace pedzone {

/// [m²] least p² − R²: two bodies that touch count as 1 mm apart, so that contact "now" stays a
/// number. Numerical: halving it lets rounding (1e-7) show in α of equal velocities.
inline constexpr float kLeastDiscGap = 1e-3F;
/// Share of p² that p² − R² is at least: bodies that touch give way like soft ones, so a contact
/// counts within acos(√share) ≈ 72° of the other's direction. Numerical: with hard bodies a queue
/// in which everybody touches the one ahead and the one behind has no free direction left (seen:
/// nine persons at a wall stood for ever); at half the value people still pass.
inline constexpr float kSoftness = 0.1F;
/// [m] least gap to a face, for the same reason.
inline constexpr float kLeastFaceGap = 1e-3F;
/// [m] a body that touches a wall or vehicle is taken to be this much thinner, so that walking
/// along it, past its joints, is free. Numerical: far above rounding, far below what one sees.
inline constexpr float kSkin = 0.01F;
/// Obstacles are stored and read in groups of this many; the last group is filled up with harmless
/// ones.
inline constexpr std::size_t kObstacleGroup = 8;

/// Discs as seen by one person. V is that person's preferred speed.
struct alignas(32) DiscGroup {
  float px[kObstacleGroup], py[kObstacleGroup];  ///< γ·p
  float q[kObstacleGroup];                       ///< γ·p·v
  float a[kObstacleGroup];                       ///< γ·(V² + v²)
  float wx[kObstacleGroup], wy[kObstacleGroup];  ///< 2·γ·v
};

/// Faces as seen by one person.
struct alignas(32) FaceGroup {
  float nx[kObstacleGroup], ny[kObstacleGroup], nv[kObstacleGroup];  ///< n/gap and n·v/gap
  float dx[kObstacleGroup], dy[kObstacleGroup], dv[kObstacleGroup];  ///< d and d·v
  float x[kObstacleGroup], half_length[kObstacleGroup];              ///< [m]
};

/// The groups of a list, for the kernel.
template <class Group>
struct ObstacleView {
  const Group* groups = nullptr;
  std::size_t size = 0;  ///< obstacles
};
using DiscView = ObstacleView<DiscGroup>;
using FaceView = ObstacleView<FaceGroup>;

/// Obstacles of one kind. Room must be there before they are added.
template <class Group>
struct ObstacleList {
  std::vector<Group> groups;
  std::size_t size = 0;  ///< obstacles

  void clear() { size = 0; }
  /// Room for n obstacles; the kernel reads two groups at once.
  void reserve(std::size_t n) {
    const std::size_t needed = n / kObstacleGroup + 2;
    if (groups.size() < needed) groups.resize(needed);
  }
  ObstacleView<Group> view() const { return {groups.data(), size}; }
};

struct DiscList : ObstacleList<DiscGroup> {
  /// p [m], v [m/s], contact distance R [m], V² [m²/s²].
  void add(float x, float y, float vx, float vy, float contact, float speed_squared) {
    const float apart = x * x + y * y;
    const float soft = kSoftness * apart > kLeastDiscGap ? kSoftness * apart : kLeastDiscGap;
    const float free = apart - contact * contact;
    const float gamma = 1.0F / (free > soft ? free : soft);
    put(gamma * x, gamma * y, gamma * (x * vx + y * vy),
        gamma * (speed_squared + (vx * vx + vy * vy)), 2.0F * gamma * vx, 2.0F * gamma * vy);
  }
  /// Fills the last group up with discs nobody touches.
  void fill_group() {
    const std::size_t n = size;
    while (size % kObstacleGroup != 0) put(0.0F, 0.0F, 0.0F, 1.0F, 0.0F, 0.0F);  // √−1: never
    size = n;
  }

 private:
  void put(float px, float py, float q, float a, float wx, float wy) {
    DiscGroup& g = groups[size / kObstacleGroup];
    const std::size_t i = size++ % kObstacleGroup;
    g.px[i] = px;
    g.py[i] = py;
    g.q[i] = q;
    g.a[i] = a;
    g.wx[i] = wx;
    g.wy[i] = wy;
  }
};

struct FaceList : ObstacleList<FaceGroup> {
  struct Face {
    float nx, ny;          ///< outward unit normal
    float dx, dy;          ///< unit vector along the face
    float vx, vy;          ///< [m/s]
    float gap;             ///< [m] to the walker's body
    float x, half_length;  ///< [m]
  };
  void add(const Face& face) {
    const float inverse = 1.0F / (face.gap > kLeastFaceGap ? face.gap : kLeastFaceGap);
    FaceGroup& g = groups[size / kObstacleGroup];
    const std::size_t i = size++ % kObstacleGroup;
    g.nx[i] = face.nx * inverse;
    g.ny[i] = face.ny * inverse;
    g.nv[i] = (face.nx * face.vx + face.ny * face.vy) * inverse;
    g.dx[i] = face.dx;
    g.dy[i] = face.dy;
    g.dv[i] = face.dx * face.vx + face.dy * face.vy;
    g.x[i] = face.x;
    g.half_length[i] = face.half_length;
  }
  /// Fills the last group up with faces nobody touches.
  void fill_group() {
    for (std::size_t n = size; n % kObstacleGroup != 0; ++n) {
      FaceGroup& g = groups[n / kObstacleGroup];
      const std::size_t i = n % kObstacleGroup;
      g.nx[i] = g.ny[i] = g.nv[i] = 0.0F;  // u = 0: never
      g.dx[i] = g.dy[i] = g.dv[i] = g.x[i] = g.half_length[i] = 0.0F;
    }
  }
};

}  // namespace pedzone
