#include "sumo/files/departures.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "core/xml.hpp"
#include "core/xml_stream.hpp"
#include "sumo/files/body_sizes.hpp"
#include "sumo/files/number_text.hpp"

namespace pedzone {
namespace {

constexpr double kBehindStart = 0.1;  // [m] SUMO 1.15: departPos base is this and the length
constexpr std::string_view kUsualType = "DEFAULT_VEHTYPE";
constexpr std::string_view kBlanks = " \t\n\r";
constexpr double kForEver = std::numeric_limits<double>::infinity();
constexpr double kWidest = 1e3;  // [m] numerical: wider than any lane

/// A word of a list by its number; empty: it has fewer. Most routes are long, and one is asked for.
std::string_view word_of(std::string_view list, std::size_t number) {
  std::size_t end = 0;
  for (std::size_t k = 0;; ++k) {
    const std::size_t begin = list.find_first_not_of(kBlanks, end);
    if (begin == std::string_view::npos) return {};
    end = std::min(list.find_first_of(kBlanks, begin), list.size());
    if (k == number) return list.substr(begin, end - begin);
  }
}

/// SUMO's departEdge: which edge of its route a vehicle begins on; nothing: SUMO chooses.
std::optional<std::size_t> depart_edge_of(const XmlElement& element) {
  if (!element.value("departEdge")) return 0;
  const auto index = number_of(element.value("departEdge"));
  return index && *index >= 0.0 ? std::optional(static_cast<std::size_t>(*index)) : std::nullopt;
}

/// SUMO's departPosLat: [m] to the left of the lane's middle, more than there is for its edge;
/// nothing: SUMO chooses.
std::optional<double> lateral_of(const XmlElement& element) {
  const std::string_view at = element.value("departPosLat").value_or("center");
  if (at == "center" || at == "default") return 0.0;
  if (at == "left") return kWidest;
  if (at == "right") return -kWidest;
  return number_of(at);
}

/// [s] between two vehicles of a flow.
std::optional<double> period_of(const XmlElement& flow, double begin, double end) {
  if (const auto period = number_of(flow.value("period"))) return period;
  for (const std::string_view rate : {"perHour", "vehsPerHour"}) {
    if (const auto hourly = number_of(flow.value(rate))) return 3600.0 / *hourly;
  }
  const auto number = number_of(flow.value("number"));
  return number ? std::optional((end - begin) / *number) : std::nullopt;
}

/// Goes through the files in SUMO's order.
class Reader {
 public:
  /// `begin`, `end`: as of read_departures().
  Reader(const Network& network, const std::vector<int>& edges, double begin, double end)
      : network_(network),
        edges_(edges.begin(), edges.end()),
        begin_(begin),
        end_(end < 0.0 ? kForEver : end) {}

  void visit(const XmlElement& element) {
    const std::string_view name = element.name();
    if (name.starts_with("vType")) {
      sizes_.visit(element);
    } else if (name == "route") {
      add_route(element);
    } else if (element.depth() <= 1) {
      distribution_.clear();
      waiting_.reset();
      if (name == "routeDistribution") begin_distribution(element);
      if (name == "vehicle" || name == "trip" || name == "flow") read(element);
    }
  }

  std::vector<Departure> take() {
    std::ranges::stable_sort(departures_, {}, &Departure::time);
    return std::move(departures_);
  }

 private:
  using Routes = std::vector<std::string>;  ///< lists of their edges

  /// A vehicle or the vehicles of a flow, but for the edge.
  struct Planned {
    Departure departure;
    std::size_t edge = 0;  ///< of its route
    std::string lane;
    double end = 0.0, period = 0.0;
    bool flow = false;
    bool mixed = false;  ///< of several classes: SUMO may choose any lane
  };

  void begin_distribution(const XmlElement& element) {
    distribution_ = std::string(element.value("id").value_or(""));
    Routes all;
    for (const std::string& route : split_words(element.value("routes").value_or(""))) {
      const auto found = routes_.find(route);
      if (found != routes_.end()) all.insert(all.end(), found->second.begin(), found->second.end());
    }
    routes_[distribution_] = std::move(all);
  }

  void add_route(const XmlElement& element) {
    const std::string edges(element.value("edges").value_or(""));
    if (element.depth() == 2 && waiting_) return begin({edges});
    if (const auto id = element.value("id")) routes_[std::string(*id)] = {edges};
    if (element.depth() == 2 && !distribution_.empty()) routes_[distribution_].push_back(edges);
  }

  void read(const XmlElement& element) {
    waiting_ = planned_by(element);
    if (!waiting_) return;
    if (const auto from = element.value("from")) {
      begin({std::string(*from)});
    } else if (const auto id = element.value("route")) {
      const auto route = routes_.find(std::string(*id));
      if (route != routes_.end()) begin(route->second);
    }
  }

  std::optional<Planned> planned_by(const XmlElement& element) const {
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
    const auto edge = depart_edge_of(element);
    if (!position || !edge || (!time && !planned.flow)) return std::nullopt;
    departure.position = *position;
    departure.time = time.value_or(begin_);
    departure.lateral = lateral_of(element);
    planned.edge = *edge;
    planned.lane = std::string(element.value("departLane").value_or(""));
    if (planned.flow && !take_times(element, planned)) return std::nullopt;
    return planned;
  }

  /// Takes in when a flow's vehicles come; false: only SUMO knows.
  bool take_times(const XmlElement& flow, Planned& planned) const {
    const double begin = planned.departure.time;
    const auto end = time_of(flow.value("end"));
    const auto number = number_of(flow.value("number"));
    const auto period = period_of(flow, begin, end.value_or(end_));
    if (!period || !(*period > 0.0)) return false;
    planned.period = *period;
    planned.end = end.value_or(kForEver);
    if (number) planned.end = std::min(planned.end, begin + *number * *period);
    return true;
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

  /// What waits for its route gets it, or those of which SUMO chooses one.
  void begin(const Routes& routes) {
    const Planned planned = *std::exchange(waiting_, std::nullopt);
    std::set<int> starts;
    for (const std::string& route : routes) {
      const auto found = network_.edge_index.find(std::string(word_of(route, planned.edge)));
      const bool asked = found != network_.edge_index.end() && edges_.contains(found->second);
      if (asked) starts.insert(found->second);
    }
    for (const int edge : starts) add(planned, edge);
  }

  void add(const Planned& planned, int edge) {
    const std::vector<int>& lanes = network_.edges[edge].lanes;
    Departure departure = planned.departure;
    departure.edge = edge;
    departure.lane = lane_of(network_.edges[edge], planned);
    if (departure.position < 0.0 && !lanes.empty()) {  // counted from its end
      const double length =
          network_.lanes[departure.lane < 0 ? lanes.front() : departure.lane].length;
      departure.position = std::max(0.0, length + departure.position);
    }
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
  double begin_, end_;
  std::map<std::string, Routes> routes_;  ///< by id; of a distribution all its members
  std::string distribution_;              ///< id of the one whose members come; "": none
  std::optional<Planned> waiting_;
  std::vector<Departure> departures_;
};

}  // namespace

std::vector<Departure> read_departures(const Scenario& scenario, const Network& network,
                                       const std::vector<int>& edges, double begin, double end) {
  Reader reader(network, edges, begin, end);
  for (const auto* files : {&scenario.additional_files, &scenario.route_files}) {
    for (const std::string& file : *files) {
      visit_elements(file, "", [&](const XmlElement& element) { reader.visit(element); });
    }
  }
  return reader.take();
}

}  // namespace pedzone
