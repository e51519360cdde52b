#include "runner/render/shape_files.hpp"

#include <gmock/gmock.h>

#include <cstring>

namespace capstan {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

/// A tetrahedron with corners at 0 and at the ends of the axes.
TriangulatedShape tetrahedron() {
  return {0.5,
          {{0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1},
           std::vector<double>(12, 2),
           std::vector<double>(12, 3),
           {1, 1, 1, 1.25}},
          {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3}};
}

template <class Value>
Value value_at(const std::string& bytes, std::size_t place) {
  Value value;
  std::memcpy(&value, bytes.data() + place, sizeof value);
  return value;
}

TEST(ShapeFiles, VtpHasPointsTrianglesAndFields) {
  const std::string text = as_vtp(tetrahedron());
  EXPECT_THAT(text, HasSubstr("NumberOfPoints=\"4\""));
  EXPECT_THAT(text, HasSubstr("NumberOfPolys=\"4\""));
  EXPECT_THAT(text, HasSubstr("0 0 0\n1 0 0\n0 1 0\n0 0 1\n"));
  EXPECT_THAT(text, HasSubstr("0 2 1\n0 1 3\n0 3 2\n1 2 3\n"));
  EXPECT_THAT(text, HasSubstr("3 6 9\n12\n"));
  for (const char* field : {"velocity", "force", "stretch", "TimeValue"})
    EXPECT_THAT(text, HasSubstr(std::string("Name=\"") + field + "\"")) << field;
}

TEST(ShapeFiles, VtpOfARunWithoutStretchesLeavesThemOut) {
  TriangulatedShape shape = tetrahedron();
  shape.arrays.stretches.clear();
  EXPECT_THAT(as_vtp(shape), Not(HasSubstr("stretch")));
}

TEST(ShapeFiles, StlHasFiftyBytesForEachTriangleAndOutwardNormals) {
  const std::string bytes = as_stl(tetrahedron());
  ASSERT_EQ(bytes.size(), 84u + 4 * 50);
  EXPECT_EQ(value_at<std::uint32_t>(bytes, 80), 4u);
  EXPECT_EQ(value_at<float>(bytes, 84 + 8), -1) << "the z component of the normal of the face at z = 0";
  EXPECT_EQ(value_at<float>(bytes, 84 + 12 + 12 + 4), 1) << "y of the second corner of the first triangle";
}

TEST(ShapeFiles, StlDoesNotBeginAsAnAsciiFile) {
  EXPECT_THAT(as_stl(tetrahedron()), Not(StartsWith("solid")));
}

TEST(ShapeFiles, ObjCountsVerticesFromOne) {
  EXPECT_THAT(as_obj(tetrahedron()), HasSubstr("v 0 0 1\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n"));
}

TEST(ShapeFiles, CollectionNamesEachFileWithItsTime) {
  EXPECT_THAT(as_pvd({{0, "a_0000.vtp"}, {0.5, "a_0001.vtp"}}),
              HasSubstr("<DataSet timestep=\"0.5\" file=\"a_0001.vtp\"/>"));
  EXPECT_THAT(as_pvd({{0, "a&\"b_0000.vtp"}}), HasSubstr("file=\"a&amp;&quot;b_0000.vtp\""));
}

}  // namespace
}  // namespace capstan
