// The connection to SUMO, for what libtraci, which keeps its socket to itself, cannot do.
#pragma once

#include <string>

namespace pedzone {

/// Takes the socket of this process that is connected to a port, or none.
void take_wire(int port);
bool has_wire();

/// Both throw std::runtime_error where the connection has ended.
void write_wire(const std::string& bytes);
std::string read_wire(std::size_t size);

}  // namespace pedzone
