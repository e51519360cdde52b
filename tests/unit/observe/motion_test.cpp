#include "solver/observe/motion.hpp"

#include <gtest/gtest.h>

namespace capstan {
namespace {

TEST(Motion, IsReadBackFromItsWord) {
  for (const auto& [motion, word] : kWords<Motion>) EXPECT_EQ(parse_word<Motion>(to_string(motion)), motion);
  EXPECT_FALSE(parse_word<Motion>("swinging"));
}

}  // namespace
}  // namespace capstan
