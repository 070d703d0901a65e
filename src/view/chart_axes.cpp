#include "view/chart_axes.hpp"

#include <fmt/format.h>

#include "pages/palette.hpp"
#include "view/zone_map.hpp"

namespace pedzone {

Vec2 ChartAxes::at(double x_value, double y_value) const {
  const Vec2 from = layout.frame.min(), to = layout.frame.max();
  return {from.x() + x.part(x_value) * (to.x() - from.x()),
          from.y() + y.part(y_value) * (to.y() - from.y())};
}

void ChartAxes::draw_grid(SvgPage& page) const {
  page.begin_group(stroke(colours::kGridLine, 1.0));
  for (const double tick : x.ticks()) page.line({at(tick, y.least), at(tick, y.most)}, "");
  for (const double tick : y.ticks()) page.line({at(x.least, tick), at(x.most, tick)}, "");
  page.end_group();
}

void ChartAxes::draw(SvgPage& page, std::string_view x_label, std::string_view y_label) const {
  const Vec2 from = layout.frame.min(), to = layout.frame.max();
  const Vec2 centre = layout.frame.center();
  page.line({{from.x(), to.y()}, from, {to.x(), from.y()}}, stroke(colours::kAxis, 1.5));
  if (y.least < 0.0) {
    page.line({at(x.least, 0.0), at(x.most, 0.0)}, stroke(colours::kAxis, 1.0));
  }
  for (const double tick : x.ticks()) {
    page.text(at(tick, y.least) - Vec2(0.0, layout.x_tick_drop), layout.tick_letters, x.label(tick),
              "class=\"x-tick\" text-anchor=\"middle\"");
  }
  for (const double tick : y.ticks()) {
    page.text(at(x.least, tick) - layout.y_tick_back, layout.tick_letters, y.label(tick),
              "class=\"y-tick\" text-anchor=\"end\"");
  }
  page.text({centre.x(), layout.x_label_height}, layout.label_letters, x_label,
            "text-anchor=\"middle\"");
  page.text({layout.y_label_right, centre.y()}, layout.label_letters, y_label,
            fmt::format("text-anchor=\"middle\" transform=\"rotate(-90 {:g} {:g})\"",
                        layout.y_label_right, page.box().max().y() - centre.y()));
}

}  // namespace pedzone
