#include "app/verify_output.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "verify/page.hpp"

namespace pedzone {
namespace {

using Json = nlohmann::ordered_json;
using namespace verify;

constexpr std::size_t kLabel = 62, kColumn = 13;

std::string cell(const FigureSpec& figure, const FigureResult& result) {
  const std::string mark = figure.judged == Judged::kNot ? " " : result.passed ? "+" : "!";
  const std::string value =
      std::isfinite(result.value) ? fmt::format("{:.{}f}", result.value, figure.digits) : "-";
  return value + " " + mark;
}

/// JSON has no infinity and no NaN.
Json number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }
Json number(const std::optional<double>& value) { return value ? number(*value) : Json(nullptr); }

Json figure_json(const FigureSpec& figure, const FigureResult& result) {
  return {{"key", figure.key},
          {"label", figure.label},
          {"unit", figure.unit},
          {"value", number(result.value)},
          {"least", number(result.least)},
          {"most", number(result.most)},
          {"limit_least", number(figure.least)},
          {"limit_most", number(figure.most)},
          {"limit_source", figure.limit_source},
          {"judged", figure.judged != Judged::kNot},
          {"passed", result.passed}};
}

Json result_json(const StandardTest& test, const TestResult& result) {
  Json figures = Json::array(), curves = Json::object();
  for (std::size_t f = 0; f < test.figures.size(); ++f) {
    figures.push_back(figure_json(test.figures[f], result.figures[f]));
  }
  for (std::size_t c = 0; c < test.charts.size(); ++c) {
    Json points = Json::array();
    for (const ChartPoint& point : result.curves[c]) {
      points.push_back({{"x", number(point.x)},
                        {"y", number(point.y)},
                        {"least", number(point.least)},
                        {"most", number(point.most)}});
    }
    curves[test.charts[c].key] = points;
  }
  return {{"passed", result.passed}, {"figures", figures}, {"curves", curves}};
}

std::string heading(const Verification& verification) {
  std::string text = fmt::format("{:<{}}{:>18}", "", kLabel, "limits");
  for (const std::string& model : verification.models) {
    text += fmt::format(" {:>{}.{}}", model, kColumn, kColumn);
  }
  return text + "\n";
}

}  // namespace

std::string verification_table(const Verification& verification) {
  std::string text =
      (verification.seeds == 1 ? "One seed"
                               : fmt::format("Medians of {} seeds", verification.seeds)) +
      "; + kept, ! not kept\n\n" + heading(verification);
  for (std::size_t t = 0; t < verification.tests.size(); ++t) {
    const StandardTest& test = verification.tests[t];
    text += fmt::format("{:<{}}", test.id, kLabel + 18);
    for (const TestResult& result : verification.results[t]) {
      text += fmt::format(" {:>{}}", result.passed ? "passed" : "FAILED", kColumn);
    }
    text += "\n";
    for (std::size_t f = 0; f < test.figures.size(); ++f) {
      const FigureSpec& figure = test.figures[f];
      const std::string label =
          figure.unit.empty() ? figure.label : figure.label + ", " + figure.unit;
      text += fmt::format("  {:<{}}{:>18}", label, kLabel - 2, limits_text(figure));
      for (const TestResult& result : verification.results[t]) {
        text += fmt::format(" {:>{}}", cell(figure, result.figures[f]), kColumn);
      }
      text += "\n";
    }
  }
  return text;
}

std::string verification_json(const Verification& verification) {
  Json json{{"models", verification.models}, {"seeds", verification.seeds}};
  json["tests"] = Json::array();
  for (std::size_t t = 0; t < verification.tests.size(); ++t) {
    const StandardTest& test = verification.tests[t];
    Json one{{"id", test.id},
             {"title", test.title},
             {"source", test.source},
             {"setup", test.setup},
             {"behaviour", test.behaviour}};
    for (std::size_t m = 0; m < verification.models.size(); ++m) {
      one["results"][verification.models[m]] = result_json(test, verification.results[t][m]);
    }
    json["tests"].push_back(one);
  }
  for (std::size_t m = 0; m < verification.models.size(); ++m) {
    json["passed"][verification.models[m]] = verification.passes(m);
  }
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string test_list_text() {
  std::string text;
  for (const StandardTest& test : standard_tests()) {
    text += fmt::format("{:<20} {} ({})\n", test.id, test.title, test.source);
  }
  return text;
}

}  // namespace pedzone
