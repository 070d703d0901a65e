#include "sumo/calls/move_batch.hpp"

#include <libsumo/TraCIConstants.h>
#include <libsumo/TraCIDefs.h>

#include <bit>
#include <cstdint>

#include "sumo/calls/wire.hpp"

namespace pedzone {
namespace {

// Numbers go with their highest byte first.
void put_byte(std::string& out, int value) { out.push_back(static_cast<char>(value)); }
void put_int(std::string& out, std::uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8)
    put_byte(out, static_cast<int>(value >> shift & 255));
}
void put_raw_string(std::string& out, const std::string& value) {
  put_int(out, static_cast<std::uint32_t>(value.size()));
  out += value;
}
void put_double(std::string& out, double value) {
  put_byte(out, libsumo::TYPE_DOUBLE);
  const auto bits = std::bit_cast<std::uint64_t>(value);
  put_int(out, static_cast<std::uint32_t>(bits >> 32));
  put_int(out, static_cast<std::uint32_t>(bits));
}

std::uint32_t int_at(const std::string& text, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t k = 0; k < 4; ++k)
    value = value << 8 | static_cast<unsigned char>(text.at(at + k));
  return value;
}

/// Each command is answered by length, command, result and a description.
void check_answer(const std::string& answer, std::size_t commands) {
  std::size_t at = 0;
  for (std::size_t k = 0; k < commands; ++k) {
    std::size_t begin = at, length = static_cast<unsigned char>(answer.at(at++));
    if (length == 0) {
      length = int_at(answer, at);
      at += 4;
    }
    const int result = static_cast<unsigned char>(answer.at(at + 1));
    if (result != libsumo::RTYPE_OK) {
      throw libsumo::TraCIException(answer.substr(at + 6, int_at(answer, at + 2)));
    }
    at = begin + length;
  }
}

}  // namespace

void MoveBatch::add(const std::string& person, double x, double y, double angle, int keep_route,
                    double match_threshold) {
  constexpr std::uint32_t kValues = 6;
  std::string command;
  put_byte(command, libsumo::CMD_SET_PERSON_VARIABLE);
  put_byte(command, libsumo::MOVE_TO_XY);
  put_raw_string(command, person);
  put_byte(command, libsumo::TYPE_COMPOUND);
  put_int(command, kValues);
  put_byte(command, libsumo::TYPE_STRING);
  put_raw_string(command, "");  // on no edge in particular
  put_double(command, x);
  put_double(command, y);
  put_double(command, angle);
  put_byte(command, libsumo::TYPE_BYTE);
  put_byte(command, keep_route);
  put_double(command, match_threshold);
  put_byte(commands_, 0);  // a length of four bytes follows, which it counts, too
  put_int(commands_, static_cast<std::uint32_t>(command.size() + 5));
  commands_ += command;
  ++count_;
}

void MoveBatch::send() {
  std::string message;
  put_int(message, static_cast<std::uint32_t>(commands_.size() + 4));
  message += commands_;
  const std::size_t count = count_;
  commands_.clear();
  count_ = 0;
  write_wire(message);
  check_answer(read_wire(int_at(read_wire(4), 0) - 4), count);
}

}  // namespace pedzone
