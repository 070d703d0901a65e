#include "zone/panel.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "core/text.hpp"

namespace pedzone {
namespace {

constexpr int kGroupLeast = 2, kGroupMost = 5;  // where nothing is said
constexpr NumberRange kNumbers{1, 1e6}, kRates{0.001, 1e6}, kTimes{0, 1e9}, kShares{0, 1};
constexpr NumberRange kSpeeds{0.1, 5.0};  // [m/s] as Profile's
constexpr NumberRange kGroups{0, 1e6}, kGroupSizes{2, 50};
constexpr const char* kNotInIds = " \t\r\n|\\'\";,<>&";  // SUMO refuses them
constexpr double kSlack = 1e-9;  // numerical: shares are sums of decimal fractions

constexpr PanelField kFields[] = {
    {"id", "id", "a new id", "pedestrians", "people are ID.0, ID.1, ..."},
    {"number", "", "1 to 1000000", "as perHour has it", "how many"},
    {"perHour", "per-hour", "0.001 to 1000000", "all at begin; with end, at random times until it",
     "they come at random times, so many an hour, until number or end is reached"},
    {"begin", "begin", "seconds", "the simulation's", "nobody departs before"},
    {"end", "end", "seconds", "open", "nobody departs later"},
    {"from", "from", "ids of edges", "the zone's edges", "where they begin, anywhere along these"},
    {"to", "to", "ids of edges", "the zone's edges", "where they go"},
    {"zone", "zone", "id of a zone", "all zones", "whose edges from and to are where not given"},
    {"alone", "alone", "0 to 1", "0.45; with groups, the rest",
     "share of people who walk alone (Moussaid 2010)"},
    {"groups", "groups", "0 to 1000000", "as alone has it", "so many groups in all; needs number"},
    {"groupSize", "group-size", "2 to 50, or a range as 2-5", "2-5",
     "members of a group; the larger the rarer (James 1953)"},
    {"speedMin", "speed-min", "0.1 to 5 m/s", "0.1", "nobody prefers to walk slower"},
    {"speedMax", "speed-max", "0.1 to 5 m/s", "the profile's topSpeed",
     "nobody prefers to walk faster"},
    {"profiles", "profiles", "PROFILE=SHARE ...", "the profiles' own shares",
     "shares of people; what is left goes to the other profiles"},
    {"activities", "activities", "ACTIVITY=SHARE ...", "none",
     "shares of people who do it now and then, each person one at most"},
    {"path", "path", "id of a path", "none", "waypoints that they follow"},
    {"atEnd", "at-end", "leave, stay", "leave", "what they do where the walk ends"},
};

const PanelField& field_of(std::string_view attribute) {
  return *std::ranges::find(kFields, attribute, &PanelField::attribute);
}

std::string attributes() { return comma_list(kFields, &PanelField::attribute); }

/// The values of a panel, each read once.
class Values {
 public:
  explicit Values(const PanelText& text) : text_(text) {}

  const std::string* find(std::string_view attribute) const {
    const auto found =
        std::ranges::find(text_.values, attribute, &std::pair<std::string, std::string>::first);
    if (found == text_.values.end()) return nullptr;
    if (found->second.empty()) throw error("is empty", attribute);
    return &found->second;
  }

  std::string word(std::string_view attribute, const std::string& otherwise) const {
    const std::string* value = find(attribute);
    return value ? *value : otherwise;
  }

  std::optional<double> number(std::string_view attribute, const NumberRange& range) const {
    const std::string* value = find(attribute);
    if (!value) return std::nullopt;
    return parse(attribute, *value, range);
  }

  std::optional<long> whole(std::string_view attribute, const NumberRange& range) const {
    const auto value = number(attribute, range);
    if (!value) return std::nullopt;
    if (*value != std::floor(*value)) throw error("is no whole number", attribute);
    return static_cast<long>(*value);
  }

