#include "verify/standard_test.hpp"

namespace pedzone::verify {

FigureSpec at_least(std::string key, std::string label, std::string unit, int digits, double least,
                    std::string source) {
  return {std::move(key), std::move(label), std::move(unit), digits, least, {}, std::move(source)};
}

FigureSpec at_most(std::string key, std::string label, std::string unit, int digits, double most,
                   std::string source) {
  return {std::move(key), std::move(label), std::move(unit), digits, {}, most, std::move(source)};
}

FigureSpec between(std::string key, std::string label, std::string unit, int digits, double least,
                   double most, std::string source) {
  return {std::move(key), std::move(label), std::move(unit), digits, least,
          most,           std::move(source)};
}

FigureSpec told(std::string key, std::string label, std::string unit, int digits,
                std::string remark) {
  return {std::move(key),    std::move(label), std::move(unit), digits, {}, {},
          std::move(remark), Judged::kNot};
}

FigureSpec stopped_short() {
  return at_most("jolts", "share of people who are stopped short", "", 2, 0.75,
                 "assumed: who minds nobody, 0.9");
}

FigureSpec in_every_seed(FigureSpec figure) {
  figure.judged = Judged::kWorst;
  return figure;
}

std::vector<StandardTest> standard_tests() {
  std::vector<StandardTest> all;
  for (const auto family : {single_walker_tests, diagram_tests, bottleneck_tests, room_tests,
                            corner_tests, counterflow_tests, crossing_tests, lane_tests}) {
    for (StandardTest& test : family()) all.push_back(std::move(test));
  }
  return all;
}

const std::vector<LeftOut>& left_out_tests() {
  static const std::vector<LeftOut> tests{
      {"RiMEA 2", "stairs up"},
      {"RiMEA 3", "stairs down; a zone has one level"},
      {"RiMEA 5", "times of reaction before walking: SUMO's departures"},
      {"RiMEA 10, 11, 14", "choice of an exit or a route: SUMO's routes"},
      {"RiMEA 13, second half", "stairs behind the corridor"}};
  return tests;
}

}  // namespace pedzone::verify
