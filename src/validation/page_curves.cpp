// Cumulative curves: which share of the persons had no more than a value.
#include <algorithm>
#include <cmath>

#include "validation/page_parts.hpp"
#include "core/statistics.hpp"
#include "view/axis.hpp"
#include "view/svg.hpp"

namespace pedzone::page {
namespace {

struct Measure {
  std::string_view title, unit;
  double Measures::*value;
};
constexpr std::array<Measure, 4> kMeasures{{{"smallest clearance", "m", &Measures::clearance},
                                            {"lateral deviation", "m", &Measures::deviation},
                                            {"least speed", "m/s", &Measures::least_speed},
                                            {"mean speed", "m/s", &Measures::mean_speed}}};

constexpr double kWidth = 320.0, kHeight = 200.0;                             // of a picture
constexpr double kLeft = 54.0, kRight = 310.0, kTop = 10.0, kBottom = 158.0;  // of the curves
constexpr double kShownPart = 0.98;  // of every curve lies left of the axis's end

/// The models whose curves are drawn: that of the page on top, so last.
std::vector<std::size_t> drawn_models(const ValidationResult& result) {
  std::vector<std::size_t> models;
  for (const std::string_view look : {"straight", "plain", "main"}) {
    for (std::size_t m = 0; m < result.models.size(); ++m) {
      if (look_of(result, m) == look) models.push_back(m);
    }
  }
  return models;
}

/// One measure of persons; those of several seeds one after the other.
struct Sample {
  std::vector<double> recorded, walked;
  double ks = 0.0;  ///< mean over seeds
};

Sample sample_of(const ValidationResult& result, std::size_t model, PersonSet set,
                 const std::string& group, double Measures::*value) {
  Sample sample;
  const ScoredRuns& runs = result.runs[model];
  std::vector<double> ks;
  for (std::size_t seed = 0; seed < runs.size(); ++seed) {
    std::vector<double> recorded, walked;
    for (const ScoredPerson* person : members(result, runs, seed, set, group)) {
      recorded.push_back(person->recorded.*value);
      walked.push_back(person->walked.*value);
    }
    ks.push_back(ks_distance(recorded, walked));
    sample.walked.insert(sample.walked.end(), walked.begin(), walked.end());
    if (seed == 0) sample.recorded = std::move(recorded);
  }
  sample.ks = mean(ks);
  return sample;
}

double x_of(double value, double end) {
  if (std::isnan(value)) return kRight;
  return kLeft + std::clamp(value / end, 0.0, 1.0) * (kRight - kLeft);
}

double y_of(double share) { return kBottom - share * (kBottom - kTop); }

/// A step up at each person's value.
std::string curve(std::vector<double> values, double end, std::string_view look) {
  std::sort(values.begin(), values.end());
  std::string path;
  add(path, "<path class=\"line {}\" d=\"M{} {}", look, kLeft, kBottom);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const double share = static_cast<double>(i + 1) / static_cast<double>(values.size());
    add(path, "H{:.1f}V{:.1f}", x_of(values[i], end), y_of(share));
  }
  add(path, "H{}\"/>\n", kRight);
  return path;
}

std::string axes(const Measure& measure, double end) {
  std::string svg;
  const double step = round_step(end, 5.0);
  for (int i = 0; i * step <= end * (1.0 + 1e-9); ++i) {
    const double x = x_of(i * step, end);
    add(svg, "<path class=\"grid-line\" d=\"M{0:.1f} {1}V{2}\"/>", x, kTop, kBottom);
    add(svg, "<text class=\"tick\" text-anchor=\"middle\" x=\"{:.1f}\" y=\"{}\">{:.3g}</text>\n", x,
        kBottom + 14.0, i * step);
  }
  for (const int percent : {0, 25, 50, 75, 100}) {
    const double y = y_of(percent / 100.0);
    add(svg, "<path class=\"grid-line\" d=\"M{} {:.1f}H{}\"/>", kLeft, y, kRight);
    if (percent % 50 != 0) continue;
    add(svg, "<text class=\"tick\" text-anchor=\"end\" x=\"{}\" y=\"{:.1f}\">{} %</text>\n",
        kLeft - 5.0, y + 4.0, percent);
  }
  add(svg, "<path class=\"axis\" d=\"M{} {}V{}H{}\"/>", kLeft, kTop, kBottom, kRight);
  add(svg, "<text class=\"title\" text-anchor=\"middle\" x=\"{}\" y=\"{}\">{} [{}]</text>\n",
      0.5 * (kLeft + kRight), kBottom + 33.0, measure.title, measure.unit);
  add(svg,
      "<text class=\"tick\" text-anchor=\"middle\" transform=\"translate(11 {}) rotate(-90)\">"
      "share of persons</text>\n",
      0.5 * (kTop + kBottom));
  return svg;
}

}  // namespace

Curves::Curves(const ValidationResult& result, PersonSet set) : result_(result), set_(set) {
  for (const Measure& measure : kMeasures) {
    double most = 0.0;
    for (const std::size_t m : drawn_models(result)) {
      const Sample sample = sample_of(result, m, set, "all", measure.value);
      for (const auto* values : {&sample.recorded, &sample.walked}) {
        const double high = quantile(*values, kShownPart);
        if (std::isfinite(high)) most = std::max(most, high);
      }
    }
    const double step = round_step(most, 5.0);
    ends_.push_back(step * std::max(1.0, std::ceil(most / step)));
  }
}

std::string Curves::of_group(const std::string& group) const {
  const auto rows = rows_of(result_, set_, group);
  if (rows.empty()) return "";
  std::string out;
  add(out, "<h3>{} <small>{} persons in {} clips</small></h3>\n<div class=\"grid\">\n",
      escaped(group), rows.front()->persons, rows.front()->clips);
  for (std::size_t k = 0; k < kMeasures.size(); ++k) out += chart(group, k);
  return out + "</div>\n";
}

std::string Curves::chart(const std::string& group, std::size_t k) const {
  const Measure& measure = kMeasures[k];
  std::string curves, legend;
  for (const std::size_t m : drawn_models(result_)) {
    Sample sample = sample_of(result_, m, set_, group, measure.value);
    const std::string_view look = look_of(result_, m);
    // The recording's curve lies under those of the models.
    if (curves.empty()) curves = curve(std::move(sample.recorded), ends_[k], "recorded");
    curves += curve(std::move(sample.walked), ends_[k], look);
    legend.insert(0, fmt::format("<span>{} {}</span>\n", named_key(result_.models[m], look),
                                 number(sample.ks, 2)));
  }
  std::string out;
  add(out, "<figure class=\"chart\"><svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">\n",
      kWidth, kHeight, escaped(fmt::format("{}: {}", group, measure.title)));
  out += axes(measure, ends_[k]) + curves;
  add(out,
      "</svg><figcaption class=\"sub\"><span "
      "class=\"legend\"><span>K-S:</span>\n{}</span></figcaption></figure>\n",
      legend);
  return out;
}

std::string curve_legend(const ValidationResult& result) {
  std::string out = "<p class=\"legend\">" + named_key("recorded", "recorded");
  const auto models = drawn_models(result);
  for (auto m = models.rbegin(); m != models.rend(); ++m) {
    out += '\n' + named_key(result.models[*m], look_of(result, *m));
  }
  return out + "</p>\n";
}

}  // namespace pedzone::page
