#include "view/svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "pages/palette.hpp"

namespace pedzone {
namespace {

constexpr double kLongSide = 1600.0;  // [pixels] of the picture as shown; the scale is free

}  // namespace

std::string escaped(std::string_view text) {
  std::string result;
  for (const char c : text) {
    switch (c) {
      case '&':
        result += "&amp;";
        break;
      case '<':
        result += "&lt;";
        break;
      case '>':
        result += "&gt;";
        break;
      case '"':
        result += "&quot;";
        break;
      case '\'':
        result += "&apos;";
        break;
      default:
        if (static_cast<unsigned char>(c) >= 0x20) result += c;
    }
  }
  return result;
}

SvgPage::SvgPage(const Box& box, double panel) : box_(box), panel_(panel) {}

void SvgPage::points(const std::vector<Vec2>& line) {
  for (std::size_t i = 0; i < line.size(); ++i) {
    fmt::format_to(std::back_inserter(body_), "{}{:.2f} {:.2f}", i == 0 ? 'M' : 'L',
                   line[i].x() - box_.min().x(), box_.max().y() - line[i].y());
  }
}

void SvgPage::close_element(std::string_view element, std::string_view title) {
  if (title.empty()) {
    body_ += "/>\n";
  } else {
    body_ += fmt::format("><title>{}</title></{}>\n", escaped(title), element);
  }
}

void SvgPage::region(const Region& region, std::string_view attributes, std::string_view title) {
  if (region.empty()) return;
  body_ += fmt::format("<path fill-rule=\"evenodd\" {} d=\"", attributes);
  for (const Polygon& polygon : region) {
    points(polygon.outer);
    body_ += 'Z';
    for (const Ring& hole : polygon.holes) {
      points(hole);
      body_ += 'Z';
    }
  }
  body_ += '"';
  close_element("path", title);
}

void SvgPage::line(const Polyline& line, std::string_view attributes, std::string_view title) {
  if (line.size() < 2) return;
  body_ += fmt::format("<path fill=\"none\" {} d=\"", attributes);
  points(line);
  body_ += '"';
  close_element("path", title);
}

void SvgPage::circle(const Vec2& centre, double radius, std::string_view attributes,
                     std::string_view title) {
  fmt::format_to(std::back_inserter(body_), "<circle {} cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.2f}\"",
                 attributes, centre.x() - box_.min().x(), box_.max().y() - centre.y(), radius);
  close_element("circle", title);
}

void SvgPage::text(const Vec2& place, double size, std::string_view text,
                   std::string_view attributes) {
  body_ += fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\" font-size=\"{:.2f}\" {}>{}</text>\n",
                       place.x() - box_.min().x(), box_.max().y() - place.y(), size, attributes,
                       escaped(text));
}

void SvgPage::clip_box(std::string_view name, const Box& box) {
  body_ += fmt::format(
      "<clipPath id=\"{}\"><rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" "
      "height=\"{:.2f}\"/></clipPath>\n",
      name, box.min().x() - box_.min().x(), box_.max().y() - box.max().y(), box.sizes().x(),
      box.sizes().y());
}

void SvgPage::begin_group(std::string_view attributes) {
  body_ += fmt::format("<g {}>\n", attributes);
}

void SvgPage::end_group() { body_ += "</g>\n"; }

Vec2 SvgPage::panel_point(double right, double down) const {
  return {box_.min().x() + right, box_.min().y() - down};
}

std::string SvgPage::finish(std::string_view title) const {
  const double width = box_.sizes().x(), height = box_.sizes().y() + panel_;
  const double pixels = kLongSide / std::max(width, height);
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{:.0f}\" height=\"{:.0f}\" "
      "viewBox=\"0 0 {:.2f} {:.2f}\" data-box=\"{:.2f} {:.2f} {:.2f} {:.2f}\" "
      "font-family=\"sans-serif\">\n"
      "<title>{}</title>\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"{}\"/>\n{}</svg>\n",
      std::ceil(pixels * width), std::ceil(pixels * height), width, height, box_.min().x(),
      box_.min().y(), box_.max().x(), box_.max().y(), escaped(title), colours::kPaper, body_);
}

}  // namespace pedzone
