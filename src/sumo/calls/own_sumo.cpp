#include "sumo/calls/own_sumo.hpp"

#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <thread>

#include "core/child_process.hpp"
extern "C" {  // glibc 2.36 does not say so itself
#include <sys/pidfd.h>
}
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

/// Until it has ended by itself, for a while.
void wait_for(Child& process) {
  const auto until = std::chrono::steady_clock::now() + kToEnd;
  while (!process.poll() && std::chrono::steady_clock::now() < until) {
    std::this_thread::sleep_for(kLook);
  }
}

std::string with_port(std::string command, int port) {
  const std::string place = "{port}";
  for (std::size_t at = 0; (at = command.find(place, at)) != std::string::npos;) {
    command.replace(at, place.size(), std::to_string(port));
  }
  return command;
}

/// SUMO waits for a client that does not come, and one that breaks off ends it anyhow.
std::unique_ptr<Child> start_client(const std::string& command, const Child& sumo) {
  return std::make_unique<Child>([&] {
    const int process = pidfd_open(sumo.id(), 0);
    const Ending ending = run_program({"sh", "-c", command}, ".");
    if (!ending.good()) pidfd_send_signal(process, SIGKILL, nullptr, 0);
    return ending.exit_code();
  });
}

/// Throws where it has ended by itself, and not well.
void require_good_end(Child& client) {
  const auto ending = client.poll();
  if (ending && !ending->good()) throw SumoError("The client that was started " + ending->text());
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
    joined_->close();
    if (client_) wait_for(*client_);
    wait_for(*process_);
    if (client_) require_good_end(*client_);
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
  std::unique_ptr<Child> client;
  if (!own.client.empty()) client = start_client(with_port(own.client, port), *process);
  try {
    auto joined = join_over_traci(address, speeds, [&] { return !process->poll(); });
    return std::make_unique<OwnSession>(std::move(process), std::move(client), std::move(joined),
                                        own.gui);
  } catch (const SumoError&) {
    if (!client) throw;
    wait_for(*process);  // the client ends it
    wait_for(*client);
    require_good_end(*client);
    throw;
  }
}

}  // namespace pedzone
