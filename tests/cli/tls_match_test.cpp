// End-to-end tests of matches with a Playmaker over TLS.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/proxy/playmaker/playmaker_server.h"
#include "tests/support/certificates.h"
#include "tests/support/command.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace {

using cls::tests::Authority;
using cls::tests::CommandResult;
using cls::tests::GameService;
using cls::tests::Identity;
using cls::tests::PlaymakerServer;
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
    Arguments argv = {cls::tests::cls_binary(),
                      "match",
                      "mock:hold",
                      "--cycles",
                      "10",
                      "--set",
                      "server::kick_off_wait=3",
                      "--force",
                      "--dir",
                      folder_.path() / "match"};
    argv.insert(argv.end(), more.begin(), more.end());
    return cls::tests::run(argv, environment);
  }

  cls::tests::TemporaryFolder folder_;
  Authority authority_;
  GameService service_;
  PlaymakerServer server_{service_, 0, credentials()};
  const std::string address_ = "127.0.0.1:" + std::to_string(server_.port());
};

TEST_F(TlsMatch, UsesCaFromOptionOrEnvironment) {
  const std::string authority = file("ca.pem", authority_.certificate());
  const CommandResult played = play({"tls:" + address_, "--tls-ca", authority});
  EXPECT_EQ(played.exit_code, 0) << played.err;
  EXPECT_THAT(played.err, Not(HasSubstr("TLS"))) << played.err;
  const CommandResult again = play({"tls:" + address_}, {"CLS_TLS_CA=" + authority});
  EXPECT_EQ(again.exit_code, 0) << again.err;
}

TEST_F(TlsMatch, ReportsTlsErrorsInOneLine) {
  const CommandResult untrusted = play({"tls:" + address_});
  EXPECT_EQ(untrusted.exit_code, 69);
  EXPECT_THAT(untrusted.err, HasSubstr("(tls:" + address_ + "): player 1: " + address_ +
                                       ": the certificate is not trusted"))
      << untrusted.err;
  const CommandResult plain = play({address_, "--start-timeout", "1"});
  EXPECT_EQ(plain.exit_code, 69);
  EXPECT_THAT(plain.err, HasSubstr("the Playmaker uses TLS; use tls:" + address_)) << plain.err;
}

TEST_F(TlsMatch, ReportsInvalidPemFiles) {
  const auto refused = [&](const Arguments& more) {
    Arguments argv = {"tls:" + address_};
    argv.insert(argv.end(), more.begin(), more.end());
    return play(argv);
  };
  const CommandResult missing = refused({"--tls-ca", "no/such.pem"});
  EXPECT_EQ(missing.exit_code, 66);
  EXPECT_EQ(missing.err, "cls: --tls-ca: no/such.pem: cannot read\n");
  const std::string text = file("text", "not a certificate\n");
  const CommandResult wrong = refused({"--tls-ca", text});
  EXPECT_EQ(wrong.exit_code, 65);
  EXPECT_EQ(wrong.err, "cls: --tls-ca: " + text + ": contains no CERTIFICATE in PEM format\n");
  const CommandResult half = refused({"--tls-cert", file("a.pem", authority_.certificate())});
  EXPECT_EQ(half.exit_code, 2);
  EXPECT_EQ(half.err, "cls: --tls-cert and --tls-key require each other\n");
}

TEST_F(TlsMatch, OtherCommandsAcceptTlsEndpoints) {
  const std::string authority = file("ca.pem", authority_.certificate());
  const auto run = [&](const Arguments& argv) {
    Arguments all = {cls::tests::cls_binary()};
    all.insert(all.end(), argv.begin(), argv.end());
    return cls::tests::run(all, {"CLS_TLS_CA=" + authority});
  };
  const CommandResult doctor = run({"doctor", "--playmaker", "tls:" + address_});
  EXPECT_EQ(doctor.exit_code, 0) << doctor.out << doctor.err;
  if (std::getenv("CLS_FULL") == nullptr) return;
  const CommandResult checked = run({"check", "playmaker", "tls:" + address_, "--calls", "50"});
  EXPECT_EQ(checked.exit_code, 0) << checked.out << checked.err;
}

}  // namespace
