#pragma once
// The client of the HTTP API that the commands use. Errors are exceptions whose text says what to do.
#include <functional>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>

#include "runner/cli/server_url.hpp"
#include "solver/case/parse.hpp"

namespace httplib {
class ClientImpl;
}

namespace capstan {

/// The server could not be reached.
class Unreachable : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The server answered with an error (application/problem+json).
class Refused : public std::runtime_error {
 public:
  Refused(int http_status, const std::string& detail, Issues found)
      : std::runtime_error(detail), status(http_status), issues(std::move(found)) {}
  int status;
  Issues issues;
};

class Client {
 public:
  /// Throws std::invalid_argument for an invalid URL.
  explicit Client(const std::string& server);
  ~Client();

  /// The JSON of the response. All requests throw Unreachable or Refused.
  /// \param query  parameters, not encoded; names may repeat
  nlohmann::ordered_json get(const std::string& path,
                             const std::multimap<std::string, std::string>& query = {});
  /// The bytes of the response, of any type.
  std::string get_file(const std::string& path, const std::multimap<std::string, std::string>& query);
  /// Calls `use` with the items of each page of a list.
  /// \param list  key of the items in a page, such as "studies"
  void for_each_page(const std::string& path, const std::string& list,
                     const std::function<void(const nlohmann::ordered_json& items)>& use);
  /// All items of a list, from all pages.
  /// \param list  key of the items in a page, such as "studies"
  nlohmann::ordered_json get_all(const std::string& path, const std::string& list);
  nlohmann::ordered_json post(const std::string& path, const std::string& body);
  nlohmann::ordered_json remove(const std::string& path);

 private:
  std::string server_;
  std::string prefix_;  ///< put before every path: the path of the server's URL
  /// The common base class of the library's HTTP and HTTPS clients. httplib::Client would choose between them
  /// by the URL, but does not accept IPv6 addresses with letters.
  std::unique_ptr<httplib::ClientImpl> http_;
};

}  // namespace capstan
