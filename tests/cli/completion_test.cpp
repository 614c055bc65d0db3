// What may stand at the cursor, as completion scripts receive it.
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "tests/support/cls_folder.h"
#include "tests/support/command.h"

namespace cls::tests {
namespace {

using Words = std::vector<std::string>;

class Completion : public testing::Test, public cls::tests::ClsFolder {
 protected:
  Completion() {
    std::ofstream(folder_.path() / "cls.toml")
        << "[teams.ada]\nendpoint = \"mock\"\n[teams.grace]\nendpoint = \"mock:hold\"\n";
  }

  // Lines without notes; the last of `words` is at the cursor.
  Words complete(Words words) const {
    words.insert(words.begin(), {"complete", "--"});
    const CommandResult result = run(std::move(words));
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.err, "");
    Words lines;
    std::istringstream in(result.out);
    for (std::string line; std::getline(in, line);) {
      const std::string path_prefix = line[0] == ':' ? line.substr(line.find('\t') + 1) : "";
      lines.push_back(line.substr(0, line.find('\t')) +
                      (path_prefix.empty() ? "" : " " + path_prefix));
    }
    return lines;
  }
};

bool has(const Words& words, const std::string& word) {
  return std::ranges::find(words, word) != words.end();
}

TEST_F(Completion, OffersCommandsAndSubcommands) {
  EXPECT_EQ(complete({"mat"}), Words{"match"});
  EXPECT_TRUE(has(complete({""}), "tournament"));
  EXPECT_EQ(complete({"tournament", "r"}), (Words{"run", "report", "resume"}));
  EXPECT_EQ(complete({"--json", "check", "pe"}), Words{"perception"});
  EXPECT_EQ(complete({"nonsense", ""}), Words{});
}

// Shells insert candidates unquoted: a stranger's cls.toml must not get a command to run.
TEST_F(Completion, OffersNoNamesThatAShellWouldRun) {
  std::ofstream(folder_.path() / "cls.toml") << "[teams.\"x$(touch p)\"]\nendpoint = \"mock\"\n"
                                                "[teams.\"a b\"]\nendpoint = \"mock\"\n"
                                                "[teams.ada]\nendpoint = \"mock\\n$(touch q)\"\n";
  const Words sides = complete({"match", ""});
  EXPECT_TRUE(has(sides, "ada"));
  for (const std::string& line : sides) {
    EXPECT_EQ(line.find_first_of("$ ("), std::string::npos) << line;
  }
}

TEST_F(Completion, OffersOptionsThatAreNotGivenYet) {
  EXPECT_EQ(complete({"match", "--se"}), (Words{"--seed", "--server", "--set"}));
  EXPECT_EQ(complete({"match", "--seed", "7", "--set", "server::half_time=10", "--se"}),
            (Words{"--server", "--set"}));
  EXPECT_TRUE(has(complete({"--"}), "--version"));
  const Words test = complete({"test", "--"});
  EXPECT_TRUE(has(test, "--accept"));
  EXPECT_FALSE(has(test, "--bless")) << "a former name";
}

TEST_F(Completion, OffersChoicesOfAnOption) {
  EXPECT_EQ(complete({"match", "--mode", ""}), (Words{"lockstep", "synch", "realtime"}));
  EXPECT_EQ(complete({"match", "--mode=r"}), Words{"--mode=realtime"});
  EXPECT_EQ(complete({"match", "--seed", ""}), Words{});
  EXPECT_EQ(complete({"mock", "--fault-cycles", "1", "2", "--host"}), Words{"--host"});
}

TEST_F(Completion, OffersSidesAndTeamsOfTheConfiguration) {
  EXPECT_EQ(complete({"match", "mock", "g"}), Words{"grace"});
  const Words left = complete({"match", ""});
  for (const char* side : {"ada", "grace", "mock", "localhost:", "run:", "team:", "planner:"}) {
    EXPECT_TRUE(has(left, side)) << side;
  }
  EXPECT_EQ(complete({"match", "mock:h"}), (Words{"mock:hold", ":files mock:"}));
  EXPECT_EQ(complete({"match", "mock", "team:../x"}), Words{":folders team:"});
  EXPECT_EQ(complete({"match", "planner:x"}), Words{":files planner:"});
  EXPECT_EQ(complete({"match", "mock", "mock", "m"}), Words{}) << "a third side";
  EXPECT_EQ(complete({"compare", "ad"}), Words{"ada"});
  EXPECT_EQ(complete({"test", "--against", "ad"}), Words{"ada"});
}

TEST_F(Completion, ToleratesABrokenConfiguration) {
  std::ofstream(folder_.path() / "cls.toml") << "[teams\n";
  EXPECT_TRUE(has(complete({"match", ""}), "mock"));
}

TEST_F(Completion, OffersServerParameters) {
  EXPECT_EQ(complete({"match", "--set", "server::half_t"}), Words{"server::half_time="});
  EXPECT_EQ(complete({"match", "--set", "server::coach="}),
            (Words{"server::coach=on", "server::coach=off"}));
  EXPECT_EQ(complete({"match", "--set=player::player_ty"}), Words{"--set=player::player_types="});
  EXPECT_EQ(complete({"server", "server::synch_mo"}), Words{"server::synch_mode="});
}

TEST_F(Completion, OffersNamesOfOtherArguments) {
  EXPECT_EQ(complete({"test", "referee_of"}), (Words{"referee_offside", ":files"}));
  EXPECT_EQ(complete({"new", "ty"}), Words{"typescript"});
  EXPECT_EQ(complete({"new", "go", "ada", "--template", "m"}), Words{"minimal"});
  EXPECT_EQ(complete({"completion", ""}), (Words{"bash", "fish", "zsh"}));
  EXPECT_EQ(complete({"stats", "x"}), Words{":files"});
  EXPECT_EQ(complete({"match", "--dir", ""}), Words{":folders"});
  EXPECT_EQ(complete({"match", "--dir="}), Words{":folders --dir="});
}

TEST_F(Completion, OffersCommandsAndTopicsOfHelp) {
  EXPECT_EQ(complete({"help", "tourn"}), (Words{"tournament", "tournaments"}));
  EXPECT_EQ(complete({"help", "tournament", "st"}), (Words{"status", "stop"}));
}

}  // namespace
}  // namespace cls::tests
