#pragma once
// One client's connection. Its request is taken in as the bytes come and its answer is sent as the client
// takes it, so that no thread ever waits for a client.
#include <httplib.h>

#include <chrono>
#include <functional>
#include <optional>
#include <string>

#include "runner/web/head.hpp"
#include "runner/web/message.hpp"

namespace capstan {

class Connection : public httplib::Stream {
 public:
  using Steady = std::chrono::steady_clock;
  /// Why a request with this head is not read further, if it is not.
  using Judge = std::function<std::optional<Response>(const Head&)>;

  /// Owns the socket.
  explicit Connection(int socket);
  ~Connection() override;

  enum class Input { incomplete, complete, ended };
  /// Takes what has come. Complete: the whole request is there, or a reason to refuse it.
  Input take_in(const Judge& judge);
  /// What has come is forgotten.
  void refuse_with(Response refusal);
  const std::optional<Response>& refusal() const { return refusal_; }
  const Head& head() const { return head_; }
  bool has_begun() const { return !received_.empty(); }
  bool has_body() const { return !refusal_ && head_.content_length > 0; }

  /// Sends what the client takes now; false once it takes nothing more.
  bool send_unsent() const;
  std::size_t unsent() const { return unsent_.size() - sent_; }
  /// After this the rest is not sent any more.
  Steady::time_point send_until() const;

  /// Writes an answer that the library has no part in.
  void answer(const Response& response);
  /// Nothing more is sent; the client reads what was.
  void end_sending();
  /// Something has come that nobody has read, or may still come.
  bool has_unread() const;
  /// Takes what has come and forgets it; false at its end, or when it is too much.
  bool absorb();

  bool is_readable() const override { return position_ < request_size(); }
  bool is_writable() const override;  ///< the client is still there
  ssize_t read(char* to, std::size_t size) override;
  ssize_t write(const char* from, std::size_t size) override;
  using httplib::Stream::write;
  void get_remote_ip_and_port(std::string& ip, int&) const override { ip = peer_; }
  void get_local_ip_and_port(std::string&, int&) const override {}
  /// The library asks for it only to refuse descriptors from 1024 on, which select() could not take.
  socket_t socket() const override { return 0; }

  int descriptor() const { return socket_; }
  Steady::time_point accepted() const { return accepted_; }
  std::size_t bytes_held() const { return received_.size() + unsent(); }
  const std::string& peer() const { return peer_; }  ///< its address, "-" if it has none
  int status() const { return status_; }             ///< of the last answer
  std::size_t bytes_written() const { return bytes_written_; }

 private:
  std::size_t request_size() const { return head_size_ + head_.content_length; }
  bool is_complete(const Judge& judge);
  bool read_head(const Judge& judge);

  int socket_;
  std::string peer_;
  Steady::time_point accepted_ = Steady::now();
  std::string received_;  ///< the head and the body, as far as they have come
  std::size_t head_size_ = 0;
  Head head_;
  std::optional<Response> refusal_;
  std::size_t position_ = 0;  ///< of read() in what was received
  // What the client has not taken yet changes also where the library only asks whether it is there:
  mutable std::string unsent_;
  mutable std::size_t sent_ = 0;  ///< of those
  mutable bool is_gone_ = false;
  Steady::time_point stuck_since_;
  std::size_t lingered_bytes_ = 0;
  int status_ = 0;
  std::size_t bytes_written_ = 0;
};

}  // namespace capstan
