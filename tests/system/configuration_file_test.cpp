// Options of the daemon from a file: capstan serve --config FILE.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <csignal>
#include <fstream>

#include "tests/support/program.hpp"
#include "tests/support/temporary_directory.hpp"

namespace capstan {
namespace {

using ::testing::HasSubstr;

class ConfigurationFile : public ::testing::Test {
 protected:
  std::string file_with(const std::string& text) {
    const std::string file = directory_.path() / "capstan.toml";
    std::ofstream(file) << text;
    return file;
  }
  /// Of a daemon that does not start.
  CommandResult serve_with(const std::string& text) {
    return run_capstan("serve --data " + data() + " --config " + file_with(text));
  }
  std::string data() const { return directory_.path() / "data"; }

 private:
  TemporaryDirectory directory_;
};

TEST_F(ConfigurationFile, GivesOptionsThatTheCommandLineDoesNot) {
  const CommandResult result = serve_with("executor = \"printer\"\n");
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.errors, HasSubstr("--executor"));
}

TEST_F(ConfigurationFile, GivesWayToTheCommandLine) {
  const std::string file = file_with("# of the group\nlisten = \"nowhere\"\ncores = \"many\"\n");
  EXPECT_EQ(Daemon(data(), {"--cores", "1", "--listen", "127.0.0.1:0", "--config", file}).end_with(SIGTERM),
            0);
}

TEST_F(ConfigurationFile, WithAnUnknownOptionIsRefusedAndTheOptionNamed) {
  const CommandResult result = serve_with("partitions = \"long\"\n");
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.errors, HasSubstr("partitions"));
}

TEST_F(ConfigurationFile, ThatIsMissingIsNamed) {
  const CommandResult result = run_capstan("serve --data " + data() + " --config " + data() + "/none.toml");
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.errors, HasSubstr("none.toml"));
}

}  // namespace
}  // namespace capstan
