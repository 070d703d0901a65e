#include "app/study_results.hpp"

#include <fmt/format.h>

#include "app/command_line/terminal.hpp"
#include "core/shell_word.hpp"
#include "results/complete_file.hpp"
#include "study/report/report.hpp"
#include "study/report/report_verdict.hpp"

namespace pedzone {

using namespace study;

namespace {

void write(const Store& store, const std::string& name, const std::string& text) {
  write_complete_file(store.folder() + "/" + name, text, kOutOption);
}

std::string line_of(const Sentence& sentence) {
  return fmt::format("  {}{}\n", sentence.head, sentence.rest);
}

/// What was found of one model: in its only condition, or over all.
std::string findings(const Plan& plan, const std::vector<Comparison>& comparisons,
                     const std::string& model) {
  std::vector<Comparison> own;
  for (const Comparison& one : comparisons) {
    if (one.model == model) own.push_back(one);
  }
  std::vector<Sentence> different;
  if (plan.conditions.size() == 1) {
    different = verdict_of(own).different;
  } else {
    for (const Measure& measure : measure_list()) {
      if (measure.primary) different.push_back(overall_sentence(own, measure.key));
    }
    std::erase_if(different, [](const Sentence& sentence) { return sentence.head.empty(); });
  }
  std::string text = line_of(summary_sentence(own, plan.study.reference));
  if (different.empty()) return text;
  text += fmt::format("{} instead of {}:\n", model, plan.study.reference);
  for (const Sentence& sentence : different) text += line_of(sentence);
  return text;
}

/// The verdict's first lines.
std::string verdict(const Plan& plan, const std::vector<Comparison>& comparisons,
                    const std::vector<FreeSpeed>& speeds) {
  std::string text;
  for (const Sentence& sentence : warning_sentences(comparisons, plan)) text += line_of(sentence);
  for (const Sentence& sentence : free_speed_sentences(speeds, plan)) text += line_of(sentence);
  for (const std::string& model : plan.study.models) {
    if (model != plan.study.reference) text += findings(plan, comparisons, model);
  }
  return text;
}

}  // namespace

void write_results(const Store& store, const Plan& plan, const Records& records) {
  const std::vector<Comparison> comparisons = compare(plan, records);
  const std::vector<FreeSpeed> speeds = free_speeds(plan, records);
  write(store, "runs.csv", runs_csv(plan, records));
  write(store, "summary.csv", summary_csv(plan, comparisons));
  write(store, "summary.json", summary_json(plan, records, comparisons, speeds));
  write(store, "report.html", report_page(store, plan, records, comparisons, speeds));
  print_result(
      verdict(plan, comparisons, speeds) +
      fmt::format(
          "Results in {}:\n"
          "  report.html    what differs, by how much, how sure; to be opened in a browser\n"
          "  summary.csv    each measure of each model against {}, also summary.json\n"
          "  runs.csv       the measures of each run\n",
          shell_word(store.folder()), plan.study.reference));
}

RunCounts count_runs(const Records& records) {
  RunCounts counts;
  for (const auto& record : records) {
    if (!record) {
      ++counts.missing;
    } else if (record->status == RunStatus::kDone) {
      ++counts.done;
    } else {
      ++(record->status == RunStatus::kFailed ? counts.failed : counts.killed);
    }
  }
  return counts;
}

}  // namespace pedzone
