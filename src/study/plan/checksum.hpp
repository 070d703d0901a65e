// Checksums by which inputs and demands are told apart.
#pragma once

#include <string>
#include <string_view>

namespace pedzone::study {

/// SHA-256 of some bytes, as 64 hexadecimal digits.
std::string sha256_hex(std::string_view bytes);

}  // namespace pedzone::study
