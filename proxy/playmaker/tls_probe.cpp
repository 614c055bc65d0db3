// One handshake with OpenSSL, looked at from inside.
#include "proxy/playmaker/tls_probe.h"

#include <arpa/inet.h>
#include <fcntl.h>
#include <netdb.h>
#include <openssl/err.h>
#include <openssl/pem.h>
#include <openssl/ssl.h>
#include <openssl/x509v3.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <memory>
#include <utility>

#include "proxy/playmaker/openssl_objects.h"

namespace cls::proxy {
namespace {

using Clock = std::chrono::steady_clock;
constexpr std::chrono::milliseconds kLimit{5000};
constexpr const char* kAsksForCertificate =
    "it asks for a certificate of ours (say --tls-cert and --tls-key)";
constexpr const char* kRefusesCertificate = "it does not accept our certificate";
constexpr unsigned char kHttp2[] = "\x02h2";  // as ALPN writes it

using openssl::Bytes;
using openssl::Certificate;
using openssl::Freer;
using openssl::Key;
using Context = std::unique_ptr<SSL_CTX, Freer<SSL_CTX_free>>;
using Connection = std::unique_ptr<SSL, Freer<SSL_free>>;

class Socket {
 public:
  explicit Socket(int fd) : fd_(fd) {}
  Socket(Socket&& other) noexcept : fd_(std::exchange(other.fd_, -1)) {}
  Socket& operator=(Socket&&) = delete;
  ~Socket() {
    if (fd_ >= 0) ::close(fd_);
  }
  int fd() const { return fd_; }
  bool open() const { return fd_ >= 0; }

 private:
  int fd_;
};

/// OpenSSL writes to sockets that may have been closed: no signal for that in this thread.
class NoPipeSignal {
 public:
  NoPipeSignal() {
    sigemptyset(&pipe_);
    sigaddset(&pipe_, SIGPIPE);
    pthread_sigmask(SIG_BLOCK, &pipe_, &before_);
  }
  NoPipeSignal(const NoPipeSignal&) = delete;
  NoPipeSignal& operator=(const NoPipeSignal&) = delete;
  ~NoPipeSignal() {
    const timespec now{};
    while (sigtimedwait(&pipe_, nullptr, &now) > 0) {
    }
    pthread_sigmask(SIG_SETMASK, &before_, nullptr);
  }

