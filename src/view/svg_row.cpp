#include "view/svg_row.hpp"

#include <fmt/format.h>

#include <cstdlib>
#include <iterator>

#include "view/svg.hpp"

namespace pedzone {
namespace {

constexpr double kGap = 24.0, kHead = 56.0, kLetters = 36.0;  // [pixels]

/// A length of the document element [pixels].
double length_of(const std::string& svg, const std::string& attribute) {
  const std::string before = " " + attribute + "=\"";
  return std::atof(svg.c_str() + svg.find(before) + before.size());
}

}  // namespace

std::string svg_row(const std::vector<NamedPicture>& pictures) {
  std::string body;
  double left = 0.0;
  const double height = length_of(pictures.front().svg, "height");
  for (const auto& [name, svg] : pictures) {
    const double scale = height / length_of(svg, "height");
    fmt::format_to(std::back_inserter(body),
                   "<text x=\"{:.2f}\" y=\"{:.2f}\" font-size=\"{:.0f}\" font-weight=\"600\">{}"
                   "</text>\n<g transform=\"translate({:.2f} {:.2f}) scale({:.4f})\">\n{}</g>\n",
                   left, kLetters, kLetters, escaped(name), left, kHead, scale,
                   svg.substr(svg.find("<svg ")));
    left += scale * length_of(svg, "width") + kGap;
  }
  const double width = left - kGap;
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
      "viewBox=\"0 0 {0:.0f} {1:.0f}\" font-family=\"sans-serif\">\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n{2}</svg>\n",
      width, kHead + height, body);
}

}  // namespace pedzone
