#include "app/video/video.hpp"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <stdexcept>
#include <vector>

#include "app/interrupts.hpp"
#include "app/share_bar.hpp"
#include "app/video/chromium.hpp"
#include "core/error.hpp"
#include "results/complete_file.hpp"

namespace pedzone {
namespace {

/// How ffmpeg packs a kind of file. The numbers are its own scales of quality: lines stay sharp.
struct Format {
  std::string_view ending, muxer;
  std::vector<std::string> words;
};

const Format& format_of(const VideoOptions& options) {
  static const std::vector<Format> kFormats{
      {".mp4",
       "mp4",
       {"-c:v", "libx264", "-crf", "20", "-pix_fmt", "yuv420p", "-movflags", "+faststart"}},
      {".webm",
       "webm",
       {"-c:v", "libvpx-vp9", "-crf", "30", "-b:v", "0", "-cpu-used", "4", "-pix_fmt", "yuv420p"}},
      {".gif",
       "gif",
       {"-filter_complex",
        "split[a][b];[a]palettegen=stats_mode=diff[p];[b][p]paletteuse=dither=none", "-loop",
        "0"}}};
  const std::string ending = std::filesystem::path(options.file).extension().string();
  for (const Format& format : kFormats) {
    if (format.ending == ending) return format;
  }
  throw InputError("is no kind of film", {.element = "option --video",
                                          .value = options.file,
                                          .allowed = "a name that ends with .mp4, .webm or .gif"});
}

std::optional<std::string> installed_ffmpeg() { return installed_program({"ffmpeg"}); }

/// Nothing in the file tells when or where it was made.
std::vector<std::string> ffmpeg_command(const VideoOptions& options, const std::string& out) {
  const Format& format = format_of(options);
  std::vector<std::string> words{*installed_ffmpeg(),
                                 "-hide_banner",
                                 "-loglevel",
                                 "error",
                                 "-y",
                                 "-f",
                                 "image2pipe",
                                 "-c:v",
                                 "png",
                                 "-framerate",
                                 fmt::format("{}", options.rate),
                                 "-i",
                                 "-",
                                 "-map_metadata",
                                 "-1",
                                 "-fflags",
                                 "+bitexact",
                                 "-flags:v",
                                 "+bitexact"};
  words.insert(words.end(), format.words.begin(), format.words.end());
  // file: has ffmpeg take any name as one.
  words.insert(words.end(), {"-f", std::string(format.muxer), "file:" + out});
  return words;
}

}  // namespace

void require_video_programs(const VideoOptions& options) {
  format_of(options);
  std::vector<std::string> missing;
  if (!installed_ffmpeg()) missing.emplace_back("ffmpeg");
  if (!Chromium::installed()) missing.emplace_back("chromium");
  if (missing.empty()) return;
  const std::string names = fmt::format("{}", fmt::join(missing, " and "));
  throw InputError(
      fmt::format("cannot be made: {} {} not installed", names, missing.size() > 1 ? "are" : "is"),
      {.element = "option --video",
       .value = options.file,
       .allowed =
           fmt::format("--out alone; or a film with Debian's {}: apt-get install {}",
                       missing.size() > 1 ? "packages" : "package", fmt::join(missing, " "))});
}

int make_video(const std::string& page, const VideoOptions& options) {
  PendingFile file(options.file, "--video");
  note_interrupts();  // from here on there is something to remove
  const TemporaryFolder folder;
  const std::string html = folder.path() + "/page.html";
  write_complete_file(html, page, "--video");
  // Codecs want even numbers.
  const int width = options.width / 2 * 2;
  const int height = 2 * static_cast<int>(std::lround(width * 9.0 / 32.0));
  Chromium browser(*Chromium::installed(), html, width, height);
  const nlohmann::json span = browser.evaluate("pedzone_begun.then(() => pedzone.film())");
  const double begin = span.at("begin"), end = span.at("end");
  PipedProgram ffmpeg(ffmpeg_command(options, file.name()), 0, -1);
  ShareBar bar("filming");
  const double step = options.speed / options.rate;  // [s] of the run
  const auto frames = static_cast<std::int64_t>(std::floor((end - begin) / step + 1e-9)) + 1;
  for (std::int64_t k = 0; k < frames && noted_interrupt() == 0; ++k) {
    browser.evaluate(fmt::format("pedzone.frame({})", begin + static_cast<double>(k) * step));
    ffmpeg.send(browser.picture());
    bar.update(static_cast<double>(k + 1) / static_cast<double>(frames));
  }
  bar.finish();
  if (const int signal = noted_interrupt(); signal != 0) {
    fmt::print(stderr, "Interrupted; no film was written.\n");
    return 128 + signal;
  }
  if (const Ending ending = ffmpeg.finish(); !ending.good()) {
    throw std::runtime_error(fmt::format("ffmpeg {}. {}", ending.text(), ffmpeg.said()));
  }
  file.finish();
  return 0;
}

}  // namespace pedzone
