// The user's panel: <pedestrians .../> of a zone file, and the same as options of the command line.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/xml.hpp"
#include "world/activities.hpp"
#include "world/profiles.hpp"
#include "zone/paths.hpp"

namespace pedzone {

/// What is said of people, as text: attributes of an element or options of the command line.
struct PanelText {
  std::string file;  ///< empty: options
  int line = 0;
  std::vector<std::pair<std::string, std::string>> values;  ///< attribute, value
};

/// People to be made. Units and ranges stand in panel_fields().
struct PanelSpec {
  PanelText text;                     ///< what it was read from, for messages
  std::string id = "pedestrians";     ///< its people are ID.0, ID.1, ...
  std::optional<long> number;         ///< unset: as many as per_hour brings until `end`
  std::optional<double> per_hour;     ///< unset: all at `begin`, or at random times until `end`
  std::optional<double> begin;        ///< unset: when the simulation begins
  std::optional<double> end;          ///< unset: open
  std::vector<std::string> from, to;  ///< ids of edges; empty: those of the zone
  std::string zone;                   ///< id; empty: all zones
  double alone;                       ///< share of people; meaningless with `groups`
  std::optional<long> groups;         ///< so many in all; the others walk alone
  int group_least, group_most;
  double speed_min, speed_max;
  std::vector<std::pair<std::string, double>> profiles;  ///< shares; the rest: others, as in table
  std::vector<std::pair<Activity, double>> activities;   ///< shares
  std::string path;                                      ///< id; empty: none
  bool stay = false;                                     ///< at the end of the walk
};

/// One attribute, for --help, the README and messages.
struct PanelField {
  std::string_view attribute;
  std::string_view option;  ///< on the command line, without the dashes
  std::string_view value;   ///< what is allowed
  std::string_view otherwise;
  std::string_view meaning;
};
std::span<const PanelField> panel_fields();

/// Reads it. Throws InputError naming the file, line and element, or the option, the value and
/// what is allowed: numbers out of range, unknown profiles, activities and paths, shares of more
/// than 1 in all, groups of one, and small children who would have to walk alone.
/// `paths`: those that `path` may name. `index` counts the elements of a file; it makes their ids.
PanelSpec read_panel(PanelText text, const Profiles& profiles, const std::vector<PathSpec>& paths,
                     std::size_t index);

/// Adds one to others. Throws InputError where another one has its id.
void add_panel(std::vector<PanelSpec>& panels, PanelSpec panel);

/// The <pedestrians> elements of a zone file.
std::vector<PanelSpec> read_panels(const XmlFile& file, const Profiles& profiles,
                                   const std::vector<PathSpec>& paths);

/// The error for one of its attributes (or for all of it when `attribute` is empty).
InputError panel_error(const PanelText& text, const std::string& problem,
                       std::string_view attribute, const std::string& value,
                       const std::string& allowed);

/// The share of each profile, in their order, in all 1: as the spec says, the rest as in the table.
/// Profiles that cannot walk in the range of speeds have none unless the spec names them.
std::vector<double> profile_shares(const PanelSpec& spec, const Profiles& profiles);

/// How often a group has `size` members, up to a factor: the zero-truncated Poisson distribution
/// that groups of pedestrians follow (James 1953), its parameter from `kAlone` (see there).
double group_weight(int size);

/// Mean size of the spec's groups.
double mean_group(const PanelSpec& spec);

/// Share of people who walk alone where nothing is said, in town on a calm day: Moussaid et al.
/// 2010 (doi 10.1371/journal.pone.0010047) saw 55 % in groups, and 70 % in a busy shopping street.
/// In a zero-truncated Poisson distribution of parameter l, exp(-l) of all people are alone.
constexpr double kAlone = 0.45;

}  // namespace pedzone
