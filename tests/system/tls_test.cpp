// The commands behind a TLS proxy. The proxy here is a TLS server that answers as the daemon would.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <httplib.h>
#include <stdlib.h>

#include <thread>

#include "tests/support/certificate.hpp"
#include "tests/support/program.hpp"
#include "tests/support/temporary_directory.hpp"

namespace capstan {
namespace {

using ::testing::HasSubstr;

class TlsTest : public ::testing::Test {
 protected:
  TlsTest() {
    certificate_.write_to(directory_.path() / "certificate.pem");
    proxy_.Get("/v1/studies", [](const httplib::Request&, httplib::Response& answer) {
      answer.set_content(R"({"studies": [], "next": null})", "application/json");
    });
    port_ = proxy_.bind_to_any_port("127.0.0.1");
    serving_ = std::thread([this] { proxy_.listen_after_bind(); });
  }
  ~TlsTest() override {
    unsetenv("SSL_CERT_FILE");
    while (!proxy_.is_running()) std::this_thread::yield();
    proxy_.stop();
    serving_.join();
  }
  void trust_certificate() { setenv("SSL_CERT_FILE", (directory_.path() / "certificate.pem").c_str(), 1); }
  CommandResult list_studies(const std::string& host) {
    return run_capstan("studies --server https://" + host + ":" + std::to_string(port_));
  }

  TemporaryDirectory directory_;
  Certificate certificate_;
  httplib::SSLServer proxy_{certificate_.x509(), certificate_.key()};
  int port_ = 0;
  std::thread serving_;
};

TEST_F(TlsTest, CommandsUseAServerWhoseCertificateIsTrusted) {
  trust_certificate();
  const CommandResult answered = list_studies("localhost");
  EXPECT_EQ(answered.exit_code, 0) << answered.errors;
}

TEST_F(TlsTest, CommandsSendNothingToAServerWithAnUntrustedCertificate) {
  const CommandResult refused = list_studies("localhost");
  EXPECT_EQ(refused.exit_code, 69);
  EXPECT_THAT(refused.errors, HasSubstr("is not trusted"));
  EXPECT_THAT(refused.errors, HasSubstr("SSL_CERT_FILE"));
}

TEST_F(TlsTest, CommandsSendNothingToAServerWithTheCertificateOfAnotherHost) {
  trust_certificate();
  EXPECT_EQ(list_studies("127.0.0.1").exit_code, 69);
}

}  // namespace
}  // namespace capstan
