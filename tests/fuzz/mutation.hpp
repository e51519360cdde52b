#pragma once
// Requests that are almost valid.
#include <random>
#include <string>
#include <vector>

namespace capstan {

/// One of the samples after up to four random changes: a bit is flipped; bytes are inserted, removed or
/// repeated; a fragment of HTTP or JSON is inserted; the text is cut, or continued with another sample.
/// Determined by the state of the generator.
std::string mutated(const std::vector<std::string>& samples, std::mt19937& random);

}  // namespace capstan
