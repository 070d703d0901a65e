// Numbers and times as SUMO writes them. What is none is nothing: SUMO itself complains of it.
#pragma once

#include <optional>
#include <string_view>

namespace pedzone {

std::optional<double> number_of(std::optional<std::string_view> text);

/// [s] of seconds, or of [days:]hours:minutes:seconds.
std::optional<double> time_of(std::optional<std::string_view> text);

}  // namespace pedzone
