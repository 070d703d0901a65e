// A page out of its mustache template and JSON.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

namespace pedzone {

using PageJson = nlohmann::ordered_json;

/// JSON that may stand inside <script>: '<' is only in its strings, and written as an escape.
std::string script_json(const PageJson& json);

/// The template with what `data` holds; an empty text is to it what is not there. `texts` are put
/// in as they are under their names (scripts, JSON of scripts): beside `data`, since they are
/// large.
std::string rendered_page(std::string_view page, const PageJson& data,
                          const std::map<std::string, std::string>& texts);

/// Licences of the libraries that draw in pages.
std::string_view page_licences();

}  // namespace pedzone
