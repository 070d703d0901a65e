#include "pages/page_builder.hpp"

#include <kainjow/mustache.hpp>
#include <vector>

#include "pages/palette.hpp"

namespace pedzone {

// Made by the build.
extern const std::string_view kPageLicences, kPageHead, kPageFoot;

namespace {

using Mustache = kainjow::mustache::data;

Mustache mustache(const PageJson& json) {
  if (json.is_object()) {
    Mustache object{Mustache::type::object};
    for (const auto& [key, value] : json.items()) object.set(key, mustache(value));
    return object;
  }
  if (json.is_array()) {
    Mustache list{Mustache::type::list};
    for (const PageJson& one : json) list.push_back(mustache(one));
    return list;
  }
  if (json.is_boolean()) return Mustache{json.get<bool>()};
  if (!json.is_string()) return Mustache{json.dump()};
  const auto& text = json.get_ref<const std::string&>();
  return text.empty() ? Mustache{false} : Mustache{text};
}

Mustache partial(std::string_view text) {
  return Mustache{kainjow::mustache::partial{[text] { return std::string(text); }}};
}

}  // namespace

std::string script_json(const PageJson& json) {
  std::string text;
  for (const char c : json.dump(-1, ' ', false, PageJson::error_handler_t::replace)) {
    if (c == '<') {
      text += "\\u003c";
    } else {
      text += c;
    }
  }
  return text;
}

std::string rendered_page(const PageParts& parts, const PageJson& shown, const PageJson& drawn,
                          const std::map<std::string, std::string>& texts) {
  Mustache all = mustache(shown);
  for (const auto& [name, text] : texts) all.set(name, text);
  for (const auto& [name, text] : parts.partials) all.set(name, partial(text));
  all.set("head", partial(kPageHead));
  all.set("foot", partial(kPageFoot));
  all.set("palette", palette_css(drawn.at("models").get<std::vector<std::string>>()));
  all.set("styles", std::string(parts.styles));
  all.set("scripts", std::string(parts.scripts));
  all.set("licences", std::string(kPageLicences));
  all.set("data", script_json(drawn));
  kainjow::mustache::mustache pattern{std::string(parts.pattern)};
  return pattern.render(all);
}

}  // namespace pedzone
