#pragma once
// A self-signed certificate for "localhost" and its key, valid for an hour.
#include <openssl/ec.h>
#include <openssl/pem.h>
#include <openssl/x509v3.h>

#include <cstdio>
#include <filesystem>
#include <memory>

namespace capstan {

class Certificate {
 public:
  Certificate() {
    X509_set_version(x509(), X509_VERSION_3);
    X509_gmtime_adj(X509_getm_notBefore(x509()), 0);
    X509_gmtime_adj(X509_getm_notAfter(x509()), 3600);
    X509_set_pubkey(x509(), key());
    const std::unique_ptr<X509_EXTENSION, decltype(&X509_EXTENSION_free)> name(
        X509V3_EXT_conf_nid(nullptr, nullptr, NID_subject_alt_name, "DNS:localhost"), X509_EXTENSION_free);
    X509_add_ext(x509(), name.get(), -1);
    X509_sign(x509(), key(), EVP_sha256());
  }

  X509* x509() const { return x509_.get(); }
  EVP_PKEY* key() const { return key_.get(); }

  void write_to(const std::filesystem::path& file) const {
    FILE* stream = std::fopen(file.c_str(), "w");
    PEM_write_X509(stream, x509());
    std::fclose(stream);
  }

 private:
  std::unique_ptr<X509, decltype(&X509_free)> x509_{X509_new(), X509_free};
  std::unique_ptr<EVP_PKEY, decltype(&EVP_PKEY_free)> key_{EVP_EC_gen("P-256"), EVP_PKEY_free};
};

}  // namespace capstan
