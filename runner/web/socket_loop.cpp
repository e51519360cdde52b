#include "runner/web/socket_loop.hpp"

#include <fcntl.h>
#include <sys/resource.h>
#include <sys/socket.h>

#include <algorithm>
#include <cerrno>

namespace capstan {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds kLingerTime{250};  // since the last byte from the client
constexpr milliseconds kMaxEndTime{1000};

/// Half of the descriptors that the process may open are left to the database and to the runs.
std::size_t connections_allowed(std::size_t wanted) {
  rlimit limit{};
  if (getrlimit(RLIMIT_NOFILE, &limit) != 0) return wanted;
  if (limit.rlim_cur < 2 * wanted) {
    limit.rlim_cur = std::min<rlim_t>(limit.rlim_max, 2 * wanted);
    setrlimit(RLIMIT_NOFILE, &limit);
  }
  return std::clamp<std::size_t>(limit.rlim_cur / 2, 1, wanted);
}

}  // namespace

SocketLoop::SocketLoop(ConnectionQueue& ready, Connection::HeadCheck check)
    : ready_(ready), check_(std::move(check)), max_connections_(connections_allowed(kMaxConnections)) {
  epoll_.add(messages_.wake_up_descriptor(), EPOLLIN);
  thread_ = std::thread([this] { run(); });
}

SocketLoop::~SocketLoop() {
  messages_.end();
  thread_.join();
}

void SocketLoop::finish(std::unique_ptr<Connection> connection) {
  if (!connection->send_unsent()) return;
  if (connection->unsent() == 0 && !connection->has_unread_input()) return;
  messages_.finish(std::move(connection));
}

void SocketLoop::run() {
  constexpr int kDeadlineInterval = 50;  // ms: how often deadlines are checked
  while (!has_ended()) {
    const bool is_idle = watched_.size() == 0 && !is_full();
    for (const epoll_event& event : epoll_.wait(is_idle ? -1 : kDeadlineInterval))
      handle_event(event.data.fd);
    process_messages();
    close_expired();
  }
}

bool SocketLoop::has_ended() const {
  return end_ < Steady::time_point::max() && (watched_.size() == 0 || Steady::now() > end_);
}

void SocketLoop::handle_event(int descriptor) {
  if (descriptor == listening_) return accept_all();
  const Iterator watched = watched_.find(descriptor);
  if (watched == watched_.end()) return;
  switch (watched->second.phase) {
    case Phase::receiving:
      return receive(watched);
    case Phase::sending:
      return send(watched);
    case Phase::lingering:
      return linger(watched);
  }
}

/// While there is no room, further connections wait in the kernel's backlog.
void SocketLoop::accept_all() {
  while (!is_full() || evict_one()) {
    const int socket = accept4(listening_, nullptr, nullptr, SOCK_CLOEXEC);
    if (socket >= 0) {
      start_receiving(socket);
    } else if (errno == EMFILE || errno == ENFILE) {
      if (!evict_one()) return std::this_thread::sleep_for(milliseconds(10));
    } else if (errno != EINTR && errno != ECONNABORTED) {
      return;
    }
  }
}

bool SocketLoop::is_full() { return watched_.size() + ready_.size() >= max_connections_; }

bool SocketLoop::evict_one() {
  const Iterator candidate = watched_.eviction_candidate(Phase::receiving);
  if (candidate == watched_.end()) return false;
  watched_.remove(candidate);
  return true;
}

void SocketLoop::receive(Iterator watched) {
  const Connection::Input input = watched->second.connection->receive(check_);
  watched_.update_bytes(watched);
  if (input == Connection::Input::complete) return ready_.push(watched_.remove(watched));
  if (input == Connection::Input::closed) return void(watched_.remove(watched));
  if (watched_.bytes() + ready_.bytes() > kMaxBytes)
    refuse(watched, problem(503, "Too much at once", "other requests are being read, come again"));
}

