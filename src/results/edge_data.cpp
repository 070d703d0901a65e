#include "results/edge_data.hpp"

#include <fmt/format.h>

#include <set>

#include "core/text.hpp"
#include "world/speeds.hpp"

namespace pedzone {
namespace {

constexpr double kSameTime = 1e-6;  // [s] numerical

}  // namespace

EdgeDataWriter::EdgeDataWriter(const std::string& path, const std::string& option,
                               std::optional<double> period)
    : file_(path, option), period_(period) {
  file_.write(R"(<?xml version="1.0" encoding="UTF-8"?>
<meandata xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" )"
              R"(xsi:noNamespaceSchemaLocation="http://sumo.dlr.de/xsd/meandata_file.xsd">
)");
}

void EdgeDataWriter::begin(const Network& network, const std::vector<Zone>& zones, double time) {
  network_ = &network;
  begin_ = end_ = time;
  std::set<int> edges;
  for (const Zone& zone : zones) {
    finders_.emplace_back(network, zone);
    for (const int lane : zone.lanes) edges.insert(network.lanes[lane].edge);
  }
  edges_.assign(edges.begin(), edges.end());
}

void EdgeDataWriter::add(double dt, int edge, const PersonOnEdge& person) {
  Sums& sums = sums_[edge];
  sums.time += dt;
  sums.distance += person.speed * dt;
  if (person.free_speed > 0.0) sums.free_time += person.speed * dt / person.free_speed;
  if (person.speed < kHaltingSpeed) sums.waiting += dt;
}

void EdgeDataWriter::step(double time, double dt, std::span<const PersonOnEdge> persons) {
  if (period_ && time >= begin_ + *period_ - kSameTime) write_interval();
  for (const PersonOnEdge& person : persons) {
    const int edge = finders_[person.zone].edge_at(person.at);
    if (edge < 0) continue;
    add(dt, edge, person);
    Track& track = tracks_[std::string(person.person)];
    track.seen = time;
    if (track.edge == edge) continue;
    if (track.edge >= 0) ++sums_[track.edge].left;
    ++sums_[edge].entered;
    track.edge = edge;
  }
  forget_gone(time);
  end_ = time + dt;
}

void EdgeDataWriter::forget_gone(double time) {
  std::erase_if(tracks_, [&](const auto& one) {
    const Track& track = one.second;
    if (track.seen == time) return false;
    ++sums_[track.edge].left;
    return true;
  });
}

std::string EdgeDataWriter::attributes(const Sums& sums, double length) const {
  std::string text = fmt::format(R"( sampledSeconds="{:.2f}")", sums.time);
  if (sums.time > 0.0) {
    const double speed = sums.distance / sums.time;
    if (speed > 0.0) text += fmt::format(R"( traveltime="{:.2f}")", length / speed);
    text +=
        fmt::format(R"( density="{:.4f}" waitingTime="{:.2f}" timeLoss="{:.2f}" speed="{:.4f}")",
                    sums.time / (end_ - begin_) / length * 1000.0, sums.waiting,
                    sums.time - sums.free_time, speed);
  }
  return text + fmt::format(R"( entered="{}" left="{}")", sums.entered, sums.left);
}

void EdgeDataWriter::write_interval() {
  file_.write(
      fmt::format("    <interval begin=\"{:.2f}\" end=\"{:.2f}\" id=\"pedzone\">\n", begin_, end_));
  for (const int edge : edges_) {
    const Edge& one = network_->edges[edge];
    file_.write(fmt::format("        <edge id=\"{}\"{}/>\n", xml_value(one.id),
                            attributes(sums_[edge], network_->lanes[one.lanes.front()].length)));
  }
  file_.write("    </interval>\n");
  sums_.clear();
  begin_ = end_;
}

void EdgeDataWriter::finish() {
  if (end_ > begin_) write_interval();
  file_.write("</meandata>\n");
  file_.finish();
}

}  // namespace pedzone
