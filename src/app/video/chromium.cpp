#include "app/video/chromium.hpp"

#include <openssl/evp.h>
#include <unistd.h>

#include <filesystem>
#include <stdexcept>

namespace pedzone {
namespace {

using Json = nlohmann::json;

constexpr int kReads = 3, kWrites = 4;  // descriptors of --remote-debugging-pipe

std::vector<std::string> command_of(const std::string& program, const std::string& folder) {
  std::vector<std::string> words{program,
                                 "--headless",
                                 "--disable-gpu",
                                 "--hide-scrollbars",
                                 "--no-first-run",
                                 "--disable-extensions",
                                 "--disable-dev-shm-usage",
                                 "--disable-background-networking",
                                 "--force-color-profile=srgb",
                                 "--remote-debugging-pipe",
                                 "--user-data-dir=" + folder};
  // Chromium refuses to run as root in its sandbox. The page is our own and fetches nothing.
  if (geteuid() == 0) words.emplace_back("--no-sandbox");
  return words;
}

/// RFC 3986: a name of a file may hold any byte.
std::string address_of(const std::string& file) {
  constexpr const char* kHex = "0123456789ABCDEF";
  std::string address = "file://";
  for (const unsigned char c : std::filesystem::absolute(file).string()) {
    if (std::isalnum(c) != 0 || c == '/' || c == '.' || c == '-' || c == '_') {
      address += static_cast<char>(c);
    } else {
      address += {'%', kHex[c >> 4U], kHex[c & 15U]};
    }
  }
  return address;
}

std::string from_base64(const std::string& text) {
  std::string bytes(text.size() / 4 * 3, '\0');
  const int length = EVP_DecodeBlock(reinterpret_cast<unsigned char*>(bytes.data()),
                                     reinterpret_cast<const unsigned char*>(text.data()),
                                     static_cast<int>(text.size()));
  if (length < 0) throw std::runtime_error("chromium sent a picture that is none");
  const std::size_t padding = text.ends_with("==") ? 2 : text.ends_with('=') ? 1 : 0;
  bytes.resize(static_cast<std::size_t>(length) - padding);
  return bytes;
}

}  // namespace

std::optional<std::string> Chromium::installed() {
  return installed_program(
      {"chromium", "chromium-browser", "google-chrome", "google-chrome-stable"});
}

Chromium::Chromium(const std::string& program, const std::string& page, int width, int height)
    : program_(command_of(program, folder_.path()), kReads, kWrites, folder_.path()) {
  const Json target = call("Target.createTarget", {{"url", "about:blank"}});
  const Json attached =
      call("Target.attachToTarget", {{"targetId", target.at("targetId")}, {"flatten", true}});
  session_ = attached.at("sessionId");
  call("Emulation.setDeviceMetricsOverride",
       {{"width", width}, {"height", height}, {"deviceScaleFactor", 1}, {"mobile", false}});
  call("Page.enable", Json::object());
  call("Page.navigate", {{"url", address_of(page)}});
  wait_for("Page.loadEventFired");
}

Json Chromium::hear() { return Json::parse(program_.hear_until('\0')); }

Json Chromium::call(const std::string& method, const Json& parameters) {
  Json message{{"id", ++calls_}, {"method", method}, {"params", parameters}};
  if (!session_.empty()) message["sessionId"] = session_;
  program_.send(message.dump() + '\0');
  for (;;) {
    const Json answer = hear();
    if (answer.value("id", 0) != calls_) continue;  // an event
    if (answer.contains("error")) {
      throw std::runtime_error("chromium: " + method + ": " +
                               answer["error"].value("message", "failed"));
    }
    return answer.at("result");
  }
}

void Chromium::wait_for(const std::string& event) {
  while (hear().value("method", "") != event) {
  }
}

Json Chromium::evaluate(const std::string& expression) {
  const Json answer =
      call("Runtime.evaluate",
           {{"expression", expression}, {"awaitPromise", true}, {"returnByValue", true}});
  if (answer.contains("exceptionDetails")) {
    throw std::runtime_error(
        "the page cannot be shown: " + answer["exceptionDetails"].value("text", "") + ' ' +
        answer.at("result").value("description", ""));
  }
  return answer.at("result").value("value", Json());
}

std::string Chromium::picture() {
  const Json answer =
      call("Page.captureScreenshot", {{"format", "png"}, {"optimizeForSpeed", true}});
  return from_base64(answer.at("data"));
}

}  // namespace pedzone
