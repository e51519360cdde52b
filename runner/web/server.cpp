#include "runner/web/server.hpp"

#include "runner/web/http_server.hpp"

namespace capstan {

Server::Server(const std::filesystem::path& data, Address address, Access access)
    : address_(std::move(address)), http_(std::make_unique<HttpServer>(data, std::move(access))) {
  address_.port = http_->listen_at(address_);
}

Server::~Server() = default;

void Server::reopen_log() { http_->reopen_log(); }

void Server::give_back_memory() { http_->give_back_memory(); }

void Server::serve(Service& service) { http_->set_service(service); }

}  // namespace capstan
