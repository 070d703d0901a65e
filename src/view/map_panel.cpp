#include "view/map_panel.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "pages/palette.hpp"
#include "view/axis.hpp"
#include "view/zone_map.hpp"

namespace pedzone {
namespace {

constexpr double kColumn = 48.0;      // [units] width of a column of the legend
constexpr std::size_t kLetters = 50;  // of a name in it
constexpr double kRow = 2.2;          // [units]
constexpr double kText = 1.4;         // [units]

Region rectangle(const Box& box) {
  return {
      {{box.min(), {box.max().x(), box.min().y()}, box.max(), {box.min().x(), box.max().y()}}, {}}};
}

/// Attributes with another width of their line: an element has each but once.
std::string with_width(const std::string& style, double width) {
  constexpr std::string_view kWidth = "stroke-width=\"";
  std::string changed = style;
  if (const std::size_t begin = changed.find(kWidth); begin != std::string::npos) {
    changed.erase(begin, changed.find('"', begin + kWidth.size()) + 1 - begin);
  }
  return changed + fmt::format(" stroke-width=\"{:.2f}\"", width);
}

}  // namespace

LegendEntry area_entry(std::string name, const std::string& style) {
  return {std::move(name),
          [style](SvgPage& page, const Box& box) { page.region(rectangle(box), style); }};
}

LegendEntry line_entry(std::string name, const std::string& style) {
  return {std::move(name), [style](SvgPage& page, const Box& box) {
            const double y = box.center().y();
            // Line widths of the map are metres; here they are made to be seen.
            page.line({{box.min().x(), y}, {box.max().x(), y}},
                      with_width(style, box.sizes().y() / 3.0));
          }};
}

std::string shortened(std::string_view text, std::size_t most) {
  std::size_t letters = 0, cut = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if ((static_cast<unsigned char>(text[i]) & 0xC0U) == 0x80U) continue;  // within a character
    if (letters + 1 == most) cut = i;
    ++letters;
  }
  return letters <= most ? std::string(text) : std::string(text.substr(0, cut)) + "…";
}

MapPanel::MapPanel(const Vec2& map, std::vector<LegendEntry> legend, bool narrow, double head)
    : map_(map),
      legend_(std::move(legend)),
      head_(head),
      unit_(narrow ? map.x() / kColumn : std::min(map.maxCoeff() / 100.0, map.x() / kColumn)) {}

std::size_t MapPanel::rows() const {
  const std::size_t columns = map_.x() >= 2.0 * kColumn * unit_ ? 2 : 1;
  return (legend_.size() + columns - 1) / columns;
}

double MapPanel::height() const {
  return unit_ * (5.0 + head_ + kRow * static_cast<double>(rows()));
}

void MapPanel::draw(SvgPage& page) const {
  const Vec2 corner = page.panel_point(0.0, 0.0), opposite = page.panel_point(map_.x(), height());
  page.region(rectangle(Box(Vec2(corner.x(), opposite.y()), Vec2(opposite.x(), corner.y()))),
              filled(colours::kPaper));
  page.line({corner, {opposite.x(), corner.y()}}, stroke(colours::kRule, 0.1 * unit_));
  for (std::size_t i = 0; i < legend_.size(); ++i) {
    const double right = unit_ * 2.0 + (i < rows() ? 0.0 : 0.5 * map_.x());
    const double down = unit_ * (head_ + kRow * static_cast<double>(1 + i % rows()));
    const Vec2 middle = page.panel_point(right + 2.0 * unit_, down - 0.1 * unit_);
    const Vec2 half(2.0 * unit_, 0.6 * unit_);
    legend_[i].draw(page, Box(middle - half, middle + half));
    page.text(page.panel_point(right + 5.0 * unit_, down + 0.4 * unit_), kText * unit_,
              shortened(legend_[i].name, kLetters));
  }
  draw_scale_bar(page);
}

/// At most an eighth of the picture.
void MapPanel::draw_scale_bar(SvgPage& page) const {
  const double length = round_length(map_.x() / 8.0);
  const double down = height() - 1.2 * unit_;
  const Vec2 from = page.panel_point(2.0 * unit_, down);
  const Vec2 to = from + Vec2(length, 0.0);
  const Vec2 tick(0.0, 0.5 * unit_);
  page.line({from + tick, from, to, to + tick}, stroke(colours::kInk, 0.15 * unit_));
  page.text(to + Vec2(unit_, 0.0), kText * unit_, fmt::format("{:g} m", length));
  page.text(page.panel_point(0.5 * map_.x(), down), kText * unit_, "north is up");
}

}  // namespace pedzone
