#include "runner/web/server.hpp"

#include "runner/web/http_server.hpp"

namespace capstan {

Server::Server(Service& service, Address address, Access access)
    : address_(std::move(address)), http_(std::make_unique<HttpServer>(service, std::move(access))) {
  address_.port = http_->listen_at(address_);
}

Server::~Server() = default;

}  // namespace capstan
