#pragma once
// A client of the server: JSON in and out, failures as exceptions that say what to do.
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

/// No server answers.
class Unreachable : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The server refused (problem+json).
class Refused : public std::runtime_error {
 public:
  Refused(int http_status, const std::string& detail, Issues found)
      : std::runtime_error(detail), status(http_status), issues(std::move(found)) {}
  int status;
  Issues issues;
};

class Client {
 public:
  /// Throws std::invalid_argument for what is no URL.
  explicit Client(const std::string& server);
  ~Client();

  /// \param query  parameters, not encoded; a name may stand several times
  nlohmann::ordered_json get(const std::string& path,
                             const std::multimap<std::string, std::string>& query = {});
  /// The items of a list, page by page. \param list  their key in each page
  void for_each_page(const std::string& path, const std::string& list,
                     const std::function<void(const nlohmann::ordered_json& items)>& use);
  /// All items of a list that comes in pages. \param list  their key in each page
  nlohmann::ordered_json get_all(const std::string& path, const std::string& list);
  nlohmann::ordered_json post(const std::string& path, const std::string& body);
  nlohmann::ordered_json remove(const std::string& path);

 private:
  std::string server_;
  std::string prefix_;  ///< of all paths
  std::unique_ptr<httplib::ClientImpl> http_;
};

}  // namespace capstan
