#include "view/scatter_chart.hpp"

#include <fmt/format.h>

#include "pages/palette.hpp"
#include "view/axis.hpp"
#include "view/svg.hpp"
#include "view/zone_map.hpp"

namespace pedzone {
namespace {

// In units of the picture; y is up.
constexpr double kWidth = 600.0, kHeight = 380.0;
constexpr double kLeft = 70.0, kRight = 585.0, kTop = 365.0, kBottom = 60.0;  // of the axes
constexpr double kText = 16.0, kRadius = 3.0;

}  // namespace

std::string scatter_chart(const std::vector<Vec2>& points, std::string_view x_label,
                          std::string_view y_label) {
  Vec2 most = Vec2::Zero();
  for (const Vec2& point : points) most = most.cwiseMax(point);
  const Axis x = Axis::over(0.0, most.x(), 6.0), y = Axis::over(0.0, most.y(), 5.0);
  const auto at = [&](double a, double b) {
    return Vec2(kLeft + x.part(a) * (kRight - kLeft), kBottom + y.part(b) * (kTop - kBottom));
  };
  SvgPage page(Box(Vec2(0.0, 0.0), Vec2(kWidth, kHeight)), 0.0);
  page.begin_group(stroke("#dddddd", 1.0));
  for (const double tick : x.ticks()) page.line({at(tick, y.least), at(tick, y.most)}, "");
  for (const double tick : y.ticks()) page.line({at(x.least, tick), at(x.most, tick)}, "");
  page.end_group();
  page.begin_group(
      fmt::format("class=\"points\" fill=\"{}\" fill-opacity=\"0.45\"", colours::kBlue.light));
  for (const Vec2& point : points) page.circle(at(point.x(), point.y()), kRadius, "");
  page.end_group();
  page.line({{kLeft, kTop}, {kLeft, kBottom}, {kRight, kBottom}}, stroke("#333333", 1.5));
  for (const double tick : x.ticks()) {
    page.text(at(tick, y.least) - Vec2(0.0, 20.0), kText, x.label(tick),
              "class=\"x-tick\" text-anchor=\"middle\"");
  }
  for (const double tick : y.ticks()) {
    page.text(at(x.least, tick) - Vec2(8.0, 5.0), kText, y.label(tick),
              "class=\"y-tick\" text-anchor=\"end\"");
  }
  page.text({0.5 * (kLeft + kRight), 12.0}, kText, x_label, "text-anchor=\"middle\"");
  const double middle = kHeight - 0.5 * (kTop + kBottom);
  page.text({18.0, kHeight - middle}, kText, y_label,
            fmt::format("text-anchor=\"middle\" transform=\"rotate(-90 18 {})\"", middle));
  std::string svg = page.finish("");
  return svg.erase(0, svg.find("<svg"));
}

}  // namespace pedzone
