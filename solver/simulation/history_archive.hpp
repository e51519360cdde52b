#pragma once
// The history and the motion samples in a checkpoint: flat arrays, one record or sample after the other.
#include <algorithm>

#include "solver/observe/motion_sample.hpp"
#include "solver/observe/observables.hpp"
#include "solver/state/state_archive.hpp"

namespace capstan {

/// Number of observables in old checkpoints, which do not store this number.
inline constexpr std::size_t kFirstObservableCount = 8;

inline void put_history(StateArchive& archive, const History& history) {
  std::vector<double> numbers;
  for (const Record& record : history)
    numbers.insert(numbers.end(), record.values.begin(), record.values.end());
  archive.put("history", std::move(numbers));
  if (kObservableCount != kFirstObservableCount) archive.put("history_columns", double(kObservableCount));
}

/// An observable that is missing in the checkpoint, because an older program wrote the file, is NaN.
inline History get_history(const StateArchive& archive) {
  const auto numbers = archive.get("history");
  const std::size_t columns = archive.contains("history_columns")
                                  ? std::size_t(archive.number("history_columns"))
                                  : kFirstObservableCount;
  History history;
  for (std::size_t first = 0; first + columns <= numbers.size(); first += columns)
    std::ranges::copy(numbers.subspan(first, std::min(columns, kObservableCount)),
                      history.emplace_back().values.begin());
  return history;
}

inline void put_samples(StateArchive& archive, const MotionSamples& samples) {
  std::vector<double> numbers;
  for (const MotionSample& s : samples) numbers.insert(numbers.end(), {s.kt, s.D_xy, s.theta, s.psi});
  archive.put("samples", std::move(numbers));
}

inline MotionSamples get_samples(const StateArchive& archive) {
  const auto numbers = archive.get("samples");
  MotionSamples samples;
  for (std::size_t i = 0; i + 4 <= numbers.size(); i += 4)
    samples.push_back({numbers[i], numbers[i + 1], numbers[i + 2], numbers[i + 3]});
  return samples;
}

}  // namespace capstan