  /// Words, each once.
  std::vector<std::string> list(std::string_view attribute) const {
    const std::string* value = find(attribute);
    if (!value) return {};
    const auto words = split_words(*value);
    if (words.empty()) throw error("is empty", attribute);
    std::set<std::string> known;
    for (const std::string& word : words) {
      if (!known.insert(word).second) throw error("is named twice", attribute, word);
    }
    return words;
  }

  /// "NAME=SHARE ...", in all at most 1.
  std::vector<std::pair<std::string, double>> shares(std::string_view attribute) const {
    std::vector<std::pair<std::string, double>> read;
    std::set<std::string> known;
    double sum = 0.0;
    for (const std::string& word : list(attribute)) {
      const std::size_t equals = word.find('=');
      if (equals == 0 || equals == std::string::npos) throw error("has no share", attribute, word);
      const std::string name = word.substr(0, equals);
      const double share = parse(attribute, word.substr(equals + 1), kShares);
      if (!known.insert(name).second) throw error("is named twice", attribute, name);
      read.emplace_back(name, share);
      sum += share;
    }
    if (sum > 1.0 + kSlack) {
      throw panel_error(text_, "has shares that add to more than 1", attribute, *find(attribute),
                        "shares of at most 1 in all");
    }
    return read;
  }

  /// "3" or "2-5".
  std::pair<int, int> sizes(std::string_view attribute) const {
    const std::string* value = find(attribute);
    if (!value) return {kGroupLeast, kGroupMost};
    const std::size_t dash = value->find('-');
    const auto size = [&](const std::string& text) {
      const double number = parse(attribute, text, kGroupSizes);
      if (number != std::floor(number)) throw error("is no whole number", attribute, text);
      return static_cast<int>(number);
    };
    if (dash == std::string::npos) return {size(*value), size(*value)};
    const std::pair<int, int> range{size(value->substr(0, dash)), size(value->substr(dash + 1))};
    if (range.first > range.second) throw error("runs backwards", attribute);
    return range;
  }

  InputError error(const std::string& problem, std::string_view attribute,
                   const std::string& value = "") const {
    const auto given =
        std::ranges::find(text_.values, attribute, &std::pair<std::string, std::string>::first);
    const bool whole = value.empty() && given != text_.values.end();
    return panel_error(text_, problem, attribute, whole ? given->second : value,
                       std::string(field_of(attribute).value));
  }

 private:
  double parse(std::string_view attribute, const std::string& text,
               const NumberRange& range) const {
    double number = 0.0;
    if (!parse_number(text, number)) throw error("is not a number", attribute, text);
    if (number < range.least || number > range.most) {
      throw error("is out of range", attribute, text);
    }
    return number;
  }

