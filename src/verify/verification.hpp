// Walks the standard tests with several models and seeds, and judges them.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "verify/standard_test.hpp"

namespace pedzone::verify {

struct FigureResult {
  double value = 0.0;              ///< median over seeds; of figures of the worst kind, the worst
  double least = 0.0, most = 0.0;  ///< over seeds
  bool passed = true;
};

/// A point of a chart: medians over seeds, and the range of y.
struct ChartPoint {
  double x = 0.0, y = 0.0, least = 0.0, most = 0.0;
};

struct TestResult {
  bool passed = true;
  std::vector<FigureResult> figures;            ///< as StandardTest::figures
  std::vector<std::vector<ChartPoint>> curves;  ///< as StandardTest::charts
  std::optional<GridMap> map;                   ///< of the first seed
};

struct Verification {
  std::vector<std::string> models;
  int seeds = 0;
  std::vector<StandardTest> tests;
  std::vector<std::vector<TestResult>> results;  ///< [test][model]

  /// Whether that model passes all tests.
  bool passes(std::size_t model) const;
};

struct VerifyOptions {
  std::vector<std::string> models;
  std::vector<std::string> only;  ///< ids of tests; none: all
  int seeds = 3;                  ///< from 1 on
};

/// Throws InputError for an id that no test has (option --only) and ModelError for a model that
/// cannot be made. `progress`: share done [0, 1], from any thread.
Verification verify(const VerifyOptions& options, const std::function<void(double)>& progress = {});

/// Judges what the seeds gave (at least one).
TestResult judged(const StandardTest& test, std::vector<Outcome> seeds);

}  // namespace pedzone::verify
