#include "verify/page.hpp"

#include <fmt/format.h>

#include <cmath>

#include "pages/page_builder.hpp"
#include "verify/drawings.hpp"

namespace pedzone {

// Made from verify/page by the build.
extern const std::string_view kVerifyPage, kVerifyStyles, kVerifyScripts;

namespace verify {
namespace {

using Json = PageJson;

constexpr std::size_t kFew = 4;  // models whose columns fit beside words

std::string digits_text(double value, int digits) {
  return std::isfinite(value) ? fmt::format("{:.{}f}", value, digits) : "–";
}

// Tables

Json cell(const FigureSpec& figure, const FigureResult& result, int seeds) {
  const bool judged = figure.judged != Judged::kNot;
  const std::string least = digits_text(result.least, figure.digits);
  const std::string most = digits_text(result.most, figure.digits);
  return {{"value", digits_text(result.value, figure.digits)},
          {"range", seeds > 1 && least != most ? least + " to " + most : ""},
          {"class", judged ? (result.passed ? "good" : "bad") : "told"}};
}

Json figures(const Verification& verification, std::size_t t) {
  const StandardTest& test = verification.tests[t];
  Json rows = Json::array();
  std::string said;  // the row above says the same
  for (std::size_t f = 0; f < test.figures.size(); ++f) {
    const FigureSpec& figure = test.figures[f];
    Json cells = Json::array();
    for (const TestResult& result : verification.results[t]) {
      cells.push_back(cell(figure, result.figures[f], verification.seeds));
    }
    rows.push_back({{"label", figure.label},
                    {"unit", figure.unit},
                    {"limits", limits_text(figure)},
                    {"limit_source", figure.limit_source == said ? "" : figure.limit_source},
                    {"cells", cells}});
    said = figure.limit_source;
  }
  return rows;
}

Json marks(const std::vector<TestResult>& results) {
  Json cells = Json::array();
  for (const TestResult& result : results) {
    cells.push_back(
        {{"class", result.passed ? "good" : "bad"}, {"text", result.passed ? "passed" : "failed"}});
  }
  return cells;
}

Json maps(const Verification& verification, std::size_t t) {
  Json pictures = Json::array();
  for (std::size_t m = 0; m < verification.models.size(); ++m) {
    const TestResult& result = verification.results[t][m];
    if (!result.map) continue;
    pictures.push_back({{"model", verification.models[m]}, {"svg_html", map_svg(*result.map)}});
  }
  return pictures;
}

Json legend() {
  Json entries = Json::array();
  for (const auto& [colour, text] : map_legend()) {
    entries.push_back({{"colour", colour}, {"text", text}});
  }
  return entries;
}

Json tests(const Verification& verification) {
  Json all = Json::array();
  for (std::size_t t = 0; t < verification.tests.size(); ++t) {
    const StandardTest& test = verification.tests[t];
    const Json pictures = maps(verification, t);
    all.push_back({{"index", t},
                   {"id", test.id},
                   {"title", test.title},
                   {"source", test.source},
                   {"setup", test.setup},
                   {"drawing_html", drawing_svg(test.drawing)},
                   {"table", verification.models.size() > kFew ? "figures many" : "figures"},
                   {"figures", figures(verification, t)},
                   {"marks", marks(verification.results[t])},
                   {"charted", !test.charts.empty()},
                   {"mapped", !pictures.empty()},
                   {"map_of", test.map_of},
                   {"maps", pictures},
                   {"legend", legend()}});
  }
  return all;
}

std::size_t passed(const Verification& verification, std::size_t model) {
  std::size_t count = 0;
  for (const auto& results : verification.results) count += results[model].passed ? 1 : 0;
  return count;
}

Json page_data(const Verification& verification, const std::string& command) {
  const std::size_t all = verification.tests.size();
  Json sums = Json::array(), left_out = Json::array();
  for (std::size_t m = 0; m < verification.models.size(); ++m) {
    sums.push_back(fmt::format("{} of {}", passed(verification, m), all));
  }
  for (const LeftOut& test : left_out_tests()) {
    left_out.push_back({{"id", test.id}, {"why", test.why}});
  }
  return {{"title", "Standard tests of walking"},
          {"verdict", fmt::format("{} passes {} of {} tests.", verification.models.front(),
                                  passed(verification, 0), all)},
          {"seeds", verification.seeds == 1
                        ? "One run of each."
                        : fmt::format("Medians of {} runs that differ by chance, and their range.",
                                      verification.seeds)},
          {"models", verification.models},
          {"tests", tests(verification)},
          {"sums", sums},
          {"left_out", left_out},
          {"command", command}};
}

// Charts

Json point_list(const Points& points) {
  Json list = Json::array();
  for (const Point& point : points) list.push_back({point.x, point.y});
  return list;
}

Json chart_json(const ChartSpec& chart) {
  Json references = Json::array(), band = Json::array();
  for (const Reference& reference : chart.references) {
    references.push_back({{"name", reference.name},
                          {"joined", reference.joined},
                          {"points", point_list(reference.points)}});
  }
  for (std::size_t k = 0; k < chart.band_low.size(); ++k) {
    band.push_back({chart.band_low[k].x, chart.band_low[k].y, chart.band_high[k].y});
  }
  return {{"title", chart.title},
          {"xTitle", chart.x_title},
          {"yTitle", chart.y_title},
          {"references", references},
          {"band", band},
          {"curves", Json::array()}};
}

Json curve_json(const std::vector<ChartPoint>& curve) {
  Json points = Json::array();
  for (const ChartPoint& point : curve) {
    if (std::isfinite(point.y)) points.push_back({point.x, point.y, point.least, point.most});
  }
  return points;
}

Json script_data(const Verification& verification) {
  Json all = Json::array();
  for (std::size_t t = 0; t < verification.tests.size(); ++t) {
    Json drawn = Json::array();
    for (std::size_t c = 0; c < verification.tests[t].charts.size(); ++c) {
      Json chart = chart_json(verification.tests[t].charts[c]);
      for (const TestResult& result : verification.results[t]) {
        chart["curves"].push_back(curve_json(result.curves[c]));
      }
      drawn.push_back(std::move(chart));
    }
    all.push_back(std::move(drawn));
  }
  return {{"models", verification.models}, {"tests", all}};
}

}  // namespace

std::string limits_text(const FigureSpec& figure) {
  if (figure.judged == Judged::kNot) return "";
  const auto text = [&](double value) { return fmt::format("{:.{}f}", value, figure.digits); };
  if (figure.least && figure.most) return text(*figure.least) + " to " + text(*figure.most);
  if (figure.least) return "≥ " + text(*figure.least);
  return figure.most ? "≤ " + text(*figure.most) : "";
}

std::string verification_page(const Verification& verification, const std::string& command) {
  return rendered_page({kVerifyPage, kVerifyStyles, kVerifyScripts},
                       page_data(verification, command), script_data(verification));
}

}  // namespace verify
}  // namespace pedzone
