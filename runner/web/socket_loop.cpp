#include "runner/web/socket_loop.hpp"

#include <fcntl.h>
#include <sys/epoll.h>
#include <sys/eventfd.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>

namespace capstan {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds kLinger{250};  // without a byte from a client that was answered
constexpr milliseconds kMaxEnd{1000};

/// Half of the descriptors are left to the database and to the runs.
std::size_t connections_allowed(std::size_t wanted) {
  rlimit limit{};
  if (getrlimit(RLIMIT_NOFILE, &limit) != 0) return wanted;
  if (limit.rlim_cur < 2 * wanted) {
    limit.rlim_cur = std::min<rlim_t>(limit.rlim_max, 2 * wanted);
    setrlimit(RLIMIT_NOFILE, &limit);
  }
  return std::clamp<std::size_t>(limit.rlim_cur / 2, 1, wanted);
}

void change_interest(int epoll, int operation, int descriptor, std::uint32_t events) {
  epoll_event wanted{};
  wanted.events = events;
  wanted.data.fd = descriptor;
  epoll_ctl(epoll, operation, descriptor, &wanted);
}

void wake(int event) {
  const std::uint64_t one = 1;
  [[maybe_unused]] const ssize_t written = write(event, &one, sizeof one);
}

}  // namespace

SocketLoop::SocketLoop(ConnectionQueue& complete, Connection::Judge judge)
    : complete_(complete),
      judge_(std::move(judge)),
      most_(connections_allowed(kMaxConnections)),
      epoll_(epoll_create1(EPOLL_CLOEXEC)),
      wake_(eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK)) {
  change_interest(epoll_, EPOLL_CTL_ADD, wake_, EPOLLIN);
  thread_ = std::thread([this] { run(); });
}

SocketLoop::~SocketLoop() {
  {
    const std::lock_guard lock(mutex_);
    is_ending_ = true;
  }
  wake(wake_);
  thread_.join();
  for (const int socket : adopted_) close(socket);
  close(wake_);
  close(epoll_);
}

void SocketLoop::listen(int listening) {
  fcntl(listening, F_SETFL, fcntl(listening, F_GETFL) | O_NONBLOCK);
  const std::lock_guard lock(mutex_);
  to_listen_ = listening;
  wake(wake_);
}

void SocketLoop::adopt(int socket) {
  const std::lock_guard lock(mutex_);
  adopted_.push_back(socket);
  wake(wake_);
}

void SocketLoop::finish(std::unique_ptr<Connection> connection) {
  if (!connection->send_unsent()) return;
  if (connection->unsent() == 0 && !connection->has_unread()) return;
  const std::lock_guard lock(mutex_);
  to_finish_.push_back(std::move(connection));
  wake(wake_);
}

void SocketLoop::stop_receiving() {
  std::unique_lock lock(mutex_);
  is_stopped_ = true;
  wake(wake_);
  stopped_.wait(lock, [&] { return has_stopped_; });
}

void SocketLoop::run() {
  constexpr int kSweep = 50;  // ms
  std::array<epoll_event, 64> events{};
  while (!has_ended()) {
    const bool is_idle = watched_.empty() && !is_full();
    const int count =
        epoll_wait(epoll_, events.data(), static_cast<int>(events.size()), is_idle ? -1 : kSweep);
    for (int i = 0; i < count; ++i) look_at(events[static_cast<std::size_t>(i)].data.fd);
    take_messages();
    end_late();
  }
}

/// The clients have a moment to take what was answered.
bool SocketLoop::has_ended() {
  const std::lock_guard lock(mutex_);
  if (!is_ending_) return false;
  if (end_ == Steady::time_point::max()) end_ = Steady::now() + kMaxEnd;
  return to_finish_.empty() && (watched_.empty() || Steady::now() > end_);
}

void SocketLoop::look_at(int descriptor) {
  if (descriptor == listening_) return accept_all();
  std::uint64_t count = 0;
  if (descriptor == wake_) {
    [[maybe_unused]] const ssize_t taken = read(wake_, &count, sizeof count);
    return;
  }
  const Place place = watched_.find(descriptor);
  if (place == watched_.end()) return;
  switch (place->second.phase) {
    case Phase::receiving:
      return receive(place);
    case Phase::sending:
      return send(place);
    case Phase::lingering:
      return linger(place);
  }
}

void SocketLoop::take_messages() {
  std::vector<int> adopted;
  std::vector<std::unique_ptr<Connection>> to_finish;
  std::unique_lock lock(mutex_);
  adopted.swap(adopted_);
  to_finish.swap(to_finish_);
  if (const int listening = std::exchange(to_listen_, -1); listening >= 0) {
    listening_ = listening;
    change_interest(epoll_, EPOLL_CTL_ADD, listening_, EPOLLIN);
  }
  const bool stops = is_stopped_ && !has_stopped_;
  lock.unlock();
  for (const int socket : adopted)
    watch(std::make_unique<Connection>(socket), Phase::receiving, Steady::now() + kMaxReceive);
  for (auto& connection : to_finish) {
    const bool is_sent = connection->unsent() == 0;
    if (is_sent) connection->end_sending();
    const auto until = is_sent ? Steady::now() + kLinger : connection->send_until();
    watch(std::move(connection), is_sent ? Phase::lingering : Phase::sending, until);
  }
  if (!stops) return;
  end_receiving();
  lock.lock();
  has_stopped_ = true;
  stopped_.notify_all();
}

