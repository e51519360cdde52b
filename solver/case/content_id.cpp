#include "solver/case/content_id.hpp"

#include <openssl/evp.h>

#include <array>
#include <nlohmann/json.hpp>
#include <stdexcept>

namespace capstan {

std::string sha256_hex(std::string_view bytes) {
  std::array<unsigned char, 32> digest{};
  if (EVP_Digest(bytes.data(), bytes.size(), digest.data(), nullptr, EVP_sha256(), nullptr) != 1)
    throw std::runtime_error("SHA-256 is not available in this OpenSSL");
  constexpr char kDigits[] = "0123456789abcdef";
  std::string hex;
  for (unsigned char byte : digest) {
    hex += kDigits[byte >> 4];
    hex += kDigits[byte & 15];
  }
  return hex;
}

CanonicalCase canonical(const Case& c) {
  std::string document = to_json(c).dump();  // shortest round-trip decimals
  const std::string version = "capstan numerics " + std::to_string(kNumericsVersion) + "\n";
  return {sha256_hex(version + document).substr(0, 16), std::move(document)};
}

std::string case_id(const Case& c) { return canonical(c).id; }

}  // namespace capstan
