#include "study/run/directory_lock.hpp"

#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "core/error.hpp"

namespace pedzone::study {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::string new_folder() {
  const auto* test = testing::UnitTest::GetInstance()->current_test_info();
  const std::string folder = testing::TempDir() + "/lock_" + test->name();
  std::filesystem::remove_all(folder);
  std::filesystem::create_directory(folder);
  return folder;
}

/// What another process says of the folder: the refusal, else who holds it.
std::string said_by_another(const std::string& folder) {
  const std::string answer = folder + "/answer";
  const pid_t other = fork();
  if (other == 0) {
    std::ofstream out(answer);
    out << lock_holder(folder) << "|";
    try {
      const DirectoryLock lock(folder, "the other");
      out << "taken";
    } catch (const InputError& error) {
      out << error.what();
    }
    out.close();
    _exit(0);
  }
  waitpid(other, nullptr, 0);
  std::ifstream in(answer);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(DirectoryLock, keeps_others_out_and_says_who_holds_it) {
  const std::string folder = new_folder();
  const DirectoryLock lock(folder, "the first");
  EXPECT_THAT(said_by_another(folder),
              AllOf(HasSubstr("the first, process " + std::to_string(getpid())),
                    HasSubstr("is in use by the first"), HasSubstr(folder)));
}

TEST(DirectoryLock, is_free_again_once_it_is_gone) {
  const std::string folder = new_folder();
  { const DirectoryLock lock(folder, "the first"); }
  EXPECT_EQ(said_by_another(folder), "|taken");
}

TEST(DirectoryLock, is_not_held_by_processes_that_its_holder_has_forked) {
  const std::string folder = new_folder();
  pid_t child = 0;
  {
    const DirectoryLock lock(folder, "the first");
    child = fork();
    if (child == 0) {
      pause();
      _exit(0);
    }
  }
  EXPECT_EQ(said_by_another(folder), "|taken");
  kill(child, SIGKILL);
  waitpid(child, nullptr, 0);
}

TEST(DirectoryLock, in_a_folder_that_is_not_there_is_an_error) {
  EXPECT_THROW(DirectoryLock("/no/such/folder", "me"), InputError);
}

}  // namespace
}  // namespace pedzone::study
