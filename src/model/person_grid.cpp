#include "model/person_grid.hpp"

#include <algorithm>
#include <cmath>

#include "model/trigonometry.hpp"

namespace pedzone {
namespace {

/// [m] smallest cell: narrow, since a row's cells are read in one go, so that width costs only
/// persons looked at in vain, while height also costs rows. Numerical, by timing.
constexpr double kCellWidth = 0.75;
constexpr double kCellHeight = 1.5;
/// At most so many cells a person (plus a few), so that memory follows the number of persons.
constexpr double kCellsPerPerson = 8.0;
constexpr double kCellsAtLeast = 4096.0;
constexpr std::uint32_t kGroup = kSlotGroup;
constexpr std::uint32_t kAllSlots = (1U << kGroup) - 1U;

}  // namespace

const PersonGrid::Level& PersonGrid::level(const View& view, double scale) {
  for (level_ = 0; level_ < levels_.size(); ++level_) {
    if (levels_[level_].view == view && levels_[level_].scale == scale) return levels_[level_];
  }
  levels_.push_back({view, scale,
                     ViewCells(view.sight, view.half_field, kCellWidth * scale,
                               kCellHeight * scale)});
  return levels_[level_];
}

PersonGrid::Cell PersonGrid::cell_of(const LatticePoint& point) const {
  const Level& level = levels_[level_];
  const double x = static_cast<double>(point.x - bounds_.left);
  const double y = static_cast<double>(point.y - bounds_.low);
  return {static_cast<int>(x * columns_per_lattice_) + level.cells.columns(),
          static_cast<int>(y * rows_per_lattice_) + level.cells.rows()};
}

void PersonGrid::choose_cells(const View& view, double scale) {
  const auto width = static_cast<double>(bounds_.right - bounds_.left);
  const auto height = static_cast<double>(bounds_.high - bounds_.low);
  const Level& chosen = level(view, scale);
  columns_per_lattice_ = 1.0 / (kCellWidth * scale * kLatticePerMetre);
  rows_per_lattice_ = 1.0 / (kCellHeight * scale * kLatticePerMetre);
  columns_ = static_cast<int>(width * columns_per_lattice_) + 1 + 2 * chosen.cells.columns();
  rows_ = static_cast<int>(height * rows_per_lattice_) + 1 + 2 * chosen.cells.rows();
}

void PersonGrid::build(const Persons& persons, const LatticeOrigin& origin, double sight,
                       double half_field) {
  size_ = persons.size();
  for (auto* array : {&x_, &y_}) array->resize(size_ + kGroup);
  for (auto* array : {&vx_, &vy_, &speed2_, &radius_, &turned_, &present_, &hx_, &hy_}) {
    array->resize(size_ + kGroup);
  }
  cell_.resize(size_);
  point_.resize(size_);
  bounds_ = {0, 0, -1, -1};
  broadest_ = 0.0F;
  if (size_ == 0) return;

  for (std::size_t i = 0; i < size_; ++i) {
    point_[i] = to_lattice(persons.x[i], persons.y[i], origin);
  }
  bounds_ = {point_[0].x, point_[0].y, point_[0].x, point_[0].y};
  for (const LatticePoint& p : point_) {
    bounds_ = {std::min<std::int64_t>(bounds_.left, p.x), std::min<std::int64_t>(bounds_.low, p.y),
               std::max<std::int64_t>(bounds_.right, p.x),
               std::max<std::int64_t>(bounds_.high, p.y)};
  }
  const double most_cells = kCellsPerPerson * static_cast<double>(size_) + kCellsAtLeast;
  const View view{sight, half_field};
  double scale = 1.0;
  choose_cells(view, scale);
  while (static_cast<double>(columns_) * rows_ > most_cells) {
    scale *= 2.0;
    choose_cells(view, scale);
  }

  // Counting sort: count, prefix sums (cell_start_[c + 1] is where cell c is filled next), place.
  cell_start_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 2, 0);
  for (std::size_t i = 0; i < size_; ++i) {
    const Cell cell = cell_of(point_[i]);
    cell_[i] = static_cast<std::uint32_t>(cell.row * columns_ + cell.column);
    ++cell_start_[cell_[i] + 2];
  }
  for (std::size_t c = 2; c < cell_start_.size(); ++c) cell_start_[c] += cell_start_[c - 1];
  for (std::size_t i = 0; i < size_; ++i) {
    const std::uint32_t slot = cell_start_[cell_[i] + 1]++;
    x_[slot] = point_[i].x;
    y_[slot] = point_[i].y;
    vx_[slot] = static_cast<float>(persons.vx[i]);
    vy_[slot] = static_cast<float>(persons.vy[i]);
    speed2_[slot] = vx_[slot] * vx_[slot] + vy_[slot] * vy_[slot];
    radius_[slot] = static_cast<float>(persons.radius[i]);
    turned_[slot] = static_cast<float>(persons.turned_radius[i]);
    broadest_ = std::max({broadest_, radius_[slot], turned_[slot]});
    present_[slot] = static_cast<float>(persons.present_radius[i]);
    const SineCosine heading = sine_cosine(wrapped(persons.heading[i]));
    hx_[slot] = static_cast<float>(heading.cos);
    hy_[slot] = static_cast<float>(heading.sin);
  }
}

std::span<const SlotGroup> PersonGrid::groups(const LatticePoint& point, double heading,
                                              std::vector<SlotGroup>& space) const {
  // Groups are written before it is known whether a row has so many: that costs less than a
  // branch that goes either way.
  constexpr std::uint32_t kBlind = 3;
  const auto runs = levels_[level_].cells.runs(heading);
  const std::size_t most = size_ / kGroup + runs.size() + kBlind;
  if (space.size() < most) space.resize(most);
  const Cell cell = cell_of(point);
  const std::uint32_t* own =
      cell_start_.data() + static_cast<std::ptrdiff_t>(cell.row) * columns_ + cell.column;
  SlotGroup* out = space.data();
  for (const CellRun& run : runs) {
    const std::uint32_t* row = own + static_cast<std::ptrdiff_t>(run.row) * columns_;
    const std::uint32_t first = row[run.left], count = row[run.right + 1] - first;
    const std::uint32_t groups = (count + kGroup - 1) / kGroup;
    for (std::uint32_t g = 0; g < kBlind; ++g) out[g] = {first + g * kGroup, kAllSlots};
    for (std::uint32_t g = kBlind; g < groups; ++g) out[g] = {first + g * kGroup, kAllSlots};
    if (groups > 0) out[groups - 1].used = kAllSlots >> (groups * kGroup - count);
    out += groups;
  }
  return {space.data(), out};
}

}  // namespace pedzone
