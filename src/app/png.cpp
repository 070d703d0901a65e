#include "app/png.hpp"

#include <cstdio>
#include <stdexcept>

#include "core/command_output.hpp"
#include "core/error.hpp"

namespace pedzone {

std::string png_from_svg(const std::string& svg, int width) {
  const auto done = command_output(
      {"rsvg-convert", "--unlimited", "--keep-aspect-ratio", "--width=" + std::to_string(width)},
      svg);
  if (!done) {
    throw InputError("cannot be made: rsvg-convert is not installed",
                     {.element = "option --out, a PNG picture",
                      .allowed = ".svg, or .png with Debian's package librsvg2-bin installed"});
  }
  std::fputs(done->error.c_str(), stderr);
  if (done->code != 0) {
    throw std::runtime_error("rsvg-convert failed (exit code " + std::to_string(done->code) + ")");
  }
  return done->out;
}

}  // namespace pedzone
