#include "sumo/calls/own_sumo.hpp"

#include <fcntl.h>
#include <netinet/in.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <iostream>
#include <thread>
#include <utility>

#include "core/child_process.hpp"
extern "C" {  // glibc 2.36 does not say so itself
#include <sys/pidfd.h>
}
#include "sumo/files/sumo_home.hpp"

namespace pedzone {
namespace {

constexpr double kPatience = 3600.0;  // [s] numerical: a large network loads for long
constexpr std::chrono::milliseconds kLook{20};
constexpr std::chrono::seconds kToEnd{30};    // for SUMO to write its outputs
constexpr std::chrono::seconds kToLeave{20};  // assumed: for a client to write what it found
constexpr std::chrono::seconds kToObey{5};    // assumed: for one that is asked to end

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
                                 std::to_string(own.all_clients() + 1)});
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

/// Ctrl-C is pedzone's, since it has a group of its own: SUMO is closed, not interrupted.
std::unique_ptr<Child> start(const std::vector<std::string>& command) {
  return std::make_unique<Child>([&] { return become(command); });
}

/// Until it has ended by itself, for a while. Whether it has.
bool wait_for(Child& process, std::chrono::seconds patience = kToEnd) {
  const auto until = std::chrono::steady_clock::now() + patience;
  while (!process.poll() && std::chrono::steady_clock::now() < until) {
    std::this_thread::sleep_for(kLook);
  }
  return process.poll().has_value();
}

std::string with_port(std::string command, int port) {
  const std::string place = "{port}";
  for (std::size_t at = 0; (at = command.find(place, at)) != std::string::npos;) {
    command.replace(at, place.size(), std::to_string(port));
  }
  return command;
}

/// That the run has begun, as another process can see it too: a pipe that nobody can write to any
/// more.
class Begun {
 public:
  Begun() {
    if (pipe2(ends_.data(), O_CLOEXEC | O_NONBLOCK) != 0) ends_ = {-1, -1};
  }
  ~Begun() {
    for (const int end : ends_) close(end);
  }
  Begun(const Begun&) = delete;
  Begun& operator=(const Begun&) = delete;

  /// To be called by each process that has it: by the one when the run begins, by the other first.
  void let_go() { close(std::exchange(ends_[1], -1)); }
  bool is_true() const {
    char nothing = 0;
    return read(ends_[0], &nothing, 1) == 0;
  }

 private:
  std::array<int, 2> ends_{-1, -1};
};

volatile std::sig_atomic_t asked_to_end = 0;

/// SUMO waits for a client that does not come; one that breaks off later ends it.
std::unique_ptr<Child> start_client(const std::string& command, const Child& sumo, Begun& begun) {
  return std::make_unique<Child>([&] {
    begun.let_go();
    std::signal(SIGTERM, [](int) { asked_to_end = 1; });  // the client's is as it was
    const int process = pidfd_open(sumo.id(), 0);
    prctl(PR_SET_CHILD_SUBREAPER, 1);  // the shell may end before what it has started
    const Ending ending = run_program({"sh", "-c", command}, ".");
    if (asked_to_end != 0) {
      while (wait(nullptr) > 0 || errno == EINTR) continue;
      return 0;
    }
    if (!begun.is_true()) pidfd_send_signal(process, SIGKILL, nullptr, 0);
    return ending.exit_code();
  });
}

/// Throws where it has not ended well.
void require_good_end(Child& client) {
  const auto ending = client.poll();
  if (ending && !ending->good()) throw SumoError("The client that was started " + ending->text());
}

/// Ends with the run: SUMO would go on for it, without pedzone. Whether it did so by itself.
bool end_with_run(Child& client) {
  if (wait_for(client, kToLeave)) return true;
  std::cerr << "Warning: the run is over, and the client that was started went on: it is ended."
            << std::endl;
  client.ask_to_end();
  if (!wait_for(client, kToObey)) client.kill();
  return false;
}

/// What a joined SUMO does; and its process ends with it, and that of a client.
class OwnSession final : public Session {
 public:
  OwnSession(std::unique_ptr<Child> process, std::unique_ptr<Child> client,
             std::unique_ptr<Session> joined, bool window)
      : process_(std::move(process)),
        client_(std::move(client)),
        joined_(std::move(joined)),
        window_(window) {}

  SumoPersons& persons() override { return joined_->persons(); }
  SumoVehicles& vehicles() override { return joined_->vehicles(); }
  /// A SUMO without a window says that it has none as an error.
  SumoView* view() override { return window_ ? joined_->view() : nullptr; }
  void step() override { joined_->step(); }
  void close() override {
    const bool by_itself = client_ && end_with_run(*client_);
    joined_->close();
    wait_for(*process_);
    if (by_itself) require_good_end(*client_);
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
  std::unique_ptr<Child> process_, client_;  ///< no client: null
  std::unique_ptr<Session> joined_;
  bool window_;
};

}  // namespace

std::unique_ptr<Session> start_own(const OwnSumo& own, const std::string& config,
                                   const std::vector<std::string>& words,
                                   const DesiredSpeeds& speeds) {
  find_sumo_data();
  const int port = own.port > 0 ? own.port : free_port();
  auto process = start(command_of(own, port, config, words));
  TraciAddress address;
  address.port = port;
  address.order = own.all_clients() + 1;
  address.patience = kPatience;
  Begun begun;
  std::unique_ptr<Child> client;
  if (!own.client.empty()) client = start_client(with_port(own.client, port), *process, begun);
  try {
    auto joined = join_over_traci(address, speeds, [&] { return !process->poll(); });
    begun.let_go();
    return std::make_unique<OwnSession>(std::move(process), std::move(client), std::move(joined),
                                        own.gui);
  } catch (const SumoError&) {
    if (!client) throw;
    wait_for(*process);  // the client ends it
    wait_for(*client);
    require_good_end(*client);
    if (client->poll()) throw SumoError("The client that was started ended before the run began.");
    throw;
  }
}

}  // namespace pedzone
