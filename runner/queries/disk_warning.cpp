#include "runner/queries/disk_warning.hpp"

#include <cmath>

namespace capstan {
namespace {

std::string gigabytes(double bytes) {
  const auto tenths = std::llround(bytes / 1e8);
  return std::to_string(tenths / 10) + "." + std::to_string(tenths % 10) + " GB";
}

}  // namespace

std::string disk_warning(double needed, double free, const std::string& runs) {
  if (needed <= free) return "";
  return "its cases will take about " + gigabytes(needed) + ", and " + gigabytes(free) + " are free in " +
         runs +
         ": make room (capstan disk says what takes it), or ask for fewer shapes with a larger "
         "outputs.shapes_every";
}

}  // namespace capstan
