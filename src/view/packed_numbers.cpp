#include "view/packed_numbers.hpp"

#include <zlib.h>

#include <algorithm>
#include <stdexcept>
#include <string_view>

namespace pedzone {
namespace {

std::vector<unsigned char> varints(std::span<const std::int32_t> numbers) {
  std::vector<unsigned char> bytes;
  bytes.reserve(numbers.size() + numbers.size() / 4);
  for (const std::int32_t number : numbers) {
    // 0, -1, 1, -2, ... as 0, 1, 2, 3, ...
    std::uint32_t rest = (static_cast<std::uint32_t>(number) << 1) ^ (number < 0 ? ~0U : 0U);
    for (; rest > 127; rest >>= 7) bytes.push_back(static_cast<unsigned char>(rest | 128));
    bytes.push_back(static_cast<unsigned char>(rest));
  }
  return bytes;
}

std::vector<unsigned char> deflated(const std::vector<unsigned char>& bytes) {
  uLongf size = compressBound(bytes.size());
  std::vector<unsigned char> small(size);
  if (compress2(small.data(), &size, bytes.data(), bytes.size(), Z_BEST_COMPRESSION) != Z_OK) {
    throw std::runtime_error("cannot compress: out of memory");
  }
  small.resize(size);
  return small;
}

std::string base64(const std::vector<unsigned char>& bytes) {
  constexpr std::string_view kLetters =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t there = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t three = 0;
    for (std::size_t k = 0; k < 3; ++k) three = three << 8 | (k < there ? bytes[i + k] : 0U);
    for (std::size_t k = 0; k < 4; ++k) {
      text += k <= there ? kLetters[three >> (18 - 6 * k) & 63] : '=';
    }
  }
  return text;
}

}  // namespace

std::string packed(std::span<const std::int32_t> numbers) {
  return base64(deflated(varints(numbers)));
}

void DifferenceRows::begin_row() {
  begins_ = true;
  last_step_ = 0;
}

void DifferenceRows::add(std::int32_t number) {
  const std::int32_t step = begins_ ? number : number - last_;
  differences_.push_back(order_ == Order::kSecond ? step - last_step_ : step);
  // The first number is a place, not a step.
  if (!begins_) last_step_ = step;
  begins_ = false;
  last_ = number;
}

}  // namespace pedzone
