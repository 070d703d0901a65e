// What somebody who mistyped a word has meant.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace pedzone {

/// The name that was most likely meant by `word`; empty: none is near. A name is near if few
/// letters of the word are missing, too many, wrong, or swapped with their neighbour, or if the
/// name begins with the word.
std::string nearest_word(std::string_view word, std::span<const std::string> names);

/// The same as the end of a message: ". Did you mean 'name'?"; empty where there is none.
std::string did_you_mean(std::string_view word, std::span<const std::string> names);

}  // namespace pedzone
