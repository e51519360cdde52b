#include "runner/render/printable.hpp"

#include <gtest/gtest.h>

namespace capstan {
namespace {

TEST(Printable, KeepsText) {
  for (const char* text : {"", "a red cell", "two\nlines\tand a tab", "θ/π = 0.25, café, 細胞, 🙂"})
    EXPECT_EQ(printable(text), text);
}

TEST(Printable, ReplacesControlCharactersAndEscapeSequences) {
  EXPECT_EQ(printable("\x1b[2Jgone\x1b]0;title\a"), "?[2Jgone?]0;title?");
  EXPECT_EQ(printable("over\rwritten\b\x7f"), "over?written??");
  EXPECT_EQ(printable("\xc2\x9b"
                      "31m"),
            "?31m")
      << "CSI in one character";
  EXPECT_EQ(printable("\x9b"
                      "31m"),
            "?31m")
      << "CSI in one byte";
  EXPECT_EQ(printable("\xe2\x80\xae"
                      "abc"),
            "?abc")
      << "right to left";
  EXPECT_EQ(printable(std::string("a\0b", 3)), "a?b");
}

TEST(Printable, ReplacesInvalidUtf8) {
  EXPECT_EQ(printable("\xff\xfe"), "??");
  EXPECT_EQ(printable("cut \xc3"), "cut ?");
  EXPECT_EQ(printable("\xe2\x82"), "??");
  EXPECT_EQ(printable("\xc0\x9b"), "??");
}

}  // namespace
}  // namespace capstan
