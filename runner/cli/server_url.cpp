#include "runner/cli/server_url.hpp"

#include <arpa/inet.h>

#include <regex>
#include <stdexcept>

#include "runner/study/small_letters.hpp"

namespace capstan {
namespace {

[[noreturn]] void refuse(const std::string& text, const std::string& why) {
  throw std::invalid_argument("\"" + text + "\" is no server URL" + why + "; one looks like " +
                              kDefaultServer + " or https://capsules.example.org");
}

std::string without_trailing_slashes(std::string path) {
  path.erase(path.find_last_not_of('/') + 1);
  return path;
}

bool is_ipv6(const std::string& host) {
  in6_addr address{};
  return inet_pton(AF_INET6, host.c_str(), &address) == 1;
}

int default_port(bool is_secure) { return is_secure ? 443 : 80; }

int port_of(const std::string& digits, const std::string& text) {
  constexpr int kMax = 65535;
  const int port = digits.size() <= 5 ? std::stoi(digits) : kMax + 1;
  if (port < 1 || port > kMax) refuse(text, ": the port must be from 1 to 65535");
  return port;
}

}  // namespace

std::string ServerUrl::authority() const {
  const bool is_address = host.find(':') != std::string::npos;
  const std::string name = is_address ? "[" + host + "]" : host;
  return port == default_port(is_secure) ? name : name + ":" + std::to_string(port);
}

ServerUrl parse_server_url(const std::string& text) {
  constexpr std::size_t kMax = 300;
  static const std::regex form(
      R"((?:(https?)://)?(?:\[([0-9a-f:.]+)\]|([a-z0-9._-]+))(?::([0-9]+))?(/[^\s?#]*)?)", std::regex::icase);
  std::smatch part;
  if (text.size() > kMax || !std::regex_match(text, part, form)) refuse(text, "");
  const std::string scheme = in_small_letters(part[1]), port = part[4];
  if (scheme.empty() && port.empty()) refuse(text, "");
  if (part[2].matched && !is_ipv6(part[2])) refuse(text, ": brackets are for an IPv6 address");
  const bool is_secure = scheme == "https";
  return {is_secure, part[2].matched ? part[2] : part[3],
          port.empty() ? default_port(is_secure) : port_of(port, text), without_trailing_slashes(part[5])};
}

}  // namespace capstan
