// The real daemon while it upgrades a large database of an older format: its answers, and its end on SIGTERM.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <csignal>
#include <thread>

#include "runner/store/database.hpp"
#include "tests/support/old_database.hpp"
#include "tests/support/program.hpp"
#include "tests/support/served_study.hpp"
#include "tests/support/temporary_directory.hpp"

namespace capstan {
namespace {

using nlohmann::ordered_json;
using ::testing::HasSubstr;

int free_port() {
  const int listening = socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  bind(listening, reinterpret_cast<sockaddr*>(&address), size);
  getsockname(listening, reinterpret_cast<sockaddr*>(&address), &size);
  close(listening);
  return ntohs(address.sin_port);
}

/// Adds `count` queued cases to the database, which differ in Ca, and all of them to one study.
void add_cases(const std::filesystem::path& file, int count) {
  sqlite3* old = nullptr;
  sqlite3_open(file.c_str(), &old);
  const std::string sql = "WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n WHERE i < " +
                          std::to_string(count) +
                          ") INSERT INTO cases (id, document) SELECT printf('%016x', i), json_set(document, "
                          "'$.Ca', 0.1 + 1e-6 * i)"
                          " FROM n, (SELECT document FROM cases WHERE state = 'done' LIMIT 1);"
                          "INSERT INTO study_cases SELECT 'kept-8a8f', number + 1000, id FROM cases WHERE id "
                          "< '0000000001000000'";
  EXPECT_EQ(sqlite3_exec(old, sql.c_str(), nullptr, nullptr, nullptr), SQLITE_OK) << sqlite3_errmsg(old);
  sqlite3_close(old);
}

/// A daemon that has not yet printed that it serves.
class StartingDaemon {
 public:
  explicit StartingDaemon(const std::filesystem::path& data)
      : client_("http://" + address_), thread_([this, data] {
          try {
            Daemon(data, {"--listen", address_}).end_with(SIGTERM);
          } catch (const DaemonDied& death) {
            exit_code_ = death.exit_code;
          }
        }) {}
  ~StartingDaemon() {
    if (thread_.joinable()) thread_.join();
  }

  /// The answer of /healthz, as soon as the port is open.
  ordered_json health() {
    ordered_json answer;
    EXPECT_TRUE(wait_until([&] {
      try {
        answer = client_.get("/healthz");
        return true;
      } catch (const Unreachable&) {
        return false;
      }
    }));
    return answer;
  }
  Client& client() { return client_; }
  /// Waits for the end. Returns the exit code, or -1 if the daemon had begun to serve.
  int wait() {
    thread_.join();
    return exit_code_;
  }

 private:
  const std::string address_ = "127.0.0.1:" + std::to_string(free_port());
  Client client_;
  int exit_code_ = -1;
  std::thread thread_;
};

TEST(Start, OnALargeOldDatabaseAnswersThatItIsStartingAndEndsAtOnceWhenTerminated) {
  const TemporaryDirectory data;
  const std::filesystem::path file = data.path() / "capstan.sqlite";
  make_old_database(file);
  add_cases(file, 100'000);
  StartingDaemon daemon(data.path());
  const ordered_json health = daemon.health();
  EXPECT_EQ(health["status"], "starting");
  for (const char* path : {"/readyz", "/v1/studies", "/metrics"}) try {
      daemon.client().get(path);
      ADD_FAILURE() << path << " was answered";
    } catch (const Refused& refusal) {
      EXPECT_EQ(refusal.status, 503);
      EXPECT_THAT(refusal.what(), HasSubstr("is starting"));
    }
  EXPECT_EQ(daemon.client().get("/healthz")["status"], "starting");
  kill(health["pid"], SIGTERM);
  EXPECT_EQ(daemon.wait(), 0);
  Database database(file, Database::Access::read);
  Statement row = database.query("SELECT count(*) FROM cases");
  ASSERT_TRUE(row.step());
  EXPECT_GE(row.integer(0), 100'000);
}

}  // namespace
}  // namespace capstan