 private:
  sigset_t pipe_{};
  sigset_t before_{};
};

bool wait_for(int fd, short events, Clock::time_point limit) {
  const auto left = std::chrono::ceil<std::chrono::milliseconds>(limit - Clock::now()).count();
  pollfd poll{fd, events, 0};
  return left > 0 && ::poll(&poll, 1, static_cast<int>(left)) > 0;
}

std::string without_brackets(const std::string& host) {
  return host.size() > 2 && host.front() == '[' ? host.substr(1, host.size() - 2) : host;
}

Socket connect_to(const std::string& host, int port, Clock::time_point limit) {
  addrinfo hints{};
  hints.ai_socktype = SOCK_STREAM;
  addrinfo* found = nullptr;
  if (::getaddrinfo(host.c_str(), std::to_string(port).c_str(), &hints, &found) != 0) {
    return Socket(-1);
  }
  const std::unique_ptr<addrinfo, Freer<::freeaddrinfo>> all(found);
  for (const addrinfo* each = found; each != nullptr; each = each->ai_next) {
    Socket socket(::socket(each->ai_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
    if (!socket.open()) continue;
    if (::connect(socket.fd(), each->ai_addr, each->ai_addrlen) == 0) return socket;
    int error = 0;
    socklen_t size = sizeof(error);
    if (wait_for(socket.fd(), POLLOUT, limit) &&
        ::getsockopt(socket.fd(), SOL_SOCKET, SO_ERROR, &error, &size) == 0 && error == 0) {
      return socket;
    }
  }
  return Socket(-1);
}

Bytes bytes_of(const std::string& text) {
  return Bytes(BIO_new_mem_buf(text.data(), static_cast<int>(text.size())));
}

void trust(SSL_CTX& context, const std::string& authorities) {
  if (authorities.empty()) {
    SSL_CTX_set_default_verify_paths(&context);
    return;
  }
  const Bytes bytes = bytes_of(authorities);
  while (const Certificate each{PEM_read_bio_X509(bytes.get(), nullptr, nullptr, nullptr)}) {
    X509_STORE_add_cert(SSL_CTX_get_cert_store(&context), each.get());
  }
}

void show(SSL_CTX& context, const TlsFiles& files) {
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

/// Repeats `step` until it is done or time is up; the last result.
template <typename Step>
int run(SSL& connection, int fd, Clock::time_point limit, Step step) {
  for (;;) {
    ERR_clear_error();
    const int result = step();
    if (result > 0) return result;
    const int error = SSL_get_error(&connection, result);
    const bool read = error == SSL_ERROR_WANT_READ;
    if (!read && error != SSL_ERROR_WANT_WRITE) return result;
    if (!wait_for(fd, read ? POLLIN : POLLOUT, limit)) return result;
  }
}

std::string certificate_trouble(const SSL& connection, const std::string& name) {
  const long verdict = SSL_get_verify_result(&connection);
  switch (verdict) {
    case X509_V_OK:
      return {};
    case X509_V_ERR_CERT_HAS_EXPIRED:
      return "its certificate has expired";
    case X509_V_ERR_CERT_NOT_YET_VALID:
      return "its certificate is not valid yet";
    case X509_V_ERR_HOSTNAME_MISMATCH:
    case X509_V_ERR_IP_ADDRESS_MISMATCH:
      return "its certificate is not for '" + name + "' (say --tls-name for another name)";
    case X509_V_ERR_DEPTH_ZERO_SELF_SIGNED_CERT:
    case X509_V_ERR_SELF_SIGNED_CERT_IN_CHAIN:
    case X509_V_ERR_UNABLE_TO_GET_ISSUER_CERT_LOCALLY:
    case X509_V_ERR_UNABLE_TO_VERIFY_LEAF_SIGNATURE:
    case X509_V_ERR_CERT_SIGNATURE_FAILURE:
      return std::string("its certificate is not trusted: ") +
             X509_verify_cert_error_string(verdict) + " (say --tls-ca FILE for who signed it)";
    default:
      return std::string("its certificate is refused: ") + X509_verify_cert_error_string(verdict);
  }
}

// What the server said about us.
std::string alert_trouble(bool with_certificate) {
  const int reason = ERR_GET_REASON(ERR_peek_error());
  if (reason == SSL_R_TLSV13_ALERT_CERTIFICATE_REQUIRED ||
      (reason == SSL_R_SSLV3_ALERT_HANDSHAKE_FAILURE && !with_certificate)) {
    return kAsksForCertificate;
  }
  if (reason == SSL_R_TLSV1_ALERT_UNKNOWN_CA || reason == SSL_R_SSLV3_ALERT_BAD_CERTIFICATE ||
      reason == SSL_R_SSLV3_ALERT_CERTIFICATE_UNKNOWN ||
      reason == SSL_R_SSLV3_ALERT_CERTIFICATE_EXPIRED ||
      reason == SSL_R_TLSV1_ALERT_ACCESS_DENIED || reason == SSL_R_TLSV1_ALERT_DECRYPT_ERROR) {
    return kRefusesCertificate + std::string(": ") + ERR_reason_error_string(ERR_peek_error());
  }
  return {};
}

/// Called when the server asks for a certificate.
int note_question(SSL* /*connection*/, void* asked) {
  *static_cast<bool*>(asked) = true;
  return 1;
}

struct Probe {
  std::unique_ptr<bool> asked;  ///< for a certificate of ours
  Socket socket;
  Context context;
  Connection connection;
  Clock::time_point limit;
  bool shook_hands = false;
};

// A handshake that ends well whatever the certificate is, so that it can be looked at.
Probe shake_hands(const GrpcTarget& target, int agent, const TlsFiles& files,
                  const std::string& name) {
  const Clock::time_point limit = Clock::now() + kLimit;
  Probe probe{std::make_unique<bool>(false),
              connect_to(without_brackets(target.host), port_of(target, agent), limit),
              Context(SSL_CTX_new(TLS_client_method())), Connection(), limit};
  if (!probe.socket.open() || probe.context == nullptr) return probe;
  trust(*probe.context, files.authorities);
  show(*probe.context, files);
  SSL_CTX_set_cert_cb(probe.context.get(), note_question, probe.asked.get());
  SSL_CTX_set_verify(probe.context.get(), SSL_VERIFY_NONE, nullptr);
  SSL_CTX_set_alpn_protos(probe.context.get(), kHttp2, sizeof(kHttp2) - 1);
  probe.connection.reset(SSL_new(probe.context.get()));
  SSL& connection = *probe.connection;
  SSL_set_fd(&connection, probe.socket.fd());
  expect_name(connection, name);
  probe.shook_hands = run(connection, probe.socket.fd(), probe.limit,
                          [&] { return SSL_connect(&connection); }) == 1;
  return probe;
}

}  // namespace

std::string tls_trouble(const GrpcTarget& target, int agent) {
  if (!target.unix_path.empty()) return {};
  const NoPipeSignal quiet;
  const TlsFiles none;
  const TlsFiles& files = target.tls != nullptr ? *target.tls : none;
  const std::string name =
      files.server_name.empty() ? without_brackets(target.host) : files.server_name;
  const Probe probe = shake_hands(target, agent, files, name);
  if (probe.connection == nullptr) return {};
  if (target.tls == nullptr) {
    return probe.shook_hands ? "it speaks TLS (say tls:" + address(target, agent) + ")" : "";
  }
  if (!probe.shook_hands) {
    const std::string alert = alert_trouble(!files.certificate.empty());
    if (!alert.empty()) return alert;
    const bool silent = ERR_peek_error() == 0 && Clock::now() >= probe.limit;
    return silent ? "it does not answer a TLS handshake"
                  : "it does not speak TLS (say " + address(target, agent) + " for plain text)";
  }
  if (std::string trouble = certificate_trouble(*probe.connection, name); !trouble.empty()) {
    return trouble;
  }
  // In TLS 1.3 the server's verdict on our certificate comes after the handshake.
  char byte = 0;
  SSL& connection = *probe.connection;
  const int got = run(connection, probe.socket.fd(), probe.limit,
                      [&] { return SSL_read(&connection, &byte, 1); });
  if (got > 0) return {};
  if (std::string alert = alert_trouble(!files.certificate.empty()); !alert.empty()) return alert;
  // gRPC's servers hang up without a word.
  if (!*probe.asked || Clock::now() >= probe.limit) return {};
  return files.certificate.empty() ? kAsksForCertificate : kRefusesCertificate;
}

}  // namespace cls::proxy
