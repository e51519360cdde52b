#include "solver/observe/half_turns.hpp"

#include <algorithm>
#include <numbers>

namespace capstan {
namespace {

using std::numbers::pi;

bool is_of_shape(Samples half_turn) { return share_of_shape(half_turn) >= kOfShape; }
bool is_of_membrane(Samples half_turn) { return share_of_shape(half_turn) <= kOfMembrane; }

}  // namespace

double shape_turns(Samples samples) { return (samples.front().theta - samples.back().theta) / pi; }
double membrane_turns(Samples samples) { return (samples.front().psi - samples.back().psi) / pi; }
double turns(Samples samples) { return shape_turns(samples) + membrane_turns(samples); }

double share_of_shape(Samples samples) {
  const double all = turns(samples);
  return all > 0 ? shape_turns(samples) / all : 0;
}

double theta_range(Samples samples) {
  const auto [low, high] = std::ranges::minmax_element(samples, {}, &MotionSample::theta);
  return high->theta - low->theta;
}

std::optional<Samples> last_turns(Samples samples, double half_turns) {
  constexpr double kRounding = 1e-9;
  for (size_t begin = samples.size(); begin-- > 0;)
    if (turns(samples.subspan(begin)) >= half_turns - kRounding) return samples.subspan(begin);
  return std::nullopt;
}

std::vector<Samples> half_turns_from_end(Samples samples) {
  std::vector<Samples> pieces;
  while (const auto piece = last_turns(samples, 1)) {
    pieces.push_back(*piece);
    samples = samples.first(samples.size() - piece->size() + 1);
  }
  return pieces;
}

int half_turns_of_last_kind(const std::vector<Samples>& half_turns) {
  if (half_turns.empty()) return 0;
  const auto kind = is_of_shape(half_turns.front()) ? is_of_shape : is_of_membrane;
  return int(std::ranges::find_if_not(half_turns, kind) - half_turns.begin());
}

Shares shares_of_half_turns(Samples samples) {
  Shares shares;
  size_t begin = 0;
  for (size_t end = 1; end < samples.size(); ++end) {
    const auto from = [&](size_t first) { return samples.subspan(first, end - first + 1); };
    while (turns(from(begin + 1)) >= 1) ++begin;
    if (turns(from(begin)) < 1) continue;
    const double share = share_of_shape(from(begin));
    shares = {std::min(shares.smallest, share), std::max(shares.largest, share)};
  }
  return shares;
}

}  // namespace capstan
