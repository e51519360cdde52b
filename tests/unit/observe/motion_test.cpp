#include "solver/observe/motion.hpp"

#include <gtest/gtest.h>

namespace capstan {
namespace {

TEST(Motion, IsReadBackFromItsWord) {
  for (const Motion motion : kMotions) EXPECT_EQ(parse_motion(to_string(motion)), motion);
  EXPECT_FALSE(parse_motion("swinging"));
}

}  // namespace
}  // namespace capstan
