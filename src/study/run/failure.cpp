#include "study/run/failure.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string_view>

#include "core/error.hpp"
#include "results/complete_file.hpp"

namespace pedzone::study {
namespace {

namespace fs = std::filesystem;

constexpr std::streamoff kLogEnd = 2000;      // bytes of a log that a record keeps
constexpr std::size_t kProbe = 256UL * 1024;  // bytes that a disk with space left can take

std::string end_of_log(const std::string& folder) {
  std::ifstream log(folder + "/" + kLogFile, std::ios::binary | std::ios::ate);
  if (!log) return "";
  const std::streamoff size = log.tellg();
  log.seekg(std::max<std::streamoff>(0, size - kLogEnd));
  if (size > kLogEnd) log.ignore(kLogEnd, '\n');  // the rest of a line
  std::ostringstream text;
  text << log.rdbuf();
  return text.str();
}

/// Whether all of it gets to the disk; else errno says why not.
bool takes(int file, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = write(file, text.data(), text.size());
    if (written < 0) return false;
    text.remove_prefix(static_cast<std::size_t>(written));  // on a disk nearly full, a part
  }
  return fsync(file) == 0;
}

}  // namespace

std::string failure_sentence(const std::string& folder, const Ending& ending) {
  std::ifstream file(folder + "/" + kFailureFile);
  std::string sentence;
  if (std::getline(file, sentence) && !sentence.empty()) return sentence;
  return "the run's process " + ending.text();
}

void record_failure(RunContext& context, const PlannedRun& run, const GivenUp& given_up,
                    const std::string& folder) {
  RunRecord record;
  try {
    record = blank_record(context, run);
  } catch (const InputError&) {  // gone: that is why it has failed
    record.id = run.id;
    record.definition = run.definition;
    record.versions = context.store.versions();
  }
  record.status = given_up.status;
  record.failure = given_up.why + "\n" + end_of_log(folder);
  record.attempts = given_up.attempts;
  record.wall_s = given_up.wall_s;
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().filename() != kLogFile) fs::remove_all(entry.path());
  }
  write_complete_file(folder + "/record.json", record_text(record), kOutOption);
  context.store.finish(folder, run.id);
}

void check_disk(const std::string& results) {
  // What is free by the file system's own account is not always to be had: quotas, reserves.
  const std::string probe = results + "/runs/.space";
  const int file = open(probe.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600);
  if (file < 0 && errno == ENOENT) return;  // there are no results
  const bool space = file >= 0 && takes(file, std::string(kProbe, '\0'));
  const int why = errno;
  if (file >= 0) close(file);
  unlink(probe.c_str());
  if (space) return;
  throw InputError("cannot be written to (" + std::string(std::strerror(why)) + ")",
                   {.element = "results",
                    .value = results,
                    .allowed = "space for the outputs of the runs; what is done is kept, and the "
                               "same command goes on from there"});
}

}  // namespace pedzone::study
