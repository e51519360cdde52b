#pragma once

namespace capstan {

/// The git revision of the sources, "-dirty" if they were changed since; "" if they came without git. Written
/// by the build.
extern const char* const kRevision;

}  // namespace capstan
