#include "runner/worker/run_progress.hpp"

#include <cstdio>

namespace capstan {

void RunProgress::show(const Record& record) {
  if (!on_terminal_ && record["kt"] < next_) return;
  next_ = record["kt"] + 1;
  if (first_ < 0) first_ = record["kt"];
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - started_).count();
  const double done = record["kt"] - first_;
  const double end = record["kt"] < until_.kt ? until_.kt : until_.last();
  const double left = done > 0 ? seconds * (end - record["kt"]) / done : 0;
  std::fprintf(stderr, "%skt = %.1f of %.1f, D_xy = %.3f, about %.0f s left%s", on_terminal_ ? "\r" : "",
               record["kt"], end, record["D_xy"], left, on_terminal_ ? "   " : "\n");
}

}  // namespace capstan
