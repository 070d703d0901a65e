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

/// [m/s] slower than this a vehicle is parked, a person stands: static obstacles. From the issue
/// this model was built for; SUMO's own threshold for halting is 0.1 m/s.
inline constexpr float kStandingSpeed = 0.05F;

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
/// Discs and faces are read in groups of this many; the arrays are filled up with harmless ones.
inline constexpr std::size_t kObstacleGroup = 8;

/// The arrays of a DiscList, for the kernel.
struct DiscView {
  const float *px, *py, *q, *a, *wx, *wy;
  std::size_t size;
};

/// The same, to be filled.
struct DiscSpace {
  float *px, *py, *q, *a, *wx, *wy;
};

/// The arrays of a FaceList.
struct FaceView {
  const float *nx, *ny, *nv, *dx, *dy, *dv, *x, *half_length;
  std::size_t size;
};

/// Discs as seen by one person. V is that person's preferred speed.
struct DiscList {
  std::vector<float> px, py;  ///< γ·p
  std::vector<float> q;       ///< γ·p·v
  std::vector<float> a;       ///< γ·(V² + v²)
  std::vector<float> wx, wy;  ///< 2·γ·v
  std::size_t size = 0;

  void clear() { size = 0; }
  void reserve(std::size_t n);  ///< room for n discs; before they are added
  /// p [m], v [m/s], contact distance R [m], V² [m²/s²].
  void add(float x, float y, float vx, float vy, float contact, float speed_squared);
  void fill_group();  ///< up to the next multiple of kObstacleGroup with discs nobody touches
  DiscView view() const {
    return {px.data(), py.data(), q.data(), a.data(), wx.data(), wy.data(), size};
  }
  DiscSpace space() { return {px.data(), py.data(), q.data(), a.data(), wx.data(), wy.data()}; }
};

/// Faces as seen by one person.
struct FaceList {
  std::vector<float> nx, ny, nv;      ///< n/gap and n·v/gap
  std::vector<float> dx, dy, dv;      ///< d and d·v
  std::vector<float> x, half_length;  ///< [m]
  std::size_t size = 0;

  void clear() { size = 0; }
  void reserve(std::size_t n);  ///< room for n faces; before they are added
  struct Face {
    float nx, ny;          ///< outward unit normal
    float dx, dy;          ///< unit vector along the face
    float vx, vy;          ///< [m/s]
    float gap;             ///< [m] to the walker's body
    float x, half_length;  ///< [m]
  };
  void add(const Face& face);
  void fill_group();  ///< with faces nobody touches
  FaceView view() const {
    return {nx.data(), ny.data(), nv.data(),          dx.data(), dy.data(),
            dv.data(), x.data(),  half_length.data(), size};
  }
};

inline void DiscList::reserve(std::size_t n) {
  n += 3 * kObstacleGroup;  // room for filling up, and for whole vectors written at the end
  if (px.size() >= n) return;
  for (auto* array : {&px, &py, &q, &a, &wx, &wy}) array->resize(n);
}

inline void DiscList::add(float x, float y, float vx, float vy, float contact,
                          float speed_squared) {
  const float apart = x * x + y * y;
  const float soft = kSoftness * apart > kLeastDiscGap ? kSoftness * apart : kLeastDiscGap;
  const float free = apart - contact * contact;
  const float gamma = 1.0F / (free > soft ? free : soft);
  px[size] = gamma * x;
  py[size] = gamma * y;
  q[size] = gamma * (x * vx + y * vy);
  a[size] = gamma * (speed_squared + (vx * vx + vy * vy));
  wx[size] = 2.0F * gamma * vx;
  wy[size] = 2.0F * gamma * vy;
  ++size;
}

inline void DiscList::fill_group() {
  for (std::size_t i = size; i % kObstacleGroup != 0; ++i) {
    px[i] = py[i] = q[i] = wx[i] = wy[i] = 0.0F;
    a[i] = 1.0F;  // the root of −1: never
  }
}

inline void FaceList::reserve(std::size_t n) {
  n += kObstacleGroup;
  if (nx.size() >= n) return;
  for (auto* array : {&nx, &ny, &nv, &dx, &dy, &dv, &x, &half_length}) array->resize(n);
}

inline void FaceList::add(const Face& face) {
  const float inverse = 1.0F / (face.gap > kLeastFaceGap ? face.gap : kLeastFaceGap);
  nx[size] = face.nx * inverse;
  ny[size] = face.ny * inverse;
  nv[size] = (face.nx * face.vx + face.ny * face.vy) * inverse;
  dx[size] = face.dx;
  dy[size] = face.dy;
  dv[size] = face.dx * face.vx + face.dy * face.vy;
  x[size] = face.x;
  half_length[size] = face.half_length;
  ++size;
}

inline void FaceList::fill_group() {
  for (std::size_t i = size; i % kObstacleGroup != 0; ++i) {
    nx[i] = ny[i] = nv[i] = dx[i] = dy[i] = dv[i] = x[i] = half_length[i] = 0.0F;  // u = 0: never
  }
}

}  // namespace pedzone
