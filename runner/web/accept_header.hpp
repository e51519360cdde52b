#pragma once
// Content negotiation (RFC 9110, 12.5.1).
#include <httplib.h>

#include <string_view>

namespace capstan {

/// The weight that the request's Accept header gives a media type, from 0 to 1; 1 without that header.
/// \param type  in lower case, as "text/csv"
double accepted_quality(const httplib::Request& request, std::string_view type);

/// Whether a route that answers JSON or CSV is asked for CSV: by ?format=csv, or without a format by the
/// Accept header.
bool wants_csv(const httplib::Request& request);

}  // namespace capstan
