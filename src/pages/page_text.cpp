#include "pages/page_text.hpp"

#include <kainjow/mustache.hpp>

namespace pedzone {

// Made by the build.
extern const std::string_view kPageLicences;

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

std::string rendered_page(std::string_view page, const PageJson& data,
                          const std::map<std::string, std::string>& texts) {
  Mustache all = mustache(data);
  for (const auto& [name, text] : texts) all.set(name, text);
  kainjow::mustache::mustache pattern{std::string(page)};
  return pattern.render(all);
}

std::string_view page_licences() { return kPageLicences; }

}  // namespace pedzone
