#pragma once
#include "runner/web/listen_address.hpp"

namespace capstan {

/// Opens a TCP socket that listens at the address. Returns its descriptor, which the caller closes. Throws
/// std::runtime_error if the address is taken or does not exist.
int open_listening_socket(const ListenAddress& address);

/// The port of a listening socket.
int port_of(int socket);

}  // namespace capstan
