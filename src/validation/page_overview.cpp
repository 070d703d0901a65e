// Key figures at a glance: for each model a dot with its interval over that of the recording.
#include <algorithm>
#include <cmath>

#include "validation/page_parts.hpp"
#include "view/axis.hpp"
#include "view/svg.hpp"

namespace pedzone::page {
namespace {

constexpr std::array kKeyFigures{std::pair{Figure::kClearance, "Smallest clearance, median [m]"},
                                 std::pair{Figure::kDeviation, "Lateral deviation, median [m]"},
                                 std::pair{Figure::kSpeed, "Mean speed, mean [m/s]"},
                                 std::pair{Figure::kLeastSpeed, "Least speed, median [m/s]"}};

constexpr double kWidth = 150.0, kHeight = 22.0, kMargin = 6.0;

/// One figure of a group with its axis from 0 to `end`.
struct Strip {
  std::size_t figure;
  double end;

  double x(double value) const {
    const double part = std::isnan(value) ? 0.0 : std::clamp(value / end, 0.0, 1.0);
    return kMargin + part * (kWidth - 2.0 * kMargin);
  }
};

Strip strip_of(const std::vector<const ValidationRow*>& rows, Figure figure) {
  const auto f = static_cast<std::size_t>(figure);
  double most = 0.0;
  for (const ValidationRow* row : rows) {
    for (const double value : {row->value[f], row->high[f]}) {
      if (std::isfinite(value)) most = std::max(most, value);
    }
  }
  const double step = round_step(most, 4.0);
  return {f, step * std::max(1.0, std::ceil(most / step))};
}

std::string dot(const Strip& strip, const ValidationRow& row, const ValidationRow& recorded,
                std::string_view look) {
  const std::size_t f = strip.figure;
  const double from = strip.x(recorded.low[f]), to = strip.x(recorded.high[f]);
  std::string svg;
  add(svg, "<svg viewBox=\"0 0 {} {}\" aria-hidden=\"true\">", kWidth, kHeight);
  add(svg, "<rect class=\"band\" x=\"{:.1f}\" y=\"0\" width=\"{:.1f}\" height=\"{}\"/>", from,
      std::max(0.0, to - from), kHeight);
  add(svg, "<path class=\"grid-line\" d=\"M{} 11H{}\"/>", kMargin, kWidth - kMargin);
  if (!std::isnan(row.value[f])) {
    add(svg, "<path class=\"{}\" fill=\"none\" stroke-width=\"2.5\" d=\"M{:.1f} 11H{:.1f}\"/>",
        look, strip.x(row.low[f]), strip.x(row.high[f]));
    add(svg, "<circle class=\"{} dot\" cx=\"{:.1f}\" cy=\"11\" r=\"5\"/>", look,
        strip.x(row.value[f]));
  }
  return svg + "</svg>";
}

std::string strip_table(const ValidationResult& result,
                        const std::vector<const ValidationRow*>& rows, const Strip& strip,
                        std::string_view title) {
  std::string out;
  add(out, "<table><caption>{}</caption><tbody>\n", title);
  for (const ValidationRow* row : rows) {
    const std::string_view look = look_of(result, *row);
    add(out,
        "<tr><th scope=\"row\">{}</th><td class=\"wide\">{}</td><td class=\"value\">{}</td></tr>\n",
        named_key(row->model, look), dot(strip, *row, *rows.front(), look),
        number(row->value[strip.figure], 2));
  }
  add(out,
      "<tr class=\"axis\"><th></th><td><span><small>0</small><small>{}</small></span></td>"
      "<td></td></tr>\n</tbody></table>\n",
      fmt::format("{:.3g}", strip.end));
  return out;
}

}  // namespace

std::string overview(const ValidationResult& result, PersonSet set, const std::string& group) {
  const auto rows = rows_of(result, set, group);
  if (rows.empty()) return "";
  std::string out;
  add(out,
      "<p>{} persons of group “{}”: mean over seeds (dot) and 95 % interval (bar); the grey band "
      "is the interval of the recording.</p>\n<div class=\"grid glance\">\n",
      rows.front()->persons, escaped(group));
  for (const auto& [figure, title] : kKeyFigures) {
    out += strip_table(result, rows, strip_of(rows, figure), title);
  }
  return out + "</div>\n";
}

}  // namespace pedzone::page
