#include "core/child_process.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <stdexcept>

namespace pedzone {
namespace {

Ending ending_of(Child& child) {
  for (;;) {
    if (const std::optional<Ending> ending = child.poll()) return *ending;
  }
}

Ending ending_of(const std::function<int()>& work) {
  Child child(work);
  return ending_of(child);
}

/// A pipe whose reading end sees its end once all who have the other one are gone.
struct Pipe {
  int read_end = -1, write_end = -1;
  Pipe() {
    std::array<int, 2> ends{};
    if (pipe(ends.data()) != 0) throw std::runtime_error("no pipe");
    read_end = ends[0];
    write_end = ends[1];
  }
  void keep_reading_end() { close(write_end); }
  /// Blocks until there is something; empty at the end.
  std::string next() const {
    char c = 0;
    return read(read_end, &c, 1) == 1 ? std::string(1, c) : "";
  }
};

TEST(Ending, tells_what_somebody_else_did) {
  EXPECT_TRUE(Ending{}.good());
  EXPECT_FALSE((Ending{1, 0}).from_outside());
  EXPECT_FALSE((Ending{0, SIGSEGV}).from_outside());
  EXPECT_FALSE((Ending{128 + SIGABRT, 0}).from_outside());
  EXPECT_TRUE((Ending{0, SIGKILL}).from_outside());
  EXPECT_TRUE((Ending{128 + SIGTERM, 0}).from_outside());
  EXPECT_EQ((Ending{0, SIGKILL}).exit_code(), 137);
}

TEST(Child, ends_with_what_its_work_returns) {
  EXPECT_EQ(ending_of([] { return 7; }).code, 7);
}

TEST(Child, whose_work_throws_ends_with_an_error) {
  EXPECT_EQ(ending_of([]() -> int { throw std::runtime_error("no way out"); }).code, 1);
}

TEST(Child, that_dies_of_a_signal_says_which) {
  const Ending ending = ending_of([] {
    std::signal(SIGTERM, SIG_DFL);
    return std::raise(SIGTERM);
  });
  EXPECT_EQ(ending.signal, SIGTERM);
}

TEST(Child, takes_signals_that_its_parent_holds_back) {
  sigset_t held, before;
  sigemptyset(&held);
  sigaddset(&held, SIGTERM);
  sigprocmask(SIG_BLOCK, &held, &before);
  const Ending ending = ending_of([] { return std::raise(SIGTERM); });
  sigprocmask(SIG_SETMASK, &before, nullptr);
  EXPECT_EQ(ending.signal, SIGTERM);
}

TEST(Child, runs_until_it_is_killed) {
  Child child([] { return pause(); });
  EXPECT_FALSE(child.poll());
  child.kill();
  ASSERT_TRUE(child.poll());
  EXPECT_EQ(child.poll()->signal, SIGKILL);
}

TEST(Child, takes_all_that_it_started_with_it) {
  Pipe alive;
  Child child([] {
    if (fork() == 0) pause();  // nobody has it die with its parent
    return 0;
  });
  alive.keep_reading_end();
  EXPECT_TRUE(ending_of(child).good());
  EXPECT_EQ(alive.next(), "") << "blocks as long as anybody is left";
}

TEST(Child, dies_with_its_parent_and_so_does_what_it_has_started) {
  Pipe alive;
  const pid_t driver = fork();
  if (driver == 0) {
    const Child child([&] {
      return run_program(
                 {"sh", "-c", "echo x >&" + std::to_string(alive.write_end) + "; exec sleep 60"},
                 "/")
          .code;
    });
    pause();
    _exit(0);
  }
  alive.keep_reading_end();
  EXPECT_EQ(alive.next(), "x");
  EXPECT_EQ(alive.next(), "\n");
  kill(driver, SIGKILL);
  EXPECT_EQ(alive.next(), "") << "blocks as long as the sleeper sleeps";
  waitpid(driver, nullptr, 0);
}

TEST(RunProgram, starts_in_the_folder_without_input) {
  EXPECT_TRUE(run_program({"sh", "-c", "test \"$PWD\" = /usr && ! read word"}, "/usr").good());
}

TEST(RunProgram, that_is_not_there_has_the_code_of_shells) {
  EXPECT_EQ(run_program({"no-such-program"}, "/").code, 127);
  EXPECT_EQ(run_program({"true"}, "/no/such/folder").code, 127);
}

}  // namespace
}  // namespace pedzone
