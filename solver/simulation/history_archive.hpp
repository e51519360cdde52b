#pragma once
// The history and the samples to and from a checkpoint: eight numbers a record, four a sample.
#include "solver/observe/history.hpp"
#include "solver/observe/motion_sample.hpp"
#include "solver/state/state_archive.hpp"

namespace capstan {

inline void put_history(StateArchive& archive, const History& history) {
  std::vector<double> numbers;
  for (const Record& r : history)
    numbers.insert(numbers.end(),
                   {r.kt, r.D_xy, r.theta, r.psi, r.volume, r.area, double(r.iterations), r.error});
  archive.put("history", std::move(numbers));
}

inline History get_history(const StateArchive& archive) {
  const auto numbers = archive.get("history");
  History history;
  for (std::size_t i = 0; i + 8 <= numbers.size(); i += 8)
    history.push_back({numbers[i], numbers[i + 1], numbers[i + 2], numbers[i + 3], numbers[i + 4],
                       numbers[i + 5], static_cast<int>(numbers[i + 6]), numbers[i + 7]});
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
