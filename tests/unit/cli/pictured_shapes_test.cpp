// Profiles and trajectories from a server on loopback.
#include "runner/cli/pictured_shapes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "runner/cli/commands.hpp"
#include "tests/support/file_bytes.hpp"
#include "tests/support/recorded_sphere.hpp"
#include "tests/support/temporary_directory.hpp"

// After Eigen: httplib includes a header that defines the macro _res.
#include "runner/web/http_server.hpp"
#include "tests/unit/web/route_fixture.hpp"

namespace capstan {
namespace {

class PicturedShapesTest : public RouteFixture {
 protected:
  PicturedShapesTest() {
    address_ = server_.listen_at(address_);
    server_.set_service(*service_);
  }

  /// A case that has recorded spheres of radius 1 + kt at kt = 0, 0.5, 1, with velocities of length 1.
  PicturedCase recorded() {
    PicturedCase c = without_shapes();
    record_spheres(directory_of("run 1").path());
    return c;
  }
  PicturedCase without_shapes() {
    const std::string id = submit_and_complete_one();
    return {"a case", "/v1/cases/" + cases(id)[0]["id"].get<std::string>(), {}};
  }

  ListenAddress address_{"127.0.0.1", 0};
  HttpServer server_{directory_.path(), AccessControl{{}, {}}};
  Client client() { return Client("http://127.0.0.1:" + std::to_string(address_.port)); }
};

double distance(const PlanePoint& point) { return std::hypot(point.x, point.y); }

TEST_F(PicturedShapesTest, TrajectoryHasThePlaceAndTheVelocityOfOneParticleAtEachTime) {
  Client http = client();
  const std::vector<Trajectory> all = trajectories(http, {recorded()});
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].title, "a case");
  ASSERT_EQ(all[0].points.size(), 3u);
  for (std::size_t n = 0; n < 3; ++n) {
    EXPECT_NEAR(distance(all[0].points[n].place), 1 + 0.5 * double(n), 1e-6);
    EXPECT_NEAR(distance(all[0].points[n].velocity), 1, 1e-6);
  }
}

TEST_F(PicturedShapesTest, ProfilesAreTheSectionsAtTheTimesThatWereAskedFor) {
  Client http = client();
  const std::vector<ProfilePanel> panels = profile_panels(http, {recorded()}, {1, 0.5});
  ASSERT_EQ(panels.size(), 2u);
  EXPECT_EQ(panels[0].title, "kt = 1");
  const Profile& later = panels[0].profiles.at(0);
  ASSERT_EQ(later.section.size(), 1u);
  for (const PlanePoint& point : later.section[0]) {
    EXPECT_LT(distance(point), 2 + 1e-6);
    EXPECT_GT(distance(point), 1.6);
  }
  EXPECT_NEAR(distance(panels[1].profiles.at(0).marker), 1.5, 1e-6);
}

TEST_F(PicturedShapesTest, AreSavedAsACollectionWithAFileForEachTime) {
  const TemporaryDirectory out;
  const std::string id = recorded().path.substr(std::string("/v1/cases/").size());
  const std::string server = "http://127.0.0.1:" + std::to_string(address_.port);
  ::testing::internal::CaptureStdout();
  EXPECT_EQ(save_shapes({.id = id, .out = out.path() / "cell.pvd", .kt = {}, .server = server}), 0);
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "3 shapes\n");
  const std::string collection = file_bytes(out.path() / "cell.pvd");
  for (const char* file : {"cell_0000.vtp", "cell_0001.vtp", "cell_0002.vtp"}) {
    EXPECT_NE(collection.find(file), std::string::npos) << file;
    EXPECT_NE(file_bytes(out.path() / file).find("PolyData"), std::string::npos) << file;
  }
}

TEST_F(PicturedShapesTest, WithoutTimesTheLastShapeIsTaken) {
  Client http = client();
  const std::vector<ProfilePanel> panels = profile_panels(http, {recorded()}, {});
  ASSERT_EQ(panels.size(), 1u);
  EXPECT_NEAR(distance(panels[0].profiles.at(0).marker), 2, 1e-6);
}

TEST_F(PicturedShapesTest, ATimeWithoutAShapeIsRefused) {
  Client http = client();
  EXPECT_THROW(profile_panels(http, {recorded()}, {0.25}), std::invalid_argument);
}

TEST_F(PicturedShapesTest, ACaseWithoutShapesIsRefused) {
  Client http = client();
  EXPECT_THROW(trajectories(http, {without_shapes()}), Refused);
}

}  // namespace
}  // namespace capstan
