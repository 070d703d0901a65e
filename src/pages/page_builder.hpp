// A page out of its mustache template, JSON and scripts that draw.
#pragma once

#include <map>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>

namespace pedzone {

using PageJson = nlohmann::ordered_json;

/// What the build makes of a page's folder. The template takes `{{>head}}` before its <body>, and
/// `{{>foot}}` after its <main>.
struct PageParts {
  std::string_view pattern, styles, scripts;
  /// Templates that `pattern` takes by these names more than once: {{>name}}.
  std::map<std::string, std::string_view> partials = {};
};

/// JSON that may stand inside <script>: '<' is only in its strings, and written as an escape.
std::string script_json(const PageJson& json);

/// The page: one file that fetches nothing and runs no script but its own. `shown` is for the
/// template and has a `title`; an empty text is to the template what is not there. `drawn` is for
/// the scripts; it names the `models` whose colours are the page's variables (palette.hpp). `texts`
/// are put in as they are under their names: beside `shown`, since they are large.
std::string rendered_page(const PageParts& parts, const PageJson& shown, const PageJson& drawn,
                          const std::map<std::string, std::string>& texts = {});

}  // namespace pedzone
