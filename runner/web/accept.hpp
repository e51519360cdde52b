#pragma once
// Which of two formats a client wants (RFC 9110, 12.5.1).
#include <string_view>

namespace capstan {

/// The weight that an Accept header gives a media type, from 0 to 1; 1 without a header.
/// \param type  in small letters, as "text/csv"
double accepted_quality(std::string_view accept, std::string_view type);

}  // namespace capstan
