#pragma once
// Requests that are almost right.
#include <random>
#include <string>
#include <vector>

namespace capstan {

/// One of the samples after some changes: bytes flipped, cut, doubled, words of the protocol put in, two of
/// them joined. The same generator state gives the same text.
std::string mutated(const std::vector<std::string>& samples, std::mt19937& random);

}  // namespace capstan
