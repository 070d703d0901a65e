#include "sumo/files/departures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "core/xml_stream.hpp"
#include "sumo/files/body_sizes.hpp"
#include "sumo/files/number_text.hpp"

namespace pedzone {
namespace {

constexpr double kBehindStart = 0.1;  // [m] SUMO 1.15: departPos base is this and the length
constexpr std::string_view kUsualType = "DEFAULT_VEHTYPE";
constexpr double kForEver = std::numeric_limits<double>::infinity();

std::string first_word(std::string_view list) {
  const std::size_t begin = std::min(list.find_first_not_of(' '), list.size());
  return std::string(list.substr(begin, list.find(' ', begin) - begin));
}

/// [s] between two vehicles of a flow.
std::optional<double> period_of(const XmlElement& flow, double begin, double end) {
  if (const auto period = number_of(flow.value("period"))) return period;
  if (const auto hourly = number_of(flow.value("vehsPerHour"))) return 3600.0 / *hourly;
  const auto number = number_of(flow.value("number"));
  if (!number || end == kForEver) return std::nullopt;
  return (end - begin) / *number;
}

/// Goes through the files in SUMO's order.
class Reader {
 public:
  Reader(const Network& network, const std::vector<int>& edges)
      : network_(network), edges_(edges.begin(), edges.end()) {}

  void visit(const XmlElement& element) {
    const std::string_view name = element.name();
    if (name.starts_with("vType")) {
      sizes_.visit(element);
    } else if (name == "route") {
      const std::string first = first_word(element.value("edges").value_or(""));
      if (element.value("id")) {
        routes_[std::string(*element.value("id"))] = first;
      } else if (element.depth() == 2 && waiting_) {
        begin(first);
      }
    } else if (element.depth() <= 1) {
      waiting_ =
          name == "vehicle" || name == "trip" || name == "flow" ? read(element) : std::nullopt;
    }
  }

  std::vector<Departure> take() {
    std::ranges::stable_sort(departures_, {}, &Departure::time);
    return std::move(departures_);
  }

 private:
  /// A vehicle or the vehicles of a flow, but for the edge.
  struct Planned {
    Departure departure;
    std::string lane;
    double end = 0.0, period = 0.0;
    bool flow = false;
    bool mixed = false;  ///< of several classes: SUMO may choose any lane
  };

  std::optional<Planned> read(const XmlElement& element) {
    Planned planned;
    planned.flow = element.name() == "flow";
    Departure& departure = planned.departure;
    departure.vehicle = std::string(element.value("id").value_or(""));
    const std::string_view type = element.value("type").value_or(kUsualType);
    take_type(type, planned);
    const auto at = element.value("departPos");
    const bool base = !at || *at == "base";
    const auto position = base ? departure.length + kBehindStart : number_of(at);
    const auto time = time_of(element.value(planned.flow ? "begin" : "depart"));
    if (!position || *position < 0.0 || (!time && !planned.flow)) return std::nullopt;
    departure.position = *position;
    departure.time = time.value_or(0.0);
    planned.lane = std::string(element.value("departLane").value_or(""));
    if (planned.flow) {
      planned.end = time_of(element.value("end")).value_or(kForEver);
      const auto period = period_of(element, departure.time, planned.end);
      if (!period || !(*period > 0.0)) return std::nullopt;
      planned.period = *period;
      const auto number = number_of(element.value("number"));
      if (number) planned.end = std::min(planned.end, departure.time + *number * *period);
    }
    waiting_ = planned;
    if (const auto from = element.value("from")) {
      begin(std::string(*from));
    } else if (const auto id = element.value("route")) {
      const auto route = routes_.find(std::string(*id));
      if (route != routes_.end()) begin(route->second);
    }
    return waiting_;
  }

  /// Takes in the size and class of the type; of a distribution the largest of its members, and
  /// that of all: SUMO chooses.
  void take_type(std::string_view type, Planned& planned) const {
    Departure& departure = planned.departure;
    BodySize size = sizes_.of_type(type).value_or(BodySize{departure.length, departure.width});
    departure.its_class = road_class(sizes_.class_of(type));
    for (const std::string& member : sizes_.members(type)) {
      const BodySize one = sizes_.of_type(member).value_or(size);
      size = {std::max(size.length, one.length), std::max(size.width, one.width)};
      planned.mixed |= road_class(sizes_.class_of(member)) != departure.its_class;
    }
    departure.length = size.length;
    departure.width = size.width;
    if (planned.mixed) departure.its_class = 0;
  }

  /// What waits for its first edge gets it.
  void begin(const std::string& edge) {
    const Planned planned = *std::exchange(waiting_, std::nullopt);
    const auto found = network_.edge_index.find(edge);
    if (found == network_.edge_index.end() || !edges_.contains(found->second)) return;
    Departure departure = planned.departure;
    departure.edge = found->second;
    departure.lane = lane_of(network_.edges[departure.edge], planned);
    if (!planned.flow) return departures_.push_back(departure);
    const double end = std::min(planned.end, departure.time + kLongestFlow);
    for (int i = 0; departure.time < end; ++i, departure.time += planned.period) {
      departure.vehicle = planned.departure.vehicle + "." + std::to_string(i);
      departures_.push_back(departure);
    }
  }

  int lane_of(const Edge& edge, const Planned& planned) const {
    const std::string& wished = planned.lane;
    if (wished.empty() || wished == "first") {
      if (planned.mixed) return -1;
      const auto first = std::ranges::find_if(edge.lanes, [&](int lane) {
        return network_.lanes[lane].lets_in(planned.departure.its_class);
      });
      return first == edge.lanes.end() ? -1 : *first;
    }
    const auto lane = network_.lane_index.find(edge.id + "_" + wished);
    return lane == network_.lane_index.end() ? -1 : lane->second;
  }

  static constexpr double kLongestFlow = 86400.0;  // [s] numerical: of one without an end

  const Network& network_;
  std::set<int> edges_;
  BodySizes sizes_;
  std::map<std::string, std::string> routes_;  ///< first edges by id
  std::optional<Planned> waiting_;
  std::vector<Departure> departures_;
};

}  // namespace

std::vector<Departure> read_departures(const Scenario& scenario, const Network& network,
                                       const std::vector<int>& edges) {
  Reader reader(network, edges);
  for (const auto* files : {&scenario.additional_files, &scenario.route_files}) {
    for (const std::string& file : *files) {
      visit_elements(file, "", [&](const XmlElement& element) { reader.visit(element); });
    }
  }
  return reader.take();
}

}  // namespace pedzone
