#include "sumo/calls/wire.hpp"

#include <netinet/in.h>
#include <sys/socket.h>

#include <atomic>
#include <cerrno>
#include <stdexcept>

#include "sumo/calls/session.hpp"

namespace pedzone {
namespace {

std::atomic<int> the_wire = -1;  // hang_up() is called by another thread

/// What a call that transfers has transferred; nothing where a signal has interrupted it.
std::size_t checked(ssize_t moved) {
  if (moved < 0 && errno == EINTR) return 0;
  if (moved <= 0) throw std::runtime_error("the connection to SUMO has ended");
  return static_cast<std::size_t>(moved);
}

}  // namespace

void take_wire(int port) {
  constexpr int kHighest = 1024;
  the_wire = -1;
  for (int wire = 3; wire < kHighest && the_wire < 0; ++wire) {
    sockaddr_in peer{};
    socklen_t size = sizeof peer;
    if (getpeername(wire, reinterpret_cast<sockaddr*>(&peer), &size) != 0) continue;
    if (peer.sin_family == AF_INET && ntohs(peer.sin_port) == port) the_wire = wire;
  }
}

bool has_wire() { return the_wire >= 0; }

void write_wire(const std::string& bytes) {
  for (std::size_t sent = 0; sent < bytes.size();) {
    sent += checked(::send(the_wire, bytes.data() + sent, bytes.size() - sent, MSG_NOSIGNAL));
  }
}

std::string read_wire(std::size_t size) {
  std::string bytes(size, '\0');
  for (std::size_t got = 0; got < size;) {
    got += checked(recv(the_wire, bytes.data() + got, size - got, 0));
  }
  return bytes;
}

void hang_up() {
  const int wire = the_wire;
  if (wire >= 0) shutdown(wire, SHUT_RDWR);
}

}  // namespace pedzone
