// A file of a test's own, gone with it.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace pedzone::study {

class TemporaryFile {
 public:
  /// `name`: tells it from the test's others.
  TemporaryFile(const std::string& name, const std::string& text) : path_(place_of(name)) {
    std::ofstream(path_) << text;
  }
  ~TemporaryFile() { std::filesystem::remove(path_); }
  TemporaryFile(const TemporaryFile&) = delete;
  TemporaryFile& operator=(const TemporaryFile&) = delete;
  const std::string& path() const { return path_; }

 private:
  /// Tests run side by side.
  static std::string place_of(const std::string& name) {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    return testing::TempDir() + "pedzone_" + test->test_suite_name() + "." + test->name() + "." +
           name;
  }
  std::string path_;
};

}  // namespace pedzone::study
