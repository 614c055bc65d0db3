// One TLS handshake with OpenSSL, which gives access to the verification result and to alerts.
#include "proxy/playmaker/tls_probe.h"

#include <openssl/err.h>
#include <openssl/pem.h>
#include <openssl/ssl.h>
#include <openssl/x509v3.h>
#include <poll.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <memory>

#include "base/system/socket_address.h"
#include "base/system/tcp_connect.h"
#include "proxy/playmaker/openssl_objects.h"

namespace cls::proxy {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds kLimit{5000};
constexpr const char* kAsksForCertificate =
    "the Playmaker requires a client certificate; use --tls-cert and --tls-key";
constexpr const char* kRefusesCertificate = "the Playmaker rejects the client certificate";
constexpr unsigned char kHttp2[] = "\x02h2";  // in ALPN format

using openssl::Bytes;
using openssl::Certificate;
using openssl::Freer;
using openssl::Key;
using Context = std::unique_ptr<SSL_CTX, Freer<SSL_CTX_free>>;
using Connection = std::unique_ptr<SSL, Freer<SSL_free>>;

/// OpenSSL may write to closed sockets: blocks SIGPIPE in this thread.
class SigpipeBlocker {
 public:
  SigpipeBlocker() {
    sigemptyset(&pipe_);
    sigaddset(&pipe_, SIGPIPE);
    pthread_sigmask(SIG_BLOCK, &pipe_, &before_);
  }
  SigpipeBlocker(const SigpipeBlocker&) = delete;
  SigpipeBlocker& operator=(const SigpipeBlocker&) = delete;
  ~SigpipeBlocker() {
    const timespec now{};
    while (sigtimedwait(&pipe_, nullptr, &now) > 0) {
    }
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }

 private:
  sigset_t pipe_{};
  sigset_t before_{};
};

Bytes bytes_of(const std::string& text) {
  return Bytes(BIO_new_mem_buf(text.data(), static_cast<int>(text.size())));
}

void add_authorities(SSL_CTX& context, const std::string& authorities) {
  if (authorities.empty()) {
    SSL_CTX_set_default_verify_paths(&context);
    return;
  }
  const Bytes bytes = bytes_of(authorities);
  while (const Certificate each{PEM_read_bio_X509(bytes.get(), nullptr, nullptr, nullptr)}) {
    X509_STORE_add_cert(SSL_CTX_get_cert_store(&context), each.get());
  }
}

void use_certificate(SSL_CTX& context, const TlsFiles& files) {
  if (files.certificate.empty()) return;
  const Certificate certificate(
      PEM_read_bio_X509(bytes_of(files.certificate).get(), nullptr, nullptr, nullptr));
  const Key key(PEM_read_bio_PrivateKey(bytes_of(files.key).get(), nullptr, nullptr, nullptr));
  if (certificate != nullptr) SSL_CTX_use_certificate(&context, certificate.get());
  if (key != nullptr) SSL_CTX_use_PrivateKey(&context, key.get());
}

void expect_name(SSL& connection, const std::string& name) {
  X509_VERIFY_PARAM* expected = SSL_get0_param(&connection);
  if (X509_VERIFY_PARAM_set1_ip_asc(expected, name.c_str()) == 1) return;
  SSL_set_tlsext_host_name(&connection, name.c_str());
  X509_VERIFY_PARAM_set1_host(expected, name.c_str(), name.size());
}

/// Repeats `step` until it succeeds, fails or the deadline passes; the last result.
template <typename Step>
int run(SSL& connection, int fd, Clock::time_point limit, Step step) {
  for (;;) {
    ERR_clear_error();
    const int result = step();
    if (result > 0) return result;
    const int error = SSL_get_error(&connection, result);
    const bool read = error == SSL_ERROR_WANT_READ;
    if (!read && error != SSL_ERROR_WANT_WRITE) return result;
    if (!base::wait_for_events(fd, read ? POLLIN : POLLOUT, limit)) return result;
  }
}

std::string describe_verification(const SSL& connection, const std::string& name) {
  const long verdict = SSL_get_verify_result(&connection);
  const std::string text = X509_verify_cert_error_string(verdict);

  switch (verdict) {
    case X509_V_OK:
      return {};
    case X509_V_ERR_CERT_HAS_EXPIRED:
      return "the certificate has expired";
    case X509_V_ERR_CERT_NOT_YET_VALID:
      return "the certificate is not valid yet";

    case X509_V_ERR_HOSTNAME_MISMATCH:
    case X509_V_ERR_IP_ADDRESS_MISMATCH:
      return "the certificate is not valid for '" + name + "'; use --tls-name for another name";
    case X509_V_ERR_DEPTH_ZERO_SELF_SIGNED_CERT:
    case X509_V_ERR_SELF_SIGNED_CERT_IN_CHAIN:
    case X509_V_ERR_UNABLE_TO_GET_ISSUER_CERT_LOCALLY:
    case X509_V_ERR_UNABLE_TO_VERIFY_LEAF_SIGNATURE:
    case X509_V_ERR_CERT_SIGNATURE_FAILURE:
      return "the certificate is not trusted: " + text + "; use --tls-ca FILE for its CA";
    default:
      return "the certificate is rejected: " + text;
  }
}

// The server's alert about the client certificate; empty: none.
std::string describe_alert(bool with_certificate) {
  const int reason = ERR_GET_REASON(ERR_peek_error());
  if (reason == SSL_R_TLSV13_ALERT_CERTIFICATE_REQUIRED ||
      (reason == SSL_R_SSLV3_ALERT_HANDSHAKE_FAILURE && !with_certificate)) {
    return kAsksForCertificate;
  }

  constexpr std::array kRefusals = {
      SSL_R_TLSV1_ALERT_UNKNOWN_CA,          SSL_R_SSLV3_ALERT_BAD_CERTIFICATE,
      SSL_R_SSLV3_ALERT_CERTIFICATE_UNKNOWN, SSL_R_SSLV3_ALERT_CERTIFICATE_EXPIRED,
      SSL_R_TLSV1_ALERT_ACCESS_DENIED,       SSL_R_TLSV1_ALERT_DECRYPT_ERROR};
  if (std::ranges::find(kRefusals, reason) != kRefusals.end()) {
    return kRefusesCertificate + std::string(": ") + ERR_reason_error_string(ERR_peek_error());
  }

  return {};
}

/// Callback: the server requests a certificate.
int on_certificate_request(SSL* /*connection*/, void* requested) {
  *static_cast<bool*>(requested) = true;
  return 1;
}

struct Probe {
  std::unique_ptr<bool> certificate_requested;
  base::UniqueFd socket;
  Context context;
  Connection connection;
  Clock::time_point limit;
  bool completed = false;  ///< the handshake
};

// A handshake that accepts any certificate, so that the result can be inspected.
Probe perform_handshake(const GrpcTarget& target, int agent, const TlsFiles& files,
                        const std::string& name) {
  const Clock::time_point limit = Clock::now() + kLimit;
  Probe probe{std::make_unique<bool>(false),
              base::connect_tcp(target.host, port_of(target, agent), limit, target.make_socket),
              Context(SSL_CTX_new(TLS_client_method())), Connection(), limit};
  if (!probe.socket || probe.context == nullptr) return probe;

  add_authorities(*probe.context, files.authorities);
  use_certificate(*probe.context, files);
  SSL_CTX_set_cert_cb(probe.context.get(), on_certificate_request,
                      probe.certificate_requested.get());
  SSL_CTX_set_verify(probe.context.get(), SSL_VERIFY_NONE, nullptr);
  SSL_CTX_set_alpn_protos(probe.context.get(), kHttp2, sizeof(kHttp2) - 1);

  probe.connection.reset(SSL_new(probe.context.get()));
  SSL& connection = *probe.connection;
  SSL_set_fd(&connection, probe.socket.get());
  expect_name(connection, name);
  probe.completed = run(connection, probe.socket.get(), probe.limit,
                        [&] { return SSL_connect(&connection); }) == 1;
  return probe;
}

}  // namespace

