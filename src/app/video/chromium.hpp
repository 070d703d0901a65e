// A page in Chromium without a display, driven over its DevTools protocol.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

#include "app/temporary_folder.hpp"
#include "app/video/piped_program.hpp"

namespace pedzone {

class Chromium {
 public:
  /// The browser's path; nothing: none is installed.
  static std::optional<std::string> installed();

  /// Opens the page in a window of that size [pixels]. Throws std::runtime_error where the browser
  /// does not start.
  Chromium(const std::string& program, const std::string& page, int width, int height);

  /// The value of an expression of the page's scripts, awaited. Throws std::runtime_error with what
  /// it throws.
  nlohmann::json evaluate(const std::string& expression);
  /// What the window shows, as a PNG file.
  std::string picture();

 private:
  nlohmann::json call(const std::string& method, const nlohmann::json& parameters);
  void wait_for(const std::string& event);
  nlohmann::json hear();

  TemporaryFolder folder_;
  PipedProgram program_;
  int calls_ = 0;
  std::string session_;  ///< of the page; empty: the browser itself is talked to
};

}  // namespace pedzone
