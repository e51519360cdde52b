#pragma once
// The HTTP server: carries requests to the routes and responses back, on threads of its own.
#include <filesystem>
#include <memory>

#include "runner/daemon/service.hpp"
#include "runner/web/access.hpp"
#include "runner/web/address.hpp"

namespace capstan {

class HttpServer;

class Server {
 public:
  /// Listens from now on, and says that it is starting. Throws std::runtime_error when the address is taken.
  /// \param data  the data directory
  Server(const std::filesystem::path& data, Address address, Access access);
  ~Server();
  Server(const Server&) = delete;
  Server& operator=(const Server&) = delete;

  /// Answers all requests from now on.
  void serve(Service& service);

  /// The request log was moved away: it goes on in a new file.
  void reopen_log();

  /// What answers took goes back to the system, unless some did a moment ago.
  void give_back_memory();

  /// With the port that was found, if any free one was asked for.
  const Address& address() const { return address_; }

 private:
  Address address_;
  std::unique_ptr<HttpServer> http_;
};

}  // namespace capstan
