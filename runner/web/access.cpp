#include "runner/web/access.hpp"

#include <arpa/inet.h>
#include <openssl/crypto.h>
#include <sys/stat.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

#include "solver/case/content_id.hpp"

namespace capstan {
namespace {

/// "example.org:80" → "example.org", "[::1]:80" → "[::1]"
std::string without_port(const std::string& authority) {
  const auto end = authority.starts_with('[') ? authority.find(']') : authority.rfind(':');
  if (end == authority.npos) return authority;
  return authority.substr(0, authority[end] == ']' ? end + 1 : end);
}

/// A rebound name is a name: no page comes from an address in digits that is not its own.
bool is_address_in_digits(std::string host) {
  unsigned char bytes[16];
  if (host.starts_with('[') && host.ends_with(']'))
    return inet_pton(AF_INET6, host.substr(1, host.size() - 2).c_str(), bytes) == 1;
  return inet_pton(AF_INET, host.c_str(), bytes) == 1;
}

bool is_named(const Access& access, const std::string& host) {
  return std::any_of(access.hosts.begin(), access.hosts.end(),
                     [&](const std::string& name) { return equal_ignoring_case(name, host); });
}

bool is_own_host(const Access& access, const std::string& authority) {
  const std::string host = without_port(authority);
  return equal_ignoring_case(host, "localhost") || is_address_in_digits(host) || is_named(access, host);
}

/// The page was loaded from this very server, or from one of its names (through a proxy).
bool is_own_origin(const Access& access, const std::string& origin, const std::string& own) {
  const auto end = origin.find("://");
  if (end == origin.npos) return false;  // "null", too
  const std::string authority = origin.substr(end + 3);
  return equal_ignoring_case(authority, own) || is_named(access, without_port(authority));
}

bool carries(const Head& head, const std::string& token) {
  constexpr std::string_view kScheme = "Bearer ";
  const std::string given = head.value("Authorization");
  return equal_ignoring_case(given.substr(0, kScheme.size()), kScheme) &&
         equal_in_constant_time(std::string_view(given).substr(kScheme.size()), token);
}

std::string checked(std::string token, const std::string& source) {
  constexpr std::size_t kMin = 16;
  const bool is_visible =
      std::all_of(token.begin(), token.end(), [](char c) { return c > 0x20 && c < 0x7f; });
  if (token.size() < kMin || !is_visible)
    throw std::invalid_argument("the token in " + source +
                                " must have 16 or more visible ASCII characters and no space");
  return token;
}

std::string first_line_of(const std::string& file) {
  struct stat status {};
  if (stat(file.c_str(), &status) != 0) throw std::invalid_argument("cannot read the token in " + file);
  if ((status.st_mode & 077) != 0)
    throw std::invalid_argument("others can read the token in " + file + "; chmod 600 it");
  std::ifstream stream(file);
  std::string line;
  std::getline(stream, line);
  return line;
}

}  // namespace

std::optional<Response> refuse_access(const Access& access, const Head& head) {
  const std::string host = head.value("Host");
  if (!is_own_host(access, host))
    return problem(421, "Misdirected request",
                   "this server is not known as " + host + "; name it with: capstan serve --host");
  if (head.count("Origin") > 0 && !is_own_origin(access, head.value("Origin"), host))
    return problem(403, "Forbidden", "pages of other sites may not ask");
  if (!access.token || carries(head, *access.token)) return std::nullopt;
  Response refusal = problem(401, "Unauthorized", "send the token: Authorization: Bearer TOKEN");
  refusal.headers["WWW-Authenticate"] = "Bearer";
  return refusal;
}

/// Of digests, which are of one length and tell nothing of how much was right.
bool equal_in_constant_time(std::string_view a, std::string_view b) {
  const std::string first = sha256_hex(a), second = sha256_hex(b);
  return CRYPTO_memcmp(first.data(), second.data(), first.size()) == 0;
}

std::optional<std::string> token_of_environment() {
  if (const char* token = std::getenv("CAPSTAN_TOKEN")) return checked(token, "CAPSTAN_TOKEN");
  const char* file = std::getenv("CAPSTAN_TOKEN_FILE");
  if (!file) return std::nullopt;
  return checked(first_line_of(file), file);
}

}  // namespace capstan