void SocketLoop::send(Iterator watched) {
  Connection& connection = *watched->second.connection;
  const bool is_connected = connection.send_unsent();
  watched_.update_bytes(watched);
  if (is_connected && connection.unsent() > 0) return;
  if (!is_connected || !connection.has_unread_input()) return void(watched_.remove(watched));
  connection.end_sending();
  watched_.change(watched, Phase::lingering, Steady::now() + kLingerTime);
}

/// Each input extends the deadline by kLingerTime, until twice kMaxReceiveTime after accepting.
void SocketLoop::linger(Iterator watched) {
  Connection& connection = *watched->second.connection;
  const auto now = Steady::now();
  if (!connection.discard_input()) return void(watched_.remove(watched));
  if (now < connection.accepted() + 2 * kMaxReceiveTime) watched->second.deadline = now + kLingerTime;
}

void SocketLoop::process_messages() {
  LoopRequests requests = messages_.take();
  if (requests.to_listen >= 0) start_listening(requests.to_listen);
  for (const int socket : requests.adopted) start_receiving(socket);
  for (auto& connection : requests.to_finish) start_finishing(std::move(connection));
  if (requests.should_end) end_ = Steady::now() + kMaxEndTime;
  if (!requests.should_stop_receiving) return;
  end_receiving();
  messages_.confirm_stopped_receiving();
}

void SocketLoop::start_listening(int socket) {
  fcntl(socket, F_SETFL, fcntl(socket, F_GETFL) | O_NONBLOCK);
  listening_ = socket;
  epoll_.add(listening_, EPOLLIN);
}

void SocketLoop::start_receiving(int socket) {
  watched_.add(std::make_unique<Connection>(socket), Phase::receiving, Steady::now() + kMaxReceiveTime);
}

void SocketLoop::start_finishing(std::unique_ptr<Connection> connection) {
  if (connection->unsent() > 0) {
    const auto deadline = connection->send_deadline();
    return watched_.add(std::move(connection), Phase::sending, deadline);
  }
  connection->end_sending();
  watched_.add(std::move(connection), Phase::lingering, Steady::now() + kLingerTime);
}

/// Closes connections whose deadline has passed. If too much memory is held, closes connections of slow
/// readers until enough is free.
void SocketLoop::close_expired() {
  const auto now = Steady::now();
  for (Iterator next = watched_.begin(); next != watched_.end();) {
    const Iterator watched = next++;
    if (now < watched->second.deadline) continue;
    if (watched->second.phase == Phase::receiving && watched->second.connection->has_begun())
      refuse(watched, problem(408, "Request timeout", "the request did not come in time"));
    else
      watched_.remove(watched);
  }
  for (Iterator candidate; watched_.bytes() > kMaxBytes &&
                           (candidate = watched_.eviction_candidate(Phase::sending)) != watched_.end();)
    watched_.remove(candidate);
  const bool has_room = !is_full() || watched_.eviction_candidate(Phase::receiving) != watched_.end();
  if (listening_ >= 0) epoll_.change(listening_, has_room ? EPOLLIN : 0u);
}

void SocketLoop::end_receiving() {
  if (listening_ >= 0) epoll_.remove(std::exchange(listening_, -1));
  for (Iterator next = watched_.begin(); next != watched_.end();) {
    const Iterator watched = next++;
    if (watched->second.phase != Phase::receiving) continue;
    if (watched->second.connection->has_begun())
      refuse(watched, problem(503, "Not available", "the server is ending, send the request again later"));
    else
      watched_.remove(watched);
  }
}

/// A request thread sends the refusal and writes the log.
void SocketLoop::refuse(Iterator watched, Response refusal) {
  if (refusal.status == 503) refusal.headers["Retry-After"] = "5";
  std::unique_ptr<Connection> connection = watched_.remove(watched);
  connection->refuse_with(std::move(refusal));
  ready_.push(std::move(connection));
}

}  // namespace capstan
