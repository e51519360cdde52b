#include "runner/web/watched_connections.hpp"

#include <string>

namespace capstan {
namespace {

std::uint32_t events_of(WatchedConnections::Phase phase) {
  return phase == WatchedConnections::Phase::sending ? EPOLLOUT : EPOLLIN;
}

}  // namespace

void WatchedConnections::add(std::unique_ptr<Connection> connection, Phase phase,
                             Steady::time_point deadline) {
  const int descriptor = connection->descriptor();
  const std::size_t bytes = connection->bytes_held();
  bytes_ += bytes;
  by_descriptor_.insert_or_assign(descriptor, Watched{std::move(connection), phase, deadline, bytes});
  epoll_.add(descriptor, events_of(phase));
}

void WatchedConnections::change(Iterator watched, Phase phase, Steady::time_point deadline) {
  watched->second.phase = phase;
  watched->second.deadline = deadline;
  epoll_.change(watched->first, events_of(phase));
}

std::unique_ptr<Connection> WatchedConnections::remove(Iterator watched) {
  std::unique_ptr<Connection> connection = std::move(watched->second.connection);
  epoll_.remove(watched->first);
  bytes_ -= watched->second.bytes;
  by_descriptor_.erase(watched);
  return connection;
}

void WatchedConnections::update_bytes(Iterator watched) {
  const std::size_t now = watched->second.connection->bytes_held();
  bytes_ += now - watched->second.bytes;
  watched->second.bytes = now;
}

WatchedConnections::Iterator WatchedConnections::eviction_candidate(Phase phase) {
  std::map<std::string, int> connections_of;  // by client
  for (const auto& [descriptor, each] : by_descriptor_)
    if (each.phase == phase) ++connections_of[each.connection->peer()];
  Iterator candidate = end();
  const auto goes_before = [&](const Watched& a, const Watched& b) {
    const int of_a = connections_of[a.connection->peer()], of_b = connections_of[b.connection->peer()];
    return of_a != of_b ? of_a > of_b : a.connection->accepted() < b.connection->accepted();
  };
  for (Iterator each = begin(); each != end(); ++each)
    if (each->second.phase == phase && (candidate == end() || goes_before(each->second, candidate->second)))
      candidate = each;
  return candidate;
}

}  // namespace capstan
