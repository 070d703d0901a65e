#include "view/scatter_chart.hpp"

#include <fmt/format.h>

#include "pages/palette.hpp"
#include "view/chart_axes.hpp"
#include "view/svg.hpp"

namespace pedzone {
namespace {

// In units of the picture; y is up.
constexpr double kWidth = 600.0, kHeight = 380.0;
constexpr double kRadius = 3.0;

AxesLayout layout() {
  return {.frame = Box(Vec2(70.0, 60.0), Vec2(585.0, 365.0)),
          .tick_letters = 16.0,
          .label_letters = 16.0,
          .x_tick_drop = 20.0,
          .y_tick_back = Vec2(8.0, 5.0),
          .x_label_height = 12.0,
          .y_label_right = 18.0};
}

}  // namespace

std::string scatter_chart(const std::vector<Vec2>& points, std::string_view x_label,
                          std::string_view y_label) {
  Vec2 most = Vec2::Zero();
  for (const Vec2& point : points) most = most.cwiseMax(point);
  const ChartAxes axes{Axis::over(0.0, most.x(), 6.0), Axis::over(0.0, most.y(), 5.0), layout()};
  SvgPage page(Box(Vec2(0.0, 0.0), Vec2(kWidth, kHeight)), 0.0);
  axes.draw_grid(page);
  page.begin_group(
      fmt::format("class=\"points\" fill=\"{}\" fill-opacity=\"0.45\"", colours::kBlue.light));
  for (const Vec2& point : points) page.circle(axes.at(point.x(), point.y()), kRadius, "");
  page.end_group();
  axes.draw(page, x_label, y_label);
  std::string svg = page.finish("");
  return svg.erase(0, svg.find("<svg"));
}

}  // namespace pedzone
