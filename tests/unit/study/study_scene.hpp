// A study file in a folder of its own, beside the scenarios of this project.
#pragma once

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include "core/error.hpp"
#include "study/plan/plan.hpp"

namespace pedzone::study {

class StudyScene : public ::testing::Test {
 protected:
  StudyScene() {
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
  }
  ~StudyScene() override { std::filesystem::remove_all(folder_); }

  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ + "/" + name) << text;
    return folder_ + "/" + name;
  }

  Study read(const std::string& text) const { return read_study(write("test.study.xml", text)); }
  Plan plan(const std::string& text) const { return make_plan(read(text)); }

  /// The message of what is wrong with a study, without the name of its file: "line: ...".
  std::string error(const std::string& text) const {
    const std::string file = folder_ + "/test.study.xml";
    try {
      plan(text);
    } catch (const InputError& problem) {
      const std::string what = problem.what();
      return what.starts_with(file + ":") ? what.substr(file.size() + 1) : what;
    }
    return "no error";
  }

  /// <scenario> of this project.
  static std::string scenario(const std::string& name, const std::string& more = "") {
    return "<scenario file=\"" PEDZONE_SCENARIOS "/" + name + "\" " + more + "/>";
  }

  static std::string text_of(const std::string& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
  }

  const std::string folder_ = ::testing::TempDir() + "study_" +
                              ::testing::UnitTest::GetInstance()->current_test_info()->name();
};

}  // namespace pedzone::study
