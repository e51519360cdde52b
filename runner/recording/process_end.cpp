#include "runner/recording/process_end.hpp"

#include <cstring>

namespace capstan {

std::string describe(const ProcessEnd& end) {
  if (!end.reason.empty()) return end.reason;
  switch (end.how) {
    case ProcessEnd::How::exited:
      return "exit code " + std::to_string(end.number);
    case ProcessEnd::How::signalled:
      return "killed by signal " + std::to_string(end.number) + " (" + strsignal(end.number) + ")";
    case ProcessEnd::How::not_begun:
      return "it was not begun";
    case ProcessEnd::How::lost:
      break;
  }
  return "the process is gone";
}

}  // namespace capstan
