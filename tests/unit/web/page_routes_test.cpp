// The page and its files.
#include "runner/web/page_files.hpp"

#include <gmock/gmock.h>

#include <regex>
#include <set>

#include "tests/unit/web/route_fixture.hpp"

namespace capstan {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

class PageRoutesTest : public RouteFixture {};

/// The addresses in the quotes of a file that match the pattern, as paths on the server.
std::set<std::string> matches_in(std::string_view text, const std::string& pattern,
                                 const std::string& folder) {
  std::set<std::string> found;
  const std::string copy(text);
  const std::regex address(pattern);
  for (std::sregex_iterator match(copy.begin(), copy.end(), address), none; match != none; ++match)
    found.insert(folder + (*match)[1].str());
  return found;
}

TEST_F(PageRoutesTest, PageIsHtmlAtTheRoot) {
  const Response page = get("/");
  EXPECT_EQ(page.status, 200);
  EXPECT_EQ(page.content_type, "text/html; charset=utf-8");
  EXPECT_THAT(page.body, StartsWith("<!doctype html>"));
}

TEST_F(PageRoutesTest, EachFileHasTheTypeThatItsBrowserExpects) {
  for (const auto& [path, type] :
       {std::pair{"/page/page.js", "text/javascript; charset=utf-8"},
        std::pair{"/page/uPlot.js", "text/javascript; charset=utf-8"},
        std::pair{"/page/page.css", "text/css; charset=utf-8"}, std::pair{"/page/icon.svg", "image/svg+xml"},
        std::pair{"/page/uPlot.LICENSE.txt", "text/plain; charset=utf-8"}}) {
    const Response file = get(path);
    EXPECT_EQ(file.status, 200) << path;
    EXPECT_EQ(file.content_type, type) << path;
    EXPECT_FALSE(file.body.empty()) << path;
  }
}

TEST_F(PageRoutesTest, UnknownFileIsNotFound) {
  for (const char* path : {"/page/nobody.js", "/page/index.html", "/page/%70age.js"})
    EXPECT_EQ(get(path).status, 404) << path;
}

TEST_F(PageRoutesTest, EveryFileForbidsOtherServersAndScriptsOrStylesInTheText) {
  for (const PageFile& file : page_files()) {
    const std::string policy = get(std::string(file.path)).headers.at("Content-Security-Policy");
    EXPECT_THAT(policy, HasSubstr("default-src 'none'")) << file.path;
    EXPECT_THAT(policy, HasSubstr("script-src 'self';")) << file.path;
    EXPECT_THAT(policy, HasSubstr("style-src 'self';")) << file.path;
    EXPECT_THAT(policy, HasSubstr("frame-ancestors 'none'")) << file.path;
    EXPECT_THAT(policy, Not(HasSubstr("unsafe"))) << file.path;
  }
}

TEST_F(PageRoutesTest, AllThatThePageLoadsIsServed) {
  std::set<std::string> loaded = matches_in(get("/").body, "(?:src|href)=\"([^\"#]+)\"", "");
  for (const PageFile& file : page_files())
    loaded.merge(matches_in(file.text, "from \"\\./([^\"]+)\"", "/page/"));
  EXPECT_TRUE(loaded.contains("/page/page.js"));
  EXPECT_TRUE(loaded.contains("/page/uPlot.js"));
  for (const std::string& path : loaded) EXPECT_EQ(get(path).status, 200) << path;
}

TEST_F(PageRoutesTest, NoTwoFilesHaveOnePath) {
  std::set<std::string_view> paths;
  for (const PageFile& file : page_files()) EXPECT_TRUE(paths.insert(file.path).second) << file.path;
}

TEST_F(PageRoutesTest, FileThatTheBrowserHasIsNotSentAgain) {
  httplib::Request again = request_for("GET", "/page/page.js");
  again.headers = {{"If-None-Match", get("/page/page.js").headers.at("ETag")}};
  EXPECT_EQ(respond(*service_, again).status, 304);
}

}  // namespace
}  // namespace capstan
