// storm SEED COUNT: sends COUNT mutations of the corpus of requests to a daemon, eight at a time, and prints
// how many were answered with which status. Fails unless the daemon afterwards answers as before, with
// unchanged results, little more memory and no descriptor left open.
#include <algorithm>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <map>
#include <mutex>
#include <thread>

#include "tests/fuzz/mutation.hpp"
#include "tests/support/file_bytes.hpp"
#include "tests/support/process_usage.hpp"
#include "tests/support/program.hpp"
#include "tests/support/raw_connection.hpp"
#include "tests/support/sample_studies.hpp"
#include "tests/support/served_study.hpp"
#include "tests/support/temporary_directory.hpp"

namespace capstan {
namespace {

constexpr int kClients = 8;

std::vector<std::string> corpus() {
  std::vector<std::string> requests;
  for (const auto& file : std::filesystem::directory_iterator(CAPSTAN_CORPUS))
    requests.push_back(file_bytes(file.path()));
  std::sort(requests.begin(), requests.end());
  return requests;
}

std::string answer_to(const std::string& url, const std::string& request) {
  RawConnection connection(url);
  connection.send(request);
  connection.finish_sending();
  return connection.receive_all();
}

using Counts = std::map<int, int>;  ///< of responses by status; 0: closed without a response

class Storm {
 public:
  Storm(std::string url, unsigned seed, int count) : url_(std::move(url)), seed_(seed), count_(count) {}

  Counts run() {
    std::vector<std::thread> clients;
    for (int client = 0; client < kClients; ++client) clients.emplace_back([this, client] { send(client); });
    for (std::thread& client : clients) client.join();
    return counts_;
  }

 private:
  void send(int client) {
    std::mt19937 random(seed_ * kClients + static_cast<unsigned>(client));
    for (int i = client; i < count_; i += kClients) {
      const int status = status_of(answer_to(url_, mutated(requests_, random)));
      const std::lock_guard lock(mutex_);
      ++counts_[status];
    }
  }

  const std::string url_;
  const unsigned seed_;
  const int count_;
  const std::vector<std::string> requests_ = corpus();
  std::mutex mutex_;
  Counts counts_;
};

/// Returns the number of requests.
int print(const Counts& counts) {
  int sum = 0;
  for (const auto& [status, number] : counts) {
    std::cout << (status == 0 ? "closed" : std::to_string(status)) << ' ' << number << '\n';
    sum += number;
  }
  return sum;
}

int run(unsigned seed, int count) {
  const TemporaryDirectory data;
  Daemon daemon(data.path());
  Client client(daemon.url());
  const std::string id =
      client.post("/v1/studies", study_document("untouched", {{"Ca", {0.26, 0.76}}}).dump())["id"];
  wait_for_cases(client, id, "done", 2);
  const std::string path = "/v1/studies/" + id + "/cases";
  const std::string results = client.get(path).dump();
  const double memory = resident_mb(daemon.pid());
  const Counts counts = Storm(daemon.url(), seed, count).run();
  const int sum = print(counts);
  const double grown = resident_mb(daemon.pid()) - memory;
  std::cout << sum << " requests; memory " << memory << " MB + " << grown << " MB; "
            << open_files(daemon.pid()) << " open files; " << client.get_all("/v1/studies", "studies").size()
            << " studies\n";
  bool passes = true;
  const auto require = [&](bool condition, const char* what) {
    if (!condition) std::cout << "FAILED: " << what << '\n';
    passes = passes && condition;
  };
  require(sum == count, "every request is answered or its connection closed");
  require(!counts.contains(500), "no response is 500");
  require(client.get(path).dump() == results, "the results are unchanged");
  require(grown < 64, "memory stays flat");
  require(open_files(daemon.pid()) < 40, "no descriptor is left open");
  require(client.get("/readyz")["status"] == "ready", "the server is ready");
  require(daemon.end_with(SIGTERM) == 0, "the daemon ends with exit code 0");
  return passes ? EXIT_SUCCESS : EXIT_FAILURE;
}

}  // namespace
}  // namespace capstan

int main(int argc, char** argv) {
  if (argc != 3) {
    std::cerr << "usage: storm SEED COUNT\n";
    return 2;
  }
  return capstan::run(static_cast<unsigned>(std::atoi(argv[1])), std::atoi(argv[2]));
}
