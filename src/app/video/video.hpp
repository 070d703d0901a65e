// An animation as a film: frames of its page, drawn by Chromium and packed by ffmpeg.
#pragma once

#include <string>

namespace pedzone {

struct VideoOptions {
  std::string file;    ///< .mp4, .webm or .gif; empty: none
  double speed = 1.0;  ///< > 0 seconds of the run in one of the film
  double rate = 25.0;  ///< [1/s] frames
  int width = 1280;    ///< [pixels], made even; the height is 9/16 of it
};

/// Throws InputError where the file's ending is none of these, or a program is missing that makes
/// it: to be called before work is done in vain.
void require_video_programs(const VideoOptions& options);

/// Writes the film of a page (view/animation.hpp); shows progress. Returns 0, or 128 + the signal
/// that interrupted it: there is no file then. Throws InputError, std::runtime_error.
int make_video(const std::string& page, const VideoOptions& options);

}  // namespace pedzone
