#include "study/run/store.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>

#include "core/error.hpp"

namespace pedzone::study {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::ThrowsMessage;

const std::map<std::string, std::string> kVersions = {{"pedzone", "1"}, {"sumo", "2"}};

/// A folder of its own with a study, and a place for results beside it.
class StoreTest : public testing::Test {
 protected:
  StoreTest() {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = testing::TempDir() + "/store_" + test->name();
    fs::remove_all(folder_);
    fs::create_directories(folder_);
    study_.file = write("study.xml", "<study/>");
    study_.folder = folder_;
    study_.id = "one";
  }
  ~StoreTest() override { fs::remove_all(folder_); }

  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ + "/" + name) << text;
    return folder_ + "/" + name;
  }
  std::string results() const { return folder_ + "/results"; }
  Store created() const { return Store::create(results(), study_, kVersions); }
  void expect_refusal(const std::string& why) const {
    EXPECT_THAT([this] { created(); }, ThrowsMessage<InputError>(HasSubstr(why)));
  }

  std::string folder_;
  Study study_;
};

/// A finished run of the plan.
void finish_run(const Store& store, RunRecord record) {
  const std::string folder = store.make_folder(record.id);
  std::ofstream(folder + "/record.json") << record_text(record);
  store.finish(folder, record.id);
}

Plan plan_of(const std::vector<std::string>& ids) {
  Plan plan;
  for (const std::string& id : ids) {
    plan.runs.emplace_back();
    plan.runs.back().id = id;
  }
  return plan;
}

RunRecord record_of(const std::string& id) {
  RunRecord record;
  record.id = id;
  return record;
}

std::size_t files_in(const std::string& folder) {
  return static_cast<std::size_t>(
      std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

TEST_F(StoreTest, is_made_and_found_again) {
  EXPECT_EQ(created().versions(), kVersions);
  const Store opened = Store::open(results());
  EXPECT_EQ(opened.versions(), kVersions);
  EXPECT_EQ(opened.folder(), fs::canonical(results()));
  EXPECT_NO_THROW(created());
}

TEST_F(StoreTest, is_made_in_an_empty_folder_and_where_a_driver_was_killed_early) {
  fs::create_directories(results());
  std::ofstream(results() + "/lock") << "somebody";
  std::ofstream(results() + "/study.json.partial") << "{";
  EXPECT_NO_THROW(created());
}

TEST_F(StoreTest, of_another_study_is_refused) {
  created();
  study_.id = "two";
  expect_refusal("another study: 'one'");
  study_.id = "one";
  study_.folder = "/elsewhere";
  expect_refusal("not 'one' in /elsewhere");
}

TEST_F(StoreTest, of_another_version_is_refused) {
  (void)Store::create(results(), study_, {{"pedzone", "1"}, {"sumo", "3"}});
  expect_refusal("another version (sumo: 3, now 2)");
}

TEST_F(StoreTest, of_another_format_is_refused) {
  created();
  std::ofstream(results() + "/study.json") << R"({"format": 0, "study": "one"})";
  expect_refusal("another version of pedzone");
}

TEST_F(StoreTest, in_a_folder_of_something_else_is_refused_and_nothing_is_touched) {
  fs::create_directories(results());
  std::ofstream(results() + "/thesis.tex") << "years";
  expect_refusal("something else (thesis.tex)");
  EXPECT_EQ(files_in(results()), 1U);
}

TEST_F(StoreTest, that_cannot_be_understood_is_refused) {
  fs::create_directories(results());
  std::ofstream(results() + "/study.json") << "{";
  expect_refusal("study.json: cannot be understood");
}

TEST_F(StoreTest, where_a_file_lies_is_refused) {
  write("results", "a file");
  expect_refusal("is a file");
}

TEST_F(StoreTest, that_is_none_cannot_be_opened) {
  EXPECT_THAT([this] { Store::open(folder_); },
              ThrowsMessage<InputError>(HasSubstr("holds no study")));
}

TEST_F(StoreTest, has_records_of_runs_that_are_over) {
  const Store store = created();
  finish_run(store, record_of("b"));
  const Records records = store.records(plan_of({"a", "b"}));
  EXPECT_FALSE(records[0]);
  ASSERT_TRUE(records[1]);
  EXPECT_EQ(records[1]->id, "b");
}

TEST_F(StoreTest, has_no_records_of_runs_whose_inputs_have_changed_or_gone) {
  const Store store = created();
  const std::string input = write("input.xml", "abc");
  RunRecord record = record_of("a");
  // NIST's example of "abc".
  record.inputs[input] = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";
  finish_run(store, record);
  EXPECT_TRUE(store.records(plan_of({"a"}))[0]);
  EXPECT_EQ(store.stored_runs(plan_of({"a", "b"})).outdated.count, 0u);
  write("input.xml", "abd");
  EXPECT_FALSE(store.records(plan_of({"a"}))[0]);
  EXPECT_EQ(store.stored_runs(plan_of({"a", "b"})).outdated.count, 1u);
  EXPECT_EQ(store.stored_runs(plan_of({"a"})).outdated.file, input);
  fs::remove(input);
  EXPECT_FALSE(store.records(plan_of({"a"}))[0]);
}

TEST_F(StoreTest, has_no_records_that_cannot_be_read) {
  const Store store = created();
  finish_run(store, record_of("a"));
  std::ofstream(store.run_folder("a") + "/record.json").close();  // as after a loss of power
  EXPECT_FALSE(store.records(plan_of({"a"}))[0]);
}

TEST_F(StoreTest, keeps_the_first_of_two_that_finish_the_same_run) {
  const Store store = created();
  RunRecord first = record_of("a"), second = record_of("a");
  second.attempts = 2;
  finish_run(store, first);
  finish_run(store, second);
  EXPECT_EQ(store.records(plan_of({"a"}))[0]->attempts, 1);
  EXPECT_EQ(files_in(results() + "/runs"), 1U);
}

TEST_F(StoreTest, replaces_what_failed_and_what_had_other_inputs) {
  const Store store = created();
  RunRecord record = record_of("a");
  record.status = RunStatus::kFailed;
  finish_run(store, record);
  record.status = RunStatus::kDone;
  record.inputs["old.xml"] = "1";
  finish_run(store, record);
  const auto kept = [&] { return read_record(store.run_folder("a") + "/record.json"); };
  EXPECT_EQ(kept().status, RunStatus::kDone);
  record.inputs["old.xml"] = "2";
  finish_run(store, record);
  EXPECT_EQ(kept().inputs, record.inputs);
  record.status = RunStatus::kFailed;  // a copy that was slower
  finish_run(store, record);
  EXPECT_EQ(kept().status, RunStatus::kDone);
  EXPECT_EQ(files_in(results() + "/runs"), 1U);
}

TEST_F(StoreTest, discards_a_run) {
  const Store store = created();
  finish_run(store, record_of("a"));
  store.discard("a");
  store.discard("never there");
  EXPECT_EQ(files_in(results() + "/runs"), 0U);
}

TEST_F(StoreTest, clears_what_nobody_makes_any_more_and_keeps_runs) {
  const Store store = created();
  finish_run(store, record_of("a"));
  std::ofstream(store.make_folder("b") + "/log.txt") << "cut";
  (void)store.make_folder("b");
  EXPECT_EQ(files_in(results() + "/runs"), 3U);
  store.clear_rubbish();
  EXPECT_EQ(files_in(results() + "/runs"), 1U);
  EXPECT_TRUE(store.records(plan_of({"a"}))[0]);
}

}  // namespace
}  // namespace pedzone::study
