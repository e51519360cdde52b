#pragma once
// A client that sends bytes as they are, well-behaved or not.
#include <chrono>
#include <string>
#include <string_view>
#include <utility>

namespace capstan {

class RawConnection {
 public:
  /// \param url  as the daemon announces it: "http://127.0.0.1:PORT"
  explicit RawConnection(const std::string& url);
  RawConnection(RawConnection&& other) noexcept : socket_(other.socket_) { other.socket_ = -1; }
  RawConnection& operator=(RawConnection&& other) noexcept {
    std::swap(socket_, other.socket_);
    return *this;
  }
  ~RawConnection();

  /// False once the server has closed the connection.
  bool send(std::string_view bytes);
  void finish_sending();

  /// What comes until there are that many bytes or the server closes. Throws std::runtime_error when nothing
  /// does for a minute.
  std::string receive(std::size_t most);
  /// The server has closed, or does so in that time.
  bool closes_within(std::chrono::milliseconds time);
  std::string receive_all();

 private:
  int socket_;
};

/// The status of the answer, 0 if there is none. That 100 came before it (Continue) does not count.
int status_of(std::string_view answer);

/// A well-formed request.
std::string request_text(const std::string& method, const std::string& target, const std::string& fields = "",
                         const std::string& body = "");

}  // namespace capstan
