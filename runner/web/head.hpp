#pragma once
// The head of a request, read strictly before any library interprets it: what two readers could take for two
// different requests is refused, and so is what the library reads unsafely.
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "runner/web/message.hpp"

namespace capstan {

struct Head {
  std::string method, target;
  std::vector<std::pair<std::string, std::string>> fields;  ///< as they came, without space around the values
  std::size_t content_length = 0;

  /// The value of a field, or "". \param name  in any case
  std::string value(std::string_view name) const;
  std::size_t count(std::string_view name) const;
};

inline constexpr std::size_t kMaxHead = 16 << 10;  // a browser's has 1 kB
inline constexpr std::size_t kMaxBody = 1 << 20;   // a study of 10,000 listed values has 100 kB
inline constexpr std::size_t kMaxPath = 1000;      // the library matches paths by recursion

struct ParsedHead {
  Head head;                        ///< as far as it was read
  std::optional<Response> refusal;  ///< why it goes no further
};

/// \param text  up to and with the empty line
ParsedHead parse_head(std::string_view text);

/// What cannot be served although it is well-formed: bodies of unknown or too great length, encoded or of
/// another type than JSON, ranges, expectations.
std::optional<Response> refuse_hazards(const Head& head);

bool equal_ignoring_case(std::string_view a, std::string_view b);

}  // namespace capstan
