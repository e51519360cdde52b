#pragma once
// One client's connection, as the library reads and writes it: never longer than a deadline, never more than
// a budget.
#include <httplib.h>

#include <chrono>
#include <optional>
#include <string>

#include "runner/web/message.hpp"

namespace capstan {

struct ReceivedHead {
  std::string text;                      ///< up to and with the empty line
  std::optional<Response> refusal = {};  ///< why it is not complete
  bool is_empty = false;                 ///< nothing came: nobody waits for an answer
};

class Connection : public httplib::Stream {
 public:
  using Steady = std::chrono::steady_clock;

  /// Owns the socket. \param read_until  however much has come by then, no more is read
  Connection(int socket, Steady::time_point read_until);
  ~Connection() override;

  ReceivedHead receive_head();
  /// What read() gives from now on: the head again, and that many bytes of body.
  void allow(std::size_t head_bytes, std::size_t body_bytes) { left_ = head_bytes + body_bytes; }

  /// Writes an answer that the library has no part in.
  void refuse(const Response& response, bool is_head_request);
  /// Something has come that nobody has read.
  bool has_unread() const;
  /// Takes what is still coming in for a moment: closing upon unread bytes would reset the connection, and
  /// the client might never see its answer.
  void absorb();

  bool is_readable() const override { return left_ > 0; }
  bool is_writable() const override;  ///< the client is still there
  ssize_t read(char* to, std::size_t size) override;
  ssize_t write(const char* from, std::size_t size) override;
  using httplib::Stream::write;
  void get_remote_ip_and_port(std::string& ip, int&) const override { ip = peer_; }
  void get_local_ip_and_port(std::string&, int&) const override {}
  /// The library asks for it only to refuse descriptors from 1024 on, which select() could not take.
  socket_t socket() const override { return 0; }

  // For the log:
  const std::string& peer() const { return peer_; }
  int status() const { return status_; }
  std::size_t bytes_written() const { return bytes_written_; }

 private:
  ssize_t receive(char* to, std::size_t size);

  int socket_;
  std::string peer_;  ///< its address, "-" if it has none; asked for at once, as one that is gone has none
  Steady::time_point read_until_;
  std::string received_;      ///< the head and what came with it
  std::size_t position_ = 0;  ///< of read() in that
  std::size_t left_ = 0;
  bool is_late_ = false;
  int status_ = 0;  ///< of the last answer
  std::size_t bytes_written_ = 0;
};

}  // namespace capstan
