// Whole numbers as text, many of them in little room: for data inside a page.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace pedzone {

/// The numbers as zigzag varints (seven bits a byte, low ones first), deflated (zlib's format), in
/// base64.
std::string packed(std::span<const std::int32_t> numbers);

/// Rows of numbers that change little from one to the next, kept as their differences.
class DifferenceRows {
 public:
  enum class Order { kFirst, kSecond };
  explicit DifferenceRows(Order order) : order_(order) {}

  /// The next number begins a row: it is kept as it is, the second one as its difference from it.
  void begin_row();
  void add(std::int32_t number);
  std::span<const std::int32_t> differences() const { return differences_; }

 private:
  Order order_;
  bool begins_ = true;
  std::int32_t last_ = 0, last_step_ = 0;
  std::vector<std::int32_t> differences_;
};

}  // namespace pedzone
