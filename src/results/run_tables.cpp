#include "results/run_tables.hpp"

namespace pedzone {
namespace {

constexpr NumberRange kValues{-1e12, 1e12};
constexpr NumberRange kPlaces{-1e9, 1e9};  // [m]
constexpr NumberRange kAmounts{0.0, 1e12};
constexpr int kDigits = 4;  // of means

}  // namespace

const Table<SeriesRow>& series_table() {
  using Row = SeriesRow;
  static const Table<Row> table{{
      number_column({"time", "s", "where the window of 10 s begins"}, &Row::time, 0, kValues),
      number_column({"persons", "", "people in the zones, mean"}, &Row::persons, kDigits, kValues),
      number_column({"personSpeed", "m/s", "their speed, mean"}, &Row::person_speed, kDigits,
                    kValues),
      number_column({"density", "1/m²", "density that they are in, mean"}, &Row::density, kDigits,
                    kValues),
      number_column({"vehicles", "", "vehicles in the zones, mean"}, &Row::vehicles, kDigits,
                    kValues),
      number_column({"vehicleSpeed", "m/s", "their speed, mean"}, &Row::vehicle_speed, kDigits,
                    kValues),
  }};
  return table;
}

const Table<DensityRow>& density_table() {
  using Row = DensityRow;
  static const Table<Row> table{{
      number_column({"x", "m", "south-west corner of a cell of 2 m"}, &Row::x, 0, kPlaces),
      number_column({"y", "m", "the same"}, &Row::y, 0, kPlaces),
      number_column({"personSeconds", "s", "how long people were in it, all together"},
                    &Row::person_seconds, 3, kAmounts),
  }};
  return table;
}

}  // namespace pedzone
