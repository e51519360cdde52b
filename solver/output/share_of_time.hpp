#pragma once
// Limits repeated work, such as writing a checkpoint, to 2 % of the time of a run.
#include <algorithm>

namespace capstan {

class ShareOfTime {
 public:
  /// Whether the work may be done again.
  /// \param now       seconds
  /// \param interval  minimum time between the end of the work and its next start, seconds
  bool is_due(double now, double interval) const {
    return now - done_ >= std::max(interval, kRestToWork * last_cost_);
  }

  /// The work took from `began` to `ended`, seconds.
  void done(double began, double ended) {
    done_ = ended;
    last_cost_ = ended - began;
  }

 private:
  static constexpr double kRestToWork = 50;
  double done_ = 0, last_cost_ = 0;
};

}  // namespace capstan
