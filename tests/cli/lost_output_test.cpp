// Standard streams that cannot be written: what plays is played to its end, then the exit code
// is 74.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "tests/support/cls_folder.h"
#include "tests/support/command.h"
#include "tests/support/command_matchers.h"
#include "tests/support/files.h"
#include "tests/support/json.h"

namespace cls::tests {
namespace {

using json = base::Json;
using testing::HasSubstr;

constexpr const char* kWarning = " --set server::slow_down_factor=2";  // has no effect: a line

class LostOutput : public testing::Test, public ClsFolder {
 protected:
  // With the redirections of a shell.
  CommandResult shell(const std::string& arguments) const {
    return Command({"/bin/bash", "-c", cls_binary().string() + " " + arguments}, {}, folder())
        .finish();
  }
  std::filesystem::path folder() const { return path(""); }

  void write_two_teams() const {
    write("cls.toml",
          "[tournament]\ncycles = 20\n[teams.A]\nendpoint = \"mock:hold\"\n"
          "[teams.B]\nendpoint = \"mock:hold\"\n");
  }
};

// The redirections of a night's run that go wrong.
const std::vector<std::string> kLost = {"2>/dev/full", ">/dev/full 2>/dev/full", ">&- 2>&-",
                                        "2> >(exit 0)", "<&- >&- 2>&-"};

TEST_F(LostOutput, DoesNotEndAMatch) {
  for (std::size_t i = 0; i < kLost.size(); ++i) {
    const std::string dir = "m" + std::to_string(i);
    const CommandResult result =
        shell("match mock:hold mock:hold --cycles 20 --dir " + dir + kWarning + " " + kLost[i]);
    EXPECT_EQ(result.exit_code, 74) << kLost[i] << result.err;
    ASSERT_TRUE(std::filesystem::exists(path(dir + "/result.json"))) << kLost[i];
    const json document = json::parse(read_file(path(dir + "/result.json")));
    EXPECT_EQ(document["end_reason"], "finished") << kLost[i];
    EXPECT_EQ(read_file(path(dir + "/match.rcg")).substr(0, 3), "ULG") << kLost[i];
  }
}

TEST_F(LostOutput, DoesNotEndATournament) {
  write_two_teams();
  for (std::size_t i = 0; i < kLost.size(); ++i) {
    const std::string cup = "t" + std::to_string(i);
    EXPECT_THAT(shell("tournament run " + cup + " " + kLost[i]), Exits(74));
    const CommandResult status = run({"tournament", "status", cup, "--json"});
    EXPECT_EQ(json::parse(status.out)["finished"], 2) << kLost[i] << status.out;
  }
}

TEST_F(LostOutput, OfEventsDoesNotEndATournament) {
  write_two_teams();
  std::filesystem::create_directory(path("t"));
  std::filesystem::create_symlink("/dev/full", path("t/events.jsonl"));
  const CommandResult result = run({"tournament", "run", "t", "--quiet"});
  EXPECT_EQ(result.exit_code, 74);
  EXPECT_EQ(result.err, "cls: cannot write t/events.jsonl: No space left on device\n");
  EXPECT_THAT(result.out, HasSubstr("0:0"));
}

const std::string kServer =
    "server server::half_time=1 server::auto_mode=on server::kick_off_wait=1 "
    "server::connect_wait=1 server::game_over_wait=1 server::port=0 server::coach_port=0 "
    "server::olcoach_port=0";

TEST_F(LostOutput, DoesNotEndAServer) {
  EXPECT_THAT(shell(kServer + " >/dev/full 2>/dev/full"), Exits(74));
  int logs = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder())) {
    if (entry.path().extension() == ".rcg") ++logs;
  }
  EXPECT_EQ(logs, 1);
}

TEST_F(LostOutput, IsAnErrorOfOtherCommands) {
  for (const std::string arguments : {"version", "help", "test --list", "train spec"}) {
    EXPECT_EQ(shell(arguments + " >&-").exit_code, 74) << arguments;
    EXPECT_EQ(shell(arguments + " > >(exit 0)").exit_code, 74) << arguments;
    EXPECT_THAT(shell(arguments + " >/dev/full").err,
                HasSubstr("cls: cannot write standard output: No space left on device"));
  }
  EXPECT_EQ(shell("match NEW mock 2>/dev/full").exit_code, 2) << "the first error stays";
}

TEST_F(LostOutput, OfALineInJsonIsAnError) {
  EXPECT_THAT(shell(kServer + " --json >/dev/full"), Exits(74));
}

}  // namespace
}  // namespace cls::tests
