#include "runner/daemon/submissions.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>
#include <vector>

#include "tests/support/service_fixture.hpp"

namespace capstan {
namespace {

TEST_F(ServiceTest, StudiesSubmittedAtOnceAreAllKept) {
  std::vector<std::thread> clients;
  for (int client = 0; client < 8; ++client)
    clients.emplace_back([this, client] {
      for (int i = 0; i < 20; ++i)
        service_->submit(sample_study("study", {{"Ca", {0.1 + client, 0.101 + 0.001 * i}}}));
    });
  for (std::thread& client : clients) client.join();
  const Readers::Reader reader = service_->reader();
  EXPECT_EQ(list_studies(*reader, {}).items.size(), 160u);
}

TEST_F(ServiceTest, ReusedKeyIsRefusedAndConcernsNobodyElse) {
  std::vector<std::thread> clients;
  std::atomic<int> refused = 0;
  for (int client = 0; client < 8; ++client)
    clients.emplace_back([this, client, &refused] {
      try {
        service_->submit(sample_study("study", {{"Ca", {0.1 + client}}}), client < 4 ? "key" : "");
      } catch (const KeyReused&) {
        ++refused;
      }
    });
  for (std::thread& client : clients) client.join();
  EXPECT_EQ(refused, 3);
  const Readers::Reader reader = service_->reader();
  EXPECT_EQ(list_studies(*reader, {}).items.size(), 5u);
}

}  // namespace
}  // namespace capstan
