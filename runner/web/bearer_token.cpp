#include "runner/web/bearer_token.hpp"

#include <openssl/crypto.h>
#include <sys/stat.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

#include "solver/case/content_id.hpp"

namespace capstan {
namespace {

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

std::optional<std::string> token_of_environment() {
  if (const char* token = std::getenv("CAPSTAN_TOKEN")) return checked(token, "CAPSTAN_TOKEN");
  const char* file = std::getenv("CAPSTAN_TOKEN_FILE");
  if (!file) return std::nullopt;
  return checked(first_line_of(file), file);
}

/// Compares digests: these have a fixed length, and similar texts have unrelated digests.
bool equal_in_constant_time(std::string_view a, std::string_view b) {
  const std::string first = sha256_hex(a), second = sha256_hex(b);
  return CRYPTO_memcmp(first.data(), second.data(), first.size()) == 0;
}

}  // namespace capstan
