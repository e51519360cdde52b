#pragma once

namespace capstan {

/// The git revision of the sources, followed by "-dirty" if they differ from it; "" if they were built
/// outside a repository. The build writes its definition (revision.cmake).
extern const char* const kRevision;

}  // namespace capstan
