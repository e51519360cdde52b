#pragma once
// One client's connection, which carries one request and its response. All operations are non-blocking: the
// request is collected as its bytes arrive, and what the client does not read at once is kept to be sent
// later.
#include <httplib.h>

#include <chrono>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "runner/web/response.hpp"

namespace capstan {

class Connection {
 public:
  using Steady = std::chrono::steady_clock;
  /// Checks a request as soon as its head is complete. Returns a refusal, or nothing if the body shall be
  /// received.
  using HeadCheck = std::function<std::optional<Response>(const httplib::Request&)>;

  /// Owns the socket from now on.
  explicit Connection(int socket);
  ~Connection();
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  // The request:
  enum class Input { incomplete, complete, closed };
  /// Receives the bytes that have arrived. `complete`: the request can be answered, possibly with a refusal.
  Input receive(const HeadCheck& check);
  /// Frees the received part of the request. The request is answered with the refusal.
  void refuse_with(Response refusal);
  const std::optional<Response>& refusal() const { return refusal_; }
  /// The part that was received; it includes the body once the request is complete.
  const httplib::Request& request() const { return request_; }
  bool has_begun() const { return has_head_ || !received_.empty(); }
  bool has_body() const { return !refusal_ && content_length_ > 0; }

  // The response:
  void send(const Response& response);
  /// Sends the head of a response and then its parts, until the stream or its connection ends.
  /// \param should_end  asked before each part
  void send_stream(const Response& response, const std::function<bool()>& should_end);
  /// Sends what the client accepts now; false if the connection is broken.
  bool send_unsent();
  std::size_t unsent() const { return unsent_.size() - sent_; }
  /// The time by which the client must have accepted the unsent rest.
  Steady::time_point send_deadline() const;

  // Lingering close (RFC 9112, 9.6): closing a socket with unread input resets the connection, and the client
  // may lose the response. So the server first shuts down its sending side, and discards what the client
  // still sends.
  void end_sending();
  bool has_unread_input() const;  ///< input has arrived, or may still arrive
  /// Discards what has arrived. False once the client has closed its side, or has sent too much.
  bool discard_input();

  int descriptor() const { return socket_; }
  Steady::time_point accepted() const { return accepted_; }
  std::size_t bytes_held() const { return received_.size() + request_.body.size() + unsent(); }
  const std::string& peer() const { return peer_; }  ///< numeric address, "-" if it has none
  int status() const { return status_; }             ///< of the response
  std::size_t bytes_written() const { return bytes_written_; }

 private:
  bool is_complete(const HeadCheck& check);
  bool parse_received_head(const HeadCheck& check);
  bool write(std::string_view bytes);
  bool accepts_more();

  const int socket_;
  const std::string peer_;
  const Steady::time_point accepted_ = Steady::now();
  std::string received_;  ///< received part of the head; once has_head_ is set, of the body
  bool has_head_ = false;
  std::size_t content_length_ = 0;
  httplib::Request request_;
  std::optional<Response> refusal_;
  std::string unsent_;
  std::size_t sent_ = 0;  ///< bytes of unsent_ that have been sent
  bool is_broken_ = false;
  Steady::time_point unsent_since_;
  std::size_t discarded_bytes_ = 0;
  int status_ = 0;
  std::size_t bytes_written_ = 0;
};

}  // namespace capstan
