#include "validation/page.hpp"

#include <algorithm>
#include <cmath>

#include "validation/page_parts.hpp"
#include "view/svg.hpp"

namespace pedzone {
namespace page {

std::string_view look_of(const ValidationResult& result, std::size_t model) {
  if (model + 1 == result.models.size()) return "main";
  const std::string& name = result.models[model];
  if (name == "plain") return "plain";
  if (name == "straight to goal") return "straight";
  return name == "constant velocity" ? "constant" : "other";
}

std::string_view look_of(const ValidationResult& result, const ValidationRow& row) {
  // From the back: the page's model is the last one, whatever it is called.
  for (std::size_t m = result.models.size(); m-- > 0;) {
    if (result.models[m] == row.model) return look_of(result, m);
  }
  return "recorded";
}

std::string named_key(std::string_view name, std::string_view look) {
  return fmt::format(
      "<span class=\"key\"><svg viewBox=\"0 0 26 10\" aria-hidden=\"true\">"
      "<path class=\"line {}\" d=\"M1 5H25\"/></svg>{}</span>",
      look, escaped(name));
}

std::string number(double value, int digits) {
  if (std::isnan(value)) return "–";
  if (std::isinf(value)) return "∞";
  return fmt::format("{:.{}f}", value, digits);
}

std::vector<const ValidationRow*> rows_of(const ValidationResult& result, PersonSet set,
                                          const std::string& group) {
  std::vector<const ValidationRow*> rows;
  for (const ValidationRow& row : result.rows) {
    if (row.set == set && row.group == group) rows.push_back(&row);
  }
  return rows;
}

namespace {

/// "all" and sites, or manoeuvres of sites.
std::vector<std::string> groups(const ValidationResult& result, bool manoeuvres) {
  std::vector<std::string> chosen;
  for (const std::string& group : groups_of(result.data)) {
    const bool whole =
        group == "all" || std::any_of(result.data.begin(), result.data.end(),
                                      [&](const Clip& clip) { return clip.site == group; });
    if (whole != manoeuvres) chosen.push_back(group);
  }
  return chosen;
}

std::size_t persons_in(const ValidationResult& result, PersonSet set) {
  return result.runs.empty() || result.runs.front().empty()
             ? 0
             : members(result, result.runs.front(), 0, set, "all").size();
}

std::string head(const ValidationResult& result) {
  std::string out;
  add(out,
      "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"/>\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
      "<title>pedzone: {} against recordings</title>\n<style>{}</style></head>\n<body>\n",
      result.models.empty() ? "" : escaped(result.models.back()), style());
  return out;
}

std::string headline(const ValidationResult& result) {
  std::string out;
  add(out, "<header><h1>{} against recordings</h1>\n",
      result.models.empty() ? "Models" : escaped(result.models.back()));
  out +=
      "<p>Recorded people around recorded vehicles, walked again: everybody follows the recording "
      "for one second, then the model walks them to where they went, while the vehicle drives as "
      "it "
      "did. A good model keeps as much room, gives way as far and slows down as much as people "
      "did.</p>\n<ul class=\"tiles\">\n";
  add(out, "<li><b>{}</b>clips replayed</li>\n<li><b>{}</b>persons in them</li>\n", result.clips,
      result.persons);
  add(out, "<li><b>{}</b>scored (tracks of 3 s and 2 m or more)</li>\n", result.scored);
  add(out, "<li><b>{}</b>seeds (speeds vary by 3 %)</li>\n</ul>\n", result.seeds);
  return out +
         "<nav><a href=\"#tables\">Tables</a><a href=\"#curves\">Distributions</a>"
         "<a href=\"#worst\">Worst cases</a><a href=\"#second\">The other set</a></nav></header>\n";
}

std::string explanations(const ValidationResult& result) {
  std::string out = "<h2>What is compared</h2>\n";
  add(out,
      "<p><b>First set, {} persons:</b> whose recorded way came within 3 m of a moving "
      "vehicle.<br/>\n"
      "<b>Second set, {} persons:</b> who would have come within 3 m of it, had they walked "
      "straight "
      "to their goal at their own speed. Unlike the first, it does not leave out those whom giving "
      "way took farther away.</p>\n",
      persons_in(result, PersonSet::kRecorded), persons_in(result, PersonSet::kStraight));
  out +=
      "<p><b>Reference rows:</b> “straight to goal” and “constant velocity” react to nothing; "
      "“plain” is the published heuristic without what was fitted to recordings. Figures are means "
      "over seeds; the small grey numbers are 95 % intervals (bootstrap over clips). K-S, the "
      "Kolmogorov-Smirnov distance, is the greatest gap between two cumulative curves: 0 where "
      "model and recording agree, 1 where they have nothing in common.</p>\n"
      "<details open=\"open\"><summary>What the figures mean</summary>\n";
  return out + figure_meanings() + "</details>\n";
}

template <class Part>
std::string each(const std::vector<std::string>& groups, Part part) {
  std::string out;
  for (const std::string& group : groups) out += part(group);
  return out;
}

/// What `part` makes of all groups; those of manoeuvres folded.
template <class Part>
std::string by_group(const ValidationResult& result, std::string_view folded, Part part) {
  std::string out = each(groups(result, false), part);
  const std::string more = each(groups(result, true), part);
  if (!more.empty()) add(out, "<details><summary>{}</summary>\n{}</details>\n", folded, more);
  return out;
}

std::string set_tables(const ValidationResult& result, PersonSet set) {
  return by_group(result, "Tables of each manoeuvre",
                  [&](const std::string& group) { return table(result, set, group); });
}

std::string set_curves(const ValidationResult& result, PersonSet set) {
  const Curves curves(result, set);
  return by_group(result, "Distributions of each manoeuvre",
                  [&](const std::string& group) { return curves.of_group(group); });
}

std::string worst_section(const std::vector<DrawnCase>& worst) {
  std::string out = "<h2 id=\"worst\">Worst cases, drawn against the recording</h2>\n";
  if (worst.empty()) return out + "<p>None were asked for.</p>\n";
  out +=
      "<p>The persons whose ways differ most from the recording, one of a clip. Each picture is "
      "turned so that the person goes from left to right, and has one scale both ways. Dots and "
      "the vehicle’s outlines (with an arrow to its front) are one second apart; their colour and "
      "number (bold: the vehicle’s) are the clock, in seconds since the person appeared.</p>\n";
  add(out, "<p class=\"legend\">{}\n{}\n{}</p>\n<div class=\"grid cases\">\n",
      named_key("recorded", "recorded"), named_key("walked by the model", "walked main"),
      clock_legend());
  for (const DrawnCase& drawn : worst) out += drawn_case(drawn);
  return out + "</div>\n";
}

}  // namespace
}  // namespace page

std::string validation_page(const ValidationResult& result, const std::vector<DrawnCase>& worst) {
  using namespace page;
  const std::vector<std::string> all = groups_of(result.data);
  std::string out = head(result) + headline(result) + "<main>\n";
  out += "<h2>At a glance</h2>\n";
  if (!all.empty()) out += overview(result, PersonSet::kRecorded, all.front());
  out += explanations(result);
  out += "<h2 id=\"tables\">Tables</h2>\n" + set_tables(result, PersonSet::kRecorded);
  out +=
      "<h2 id=\"curves\">Distributions</h2>\n"
      "<p>Cumulative curves: how many persons had at most the value below. The nearer a model’s "
      "curve is to the recording’s, the better. Seeds are pooled; K-S is their mean, as in the "
      "tables. Few values lie beyond the axis’s end; they are drawn at it.</p>\n" +
      curve_legend(result) + set_curves(result, PersonSet::kRecorded);
  out += worst_section(worst);
  out +=
      "<h2 id=\"second\">The second set</h2>\n"
      "<details><summary>Tables and distributions of those whom walking straight would have taken "
      "near a vehicle</summary>\n" +
      set_tables(result, PersonSet::kStraight) + curve_legend(result) +
      set_curves(result, PersonSet::kStraight) + "</details>\n";
  return out + "</main></body></html>\n";
}

}  // namespace pedzone
