// `mix:` sides: one team whose agents are decided for by several Playmakers.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "tests/support/built.h"
#include "tests/support/cls_folder.h"
#include "tests/support/command.h"
#include "tests/support/command_matchers.h"
#include "tests/support/files.h"
#include "tests/support/json.h"
#include "tests/support/port_lock.h"

namespace cls::tests {
namespace {

using json = base::Json;
using testing::HasSubstr;
using Arguments = std::vector<std::string>;

class MixedSide : public testing::Test, public cls::tests::ClsFolder {
 protected:
  static std::string fake(const std::string& flags = "") {
    return "run:exec " + built("cls_fake_playmaker") + " --port {port} " + flags;
  }

  CommandResult play(const std::string& left, const std::string& folder,
                     const Arguments& more = {}) const {
    return run(joined({"match", left, "mock", "--seed", "5", "--left-name", "left", "--force",
                       "--dir", folder, "--right-name", "right"},
                      more));
  }

  json result(const std::string& folder) const {
    return json::parse(read_file(folder_.path() / folder / "result.json"));
  }
};

// Who decides for whom does not show in the match.
TEST_F(MixedSide, PlaysTheMatchOfOnePlaymaker) {
  const Arguments cycles = {"--cycles", "60"};
  ASSERT_EQ(play("mock:simple", "one", cycles).exit_code, 0);
  const CommandResult mixed = play(
      "mix:goalie=mock:simple;2-6," + std::string("forwards=") + fake() + ";others=mock:simple",
      "three", cycles);
  ASSERT_EQ(mixed.exit_code, 0) << mixed.err;
  EXPECT_EQ(mixed.err, "");
  EXPECT_TRUE(read_file(folder_.path() / "one/match.rcg") ==
              read_file(folder_.path() / "three/match.rcg"));
  EXPECT_THAT(mixed.out, HasSubstr("left 2-6,forwards: run:exec"));
}

// As in the cooperative challenge: players of two teams, each with its own name, in one team.
TEST_F(MixedSide, PlaysExternalTeamsAsOne) {
  for (const char* name : {"LIONS", "BEARS"}) {
    const std::string player = copy_built("cls_fake_player", folder_.path() / name);
    write(std::string(name) + "/start",
          "#!/bin/sh\n[ $3 = 12 ] && exec sleep 600\n[ $3 = 1 ] && goalie='--goalie 1'\n"
          "exec " +
              player + " --port $4 --name " + name + " $goalie\n");
    std::filesystem::permissions(path(name) / "start", std::filesystem::perms::owner_all);
  }

  const PortLock ports;
  for (const char* mode : {"synch", "realtime"}) {
    const CommandResult mixed =
        run({"match", "mix:1-5=team:LIONS;others=team:BEARS", "mock:hold", "--cycles", "40",
             "--no-coach", "--mode", mode, "--dir", mode});
    ASSERT_EQ(mixed.exit_code, 0) << mode << mixed.err;
    const json played = result(mode);
    EXPECT_EQ(played["left"]["name"], "LIONS+BEARS") << mode;
    int lions = 0;
    int bears = 0;
    for (const json& process : played["processes"]) {
      const auto command = process["command"].get<std::string>();
      lions += command.find("/LIONS/start") != std::string::npos;
      bears += command.find("/BEARS/start") != std::string::npos;
    }
    EXPECT_EQ(lions, 5) << mode;
    EXPECT_EQ(bears, 6) << mode;
  }
}

TEST_F(MixedSide, ExternalTeamsAndPlaymakersDoNotMix) {
  const CommandResult both = run({"match", "mix:1=team:LIONS;others=mock", "mock"});
  EXPECT_EQ(both.exit_code, 2);
  EXPECT_THAT(both.err, HasSubstr("external teams and Playmakers do not play in one team"));
  write("PACK/start.sh", "#!/bin/sh\n");
  std::filesystem::permissions(path("PACK/start.sh"), std::filesystem::perms::owner_all);
  const CommandResult all = run({"match", "mix:1=team:PACK;others=team:PACK", "mock"});
  EXPECT_NE(all.exit_code, 0);
  EXPECT_THAT(all.err, HasSubstr("a part of a mixed team needs start"));
}

// Competitions demand a process for each agent. It plays the match of one for all.
TEST_F(MixedSide, RunsAProcessForEachAgent) {
  const Arguments cycles = {"--cycles", "60"};
  ASSERT_EQ(play(fake(), "one", cycles).exit_code, 0);
  Arguments limited = cycles;
  limited.insert(limited.end(), {"--max-memory", "4G"});
  const CommandResult each = play("each:" + fake(), "each", limited);
  ASSERT_EQ(each.exit_code, 0) << each.err;
  EXPECT_EQ(each.err, "");
  EXPECT_TRUE(read_file(folder_.path() / "one/match.rcg") ==
              read_file(folder_.path() / "each/match.rcg"));

  const json document = result("each");
  EXPECT_EQ(document["left"]["endpoint"], "each:" + fake());
  ASSERT_EQ(document["left"]["parts"].size(), 12U);
  EXPECT_EQ(document["left"]["parts"][6]["agents"], "7");
  EXPECT_EQ(document["processes"].size(), 12U);

  for (const char* agent : {"1", "11", "coach"}) {
    EXPECT_TRUE(std::filesystem::exists(folder_.path() / "each" /
                                        (std::string("left-playmaker-") + agent + ".log")));
  }
}

TEST_F(MixedSide, NamesTheProcessOfAnAgentThatFails) {
  const CommandResult played =
      play("each:run:[ {port} = 0 ] || exec " + built("cls_fake_playmaker") +
               " --port {port} --exit-at-cycle 10",
           "match", {"--cycles", "60"});
  EXPECT_NE(played.exit_code, 0);
  EXPECT_THAT(played.err, HasSubstr("left Playmaker ("));
}

TEST_F(MixedSide, ReportsEachPart) {
  ASSERT_THAT(play("mix:1-7=mock:hold;others=" + fake() + ";coach=" + fake("x"), "match",
                   {"--cycles", "30"}),
              Exits(0));

  const json document = result("match");
  const json& parts = document["left"]["parts"];
  ASSERT_EQ(parts.size(), 3U);
  EXPECT_EQ(parts[0]["agents"], "1-7");
  EXPECT_EQ(parts[0]["endpoint"], "mock:hold");
  auto decisions = document["left"]["coach"]["decisions"].get<std::int64_t>();
  for (const json& player : document["left"]["players"]) {
    decisions += player["decisions"].get<std::int64_t>();
  }

  EXPECT_EQ(parts[0]["decisions"].get<std::int64_t>() + parts[1]["decisions"].get<std::int64_t>() +
                parts[2]["decisions"].get<std::int64_t>(),
            decisions);
  EXPECT_EQ(parts[2]["decisions"], document["left"]["coach"]["decisions"]);
  EXPECT_GT(parts[1]["cpu_seconds"], 0.0);
  EXPECT_EQ(document["right"]["parts"].size(), 0U);
  EXPECT_EQ(document["processes"][0]["name"], "left Playmaker (others)");
  EXPECT_EQ(document["processes"][1]["log"], "left-playmaker-coach.log");
}

TEST_F(MixedSide, NamesTheProgramThatCrashes) {
  const CommandResult played =
      play("mix:1-10=mock;11=" + fake("--exit-at-cycle 10"), "match", {"--cycles", "60"});
  EXPECT_EQ(played.exit_code, 1) << played.err;
  const json document = result("match");
  EXPECT_EQ(document["end_reason"], "crashed");
  EXPECT_EQ(document["fault"], "left");
  EXPECT_EQ(document["failure"]["process"], "left Playmaker (11)");
  EXPECT_EQ(document["failure"]["output"].back(), "out of ideas");
}

TEST_F(MixedSide, RefusesWhenOnePartDoesNotListen) {
  const CommandResult played =
      play("mix:1-10=mock;11=" + fake("--never-listen 1"), "match", {"--start-timeout", "1"});
  EXPECT_EQ(played.exit_code, 69);
  EXPECT_THAT(played.err, HasSubstr("no answer to Register of player 11"));
  EXPECT_THAT(played.err, HasSubstr("it did not listen on port "));
}

TEST_F(MixedSide, PlaysInSynchMode) {
  const CommandResult played =
      play("mix:players=" + fake() + ";coach=mock", "match",
           {"--cycles", "20", "--mode", "synch", "--set", "server::kick_off_wait=3"});
  EXPECT_EQ(played.exit_code, 0) << played.err;
}

TEST_F(MixedSide, IsATeamOfAConfiguration) {
  std::filesystem::create_directory(folder_.path() / "below");
  std::ofstream(folder_.path() / "cls.toml")
      << "[teams.ada]\nendpoint = \"\"\"mix:\n  1 = mock:hold;\n  others = mock\"\"\"\n";
  Command command({cls_binary(), "match", "ada", "mock", "--cycles", "10", "--dir", "match"}, {},
                  folder_.path() / "below");
  EXPECT_THAT(command.finish(), Exits(0));
}

TEST_F(MixedSide, HasNoSinglePlaymakerToCheck) {
  const CommandResult checked = run({"check", "playmaker", "mix:1=mock;others=mock"});
  EXPECT_EQ(checked.exit_code, 2);
  EXPECT_EQ(checked.err, "cls: mix: and each: have several Playmakers; check each of them\n");
}

}  // namespace
}  // namespace cls::tests
