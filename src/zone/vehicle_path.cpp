#include "zone/vehicle_path.hpp"

#include <algorithm>
#include <filesystem>

#include "core/csv_stream.hpp"
#include "core/xml.hpp"

namespace pedzone {
namespace {

constexpr NumberRange kTimes{0.0, 1e9};    // [s]
constexpr NumberRange kPlaces{-1e7, 1e7};  // [m] of coordinates
const std::vector<std::string> kColumns{"t", "x", "y"};

std::vector<VehiclePath::Row> read_rows(const std::string& name) {
  std::vector<VehiclePath::Row> rows;
  visit_rows(name, kColumns, [&](const CsvRow& row) {
    const double time = row.number(0, kTimes);
    if (!rows.empty() && time <= rows.back().time) {
      throw row.error("is not later than the row before", 0, "increasing times");
    }
    rows.push_back({time, {row.number(1, kPlaces), row.number(2, kPlaces)}});
  });
  const auto elsewhere = [&](const auto& row) { return row.front != rows.front().front; };
  if (std::ranges::none_of(rows, elsewhere)) {
    throw InputError("does not lead anywhere", {name, 0, "rows", std::to_string(rows.size()),
                                                "two or more, at two places or more"});
  }
  return rows;
}

VehiclePathSpec read_spec(const XmlFile& file, const pugi::xml_node& node) {
  file.check_names(node, {"vehicle", "file"}, {});
  const std::string vehicle = file.required(node, "vehicle"), given = file.required(node, "file");
  return {vehicle, file.beside(given), given, file.file(), file.line(node)};
}

VehiclePath read_path_of(const VehiclePathSpec& spec) {
  if (!std::filesystem::is_regular_file(spec.file)) {
    throw InputError("does not exist", {spec.zone_file, spec.line, "<vehiclePath> attribute file",
                                        spec.given, "a CSV file with header t,x,y"});
  }
  VehiclePath path(spec.vehicle, read_rows(spec.file));
  path.file = spec.zone_file;
  path.line = spec.line;
  return path;
}

}  // namespace

VehiclePath::VehiclePath(std::string vehicle, std::vector<Row> rows)
    : vehicle_(std::move(vehicle)), rows_(std::move(rows)), gone_{0.0} {
  for (std::size_t k = 1; k < rows_.size(); ++k) {
    gone_.push_back(gone_.back() + (rows_[k].front - rows_[k - 1].front).norm());
  }
}

double VehiclePath::gone(double time) const {
  const auto next = std::ranges::upper_bound(rows_, time, {}, &Row::time);
  if (next == rows_.begin()) return 0.0;
  if (next == rows_.end()) return gone_.back();
  const auto k = static_cast<std::size_t>(next - rows_.begin());
  const double share = (time - rows_[k - 1].time) / (rows_[k].time - rows_[k - 1].time);
  return gone_[k - 1] + share * (gone_[k] - gone_[k - 1]);
}

Vec2 VehiclePath::place(double gone) const {
  // The first piece that is longer than nothing and ends behind the place; the last one at the end.
  auto end = std::ranges::upper_bound(gone_, std::max(gone, 0.0));
  if (end == gone_.end()) end = std::ranges::lower_bound(gone_, gone_.back());
  const auto k = static_cast<std::size_t>(end - gone_.begin());
  const double share = (gone - gone_[k - 1]) / (gone_[k] - gone_[k - 1]);
  return rows_[k - 1].front + std::min(share, 1.0) * (rows_[k].front - rows_[k - 1].front);
}

Vec2 VehiclePath::front(double time) const { return place(gone(time)); }

double VehiclePath::heading(double time, double length) const {
  const double at = gone(time);
  return angle_of(place(at) - place(at - length));
}

Polyline VehiclePath::way(double time, double behind, double ahead) const {
  const double at = gone(time), to = std::min(at + ahead, gone_.back());
  Polyline way{place(at - behind), place(at)};
  for (std::size_t k = 0; k < gone_.size(); ++k) {
    if (gone_[k] > at && gone_[k] < to) way.push_back(rows_[k].front);
  }
  if (to > at) way.push_back(place(to));
  return way;
}

InputError VehiclePath::error(const std::string& problem, const std::string& allowed) const {
  return InputError(problem, {file, line, "<vehiclePath> attribute vehicle", vehicle_, allowed});
}

std::vector<VehiclePathSpec> read_vehicle_path_specs(const XmlFile& file) {
  std::vector<VehiclePathSpec> specs;
  for (const pugi::xml_node& node : file.root().children("vehiclePath")) {
    VehiclePathSpec spec = read_spec(file, node);
    if (std::ranges::find(specs, spec.vehicle, &VehiclePathSpec::vehicle) != specs.end()) {
      throw file.error("has a path already", node, "vehicle", spec.vehicle, "one path a vehicle");
    }
    specs.push_back(std::move(spec));
  }
  return specs;
}

std::vector<VehiclePath> read_vehicle_paths(const std::vector<VehiclePathSpec>& specs) {
  std::vector<VehiclePath> paths;
  for (const VehiclePathSpec& spec : specs) paths.push_back(read_path_of(spec));
  return paths;
}

}  // namespace pedzone
