#include "view/line_chart.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "pages/palette.hpp"
#include "view/chart_axes.hpp"
#include "view/map_panel.hpp"
#include "view/svg.hpp"
#include "view/zone_map.hpp"
#include "zone/simplify.hpp"

namespace pedzone {
namespace {

// In units of the picture; y is up.
constexpr double kWidth = 1000.0, kHeight = 520.0;
constexpr double kLeft = 85.0, kRight = 790.0, kTop = 470.0, kBottom = 70.0;  // of the axes
constexpr double kText = 17.0, kTitle = 19.0, kRow = 27.0;
constexpr std::size_t kLetters = 16;       // of a name in the legend
constexpr std::size_t kTitleLetters = 75;  // of the title
constexpr double kThinning = 0.3;          // corners of lines are left out so far

AxesLayout layout() {
  return {.frame = Box(Vec2(kLeft, kBottom), Vec2(kRight, kTop)),
          .tick_letters = kText,
          .label_letters = kTitle,
          .x_tick_drop = 24.0,
          .y_tick_back = Vec2(10.0, 6.0),
          .x_label_height = 18.0,
          .y_label_right = 24.0};
}

class Picture {
 public:
  explicit Picture(const Chart& chart)
      : chart_(chart), page_(Box(Vec2(0.0, 0.0), Vec2(kWidth, kHeight)), 0.0) {
    Box box;
    for (const ChartLine& line : chart.lines) {
      for (const Polyline& piece : line.pieces) box.extend(box_of(piece));
    }
    for (const ChartBand& band : chart.bands) {
      for (const auto& piece : band.pieces) {
        for (const auto& point : piece) {
          box.extend(Vec2(point.x, point.low));
          box.extend(Vec2(point.x, point.high));
        }
      }
    }
    if (box.isEmpty()) box = Box(Vec2(0.0, 0.0), Vec2(1.0, 1.0));
    axes_.x = Axis::over(box.min().x(), box.max().x(), 8.0);
    const double low = chart.y_has_zero ? std::min(0.0, box.min().y()) : box.min().y();
    axes_.y = Axis::over(low, std::min(box.max().y(), chart.y_most), 6.0);
  }

  std::string draw() {
    page_.clip_box("frame", axes_.layout.frame);
    axes_.draw_grid(page_);
    page_.begin_group("clip-path=\"url(#frame)\" stroke-linejoin=\"round\"");
    for (const ChartBand& band : chart_.bands) draw_band(band);
    for (const ChartLine& line : chart_.lines) draw_line(line);
    page_.end_group();
    axes_.draw(page_, chart_.x_label, chart_.y_label);
    draw_texts();
    draw_legend();
    return page_.finish(chart_.title);
  }

 private:
  void draw_texts() {
    if (!chart_.note.empty()) {
      page_.text(
          {kRight - 8.0, kTop - 22.0}, 0.9 * kText, chart_.note,
          fmt::format("class=\"note\" text-anchor=\"end\" font-style=\"italic\" stroke=\"{}\" "
                      "stroke-width=\"4\" paint-order=\"stroke\"",
                      colours::kPaper));
    }
    page_.text({kLeft, kTop + 20.0}, kTitle, shortened(chart_.title, kTitleLetters),
               "font-weight=\"bold\"");
  }

  void draw_line(const ChartLine& line) {
    page_.begin_group("class=\"line\" " + look_of(line));
    for (const Polyline& piece : line.pieces) {
      Polyline placed;
      for (const Vec2& point : piece) placed.push_back(axes_.at(point.x(), point.y()));
      page_.line(simplified(placed, kThinning), "", line.name);
    }
    page_.end_group();
  }

  void draw_band(const ChartBand& band) {
    page_.begin_group("class=\"band\" " + look_of(band));
    for (const auto& piece : band.pieces) {
      Polyline low, high;
      for (const ChartBand::Point& point : piece) {
        low.push_back(axes_.at(point.x, point.low));
        high.push_back(axes_.at(point.x, point.high));
      }
      low = simplified(low, kThinning);
      high = simplified(high, kThinning);
      low.insert(low.end(), high.rbegin(), high.rend());
      page_.region({{low, {}}}, "", band.name);
    }
    page_.end_group();
  }

  static std::string look_of(const ChartLine& line) {
    std::string look = stroke(line.colour, 2.2);
    if (line.dashes.empty()) return look;
    return look + fmt::format(" stroke-dasharray=\"{}\"", line.dashes);
  }
  static std::string look_of(const ChartBand& band) {
    return fmt::format("fill=\"{}\" fill-opacity=\"0.25\"", band.colour);
  }

  void draw_legend() {
    double y = kTop - 8.0;
    const auto entry = [&](const std::string& name, const auto& sign) {
      sign(Vec2(kRight + 20.0, y), Vec2(kRight + 52.0, y));
      page_.text({kRight + 60.0, y - 6.0}, 0.9 * kText, shortened(name, kLetters));
      y -= kRow;
    };
    for (const ChartLine& line : chart_.lines) {
      entry(line.name, [&](const Vec2& from, const Vec2& to) {
        page_.line({from, to}, look_of(line));
      });
    }
    for (const ChartBand& band : chart_.bands) {
      entry(band.name, [&](const Vec2& from, const Vec2& to) {
        const Vec2 half(0.0, 8.0);
        page_.region({{{from - half, to - half, to + half, from + half}, {}}}, look_of(band));
      });
    }
  }

  const Chart& chart_;
  SvgPage page_;
  ChartAxes axes_{.x = {}, .y = {}, .layout = layout()};
};

}  // namespace

std::string line_chart(const Chart& chart) { return Picture(chart).draw(); }

}  // namespace pedzone
