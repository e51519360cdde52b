#pragma once
// A client that sends any bytes, valid HTTP or not.
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

  /// Blocks until all bytes are sent. False if the server closes the connection before.
  bool send(std::string_view bytes);
  void finish_sending();

  /// Blocks until that many bytes have arrived or the server closes the connection. Throws std::runtime_error
  /// if neither happens for a minute.
  std::string receive(std::size_t max_bytes);
  std::string receive_all();
  /// True if the server has closed the connection, or closes it within that time.
  bool closes_within(std::chrono::milliseconds time);

 private:
  int socket_;
};

/// The status of a response, 0 if there is none. A preceding 100 (Continue) is skipped.
int status_of(std::string_view answer);

/// A valid request.
/// \param fields  header lines, each with its line end
std::string request_text(const std::string& method, const std::string& target, const std::string& fields = "",
                         const std::string& body = "");

}  // namespace capstan
