#include "study/report/report_verdict.hpp"

#include <gmock/gmock.h>

#include "study/report/report_numbers.hpp"

namespace pedzone::study {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// A comparison with these means [unit of the measure] and half width of the interval.
Comparison comparison(const std::string& measure, double reference, double sample, double half,
                      Finding finding, std::size_t pairs = 30) {
  Comparison one;
  one.model = "heuristic";
  one.measure = measure;
  one.finding = finding;
  one.reference.mean = reference;
  one.sample.mean = sample;
  one.difference.n = pairs;
  one.difference.mean = sample - reference;
  if (pairs > 1)
    one.difference.student = Interval{sample - reference - half, sample - reference + half};
  if (reference != 0.0) one.relative = (sample - reference) / reference;
  return one;
}

Plan plan_of(std::size_t conditions) {
  Plan plan;
  plan.study.reference = "striping";
  plan.study.models = {"striping", "heuristic", "orca"};
  for (std::size_t i = 0; i < conditions; ++i)
    plan.conditions.push_back({0, {}, "demand=" + std::to_string(i)});
  return plan;
}

std::string text(const Sentence& sentence) { return sentence.head + sentence.rest; }

TEST(Verdict, says_by_how_much_and_how_sure_and_in_which_direction) {
  const Sentence less =
      difference_sentence(comparison("person.travelTime", 84.2, 72.1, 3.0, Finding::kDifferent));
  EXPECT_EQ(text(less),
            "People's trips are 12.1 s [9.1, 15.1] shorter (from 84.2 to 72.1 s: −14 %; "
            "30 pairs of runs)");
  EXPECT_EQ(less.tone, Sentence::Tone::kLower);

  const Sentence more =
      difference_sentence(comparison("person.speed", 1.2, 1.25, 0.01, Finding::kDifferent));
  EXPECT_EQ(more.head, "People walk 0.050 m/s [0.040, 0.060] faster in the zone");
  EXPECT_EQ(more.tone, Sentence::Tone::kHigher);
  EXPECT_THAT(more.rest, HasSubstr("+4.2 %"));

  const Sentence longer =
      difference_sentence(comparison("vehicle.delay", 10.0, 30.0, 4.0, Finding::kDifferent));
  EXPECT_EQ(longer.head, "Vehicles' delay is 20.0 s [16.0, 24.0] longer");
  EXPECT_EQ(longer.tone, Sentence::Tone::kHigher);
}

TEST(Verdict, counts_have_no_unit_and_a_difference_from_nothing_no_percent) {
  const Sentence one =
      difference_sentence(comparison("conflict.contacts", 0.0, 3.5, 0.5, Finding::kDifferent));
  EXPECT_EQ(
      text(one),
      "There are 3.50 [3.00, 4.00] more contacts a run (from 0.00 to 3.50; 30 pairs of runs)");
}

TEST(Verdict, a_measure_without_a_phrase_of_its_own_is_named) {
  const Sentence one =
      difference_sentence(comparison("conflict.ttc", 1.0, 0.5, 0.1, Finding::kDifferent));
  EXPECT_EQ(one.head, "TTC is 0.50 s [0.40, 0.60] lower");
  EXPECT_EQ(one.tone, Sentence::Tone::kLower);
}

TEST(Verdict, every_finding_has_its_sentence) {
  Comparison unclear = comparison("vehicle.stops", 2.0, 2.1, 1.0, Finding::kInconclusive, 10);
  unclear.seeds_needed = 51;
  Comparison same = comparison("conflict.contacts", 0.0, 0.0, 0.0, Finding::kSame);
  same.difference.all_equal = true;
  const std::vector<Comparison> all{
      comparison("person.travelTime", 84.2, 72.1, 3.0, Finding::kDifferent),
      comparison("person.delay", 10.0, 10.1, 0.5, Finding::kNotShown),
      comparison("vehicle.travelTime", 80.0, 76.0, 1.0, Finding::kHint),
      unclear,
      same,
      comparison("conflict.count", 0.0, 0.0, 0.0, Finding::kTooFew, 0),
      comparison("conflict.pet", 1.0, 0.5, 0.1, Finding::kDifferent)};  // not of the family
  const Verdict verdict = verdict_of(all);
  ASSERT_EQ(verdict.different.size(), 1u);
  EXPECT_EQ(text(verdict.not_shown),
            "No difference shown in people's delay in the zone (−0.40 to +0.60 s).");
  EXPECT_EQ(text(verdict.hints),
            "Hints, no more, of a difference in vehicles' travel time (−5.0 to −3.0 s): alone each "
            "would count, among so many measures it may be chance.");
  EXPECT_EQ(text(verdict.inconclusive),
            "Cannot say from so few runs whether there is a difference in vehicles' stops "
            "(−0.9 to +1.1; +41 seeds).");
  EXPECT_EQ(text(verdict.same), "Equal in every pair of runs: contacts (0).");
  EXPECT_EQ(text(verdict.too_few),
            "Not compared, as fewer than three pairs of runs have it: conflicts.");
}

TEST(Verdict, seeds_that_nobody_would_run_are_not_counted) {
  Comparison unclear = comparison("vehicle.stops", 2.0, 2.1, 1.0, Finding::kInconclusive, 10);
  unclear.seeds_needed = 1744;
  EXPECT_THAT(text(verdict_of(std::vector{unclear}).inconclusive), HasSubstr("; > 1000 seeds)"));
}

TEST(Verdict, one_is_singular) {
  Comparison unclear = comparison("vehicle.stops", 2.0, 2.1, 1.0, Finding::kInconclusive, 10);
  unclear.seeds_needed = 11;
  EXPECT_THAT(text(verdict_of(std::vector{unclear}).inconclusive), HasSubstr("; +1 seed)"));
  EXPECT_THAT(
      difference_sentence(comparison("vehicle.stops", 2.0, 1.0, 0.5, Finding::kDifferent, 1)).rest,
      HasSubstr("1 pair of runs"));
}

TEST(Verdict, nothing_found_says_nothing) {
  const Verdict verdict = verdict_of({});
  EXPECT_TRUE(verdict.different.empty());
  for (const Sentence* one : {&verdict.hints, &verdict.not_shown, &verdict.inconclusive,
                              &verdict.same, &verdict.too_few, &verdict.cut_off}) {
    EXPECT_EQ(text(*one), "");
  }
}

TEST(Verdict, several_conditions_are_summed_up_with_both_directions) {
  std::vector<Comparison> all{
      comparison("person.travelTime", 100.0, 86.0, 3.0, Finding::kDifferent),
      comparison("person.travelTime", 100.0, 97.0, 1.0, Finding::kDifferent),
      comparison("person.travelTime", 100.0, 100.5, 1.0, Finding::kNotShown)};
  Sentence sentence = overall_sentence(all, "person.travelTime");
  EXPECT_EQ(text(sentence), "People's trips are shorter in 2 of 3 conditions (−14 % to −3.0 %).");
  EXPECT_EQ(sentence.tone, Sentence::Tone::kLower);
  all.push_back(comparison("person.travelTime", 100.0, 110.0, 3.0, Finding::kDifferent));
  sentence = overall_sentence(all, "person.travelTime");
  EXPECT_EQ(
      text(sentence),
      "People's trips are shorter in 2 of 4 conditions (−14 % to −3.0 %), the opposite in 1 of "
      "4 conditions (+10 %).");
  EXPECT_EQ(sentence.tone, Sentence::Tone::kPlain) << "neither lower nor higher";
  EXPECT_EQ(text(overall_sentence(all, "vehicle.stops")), "");
}

TEST(Verdict, tells_how_many_comparisons_came_out_how) {
  EXPECT_EQ(text(tally_sentence({})), "");
  const std::vector<Comparison> all{
      comparison("person.travelTime", 100.0, 86.0, 3.0, Finding::kDifferent),
      comparison("person.delay", 10.0, 10.1, 0.5, Finding::kNotShown),
      comparison("vehicle.stops", 2.0, 2.1, 1.0, Finding::kInconclusive),
      comparison("vehicle.delay", 2.0, 2.1, 1.0, Finding::kInconclusive),
      comparison("conflict.pet", 1.0, 0.5, 0.1, Finding::kDifferent)};  // not of the family
  EXPECT_EQ(text(tally_sentence(all)),
            "Of 4 comparisons (each measure in each condition): 1 a difference, 1 no difference to "
            "speak of and 2 not to be told from so few seeds.");
}

TEST(Verdict, ways_are_told_in_percent_and_shares_in_points) {
  EXPECT_EQ(text(difference_sentence(
                comparison("person.detour", 1.1, 1.001, 0.0033, Finding::kDifferent))),
            "People's ways are 9.00 % [8.70, 9.30] shorter (from 1.1000 to 1.0010; 30 pairs of "
            "runs)");
  EXPECT_EQ(
      difference_sentence(comparison("person.arrived", 0.6, 0.95, 0.03, Finding::kDifferent)).head,
      "The share of people who arrive by the end is 35.0 percentage points [32.0, 38.0] "
      "higher");
}

TEST(Verdict, nothing_falls_by_more_than_all_of_it) {
  const auto change = [](double from, double to) {
    return text(
        difference_sentence(comparison("person.delay", from, to, 1.0, Finding::kDifferent)));
  };
  EXPECT_THAT(change(10.0, -4.0), Not(HasSubstr("%"))) << "a delay may be below 0";
  EXPECT_THAT(change(-4.0, -8.0), Not(HasSubstr("%")));
  EXPECT_THAT(change(10.0, 4.0), HasSubstr("−60 %"));
}

/// A study cut off at its end: of ten people six arrive with striping, all with the heuristic.
std::vector<Comparison> cut_off_study(double striping_time, double own_time) {
  std::vector<Comparison> all{
      comparison("person.travelTime", striping_time, own_time, 17.0, Finding::kDifferent),
      comparison("person.arrived", 0.6, 1.0, 0.08, Finding::kDifferent),
      comparison("person.speed", 0.5, 1.2, 0.05, Finding::kDifferent),
      comparison("person.nearlyAll", 930.0, 580.0, 10.0, Finding::kDifferent)};
  all.back().reference.max = 941.0;
  all.back().sample.max = 590.0;
  mark_cut_off(all);
  return all;
}

TEST(CutOff, times_are_told_as_at_least) {
  const std::vector<Comparison> all = cut_off_study(326.0, 164.0);
  EXPECT_EQ(all[0].bound, Bound::kAtLeast);
  EXPECT_EQ(all[2].bound, Bound::kExact) << "a speed is no sum over a trip";
  EXPECT_EQ(verdict_of(all).different[0].head,
            "People's trips are at least 162 s [145, 179] shorter");
  EXPECT_THAT(summary_sentence(all, "striping").head,
              HasSubstr("With heuristic instead of striping, people's trips are at least 162 s"));
  const std::vector<Sentence> warnings = warning_sentences(all, plan_of(1));
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(text(warnings[0]),
            "Warning: the end of the runs cuts off people's trips: by then 60 % of them have "
            "arrived with striping, 100 % with heuristic. Their times are told as “at least”. "
            "end=\"1000\" in the study file would let nearly all arrive.");
}

TEST(CutOff, of_who_seems_fast_since_few_arrive_nothing_is_told) {
  const std::vector<Comparison> all = cut_off_study(164.0, 326.0);
  EXPECT_EQ(all[0].bound, Bound::kUnknown);
  const Verdict verdict = verdict_of(all);
  for (const Sentence& one : verdict.different) EXPECT_THAT(one.head, Not(HasSubstr("trips")));
  EXPECT_THAT(text(verdict.cut_off), HasSubstr("people's travel time. Fewer have arrived"));
  EXPECT_THAT(summary_sentence(all, "striping").head, Not(HasSubstr("trips")));
}

TEST(CutOff, no_end_is_proposed_where_nobody_arrives_any_more) {
  std::vector<Comparison> all = cut_off_study(326.0, 164.0);
  all.back().undefined = 1;
  EXPECT_THAT(text(warning_sentences(all, plan_of(1)).front()),
              HasSubstr("no end may be late enough"));
}

TEST(CutOff, is_told_where_few_arrive_though_alike) {
  std::vector<Comparison> all{comparison("person.travelTime", 64.0, 65.0, 0.2, Finding::kDifferent),
                              comparison("person.arrived", 0.38, 0.39, 0.01, Finding::kNotShown)};
  mark_cut_off(all);
  EXPECT_EQ(all[0].bound, Bound::kUnknown);
  EXPECT_TRUE(verdict_of(all).different.empty());
  EXPECT_THAT(text(warning_sentences(all, plan_of(1)).at(0)),
              HasSubstr("38 % of them have arrived with striping, 39 % with heuristic. Their times "
                        "are told as “at least”, or not at all."));
}

TEST(CutOff, is_nothing_where_as_many_arrive) {
  std::vector<Comparison> all{
      comparison("person.travelTime", 326.0, 164.0, 17.0, Finding::kDifferent),
      comparison("person.arrived", 0.95, 0.99, 0.01, Finding::kDifferent)};
  mark_cut_off(all);
  EXPECT_EQ(all[0].bound, Bound::kExact);
  EXPECT_TRUE(warning_sentences(all, plan_of(1)).empty());
}

TEST(Summary, says_what_matters_first_and_how_many_measures_differ) {
  const std::vector<Comparison> all{
      comparison("vehicle.stops", 8.0, 1.0, 0.5, Finding::kDifferent),
      comparison("person.delay", 30.0, 10.0, 2.0, Finding::kDifferent),
      comparison("conflict.serious", 40.0, 8.0, 4.0, Finding::kDifferent),
      comparison("person.travelTime", 84.2, 72.1, 3.0, Finding::kDifferent),
      comparison("vehicle.delay", 10.0, 10.1, 0.5, Finding::kNotShown)};
  EXPECT_EQ(text(summary_sentence(all, "striping")),
            "With heuristic instead of striping, people's trips are 12.1 s [9.1, 15.1] shorter, "
            "there are 32.0 [28.0, 36.0] fewer serious conflicts a run and people's delay in the "
            "zone is 20.0 s [18.0, 22.0] shorter. 4 of 13 main measures differ.");
}

TEST(Summary, of_too_few_seeds_says_how_many_more) {
  std::vector<Comparison> all{
      comparison("person.travelTime", 84.2, 72.1, 3.0, Finding::kTooFew, 2),
      comparison("vehicle.delay", 10.0, 10.1, 0.5, Finding::kTooFew, 2)};
  EXPECT_EQ(text(summary_sentence(all, "striping")),
            "Too few seeds to tell what heuristic changes: run 1 more. Nothing was compared.");
  all[1].missing = 1;
  EXPECT_EQ(text(summary_sentence(all, "striping")),
            "Too few runs are done to tell what heuristic changes: 1 pair is missing, since runs "
            "failed or are not there yet. Nothing was compared.");
}

TEST(Summary, of_no_difference_says_where_seeds_were_too_few) {
  const std::vector<Comparison> all{
      comparison("person.travelTime", 84.2, 84.1, 3.0, Finding::kNotShown),
      comparison("vehicle.delay", 10.0, 9.0, 5.0, Finding::kInconclusive)};
  EXPECT_EQ(text(summary_sentence(all, "striping")),
            "No difference was found with heuristic, and for 1 of 2 comparisons there are too few "
            "seeds to tell.");
}

TEST(Summary, of_hints_alone_does_not_say_that_nothing_was_found) {
  const std::vector<Comparison> all{
      comparison("person.travelTime", 84.2, 72.1, 3.0, Finding::kHint, 4),
      comparison("person.delay", 10.0, 5.0, 2.0, Finding::kHint, 4),
      comparison("vehicle.delay", 10.0, 9.0, 5.0, Finding::kInconclusive, 4)};
  EXPECT_EQ(
      text(summary_sentence(all, "striping")),
      "Nothing is certain from 4 seeds with heuristic: 2 of 3 comparisons are hints, no more. "
      "Run more seeds to tell.");
}

TEST(Warning, where_nobody_walked_nothing_was_compared) {
  std::vector<Comparison> all{comparison("person.travelTime", 84.2, 84.2, 0.0, Finding::kSame),
                              comparison("person.visitors", 0.0, 0.0, 0.0, Finding::kSame)};
  EXPECT_EQ(text(summary_sentence(all, "striping")),
            "Nobody walked in the zones: nothing was compared.");
  const std::vector<Sentence> warnings = warning_sentences(all, plan_of(2));
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_THAT(warnings[0].head, HasSubstr("nobody walked in the zones in 1 of 2 conditions"));
  all[1].sample.mean = 1.0;
  EXPECT_TRUE(warning_sentences(all, plan_of(2)).empty());
}

TEST(Warning, of_people_who_jump) {
  std::vector<Comparison> all{comparison("person.jumped", 4.9, 0.0, -4.9, Finding::kDifferent)};
  EXPECT_THAT(text(warning_sentences(all, plan_of(1)).at(0)),
              HasSubstr("Warning: striping puts people on by 4.9 m each"));
  EXPECT_THAT(text(warning_sentences(all, plan_of(1)).at(0)), HasSubstr("no walking areas"));
  all[0].reference.mean = 0.4;
  EXPECT_TRUE(warning_sentences(all, plan_of(1)).empty());
}

TEST(Warning, of_teleports) {
  std::vector<Comparison> all{comparison("vehicle.teleports", 0.75, 0.25, 0.5, Finding::kNotShown)};
  EXPECT_EQ(
      text(warning_sentences(all, plan_of(1)).at(0)),
      "Warning: SUMO teleported vehicles, 0.8 a run with striping and 0.2 with heuristic: their "
      "trips are shorter by that.");
  all[0].reference.mean = all[0].sample.mean = 0.0;
  EXPECT_TRUE(warning_sentences(all, plan_of(1)).empty());
}

SampleSummary sample_of(std::size_t n, double mean, double sd) {
  SampleSummary sample;
  sample.n = n;
  sample.mean = mean;
  sample.sd = sd;
  return sample;
}

FreeSpeed free_walks(double way) {
  FreeSpeed free{0, "heuristic", 12, 0.996, 0.99, 1.0, true};
  free.way = sample_of(12, way, 0.02);
  free.time = sample_of(12, way, 0.02);
  return free;
}

TEST(Geometry, is_told_where_ways_differ_without_others) {
  const std::vector<FreeSpeed> alone{free_walks(-0.08)};
  EXPECT_EQ(text(free_speed_sentences(alone, plan_of(1)).front()),
            "With interaction switched off, heuristic walks 0.4 % slower than striping (12 "
            "persons): speeds agree within 2 %. But their ways are 8.0 % shorter and they take 8.0 "
            "% less time even without others: a part of what differs below is geometry, not "
            "interaction.");
}

TEST(Geometry, may_be_all_of_a_difference) {
  Comparison time = comparison("person.travelTime", 175.0, 161.0, 3.0, Finding::kDifferent, 10);
  time.difference.sd = 4.0;
  EXPECT_EQ(text(interaction_sentence(std::vector{time}, free_walks(-0.08))),
            "Geometry and interaction. Of the 8.0 % by which people's trips are shorter, 8.0 "
            "percentage points are there without others, too; interaction makes 0.0 [−1.9, 1.9].");
  time.bound = Bound::kAtLeast;
  EXPECT_EQ(text(interaction_sentence(std::vector{time}, free_walks(-0.08))), "");
  EXPECT_EQ(text(interaction_sentence({}, free_walks(-0.08))), "");
}

TEST(Geometry, is_taken_off_what_interaction_makes) {
  Comparison time = comparison("person.travelTime", 100.0, 150.0, 3.0, Finding::kDifferent, 10);
  time.difference.sd = 4.0;
  EXPECT_THAT(text(interaction_sentence(std::vector{time}, free_walks(-0.08))),
              HasSubstr("Of the 50.0 % by which people's trips are longer, −8.0 percentage points "
                        "are there without others, too; interaction makes 58.0 [55.0, 61.0]."));
}

TEST(FreeSpeedVerdict, agrees_or_warns) {
  const std::vector<FreeSpeed> fine{{0, "heuristic", 12, 0.996, 0.99, 1.0, true}};
  EXPECT_THAT(text(free_speed_sentences(fine, plan_of(1)).front()),
              HasSubstr("heuristic walks 0.4 % slower than striping (12 persons): speeds agree"));
  const std::vector<FreeSpeed> off{{1, "heuristic", 1, 1.031, 1.031, 1.031, false}};
  const Sentence warning = free_speed_sentences(off, plan_of(2)).front();
  EXPECT_EQ(warning.tone, Sentence::Tone::kWarning);
  EXPECT_EQ(warning.head,
            "Warning: with interaction switched off, heuristic walks 3.1 % faster than striping in "
            "“demand=1”");
  EXPECT_THAT(warning.rest, HasSubstr("(1 person)"));
}

TEST(FreeSpeedVerdict, what_was_not_measured_is_a_warning) {
  const std::vector<FreeSpeed> none{{0, "heuristic", 0, 1.0, 1.0, 1.0, false}};
  const Sentence sentence = free_speed_sentences(none, plan_of(1)).front();
  EXPECT_EQ(sentence.tone, Sentence::Tone::kWarning);
  EXPECT_THAT(sentence.head, HasSubstr("was not measured"));
}

TEST(FreeSpeedVerdict, several_conditions_that_agree_are_one_sentence) {
  const std::vector<FreeSpeed> speeds{{0, "heuristic", 12, 0.996, 0.9, 1.0, true},
                                      {1, "heuristic", 11, 0.994, 0.9, 1.0, true},
                                      {2, "heuristic", 12, 1.05, 1.0, 1.1, false}};
  const std::vector<Sentence> sentences = free_speed_sentences(speeds, plan_of(3));
  ASSERT_EQ(sentences.size(), 2u);
  EXPECT_EQ(sentences[0].tone, Sentence::Tone::kWarning) << "what is wrong comes first";
  EXPECT_THAT(text(sentences[1]), HasSubstr("0.4 % to 0.6 % slower than striping (11 to 12 persons "
                                            "in each of 2 conditions)"));
}

TEST(FreeSpeedVerdict, many_that_disagree_are_one_warning) {
  std::vector<FreeSpeed> speeds;
  for (std::size_t i = 0; i < 9; ++i) {
    speeds.push_back({i, "orca", 12, 1.03 + 0.01 * static_cast<double>(i % 2), 1.0, 1.1, false});
  }
  const std::vector<Sentence> sentences = free_speed_sentences(speeds, plan_of(9));
  ASSERT_EQ(sentences.size(), 1u);
  EXPECT_THAT(sentences.front().head,
              HasSubstr("3.0 % to 4.0 % faster than striping in 9 conditions"));
}

TEST(FreeSpeedVerdict, each_model_has_its_own) {
  const std::vector<FreeSpeed> speeds{{0, "heuristic", 12, 0.996, 0.9, 1.0, true},
                                      {0, "orca", 12, 0.994, 0.9, 1.0, true}};
  const std::vector<Sentence> sentences = free_speed_sentences(speeds, plan_of(1));
  ASSERT_EQ(sentences.size(), 2u);
  EXPECT_THAT(sentences[0].head, HasSubstr("heuristic walks 0.4 %"));
  EXPECT_THAT(sentences[1].head, HasSubstr("orca walks 0.6 %"));
}

TEST(Numbers, have_the_digits_that_their_uncertainty_leaves) {
  EXPECT_EQ(decimals_for(3.1), 1);
  EXPECT_EQ(decimals_for(0.031), 3);
  EXPECT_EQ(decimals_for(310.0), 0);
  EXPECT_EQ(decimals_for(0.0), 0);
  EXPECT_EQ(number_text(-0.004, 2), "0.00") << "no minus before nothing";
  EXPECT_EQ(number_text(-1.5, 1), "−1.5");
  EXPECT_EQ(signed_text(1.5, 1), "+1.5");
  EXPECT_EQ(signed_text(0.0, 1), "0.0");
  EXPECT_EQ(digits_text(0.012345), "0.0123");
  EXPECT_EQ(digits_text(12345.6), "12346");
  EXPECT_EQ(digits_text({}), "–");
  EXPECT_EQ(percent_text(9.96), "10 %");
  EXPECT_EQ(percent_text(99.6), "99.6 %") << "not all";
  EXPECT_EQ(percent_text(99.96), "100 %");
  EXPECT_EQ(signed_percent(-0.01), "0.0 %");
  EXPECT_EQ(joined({"a", "b", "c"}), "a, b and c");
}

}  // namespace
}  // namespace pedzone::study
