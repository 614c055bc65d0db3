// Teams started by `cls server`: server::team_l_start and team_r_start.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/support/command.h"
#include "tests/support/command_matchers.h"
#include "tests/support/files.h"
#include "tests/support/marked_processes.h"
#include "tests/support/temporary_folder.h"

namespace cls::tests {
namespace {

using testing::HasSubstr;

constexpr std::chrono::seconds kSoon{20};

std::string fake_player() { return cls_binary().parent_path() / "cls_fake_player"; }

/// A team of one player, which gets the address of the server from its arguments.
std::string team(const std::string& name) {
  return fake_player() + " --name " + name + " --port $CLS_SERVER_PORT";
}

class ServerTeams : public testing::Test {
 protected:
  Command serve(const std::vector<std::string>& argv) const {
    return Command(joined({cls_binary(), "server", "--port", "0", "--dir", folder.path()}, argv),
                   {std::string(kMarkVariable) + "=" + mark, "RCSS_CONF_DIR=/nonexistent"});
  }

  /// Creates an executable file with this text; returns its path.
  std::string script(const std::string& text) const {
    const std::filesystem::path path = folder.path() / "start.sh";
    std::ofstream(path) << "#!/bin/sh\n" << text;
    std::filesystem::permissions(path, std::filesystem::perms::owner_all);
    return path;
  }

  bool nobody_left() const { return all_marked_gone(mark, kSoon); }

  const TemporaryFolder folder;
  const std::string mark = new_mark();
};

TEST_F(ServerTeams, PlayMatchAndStopWithServer) {
  Command server = serve({"server::team_l_start=" + team("Reds"),
                          "server::team_r_start=echo the right one comes; " + team("Blues"),
                          "server::synch_mode=on", "server::auto_mode=on",
                          "server::kick_off_wait=2", "server::connect_wait=20", "--cycles", "20"});
  const auto served = server.finish();
  EXPECT_EQ(served.exit_code, 0) << served.err;
  EXPECT_TRUE(nobody_left());

  // The first team to connect is the left one: the right one waits for it.
  std::size_t at = 0;
  for (const std::string& line :
       {"Starting \"/bin/sh -c " + team("Reds") + "\"\n",
        std::string("A new (v18) player (Reds 1) connected.\n"),
        std::string("Starting \"/bin/sh -c echo the right one comes; "),
        std::string("A new (v18) player (Blues 1) connected.\n"), std::string("Killing "),
        std::string("\nGame Over. Exiting...\n")}) {
    const std::size_t found = served.out.find(line, at);
    ASSERT_NE(found, std::string::npos) << line << "\nin\n" << served.out;
    at = found;
  }

  EXPECT_THAT(served.out, HasSubstr("\nthe right one comes\n"));
  EXPECT_EQ(served.err, "");
}

TEST_F(ServerTeams, ReceiveSigintThenSigkill) {
  const std::string note = folder.path() / "note";
  // The remaining process ignores all signals that can be ignored.
  const std::string start = script(
      "(trap '' INT TERM; while true; do sleep 1; done) &\n"
      "trap 'echo interrupted >" +
      note +
      "; exit 0' INT\n"
      "echo up\n"
      "while true; do sleep 0.1; done\n");

  Command server = serve({"server::team_l_start=exec " + start});
  ASSERT_TRUE(server.wait_for_output("\nup\n"));

  server.send_signal(SIGINT);
  const auto served = server.finish();
  EXPECT_EQ(served.exit_code, 130);
  EXPECT_EQ(read_file(note), "interrupted\n");
  EXPECT_TRUE(nobody_left());
  EXPECT_EQ(served.err, "");
}

TEST_F(ServerTeams, StopWhenServerIsKilled) {
  const std::string start = script("trap '' INT TERM\necho up\nwhile true; do sleep 1; done\n");
  Command server = serve({"server::team_l_start=" + start});
  ASSERT_TRUE(server.wait_for_output("\nup\n"));
  server.send_signal(SIGKILL);
  EXPECT_EQ(server.finish().signal, SIGKILL);
  EXPECT_TRUE(nobody_left());
}

TEST_F(ServerTeams, ReportFailedCommandOnce) {
  const std::string runs = folder.path() / "runs";
  Command server = serve({"server::team_l_start=echo x >>" + runs + "; exit 3",
                          "server::team_r_start=echo y >>" + runs, "server::synch_mode=on",
                          "server::auto_mode=on", "server::kick_off_wait=2",
                          "server::connect_wait=20", "--cycles", "2"});
  EXPECT_THAT(server.finish(),
              Exits(0, "cls: team_l_start: 'echo x >>" + runs + "; exit 3' failed: exit code 3\n"));
  EXPECT_EQ(read_file(runs), "x\n");  // without a left team the right one is not started
}

}  // namespace
}  // namespace cls::tests