std::string explain_tls_failure(const GrpcTarget& target, int agent) {
  if (!target.unix_path.empty()) return {};
  const SigpipeBlocker blocker;
  const TlsFiles files = target.tls != nullptr ? *target.tls : TlsFiles();
  const std::string name =
      files.server_name.empty() ? base::strip_brackets(target.host) : files.server_name;
  const Probe probe = perform_handshake(target, agent, files, name);
  if (probe.connection == nullptr) return {};

  if (target.tls == nullptr) {
    return probe.completed ? "the Playmaker uses TLS; use tls:" + address(target, agent) : "";
  }
  if (!probe.completed) {
    const std::string alert = describe_alert(!files.certificate.empty());
    if (!alert.empty()) return alert;
    const bool timed_out = ERR_peek_error() == 0 && Clock::now() >= probe.limit;
    if (timed_out) return "no reply to the TLS handshake";
    return "the Playmaker does not use TLS; use " + address(target, agent) + " for plain text";
  }
  if (std::string problem = describe_verification(*probe.connection, name); !problem.empty()) {
    return problem;
  }

  // In TLS 1.3 the server's alert about the client certificate arrives after the handshake.
  char byte = 0;
  SSL& connection = *probe.connection;
  const int got = run(connection, probe.socket.get(), probe.limit,
                      [&] { return SSL_read(&connection, &byte, 1); });

  if (got > 0) return {};
  if (std::string alert = describe_alert(!files.certificate.empty()); !alert.empty()) return alert;
  // gRPC servers close the connection without an alert.
  if (!*probe.certificate_requested || Clock::now() >= probe.limit) return {};
  return files.certificate.empty() ? kAsksForCertificate : kRefusesCertificate;
}

}  // namespace cls::proxy
