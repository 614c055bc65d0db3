// Playmakers with TLS: valid certificates, each kind of invalid one, and plain text.
#include <gmock/gmock.h>
#include <grpcpp/grpcpp.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <memory>
#include <string>

#include "proxy/playmaker/grpc_playmaker.h"
#include "proxy/playmaker/tls_probe.h"
#include "tests/proxy/playmaker/playmaker_server.h"
#include "tests/support/certificates.h"

namespace cls::proxy {
namespace {

using testing::HasSubstr;
using testing::StartsWith;
using namespace std::chrono_literals;
using tests::Authority;
using tests::Identity;
using tests::Validity;

std::shared_ptr<grpc::ServerCredentials> secured(const Identity& identity,
                                                 const std::string& clients_authority = "") {
  grpc::SslServerCredentialsOptions options(
      clients_authority.empty() ? GRPC_SSL_DONT_REQUEST_CLIENT_CERTIFICATE
                                : GRPC_SSL_REQUEST_AND_REQUIRE_CLIENT_CERTIFICATE_AND_VERIFY);
  options.pem_root_certs = clients_authority;
  options.pem_key_cert_pairs.push_back({identity.key, identity.certificate});
  return grpc::SslServerCredentials(options);
}

GrpcTarget target_at(int port, TlsFiles files) {
  GrpcTarget target = tests::loopback(port);
  target.tls = std::make_shared<TlsFiles>(std::move(files));
  return target;
}

RpcStatus registered_at(const GrpcTarget& target, RpcTimeout timeout = 10s) {
  protos::RegisterRequest request;
  request.set_uniform_number(4);
  const auto playmaker = make_grpc_playmaker(target);
  const Reply reply = playmaker->call(4, proto::Rpc::kRegister, request, timeout);
  if (!reply.status.ok()) return reply.status;
  EXPECT_EQ(reply.as<protos::RegisterResponse>()->uniform_number(), 4);
  playmaker->begin(4, proto::Rpc::kGetPlayerActions, protos::State(), timeout);
  return playmaker->next_reply()->status;
}

std::string at(int port) { return "127.0.0.1:" + std::to_string(port) + ": "; }

class Tls : public testing::Test {
 protected:
  TlsFiles trusting() const { return {authority_.certificate(), "", "", ""}; }

  /// Error message of a client that trusts the authority, for a server with this certificate.
  std::string error_for(const Identity& identity) {
    tests::PlaymakerServer server(service_, 0, secured(identity));
    const RpcStatus status = registered_at(target_at(server.port(), trusting()));
    EXPECT_EQ(status.outcome, RpcOutcome::kUnavailable);
    const std::string place = at(server.port());
    EXPECT_THAT(status.message, StartsWith(place));
    return status.message.substr(std::min(place.size(), status.message.size()));
  }

  Authority authority_;
  tests::GameService service_;
};

TEST_F(Tls, AcceptsSignedCertificateForHost) {
  tests::PlaymakerServer server(service_, 0, secured(authority_.issue("127.0.0.1")));
  const RpcStatus status = registered_at(target_at(server.port(), trusting()));
  EXPECT_TRUE(status.ok()) << status.message;
}

TEST_F(Tls, AcceptsOtherNameFromOption) {
  tests::PlaymakerServer server(service_, 0, secured(authority_.issue("playmaker.example")));
  TlsFiles files = trusting();
  files.server_name = "playmaker.example";
  const RpcStatus status = registered_at(target_at(server.port(), files));
  EXPECT_TRUE(status.ok()) << status.message;
}

TEST_F(Tls, ReportsInvalidCertificateImmediately) {
  EXPECT_EQ(error_for(authority_.issue("127.0.0.1", Validity::kOver)),
            "the certificate has expired");
  EXPECT_EQ(error_for(authority_.issue("127.0.0.1", Validity::kNotYet)),
            "the certificate is not valid yet");
  EXPECT_EQ(error_for(authority_.issue("playmaker.example")),
            "the certificate is not valid for '127.0.0.1'; use --tls-name for another name");
  const Authority stranger;
  const std::string untrusted = error_for(stranger.issue("127.0.0.1"));
  EXPECT_THAT(untrusted, StartsWith("the certificate is not trusted: "));
  EXPECT_THAT(untrusted, HasSubstr("--tls-ca"));
}

TEST_F(Tls, SendsClientCertificateWhenRequired) {
  tests::PlaymakerServer server(service_, 0,
                                secured(authority_.issue("127.0.0.1"), authority_.certificate()));
  TlsFiles files = trusting();
  const RpcStatus without = registered_at(target_at(server.port(), files));
  EXPECT_EQ(without.message,
            at(server.port()) +
                "the Playmaker requires a client certificate; use --tls-cert and --tls-key");

  const Authority stranger;
  const Identity unknown = stranger.issue("us.example");
  files.certificate = unknown.certificate;
  files.key = unknown.key;
  const RpcStatus refused = registered_at(target_at(server.port(), files), 1s);

  EXPECT_FALSE(refused.ok());
  EXPECT_THAT(refused.message, HasSubstr("the Playmaker rejects the client certificate"))
      << refused.message;

  const Identity known = authority_.issue("us.example");
  files.certificate = known.certificate;
  files.key = known.key;
  const RpcStatus taken = registered_at(target_at(server.port(), files));
  EXPECT_TRUE(taken.ok()) << taken.message;
}

TEST_F(Tls, ReportsPlainTextServerImmediately) {
  tests::PlaymakerServer server(service_);
  const RpcStatus status = registered_at(target_at(server.port(), trusting()));
  EXPECT_EQ(status.message, at(server.port()) + "the Playmaker does not use TLS; use 127.0.0.1:" +
                                std::to_string(server.port()) + " for plain text");
}

TEST_F(Tls, ReportsTlsServerToPlainTextClient) {
  tests::PlaymakerServer server(service_, 0, secured(authority_.issue("127.0.0.1")));
  GrpcTarget plain;
  plain.host = "127.0.0.1";
  plain.port = server.port();
  const RpcStatus status = registered_at(plain, 300ms);
  EXPECT_EQ(status.outcome, RpcOutcome::kUnavailable);
  const std::string reason =
      "the Playmaker uses TLS; use tls:127.0.0.1:" + std::to_string(server.port());
  EXPECT_EQ(status.message, at(server.port()) + "unreachable for 300 ms: " + reason);
}

TEST_F(Tls, ReportsUnreachableServerWithoutTlsReason) {
  int port = 0;
  { port = tests::PlaymakerServer(service_).port(); }
  EXPECT_EQ(explain_tls_failure(target_at(port, trusting()), 1), "");
  const RpcStatus status = registered_at(target_at(port, trusting()), 300ms);
  EXPECT_THAT(status.message, HasSubstr("unreachable for"));
}

}  // namespace
}  // namespace cls::proxy
