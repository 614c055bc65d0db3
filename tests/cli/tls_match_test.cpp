// End-to-end tests of matches with a Playmaker over TLS.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/proxy/playmaker/playmaker_server.h"
#include "tests/support/certificates.h"
#include "tests/support/command.h"
#include "tests/support/command_matchers.h"
#include "tests/support/json.h"
#include "tests/support/temporary_folder.h"

namespace cls::tests {
namespace {

using testing::HasSubstr;
using testing::Not;
using Arguments = std::vector<std::string>;

class TlsMatch : public testing::Test {
 protected:
  std::string file(const std::string& name, const std::string& text) const {
    const std::filesystem::path path = folder_.path() / name;
    std::ofstream(path) << text;
    return path;
  }
  std::shared_ptr<grpc::ServerCredentials> credentials() const {
    const Identity identity = authority_.issue("127.0.0.1");
    grpc::SslServerCredentialsOptions options;
    options.pem_key_cert_pairs.push_back({identity.key, identity.certificate});
    return grpc::SslServerCredentials(options);
  }
  CommandResult play(const Arguments& more, const Arguments& environment = {}) const {
    return tests::run(
        joined({cls_binary(), "match", "mock:hold", "--cycles", "10", "--set",
                "server::kick_off_wait=3", "--force", "--dir", folder_.path() / "match"},
               more),
        environment);
  }

  TemporaryFolder folder_;
  Authority authority_;
  GameService service_;
  PlaymakerServer server_{service_, 0, credentials()};
  const std::string address_ = "127.0.0.1:" + std::to_string(server_.port());
};

TEST_F(TlsMatch, UsesCaFromOptionOrEnvironment) {
  const std::string authority = file("ca.pem", authority_.certificate());
  EXPECT_THAT(play({"tls:" + address_, "--tls-ca", authority}), Exits(0, Not(HasSubstr("TLS"))));
  EXPECT_THAT(play({"tls:" + address_}, {"CLS_TLS_CA=" + authority}), Exits(0));
}

TEST_F(TlsMatch, ReportsTlsErrorsInOneLine) {
  EXPECT_THAT(play({"tls:" + address_}),
              Exits(69, HasSubstr("(tls:" + address_ + "): player 1: " + address_ +
                                  ": the certificate is not trusted")));
  EXPECT_THAT(play({address_, "--start-timeout", "1"}),
              Exits(69, HasSubstr("the Playmaker uses TLS; use tls:" + address_)));
}

TEST_F(TlsMatch, ReportsInvalidPemFiles) {
  const auto refused = [&](const Arguments& more) {
    return play(joined({"tls:" + address_}, more));
  };
  EXPECT_THAT(refused({"--tls-ca", "no/such.pem"}),
              Exits(66, "cls: --tls-ca: no/such.pem: cannot read\n"));
  const std::string text = file("text", "not a certificate\n");
  EXPECT_THAT(refused({"--tls-ca", text}),
              Exits(65, "cls: --tls-ca: " + text + ": contains no CERTIFICATE in PEM format\n"));
  EXPECT_THAT(refused({"--tls-cert", file("a.pem", authority_.certificate())}),
              Exits(2, "cls: --tls-cert and --tls-key require each other\n"));
}

TEST_F(TlsMatch, OtherCommandsAcceptTlsEndpoints) {
  const std::string authority = file("ca.pem", authority_.certificate());
  const auto run = [&](const Arguments& argv) {
    return tests::run(joined({cls_binary()}, argv), {"CLS_TLS_CA=" + authority});
  };
  EXPECT_THAT(run({"doctor", "--playmaker", "tls:" + address_}), Exits(0));
  if (std::getenv("CLS_FULL") == nullptr) return;
  EXPECT_THAT(run({"check", "playmaker", "tls:" + address_, "--calls", "50"}), Exits(0));
}

}  // namespace
}  // namespace cls::tests
