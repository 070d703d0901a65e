#include "sumo/calls/own_sumo.hpp"

#include <netinet/in.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <thread>

#include "sumo/files/sumo_home.hpp"

namespace pedzone {
namespace {

constexpr double kPatience = 3600.0;  // [s] numerical: a large network loads for long
constexpr std::chrono::milliseconds kLook{20};
constexpr std::chrono::seconds kToEnd{30};  // for SUMO to write its outputs

/// A port that is free now.
int free_port() {
  const int probe = socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in at{};
  at.sin_family = AF_INET;
  at.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof at;
  const bool found = bind(probe, reinterpret_cast<sockaddr*>(&at), size) == 0 &&
                     getsockname(probe, reinterpret_cast<sockaddr*>(&at), &size) == 0;
  close(probe);
  if (!found) throw SumoError("There is no free port for SUMO.");
  return ntohs(at.sin_port);
}

std::vector<std::string> command_of(const OwnSumo& own, int port, const std::string& config,
                                    const std::vector<std::string>& words) {
  std::vector<std::string> command{own.gui ? "sumo-gui" : "sumo", "-c", config};
  command.insert(command.end(), words.begin(), words.end());
  command.insert(command.end(), {"--remote-port", std::to_string(port), "--num-clients",
                                 std::to_string(own.clients + 1)});
  if (own.gui) {
    command.insert(command.end(),
                   {"--start", "--quit-on-end", "--delay", std::to_string(own.delay)});
    const std::string size = "--window-size";  // SUMO takes an option once
    if (std::ranges::find(words, size) == words.end()) {
      command.insert(command.end(), {size, "1400,900"});
    }
  }
  return command;
}

/// Never returns.
[[noreturn]] void become(const std::vector<std::string>& command, pid_t parent) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (getppid() != parent) _exit(1);
  setpgid(0, 0);  // Ctrl-C is pedzone's: SUMO is closed, not interrupted
  std::vector<char*> words;
  for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  execvp(words.front(), words.data());
  std::perror(words.front());
  _exit(127);
}

class SumoProcess {
 public:
  explicit SumoProcess(const std::vector<std::string>& command) {
    std::fflush(nullptr);
    const pid_t parent = getpid();
    pid_ = fork();
    if (pid_ < 0) throw SumoError("cannot start a process for SUMO");
    if (pid_ == 0) become(command, parent);
  }
  ~SumoProcess() {
    if (ended()) return;
    kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
  }
  SumoProcess(const SumoProcess&) = delete;
  SumoProcess& operator=(const SumoProcess&) = delete;

  bool ended() {
    if (!over_) over_ = waitpid(pid_, nullptr, WNOHANG) == pid_;
    return over_;
  }
  /// Until it has ended by itself, for a while.
  void wait() {
    const auto until = std::chrono::steady_clock::now() + kToEnd;
    while (!ended() && std::chrono::steady_clock::now() < until) std::this_thread::sleep_for(kLook);
  }

 private:
  pid_t pid_ = -1;
  bool over_ = false;
};

/// What a joined SUMO does; and its process ends with it.
class OwnSession final : public Session {
 public:
  OwnSession(std::unique_ptr<SumoProcess> process, std::unique_ptr<Session> joined)
      : process_(std::move(process)), joined_(std::move(joined)) {}

  SumoPersons& persons() override { return joined_->persons(); }
  SumoVehicles& vehicles() override { return joined_->vehicles(); }
  SumoView* view() override { return joined_->view(); }
  void step() override { joined_->step(); }
  void close() override {
    joined_->close();
    process_->wait();
  }
  double time() const override { return joined_->time(); }
  double step_length() const override { return joined_->step_length(); }
  double end_time() const override { return joined_->end_time(); }
  bool nobody_left() const override { return joined_->nobody_left(); }
  long departed_persons() const override { return joined_->departed_persons(); }
  long arrived_persons() const override { return joined_->arrived_persons(); }
  SumoEvents events() const override { return joined_->events(); }
  bool is_lost(const std::exception& error) const override { return joined_->is_lost(error); }
  std::string option(const std::string& name) const override { return joined_->option(name); }
  std::string edge_parameter(const std::string& edge, const std::string& key) const override {
    return joined_->edge_parameter(edge, key);
  }
  void set_edge_parameter(const std::string& edge, const std::string& key,
                          const std::string& value) override {
    joined_->set_edge_parameter(edge, key, value);
  }

 private:
  std::unique_ptr<SumoProcess> process_;
  std::unique_ptr<Session> joined_;
};

}  // namespace

std::unique_ptr<Session> start_own(const OwnSumo& own, const std::string& config,
                                   const std::vector<std::string>& words,
                                   const DesiredSpeeds& speeds) {
  find_sumo_data();
  const int port = own.port > 0 ? own.port : free_port();
  auto process = std::make_unique<SumoProcess>(command_of(own, port, config, words));
  TraciAddress address;
  address.port = port;
  address.order = own.clients + 1;
  address.patience = kPatience;
  auto joined = join_over_traci(address, speeds, [&] { return !process->ended(); });
  return std::make_unique<OwnSession>(std::move(process), std::move(joined));
}

}  // namespace pedzone
