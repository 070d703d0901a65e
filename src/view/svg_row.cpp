#include "view/svg_row.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <iterator>

#include "pages/palette.hpp"
#include "view/svg.hpp"

namespace pedzone {
namespace {

constexpr double kGap = 24.0, kHead = 56.0, kLetters = 36.0;  // [pixels]

/// A length of the document element [pixels].
double length_of(const std::string& svg, const std::string& attribute) {
  const std::string before = " " + attribute + "=\"";
  return std::atof(svg.c_str() + svg.find(before) + before.size());
}

/// A picture with its name above it, its corner at (x, y).
void place(const NamedPicture& picture, double x, double y, double scale, std::string& body) {
  fmt::format_to(std::back_inserter(body),
                 "<text x=\"{:.2f}\" y=\"{:.2f}\" font-size=\"{:.0f}\" font-weight=\"600\">{}"
                 "</text>\n<g transform=\"translate({:.2f} {:.2f}) scale({:.4f})\">\n{}</g>\n",
                 x, y + kLetters, kLetters, escaped(picture.name), x, y + kHead, scale,
                 picture.svg.substr(picture.svg.find("<svg ")));
}

std::string sheet(double width, double height, const std::string& body) {
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
      "viewBox=\"0 0 {0:.0f} {1:.0f}\" font-family=\"sans-serif\">\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"{2}\"/>\n{3}</svg>\n",
      width, height, colours::kPaper, body);
}

}  // namespace

std::string svg_row(const std::vector<NamedPicture>& pictures) {
  std::string body;
  double left = 0.0;
  const double height = length_of(pictures.front().svg, "height");
  for (const NamedPicture& picture : pictures) {
    const double scale = height / length_of(picture.svg, "height");
    place(picture, left, 0.0, scale, body);
    left += scale * length_of(picture.svg, "width") + kGap;
  }
  return sheet(left - kGap, kHead + height, body);
}

std::string svg_column(const std::vector<NamedPicture>& pictures) {
  std::string body;
  double top = 0.0;
  const double width = length_of(pictures.front().svg, "width");
  for (const NamedPicture& picture : pictures) {
    const double scale = width / length_of(picture.svg, "width");
    place(picture, 0.0, top, scale, body);
    top += kHead + scale * length_of(picture.svg, "height") + kGap;
  }
  return sheet(width, top - kGap, body);
}

bool is_wide(const std::string& svg) { return length_of(svg, "width") > length_of(svg, "height"); }

}  // namespace pedzone
