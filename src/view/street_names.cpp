#include "view/street_names.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <tuple>

#include "view/map_panel.hpp"

namespace pedzone {
namespace {

constexpr std::size_t kLetters = 40;  // of a name
constexpr double kStraightest = 0.5;  // cosine of 60°: a street that turns more gets a new line

/// An edge between two junctions; its direction does not matter.
struct Piece {
  std::string from, to;
  Polyline line;
  bool used = false;
};

Vec2 direction(const Vec2& from, const Vec2& to) { return (to - from).normalized(); }

/// Pieces of one name, joined to lines.
class Joiner {
 public:
  explicit Joiner(std::vector<Piece>& pieces) : pieces_(pieces) {
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      at_[pieces[i].from].push_back(i);
      at_[pieces[i].to].push_back(i);
    }
  }

  std::vector<Polyline> lines() {
    std::vector<Polyline> lines;
    for (Piece& piece : pieces_) {
      if (piece.used) continue;
      piece.used = true;
      Polyline line = piece.line;
      extend(line, piece.to);
      std::ranges::reverse(line);
      extend(line, piece.from);
      lines.push_back(std::move(line));
    }
    return lines;
  }

 private:
  /// Goes on from the line's end, which is at a junction, as straight as it can.
  void extend(Polyline& line, std::string junction) {
    while (const auto next = straightest(line, junction)) {
      Piece& piece = pieces_[*next];
      piece.used = true;
      const bool forward = piece.from == junction;
      Polyline more = piece.line;
      if (!forward) std::ranges::reverse(more);
      line.insert(line.end(), more.begin(), more.end());
      junction = forward ? piece.to : piece.from;
    }
  }

  std::optional<std::size_t> straightest(const Polyline& line, const std::string& junction) const {
    std::optional<std::size_t> best;
    double most = kStraightest;
    const Vec2 ahead = direction(line[line.size() - 2], line.back());
    for (const std::size_t i : at_.at(junction)) {
      const Piece& piece = pieces_[i];
      if (piece.used) continue;
      const auto& p = piece.line;
      const Vec2 away =
          piece.from == junction ? direction(p[0], p[1]) : direction(p.back(), p[p.size() - 2]);
      if (ahead.dot(away) <= most) continue;
      most = ahead.dot(away);
      best = i;
    }
    return best;
  }

  std::vector<Piece>& pieces_;
  std::map<std::string, std::vector<std::size_t>> at_;  ///< pieces that end at a junction
};

}  // namespace

std::vector<NamedStreet> named_streets(const Place& place, const Box& box) {
  const Network& network = place.network;
  std::map<std::string, std::vector<Piece>> by_name;
  std::set<std::tuple<std::string, std::string, std::string>> known;  // either direction is enough
  for (const Edge& edge : network.edges) {
    const auto name = place.street_names.find(edge.id);
    if (name == place.street_names.end() || edge.function != EdgeFunction::kNormal) continue;
    const Lane& lane = network.lanes[edge.lanes[edge.lanes.size() / 2]];
    if (!box.intersects(box_of(lane.shape))) continue;
    const auto [first, second] = std::minmax(edge.from, edge.to);
    if (!known.insert({name->second, first, second}).second) continue;
    by_name[name->second].push_back({edge.from, edge.to, lane.shape});
  }
  std::vector<NamedStreet> streets;
  for (auto& [name, pieces] : by_name) {
    for (Polyline& line : Joiner(pieces).lines()) {
      streets.push_back({shortened(name, kLetters), std::move(line)});
    }
  }
  return streets;
}

}  // namespace pedzone