bool SocketLoop::is_full() { return watched_.size() + complete_.size() >= most_; }

/// The oldest connection of the client that has most of them.
SocketLoop::Place SocketLoop::victim(Phase phase) {
  std::map<std::string, int> count;
  for (const auto& [descriptor, each] : watched_)
    if (each.phase == phase) ++count[each.connection->peer()];
  const auto rank = [&](const Watched& each) {
    return std::pair(each.phase == phase ? count[each.connection->peer()] : 0,
                     -each.connection->accepted().time_since_epoch());
  };
  const Place first = std::max_element(watched_.begin(), watched_.end(), [&](const auto& a, const auto& b) {
    return rank(a.second) < rank(b.second);
  });
  return count.empty() ? watched_.end() : first;
}

bool SocketLoop::make_room() {
  const Place oldest = victim(Phase::receiving);
  if (oldest == watched_.end()) return false;
  take(oldest);
  return true;
}

/// Those that find no room wait in the kernel's backlog.
void SocketLoop::accept_all() {
  while (!is_full() || make_room()) {
    const int socket = accept4(listening_, nullptr, nullptr, SOCK_CLOEXEC);
    if (socket >= 0) {
      watch(std::make_unique<Connection>(socket), Phase::receiving, Steady::now() + kMaxReceive);
    } else if (errno == EMFILE || errno == ENFILE) {
      if (!make_room()) return std::this_thread::sleep_for(milliseconds(10));
    } else if (errno != EINTR && errno != ECONNABORTED) {
      return;
    }
  }
}

void SocketLoop::watch(std::unique_ptr<Connection> connection, Phase phase, Steady::time_point until) {
  const int descriptor = connection->descriptor();
  bytes_held_ += connection->bytes_held();
  watched_.insert_or_assign(descriptor, Watched{std::move(connection), phase, until});
  change_interest(epoll_, EPOLL_CTL_ADD, descriptor, phase == Phase::sending ? EPOLLOUT : EPOLLIN);
}

std::unique_ptr<Connection> SocketLoop::take(Place place) {
  std::unique_ptr<Connection> connection = std::move(place->second.connection);
  change_interest(epoll_, EPOLL_CTL_DEL, place->first, 0);
  bytes_held_ -= connection->bytes_held();
  watched_.erase(place);
  return connection;
}

void SocketLoop::receive(Place place) {
  Connection& connection = *place->second.connection;
  const std::size_t before = connection.bytes_held();
  const Connection::Input input = connection.take_in(judge_);
  bytes_held_ += connection.bytes_held() - before;
  if (input == Connection::Input::complete) return complete_.push(take(place));
  if (input == Connection::Input::ended) return void(take(place));
  if (bytes_held_ + complete_.bytes() > kMaxBytes)
    refuse(place, problem(503, "Too much at once", "other requests are being read, come again"));
}

void SocketLoop::send(Place place) {
  Connection& connection = *place->second.connection;
  const std::size_t before = connection.bytes_held();
  const bool is_there = connection.send_unsent();
  bytes_held_ -= before - connection.bytes_held();
  if (!is_there) return void(take(place));
  if (connection.unsent() > 0) return;
  if (!connection.has_unread()) return void(take(place));
  connection.end_sending();
  place->second.phase = Phase::lingering;
  place->second.until = Steady::now() + kLinger;
  change_interest(epoll_, EPOLL_CTL_MOD, place->first, EPOLLIN);
}

/// To close upon unread bytes would reset the connection, and the client might never see its answer.
void SocketLoop::linger(Place place) {
  const Connection& connection = *place->second.connection;
  const auto now = Steady::now();
  if (!place->second.connection->absorb()) return void(take(place));
  if (now < connection.accepted() + 2 * kMaxReceive) place->second.until = now + kLinger;
}

void SocketLoop::end_late() {
  const auto now = Steady::now();
  for (Place place = watched_.begin(); place != watched_.end();) {
    const Place each = place++;
    if (now < each->second.until) continue;
    if (each->second.phase == Phase::receiving && each->second.connection->has_begun())
      refuse(each, problem(408, "Request timeout", "the request did not come in time"));
    else
      take(each);
  }
  for (Place each; bytes_held_ > kMaxBytes && (each = victim(Phase::sending)) != watched_.end();) take(each);
  const bool has_room = !is_full() || victim(Phase::receiving) != watched_.end();
  if (listening_ >= 0) change_interest(epoll_, EPOLL_CTL_MOD, listening_, has_room ? EPOLLIN : 0u);
}

void SocketLoop::end_receiving() {
  if (listening_ >= 0) change_interest(epoll_, EPOLL_CTL_DEL, std::exchange(listening_, -1), 0);
  for (Place place = watched_.begin(); place != watched_.end();) {
    const Place each = place++;
    if (each->second.phase != Phase::receiving) continue;
    if (each->second.connection->has_begun())
      refuse(each, problem(503, "Not available", "the server is ending, send the request again later"));
    else
      take(each);
  }
}

/// A request thread writes the answer, and the log.
void SocketLoop::refuse(Place place, Response refusal) {
  if (refusal.status == 503) refusal.headers["Retry-After"] = "5";
  std::unique_ptr<Connection> connection = take(place);
  connection->refuse_with(std::move(refusal));
  complete_.push(std::move(connection));
}

}  // namespace capstan
