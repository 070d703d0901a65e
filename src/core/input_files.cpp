#include "core/input_files.hpp"

#include <filesystem>
#include <mutex>
#include <optional>
#include <unordered_set>

namespace pedzone {
namespace {

std::mutex guard;
std::unordered_set<std::string> noted;

/// Its one name without links; nothing where it is not there, or no plain file.
std::optional<std::string> plain_name(const std::string& file) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return std::nullopt;
  const std::filesystem::path path = std::filesystem::canonical(file, error);
  return error ? std::nullopt : std::optional(path.string());
}

}  // namespace

void note_input(const std::string& file) {
  const auto name = plain_name(file);
  if (!name) return;
  const std::scoped_lock lock(guard);
  noted.insert(*name);
}

bool is_input(const std::string& file) {
  const auto name = plain_name(file);
  if (!name) return false;
  const std::scoped_lock lock(guard);
  return noted.contains(*name);
}

}  // namespace pedzone
