#pragma once
// The content id of a case: cases with equal inputs and equal numerics have the same id.
#include <string>
#include <string_view>

#include "solver/case/case.hpp"

namespace capstan {

/// Increased whenever the solver's results change for the same case.
inline constexpr int kNumericsVersion = 13;

/// A case as it is stored. Equal cases have equal documents.
struct CanonicalCase {
  std::string id;        ///< SHA-256 over the numerics version and the document; 16 hexadecimal digits
  std::string document;  ///< JSON
};
CanonicalCase canonical(const Case& c);

/// The id only.
std::string case_id(const Case& c);

/// SHA-256, 64 hexadecimal digits.
std::string sha256_hex(std::string_view bytes);

}  // namespace capstan
