#include "runner/daemon/run_supervision.hpp"

namespace capstan {
namespace {

std::string without_decimals(double number) { return std::to_string(static_cast<long long>(number)); }

}  // namespace

RunSupervision::RunSupervision(Claim claim, Executor& executor, const Clock& clock, RunLimits limits,
                               std::chrono::milliseconds heartbeat)
    : claim_(std::move(claim)),
      executor_(&executor),
      clock_(&clock),
      limits_(limits),
      heartbeat_(heartbeat),
      renewed_(clock.now()),
      started_(clock.elapsed()),
      progress_checked_(started_) {}

void RunSupervision::check_progress() {
  const auto now = clock_->elapsed();
  if (now - progress_checked_ < heartbeat_) return;
  progress_checked_ = now;
  const auto usage = executor_->usage(claim_.handle);
  if (!usage) return;
  idle_heartbeats_ = usage->cpu_seconds == cpu_seconds_ ? idle_heartbeats_ + 1 : 0;
  cpu_seconds_ = usage->cpu_seconds;
  if (has_stalled()) kill();
}

void RunSupervision::enforce_limits() {
  const auto usage = limits_.memory_mb > 0 ? executor_->usage(claim_.handle) : std::nullopt;
  if (exceeded_limit_.empty() && usage && usage->memory_mb > limits_.memory_mb) {
    exceeded_limit_ = "it took " + without_decimals(usage->memory_mb) + " MB of memory; the limit is " +
                      without_decimals(limits_.memory_mb);
    kill();
  }
  if (limits_.wall_time.count() <= 0 || clock_->elapsed() - started_ <= limits_.wall_time) return;
  if (exceeded_limit_.empty())
    exceeded_limit_ = "it took longer than the limit of " + std::to_string(limits_.wall_time.count()) + " s";
  ask_to_stop();
}

void RunSupervision::ask_to_stop() {
  if (!stop_asked_) {
    stop_asked_ = clock_->elapsed();
    executor_->cancel(claim_.handle, StopBy::checkpoint);
  } else if (clock_->elapsed() - *stop_asked_ > kGrace) {
    kill();
  }
}

void RunSupervision::kill() {
  if (!is_killed_) executor_->cancel(claim_.handle, StopBy::kill);
  is_killed_ = true;
}

/// A lease expires at a time of day. If the clock was set back or forward, the lease is renewed at once.
void RunSupervision::keep_lease(JobQueue& queue) {
  const auto since = clock_->now() - renewed_;
  if (is_killed_ || (since >= since.zero() && since < heartbeat_)) return;
  renewed_ = clock_->now();
  if (!queue.renew(claim_)) kill();
}

}  // namespace capstan
