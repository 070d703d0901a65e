// SVG text in the network's frame: metres in, north up.
#pragma once

#include <string>
#include <string_view>

#include "zone/shapes.hpp"

namespace pedzone {

/// Text with the five characters that mean something in XML written as entities; control
/// characters, which XML does not allow, are left out.
std::string escaped(std::string_view text);

/// Collects the elements of a picture. One unit of the picture is a metre; y is turned round.
class SvgPage {
 public:
  /// `box` [m] is what the picture shows; `panel` [m] is added below it for a legend.
  SvgPage(const Box& box, double panel);

  /// `attributes` are SVG's own, such as `fill="none"`. `title` (may be empty) is what a browser
  /// shows under the pointer; it is escaped here.
  void region(const Region& region, std::string_view attributes, std::string_view title = "");
  void line(const Polyline& line, std::string_view attributes, std::string_view title = "");
  void circle(const Vec2& centre, double radius, std::string_view attributes,
              std::string_view title = "");
  void text(const Vec2& place, double size, std::string_view text,
            std::string_view attributes = "");

  /// Names a box that groups can be cut to: clip-path="url(#name)".
  void clip_box(std::string_view name, const Box& box);

  /// Opens and closes a group of elements with common attributes.
  void begin_group(std::string_view attributes);
  void end_group();

  /// A place of the legend panel [m]: `right` of the picture's left edge, `down` from its lower.
  Vec2 panel_point(double right, double down) const;
  const Box& box() const { return box_; }

  /// The whole file. `title` names the picture; it is escaped here. The attribute data-box tells
  /// what is shown: least x and y, greatest x and y.
  std::string finish(std::string_view title) const;

 private:
  void points(const std::vector<Vec2>& line);
  void close_element(std::string_view element, std::string_view title);

  Box box_;
  double panel_;
  std::string body_;
};

}  // namespace pedzone
