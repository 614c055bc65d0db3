// Errors of hosts, names and options: one line that names the thing and the remedy, at once.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <chrono>
#include <string>
#include <thread>
#include <vector>

#include "tests/support/cls_folder.h"
#include "tests/support/command.h"
#include "tests/support/command_matchers.h"
#include "tests/support/files.h"
#include "tests/support/host_namespaces.h"
#include "tests/support/json.h"

namespace cls::tests {
namespace {

using testing::HasSubstr;
using testing::Not;
using Words = std::vector<std::string>;

class FirstLine : public testing::Test, public ClsFolder {};

// A network of its own whose loopback interface is down, as in a sandbox of a judge.
CommandResult without_loopback(const Words& words) {
  return tests::run(joined({"unshare", "--user", "--map-root-user", "--net", cls_binary()}, words));
}

TEST_F(FirstLine, ALoopbackInterfaceThatIsDownIsNamedAtOnce) {
  if (!host_has_namespaces()) GTEST_SKIP() << "this host lets no user make namespaces";
  const auto begin = std::chrono::steady_clock::now();
  const CommandResult played =
      without_loopback({"match", "mock:hold", "mock:hold", "--mode", "synch", "--cycles", "20",
                        "--dir", (folder_.path() / "m").string()});
  EXPECT_LT(std::chrono::steady_clock::now() - begin, std::chrono::seconds(10));
  EXPECT_NE(played.exit_code, 0);
  EXPECT_THAT(played.err, HasSubstr("the loopback interface is down; bring it up: ip link set"));
  EXPECT_THAT(played.err, Not(HasSubstr("nothing listens")));
  EXPECT_THAT(without_loopback({"doctor"}).out, HasSubstr("the loopback interface is down"));
}

TEST_F(FirstLine, AStartTimeThatClocksSkipIsRefused) {
  write("cls.toml",
        "[tournament]\nstart_times = [\"2037-03-29 02:30\"]\nslot_minutes = 20\n"
        "[teams.A]\nendpoint = \"mock\"\n[teams.B]\nendpoint = \"mock\"\n");
  const auto plan = [this](const std::string& zone) {
    return run({"tournament", "plan", "."}, {"TZ=" + zone});
  };
  EXPECT_THAT(plan("Europe/Berlin"), Exits(78, HasSubstr("clocks skip this time; it would be")));
  EXPECT_EQ(plan("UTC").exit_code, 0);
}

TEST_F(FirstLine, NamesThatAreTooLongOrHaveAPortAreRefused) {
  const std::string path = "unix:/tmp/" + std::string(120, 'a');
  EXPECT_THAT(run({"match", path, "mock"}), Exits(2, HasSubstr("at most 107 bytes")));
  write("cls.toml",
        "[tournament]\nexecutor = \"hosts\"\nhosts = [\"ada@node:2222\"]\n"
        "[teams.A]\nendpoint = \"mock\"\n[teams.B]\nendpoint = \"mock\"\n");
  EXPECT_THAT(run({"tournament", "plan", "."}),
              Exits(78, HasSubstr("hosts: 'ada@node:2222': ssh takes no port here")));
  EXPECT_THAT(run({"watch", "localhost:1"}), Exits(69, HasSubstr("localhost:1")));
}

TEST_F(FirstLine, TheEndingOfAReportIsItsFormat) {
  ASSERT_EQ(run({"match", "mock:hold", "mock:hold", "--cycles", "20", "--dir", "m"}).exit_code, 0);
  const auto read = [this](const char* name) { return read_file(path(name)); };
  EXPECT_EQ(run({"report", "m", "--out", "r.md"}).exit_code, 0);
  EXPECT_THAT(read("r.md"), testing::AllOf(HasSubstr("# "), Not(HasSubstr("<html"))));
  EXPECT_THAT(run({"report", "m", "--format", "html", "--out", "s.md"}),
              Exits(2, HasSubstr("its ending says md, the format is html")));
  EXPECT_THAT(run({"watch", "m", "--out", "w.svg"}),
              Exits(2, HasSubstr("its ending says svg, the format is html")));

  write("cup/cls.toml",
        "[tournament]\ncycles = 5\nswap_sides = false\n[teams.A]\nendpoint = \"mock:hold\"\n"
        "[teams.B]\nendpoint = \"mock:hold\"\n");
  ASSERT_EQ(run({"tournament", "run", "cup", "--quiet"}).exit_code, 0);
  EXPECT_EQ(run({"tournament", "report", "cup", "--out", "t.html"}).exit_code, 0);
  EXPECT_THAT(read("t.html"), HasSubstr("<html"));
  EXPECT_EQ(run({"tournament", "report", "cup", "--out", "t.json"}).exit_code, 0);
  EXPECT_EQ(base::Json::parse(read("t.json"))["schema"], "cls.tournament/1");
}

// Flags without values are flags in every command that plays matches.
TEST_F(FirstLine, AFlagOfAMatchIsAFlagOfAComparison) {
  const CommandResult compared = run({"compare", "mock:hold", "mock:hold", "--record-world-models",
                                      "--cycles", "5", "--max-pairs", "1", "--dir", "c"});
  EXPECT_THAT(compared.err, Not(HasSubstr("requires a value")));
  EXPECT_NE(compared.exit_code, 2) << compared.err;
}

TEST_F(FirstLine, AScriptAsASideIsOfferedAsACommand) {
  write("decide.py", "print('no Playmaker')\n");
  const std::string offer = "did you mean 'run:python3 decide.py --port {port}'?";
  EXPECT_THAT(run({"match", "decide.py", "mock"}), Exits(2, HasSubstr(offer)));
  write("cls.toml", "[teams.ada]\nendpoint = \"run:./run --port {port}\"\n");
  EXPECT_THAT(run({"match", "decide.py", "mock"}), Exits(2, HasSubstr(offer))) << "in a project";
}

// Ctrl-Z, and on after a while: nobody is blamed for it.
TEST_F(FirstLine, AMatchThatWasStoppedAndContinuedGoesOn) {
  Command match({cls_binary(), "match", "mock:hold", "mock:hold", "--mode", "realtime", "--cycles",
                 "80", "--stall-after", "3", "--dir", "m"},
                {}, folder_.path());
  std::this_thread::sleep_for(std::chrono::seconds(3));
  match.send_signal(SIGSTOP);
  std::this_thread::sleep_for(std::chrono::seconds(6));
  match.send_signal(SIGCONT);
  const CommandResult result = match.finish();
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("cls stood still for "));
}

}  // namespace
}  // namespace cls::tests