  const PanelText& text_;
};

void read_times(const Values& values, PanelSpec& spec) {
  spec.number = values.whole("number", kNumbers);
  spec.per_hour = values.number("perHour", kRates);
  spec.begin = values.number("begin", kTimes);
  spec.end = values.number("end", kTimes);
  if (!spec.number && !spec.per_hour) {
    throw panel_error(spec.text, "is missing", "number", "", "number or perHour");
  }
  if (!spec.number && !spec.end) {
    throw panel_error(spec.text, "is missing", "end", "", "perHour with number or end");
  }
  const double hours = (spec.end.value_or(0.0) - spec.begin.value_or(0.0)) / 3600.0;
  if (!spec.number && *spec.per_hour * hours > kNumbers.most) {
    throw panel_error(spec.text, "asks for too many people until end", "perHour",
                      *values.find("perHour"), "1000000 in all");
  }
  if (spec.end && spec.begin.value_or(0.0) > *spec.end) {
    throw values.error("lies before begin", "end");
  }
}

void read_groups(const Values& values, PanelSpec& spec) {
  const auto alone = values.number("alone", kShares);
  spec.alone = alone.value_or(kAlone);
  spec.groups = values.whole("groups", kGroups);
  std::tie(spec.group_least, spec.group_most) = values.sizes("groupSize");
  if (!spec.groups) return;
  if (alone) {
    throw panel_error(spec.text, "contradicts groups", "alone", *values.find("alone"),
                      "one of the two");
  }
  if (!spec.number) {
    throw panel_error(spec.text, "needs number", "groups", *values.find("groups"),
                      "groups together with number");
  }
  if (*spec.groups * spec.group_least > *spec.number) {
    throw panel_error(spec.text, "is too many", "groups", *values.find("groups"),
                      "0 to " + std::to_string(*spec.number / spec.group_least) + " groups of " +
                          std::to_string(spec.group_least) + " or more among " +
                          std::to_string(*spec.number));
  }
}

void read_profiles(const Values& values, const Profiles& profiles, PanelSpec& spec) {
  spec.profiles = values.shares("profiles");
  for (const auto& [id, share] : spec.profiles) {
    const Profile* profile = profiles.find(id);
    if (!profile) {
      throw panel_error(spec.text, "is no profile", "profiles", id, profiles.ids());
    }
    if (share > 0.0 && profile->top_speed < spec.speed_min) {
      throw panel_error(spec.text, "cannot walk so fast", "profiles", id,
                        "profiles whose topSpeed is above speedMin");
    }
  }
}

void read_activities(const Values& values, PanelSpec& spec) {
  for (const auto& [id, share] : values.shares("activities")) {
    const ActivityInfo* info = find_activity(id);
    if (!info || info->activity == Activity::kNone) {
      throw panel_error(spec.text, "is no activity", "activities", id, activity_ids());
    }
    spec.activities.emplace_back(info->activity, share);
  }
}

/// Share of people with whom a small child can walk: all but one of each group.
double share_of_room(const PanelSpec& spec) {
  const double mean = mean_group(spec);
  if (!spec.groups) return (1.0 - spec.alone) * (mean - 1.0) / mean;
  const double number = static_cast<double>(*spec.number);
  return std::min(1.0, static_cast<double>(*spec.groups) * (mean - 1.0) / number);
}

void check_guarded(const PanelSpec& spec, const Profiles& profiles) {
  double guarded = 0.0;
  std::string first;
  for (const auto& [id, share] : spec.profiles) {
    if (profiles.find(id)->guarded < 0.5 || share <= 0.0) continue;
    guarded += share;
    if (first.empty()) first = id;
  }
  if (guarded <= share_of_room(spec) + kSlack) return;
  throw panel_error(spec.text, "would have to walk alone", "profiles", first,
                    "no more than one less than each group has members: more or larger groups "
                    "(alone, groups, groupSize) or a smaller share");
}

}  // namespace

std::span<const PanelField> panel_fields() { return kFields; }

InputError panel_error(const PanelText& text, const std::string& problem,
                       std::string_view attribute, const std::string& value,
                       const std::string& allowed) {
  if (text.file.empty()) {
    const std::string option(attribute.empty() ? "" : field_of(attribute).option);
    const std::string name = option.empty() ? "--pedestrians" : "--pedestrians-" + option;
    return InputError(problem, {"", 0, "option " + name, value, allowed});
  }
  const auto id = std::ranges::find(text.values, "id", &std::pair<std::string, std::string>::first);
  std::string element =
      id == text.values.end() ? "<pedestrians>" : "<pedestrians id=\"" + id->second + "\">";
  if (!attribute.empty()) element += " attribute " + std::string(attribute);
  return InputError(problem, {text.file, text.line, element, value, allowed});
}

double group_weight(int size) {
  const double parameter = -std::log(kAlone);
  return std::pow(parameter, size) / std::tgamma(size + 1.0);
}

double mean_group(const PanelSpec& spec) {
  double sum = 0.0, weights = 0.0;
  for (int size = spec.group_least; size <= spec.group_most; ++size) {
    sum += size * group_weight(size);
    weights += group_weight(size);
  }
  return sum / weights;
}

std::vector<double> profile_shares(const PanelSpec& spec, const Profiles& profiles) {
  std::vector<double> shares;
  std::vector<bool> named;
  double given = 0.0, rest = 0.0;
  for (const Profile& profile : profiles.all()) {
    const auto found =
        std::ranges::find(spec.profiles, profile.id, &std::pair<std::string, double>::first);
    named.push_back(found != spec.profiles.end());
    const bool able = profile.top_speed >= spec.speed_min;
    shares.push_back(named.back() ? found->second : able ? profile.share : 0.0);
    (named.back() ? given : rest) += shares.back();
  }
  if (rest <= 0.0 && given < 1.0 - kSlack) {
    throw panel_error(spec.text, "leaves nobody for the rest", "profiles", "",
                      "shares of 1 in all, or other profiles that can walk in the range of speeds");
  }
  for (std::size_t i = 0; i < shares.size(); ++i) {
    if (!named[i] && rest > 0.0) shares[i] *= std::max(0.0, 1.0 - given) / rest;
  }
  return shares;
}

PanelSpec read_panel(PanelText text, const Profiles& profiles, const std::vector<PathSpec>& paths,
                     std::size_t index) {
  PanelSpec spec;
  spec.text = std::move(text);
  for (const auto& [name, value] : spec.text.values) {
    if (std::ranges::find(kFields, name, &PanelField::attribute) != std::end(kFields)) continue;
    throw panel_error(spec.text, "is an unknown attribute", "", name, attributes());
  }
  const Values values(spec.text);
  spec.id = values.word("id", index == 0 ? spec.id : spec.id + std::to_string(index + 1));
  if (spec.id.find_first_of(kNotInIds) != std::string::npos) {
    throw panel_error(spec.text, "is no id", "id", spec.id, "no spaces and none of |\\'\";,<>&");
  }
  read_times(values, spec);
  spec.from = values.list("from");
  spec.to = values.list("to");
  spec.zone = values.word("zone", "");
  read_groups(values, spec);
  spec.speed_min = values.number("speedMin", kSpeeds).value_or(kSpeeds.least);
  spec.speed_max = values.number("speedMax", kSpeeds).value_or(kSpeeds.most);
  if (spec.speed_max < spec.speed_min) {
    throw panel_error(spec.text, "lies below speedMin", "speedMax", *values.find("speedMax"),
                      "speedMin to 5 m/s");
  }
  read_profiles(values, profiles, spec);
  profile_shares(spec, profiles);  // for what it refuses
  check_guarded(spec, profiles);
  read_activities(values, spec);
  spec.path = values.word("path", "");
  if (!spec.path.empty() && std::ranges::find(paths, spec.path, &PathSpec::id) == paths.end()) {
    const std::string allowed = comma_list(paths, &PathSpec::id);
    throw panel_error(spec.text, "is no path", "path", spec.path,
                      allowed.empty() ? "none: the zone file has no <path>" : allowed);
  }
  const std::string at_end = values.word("atEnd", "leave");
  if (at_end != "leave" && at_end != "stay") throw values.error("is unknown", "atEnd");
  spec.stay = at_end == "stay";
  return spec;
}

void add_panel(std::vector<PanelSpec>& panels, PanelSpec panel) {
  if (std::ranges::find(panels, panel.id, &PanelSpec::id) != panels.end()) {
    throw panel_error(panel.text, "is used twice", "id", panel.id, "a new id");
  }
  panels.push_back(std::move(panel));
}

std::vector<PanelSpec> read_panels(const XmlFile& file, const Profiles& profiles,
                                   const std::vector<PathSpec>& paths) {
  std::vector<PanelSpec> specs;
  for (const pugi::xml_node& node : file.root().children("pedestrians")) {
    PanelText text{file.file(), file.line(node), {}};
    for (const pugi::xml_attribute& attribute : node.attributes()) {
      text.values.emplace_back(attribute.name(), attribute.value());
    }
    if (node.first_child()) throw file.error("holds something", node, "", "", "attributes only");
    add_panel(specs, read_panel(std::move(text), profiles, paths, specs.size()));
  }
  return specs;
}

}  // namespace pedzone
