// Tables of the page: all figures of a group, and what figures mean.
#include <cmath>
#include <numeric>

#include "validation/page_parts.hpp"
#include "view/svg.hpp"

namespace pedzone::page {
namespace {

/// Neighbouring figures with a common heading.
struct Block {
  std::string_view title;
  std::size_t figures;
};
constexpr std::array<Block, 6> kBlocks{{{"Contact", 2},
                                        {"Smallest clearance", 3},
                                        {"Lateral deviation", 2},
                                        {"Speed", 3},
                                        {"Order and time", 4},
                                        {"Distance to recording", 2}}};
static_assert(std::accumulate(kBlocks.begin(), kBlocks.end(), std::size_t{0},
                              [](std::size_t sum, const Block& b) { return sum + b.figures; }) ==
              kFigures);

bool begins_block(std::size_t figure) {
  std::size_t begin = 0;
  for (const Block& block : kBlocks) {
    if (figure == begin) return true;
    begin += block.figures;
  }
  return false;
}

std::string shown(const FigureInfo& info, double value) {
  return number(value * info.scale, info.digits);
}

std::string interval(const FigureInfo& info, const ValidationRow& row, std::size_t figure) {
  if (std::isnan(row.low[figure]) || std::isnan(row.high[figure])) return "";
  return shown(info, row.low[figure]) + "–" + shown(info, row.high[figure]);
}

std::string table_head() {
  std::string head = "<thead><tr><th class=\"corner\" rowspan=\"2\"></th>";
  for (const Block& block : kBlocks) {
    add(head, "<th class=\"first block\" colspan=\"{}\" scope=\"colgroup\">{}</th>", block.figures,
        block.title);
  }
  head += "</tr>\n<tr>";
  for (std::size_t f = 0; f < kFigures; ++f) {
    const FigureInfo& info = figure_list()[f];
    add(head, "<th{} scope=\"col\" title=\"{}\">{}<small>{}</small></th>",
        begins_block(f) ? " class=\"first\"" : "", escaped(info.meaning), escaped(info.title),
        info.unit.empty() ? "0–1" : escaped(info.unit));
  }
  return head + "</tr></thead>\n";
}

std::string table_row(const ValidationRow& row, std::string_view look) {
  std::string line;
  add(line, "<tr class=\"row-{}\"><th scope=\"row\">{}</th>", look, named_key(row.model, look));
  for (std::size_t f = 0; f < kFigures; ++f) {
    const FigureInfo& info = figure_list()[f];
    add(line, "<td{}>{}<small>{}</small></td>", begins_block(f) ? " class=\"first\"" : "",
        shown(info, row.value[f]), interval(info, row, f));
  }
  return line + "</tr>\n";
}

}  // namespace

std::string table(const ValidationResult& result, PersonSet set, const std::string& group) {
  const auto rows = rows_of(result, set, group);
  if (rows.empty()) return "";
  std::string out;
  add(out, "<h3>{} <small>{} persons in {} clips</small></h3>\n", escaped(group),
      rows.front()->persons, rows.front()->clips);
  out += "<div class=\"scroll\" tabindex=\"0\"><table class=\"figures\">\n" + table_head() +
         "<tbody>\n";
  for (const ValidationRow* row : rows) out += table_row(*row, look_of(result, *row));
  return out + "</tbody></table></div>\n";
}

std::string figure_meanings() {
  std::string out = "<ul class=\"meanings\">\n";
  std::size_t f = 0;
  for (const Block& block : kBlocks) {
    for (std::size_t end = f + block.figures; f < end; ++f) {
      const FigureInfo& info = figure_list()[f];
      add(out, "<li><b>{}: {}</b>{} {}</li>\n", block.title, escaped(info.title),
          info.unit.empty() ? "" : fmt::format(" [{}]", escaped(info.unit)), escaped(info.meaning));
    }
  }
  return out + "</ul>\n";
}

}  // namespace pedzone::page
