// X.509 certificates made with OpenSSL.
#include "tests/support/certificates.h"

#include <openssl/ec.h>
#include <openssl/evp.h>
#include <openssl/pem.h>
#include <openssl/x509v3.h>

#include <cctype>
#include <stdexcept>

#include "proxy/playmaker/openssl_objects.h"

namespace cls::tests {
namespace {

constexpr long kDay = 24L * 60L * 60L;

using proxy::openssl::Bytes;
using proxy::openssl::Certificate;
using proxy::openssl::Key;

void check(bool good) {
  if (!good) throw std::runtime_error("OpenSSL refuses to make a certificate");
}

template <typename Write>
std::string text_of(Write write) {
  const Bytes bytes(BIO_new(BIO_s_mem()));
  check(write(bytes.get()) == 1);
  char* data = nullptr;
  const long size = BIO_get_mem_data(bytes.get(), &data);
  return {data, static_cast<std::size_t>(size)};
}

std::string pem(X509* certificate) {
  return text_of([&](BIO* out) { return PEM_write_bio_X509(out, certificate); });
}

std::string pem(EVP_PKEY* key) {
  return text_of([&](BIO* out) {
    return PEM_write_bio_PrivateKey(out, key, nullptr, nullptr, 0, nullptr, nullptr);
  });
}

void extend(X509* certificate, X509* issuer, int what, const std::string& value) {
  X509V3_CTX context;
  X509V3_set_ctx(&context, issuer, certificate, nullptr, nullptr, 0);
  X509_EXTENSION* extension = X509V3_EXT_conf_nid(nullptr, &context, what, value.c_str());
  check(extension != nullptr && X509_add_ext(certificate, extension, -1) == 1);
  X509_EXTENSION_free(extension);
}

// Without a signature.
Certificate make(const std::string& name, EVP_PKEY* key, Validity validity) {
  static long serial = 1;
  Certificate certificate(X509_new());
  check(X509_set_version(certificate.get(), 2) == 1);
  ASN1_INTEGER_set(X509_get_serialNumber(certificate.get()), ++serial);
  const long shift = validity == Validity::kOver     ? -20 * kDay
                     : validity == Validity::kNotYet ? 20 * kDay
                                                     : 0;
  X509_gmtime_adj(X509_getm_notBefore(certificate.get()), shift - kDay);
  X509_gmtime_adj(X509_getm_notAfter(certificate.get()), shift + 10 * kDay);
  X509_NAME* subject = X509_get_subject_name(certificate.get());
  check(X509_NAME_add_entry_by_txt(subject, "CN", MBSTRING_ASC,
                                   reinterpret_cast<const unsigned char*>(name.c_str()), -1, -1,
                                   0) == 1);
  check(X509_set_pubkey(certificate.get(), key) == 1);
  return certificate;
}

}  // namespace

struct Authority::Parts {
  Key key{EVP_EC_gen("P-256")};
  Certificate certificate;
};

Authority::Authority() : parts_(std::make_unique<Parts>()) {
  check(parts_->key != nullptr);
  parts_->certificate = make("the tests", parts_->key.get(), Validity::kNow);
  X509* own = parts_->certificate.get();
  check(X509_set_issuer_name(own, X509_get_subject_name(own)) == 1);
  extend(own, own, NID_basic_constraints, "critical,CA:TRUE");
  extend(own, own, NID_subject_key_identifier, "hash");
  check(X509_sign(own, parts_->key.get(), EVP_sha256()) > 0);
}

Authority::~Authority() = default;

std::string Authority::certificate() const { return pem(parts_->certificate.get()); }

Identity Authority::issue(const std::string& name, Validity validity) const {
  const Key key(EVP_EC_gen("P-256"));
  check(key != nullptr);
  const Certificate certificate = make(name, key.get(), validity);
  X509* issuer = parts_->certificate.get();
  check(X509_set_issuer_name(certificate.get(), X509_get_subject_name(issuer)) == 1);
  const bool address = std::isdigit(static_cast<unsigned char>(name.front())) != 0;
  extend(certificate.get(), issuer, NID_subject_alt_name, (address ? "IP:" : "DNS:") + name);
  check(X509_sign(certificate.get(), parts_->key.get(), EVP_sha256()) > 0);
  return {pem(certificate.get()), pem(key.get())};
}

}  // namespace cls::tests
