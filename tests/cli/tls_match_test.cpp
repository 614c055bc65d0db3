// Matches with a Playmaker behind TLS, as a user starts them.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "tests/proxy/playmaker_server.h"
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
using Words = std::vector<std::string>;

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
  CommandResult play(const Words& more, const Words& environment = {}) const {
    Words words = {cls::tests::cls_binary(),
                   "match",
                   "mock:hold",
                   "--cycles",
                   "10",
                   "--set",
                   "server::kick_off_wait=3",
                   "--dir",
                   folder_.path() / "match"};
    words.insert(words.end(), more.begin(), more.end());
    return cls::tests::run(words, environment);
  }

  cls::tests::TemporaryFolder folder_;
  Authority authority_;
  GameService service_;
  PlaymakerServer server_{service_, 0, credentials()};
  const std::string address_ = "127.0.0.1:" + std::to_string(server_.port());
};

TEST_F(TlsMatch, PlaysWithTheAuthorityFromAnOptionOrTheEnvironment) {
  const std::string authority = file("ca.pem", authority_.certificate());
  const CommandResult played = play({"tls:" + address_, "--tls-ca", authority});
  EXPECT_EQ(played.exit_code, 0) << played.err;
  EXPECT_EQ(played.err, "");
  const CommandResult again = play({"tls:" + address_}, {"CLS_TLS_CA=" + authority});
  EXPECT_EQ(again.exit_code, 0) << again.err;
}

TEST_F(TlsMatch, TellsWhatIsWrongInOneLine) {
  const CommandResult untrusted = play({"tls:" + address_});
  EXPECT_EQ(untrusted.exit_code, 69);
  EXPECT_NE(untrusted.err.find("(tls:" + address_ + "): player 1: " + address_ +
                               ": its certificate is not trusted"),
            std::string::npos)
      << untrusted.err;
  const CommandResult plain = play({address_, "--start-timeout", "1"});
  EXPECT_EQ(plain.exit_code, 69);
  EXPECT_NE(plain.err.find("it speaks TLS (say tls:" + address_ + ")"), std::string::npos)
      << plain.err;
}

TEST_F(TlsMatch, FilesThatAreNoneAreNamed) {
  const auto refused = [&](const Words& more) {
    Words words = {"tls:" + address_};
    words.insert(words.end(), more.begin(), more.end());
    return play(words);
  };
  const CommandResult missing = refused({"--tls-ca", "no/such.pem"});
  EXPECT_EQ(missing.exit_code, 66);
  EXPECT_EQ(missing.err, "cls: --tls-ca: no/such.pem: cannot be read\n");
  const std::string text = file("text", "not a certificate\n");
  const CommandResult wrong = refused({"--tls-ca", text});
  EXPECT_EQ(wrong.exit_code, 65);
  EXPECT_EQ(wrong.err, "cls: --tls-ca: " + text + ": no CERTIFICATE in PEM form\n");
  const CommandResult half = refused({"--tls-cert", file("a.pem", authority_.certificate())});
  EXPECT_EQ(half.exit_code, 2);
  EXPECT_EQ(half.err, "cls: --tls-cert and --tls-key go together\n");
}

TEST_F(TlsMatch, OtherCommandsTakeTheSameForms) {
  const std::string authority = file("ca.pem", authority_.certificate());
  const auto run = [&](const Words& words) {
    Words all = {cls::tests::cls_binary()};
    all.insert(all.end(), words.begin(), words.end());
    return cls::tests::run(all, {"CLS_TLS_CA=" + authority});
  };
  const CommandResult doctor = run({"doctor", "--playmaker", "tls:" + address_});
  EXPECT_EQ(doctor.exit_code, 0) << doctor.out << doctor.err;
  if (std::getenv("CLS_FULL") == nullptr) return;
  const CommandResult checked = run({"check", "playmaker", "tls:" + address_, "--calls", "50"});
  EXPECT_EQ(checked.exit_code, 0) << checked.out << checked.err;
}

}  // namespace
