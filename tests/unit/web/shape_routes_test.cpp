// What the route of a case's shapes answers.
#include <gmock/gmock.h>

#include <cstring>

#include "tests/support/recorded_sphere.hpp"
#include "tests/unit/web/route_fixture.hpp"

namespace capstan {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

class ShapeRoutesTest : public RouteFixture {
 protected:
  /// The path of the shapes of a case that has recorded spheres at kt = 0, 0.5, 1.
  std::string path_of_recorded() {
    const std::string path = path_of_case();
    record_spheres(directory_of("run 1").path());
    return path;
  }
  std::string path_of_case() {
    const std::string id = submit_and_complete_one();
    return "/v1/cases/" + cases(id)[0]["id"].get<std::string>() + "/shapes";
  }
};

/// The header and the arrays of a binary answer.
struct Tensors {
  nlohmann::json header;
  std::string data;

  explicit Tensors(const std::string& bytes) {
    std::uint64_t size = 0;
    std::memcpy(&size, bytes.data(), sizeof size);
    EXPECT_EQ(size % 8, 0u);
    header = nlohmann::json::parse(bytes.substr(8, size));
    data = bytes.substr(8 + size);
  }
  template <class Value>
  std::vector<Value> values(const std::string& name) const {
    const std::size_t begin = header[name]["data_offsets"][0], end = header[name]["data_offsets"][1];
    std::vector<Value> values((end - begin) / sizeof(Value));
    std::memcpy(values.data(), data.data() + begin, end - begin);
    return values;
  }
};

TEST_F(ShapeRoutesTest, ListHasTheRecordedTimes) {
  EXPECT_EQ(nlohmann::json::parse(get(path_of_recorded()).body),
            nlohmann::json::parse(R"({"kt": [0, 0.5, 1]})"));
}

TEST_F(ShapeRoutesTest, BinaryHoldsAllShapesOfASmallCase) {
  const Response response = get(path_of_recorded(), {{"format", "binary"}});
  EXPECT_EQ(response.content_type, "application/octet-stream");
  const Tensors tensors(response.body);
  EXPECT_EQ(tensors.header["__metadata__"], nlohmann::json::parse(R"({"first": "0", "total": "3"})"));
  EXPECT_EQ(tensors.header["positions"]["shape"], nlohmann::json({3, 42, 3}));
  EXPECT_EQ(tensors.values<double>("kt"), (std::vector<double>{0, 0.5, 1}));
  const auto positions = tensors.values<float>("positions");
  const Icosphere sphere = recorded_sphere();
  EXPECT_EQ(positions[2 * 126], static_cast<float>(2 * sphere.directions(0, 0))) << "at kt = 1";
  EXPECT_EQ(tensors.values<float>("stretches").size(), 3u * 42);
  EXPECT_EQ(tensors.values<std::uint32_t>("triangles")[2], static_cast<unsigned>(sphere.mesh.faces(2, 0)));
}

TEST_F(ShapeRoutesTest, BinaryGoesOnFromAnIndex) {
  const Tensors tensors(get(path_of_recorded(), {{"format", "binary"}, {"first", "2"}}).body);
  EXPECT_EQ(tensors.header["__metadata__"]["first"], "2");
  EXPECT_EQ(tensors.values<double>("kt"), std::vector<double>{1});
}

TEST_F(ShapeRoutesTest, OneShapeIsTheNearestToTheTime) {
  const Tensors tensors(get(path_of_recorded(), {{"format", "binary"}, {"kt", "0.7"}}).body);
  EXPECT_EQ(tensors.values<double>("kt"), std::vector<double>{0.5});
}

TEST_F(ShapeRoutesTest, OneShapeIsAFileForOtherPrograms) {
  const std::string path = path_of_recorded();
  EXPECT_THAT(get(path, {{"format", "vtp"}, {"kt", "1"}}).body, HasSubstr("NumberOfPoints=\"42\""));
  EXPECT_EQ(get(path, {{"format", "stl"}, {"kt", "1"}}).body.size(), 84u + 50 * 80);
  EXPECT_THAT(get(path, {{"format", "obj"}, {"kt", "1"}}).body, HasSubstr("# capsule at kt = 1\n"));
}

TEST_F(ShapeRoutesTest, FileOfOneShapeNeedsATime) {
  const Response response = get(path_of_recorded(), {{"format", "vtp"}});
  EXPECT_EQ(response.status, 400);
  EXPECT_THAT(response.body, HasSubstr("\"pointer\": \"kt\""));
}

TEST_F(ShapeRoutesTest, CaseWithoutShapesHasAnEmptyListAndSaysHowToRecordSome) {
  const std::string path = path_of_case();
  EXPECT_THAT(nlohmann::json::parse(get(path).body)["kt"], IsEmpty());
  const Response response = get(path, {{"format", "binary"}});
  EXPECT_EQ(response.status, 404);
  EXPECT_THAT(response.body, HasSubstr("shapes_every"));
}

TEST_F(ShapeRoutesTest, UnknownCaseFormatOrIndexIsRefused) {
  const std::string path = path_of_recorded();
  EXPECT_EQ(get("/v1/cases/0123456789abcdef/shapes").status, 404);
  EXPECT_EQ(get(path, {{"format", "ply"}}).status, 400);
  EXPECT_EQ(get(path, {{"format", "binary"}, {"first", "-1"}}).status, 400);
  EXPECT_EQ(get(path, {{"format", "binary"}, {"first", "3"}}).status, 404);
  EXPECT_EQ(get(path, {{"format", "vtp"}, {"kt", "soon"}}).status, 400);
}

TEST_F(ShapeRoutesTest, UnchangedShapesAreNotSentAgain) {
  const std::string path = path_of_recorded();
  httplib::Request again = request_for("GET", path, {{"format", "binary"}});
  again.headers = {{"If-None-Match", get(path, {{"format", "binary"}}).headers.at("ETag")}};
  EXPECT_EQ(respond(*service_, again).status, 304);
}

}  // namespace
}  // namespace capstan
