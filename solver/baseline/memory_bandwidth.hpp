#pragma once
// What the memory can give: the limit of a sweep that does nothing else.
#include <cstddef>

namespace capstan {

/// Bytes a second, read and written together, of scaling an array of this size in place on as many threads as
/// OpenMP has. Every byte is read once and written once and nothing is fetched only to be overwritten: the
/// traffic of an InPlaceLattice of the same size, without its work. The best of several passes, in half a
/// second.
double memory_bandwidth(std::size_t bytes);

}  // namespace capstan
