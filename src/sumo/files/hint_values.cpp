#include "sumo/files/hint_values.hpp"

#include <algorithm>
#include <map>

#include "core/random.hpp"
#include "core/xml.hpp"
#include "core/xml_stream.hpp"

namespace pedzone {
namespace {

/// "texting phoning=0.5": each with the rate [1/min] at which it begins, or its usual one.
std::array<double, kActivities> rates_of(const std::string& text) {
  std::array<double, kActivities> rates{};
  for (const std::string& word : split_words(text)) {
    const std::size_t equals = word.find('=');
    const ActivityInfo* info = find_activity(word.substr(0, equals));
    if (info == nullptr || info->activity == Activity::kNone) {
      throw HintProblem{"is no activity", word, activity_ids()};
    }
    double rate = info->rate;
    if (equals != std::string::npos &&
        (!parse_number(word.substr(equals + 1), rate) || rate < 0.0 || rate > 60.0)) {
      throw HintProblem{"has no rate", word, "ACTIVITY or ACTIVITY=0 to 60 (per minute)"};
    }
    rates[static_cast<std::size_t>(info->activity)] = rate;
  }
  return rates;
}

template <class Found>
Found known(Found found, const char* problem, const std::string& value, const std::string& ids) {
  if (found == nullptr) throw HintProblem{problem, value, ids};
  return found;
}

/// Who is in each group of a scenario's files. A vType or a personFlow counts as many.
class GroupCount {
 public:
  /// To be shown every element in its order.
  void visit(const XmlElement& element) {
    parents_.resize(static_cast<std::size_t>(element.depth()));
    parents_.emplace_back(element.name());
    if (element.name() != "param" || element.depth() == 0) return;
    if (element.value("key") != "pedzone.group") return;
    const std::string group(element.value("value").value_or(""));
    if (group.empty()) return;
    const bool one = parents_[parents_.size() - 2] == "person";
    Group& found = groups_.try_emplace(group, Group{0, lone(element, group)}).first->second;
    found.members += one ? 1 : 2;
  }

  /// Throws the InputError of the first of those with one member.
  void require_company() const {
    for (const auto& [id, group] : groups_) {
      if (group.members == 1) throw group.error;
    }
  }

 private:
  struct Group {
    int members;
    InputError error;
  };

  static InputError lone(const XmlElement& element, const std::string& group) {
    return element.error("is a group of one", "value", group,
                         "the same pedzone.group for two persons or more");
  }

  std::vector<std::string> parents_;     ///< names of the open elements, the last one included
  std::map<std::string, Group> groups_;  ///< by id
};

}  // namespace

void take_hint(std::string_view key, const std::string& value, const HintContext& context,
               PersonHints& hints) {
  // For SUMO a parameter without a value is none, too.
  if (value.empty()) return;
  if (key == "pedzone.profile") {
    hints.profile =
        known(context.profiles.find(value), "is no profile", value, context.profiles.ids());
  } else if (key == "pedzone.aware") {
    if (value != "true" && value != "false") {
      throw HintProblem{"is neither true nor false", value, "true, false"};
    }
    hints.aware = value == "true";
  } else if (key == "pedzone.group") {
    hints.group = person_key(value);
  } else if (key == "pedzone.activities") {
    hints.rates = rates_of(value);
  } else if (key == "pedzone.path") {
    hints.path = known(find_path(context.paths, value), "is no path of the zone file", value,
                       path_ids(context.paths));
  }
}

void require_known_hints(const Scenario& scenario, const HintContext& context) {
  const auto check = [&](const XmlElement& element) {
    if (element.name() != "param") return;
    const auto key = std::ranges::find(kHintKeys, element.value("key").value_or(""));
    if (key == std::end(kHintKeys)) return;
    PersonHints unused;
    try {
      take_hint(*key, std::string(element.value("value").value_or("")), context, unused);
    } catch (const HintProblem& hint) {
      throw element.error(hint.problem, "value", hint.value, hint.allowed);
    }
  };
  GroupCount groups;
  for (const auto* files : {&scenario.route_files, &scenario.additional_files}) {
    for (const std::string& file : *files) {
      visit_elements(file, "", [&](const XmlElement& element) {
        check(element);
        groups.visit(element);
      });
    }
  }
  groups.require_company();
}

}  // namespace pedzone
