// End-to-end tests of `cls tune`: searches with short matches of mocks.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <thread>

#include "tests/support/cls_folder.h"
#include "tests/support/command.h"
#include "tests/support/command_matchers.h"
#include "tests/support/files.h"
#include "tests/support/json.h"

namespace cls::tests {
namespace {

using testing::HasSubstr;

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using json = base::Json;
using Arguments = std::vector<std::string>;

class Tune : public testing::Test, public ClsFolder {
 protected:
  Tune() : ClsFolder(180s) {}

  // Two generations of four candidates, a pair each; matches of ten cycles.
  void SetUp() override {
    ASSERT_EQ(tune({"init", "a"}).exit_code, 0);
    replace("a/tune.toml", "generations = 6", "generations = 2");
    replace("a/tune.toml", "pairs = 3 ", "pairs = 1 ");
    replace("a/tune.toml", "#population = 0", "population = 4");
    replace("a/tune.toml", "#verdict_pairs = 200", "verdict_pairs = 1");
  }

  void replace(const fs::path& file, const std::string& from, const std::string& to) const {
    std::string text = read_file(folder_.path() / file);
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << from;
    std::ofstream(folder_.path() / file) << text.replace(at, from.size(), to);
  }

  CommandResult tune(Arguments arguments) const {
    arguments.insert(arguments.begin(), "tune");
    return run(std::move(arguments));
  }
  CommandResult search(const std::string& folder, Arguments more = {}) const {
    return tune(joined({"run", folder, "--cycles", "10", "--quiet", "--json"}, more));
  }
  void copy_search(const std::string& folder) const {
    fs::create_directory(path(folder));
    for (const char* name : {"tune.toml", "striker.json.in"}) {
      fs::copy_file(path("a") / name, path(folder) / name);
    }
  }
};

TEST_F(Tune, SearchesComparesAndReports) {
  const CommandResult ran = search("a");
  EXPECT_EQ(ran.exit_code, 3) << "one pair decides nothing: " << ran.err;
  const json document = json::parse(ran.out);
  EXPECT_EQ(document["schema"], "cls.tune/1");
  EXPECT_EQ(document["played"], 2);
  EXPECT_EQ(document["pairs"], 8);
  EXPECT_EQ(document["verdict"], "undecided");
  EXPECT_EQ(document["history"][0]["candidates"].size(), 4u);

  for (const char* name : {"best.toml", "search.svg", "verdict/tournament.db",
                           "generations/0002/files/tune4/striker.json"}) {
    EXPECT_TRUE(fs::exists(path("a") / name)) << name;
  }

  for (const char* matches : {"generations/0001/matches", "verdict/matches"}) {
    const fs::path folder = path("a") / matches;
    EXPECT_TRUE(!fs::exists(folder) || fs::is_empty(folder)) << "no match failed: " << folder;
  }

  EXPECT_EQ(json::parse(tune({"report", "a", "--json"}).out), document);
  const CommandResult text = tune({"report", "a", "--picture", "found.svg"});
  EXPECT_THAT(text.out, HasSubstr("cma-es: generation 2 of 2, 8 pairs"));
  EXPECT_THAT(text.out, HasSubstr("verdict: undecided"));
  EXPECT_TRUE(fs::exists(path("found.svg")));
  EXPECT_EQ(tune({"status", "a"}).out.rfind("generation 2/2: ", 0), 0u);
  // The same command plays nothing again; more generations continue, with another verdict.
  EXPECT_EQ(search("a").out, ran.out);
  const json more = json::parse(search("a", {"--generations", "3"}).out);
  EXPECT_EQ(more["played"], 3);
  EXPECT_EQ(more["history"][0], document["history"][0]);
}

TEST_F(Tune, TakesSeedAndMatchFoldersToKeepFromFileAndCommandLine) {
  replace("a/tune.toml", "#seed = 1", "seed = 5");
  replace("a/tune.toml", "verdict_pairs = 1", "verdict_pairs = 0");
  copy_search("b");
  const Arguments one = {"--generations", "1", "--keep-logs", "all"};
  const json five = json::parse(search("a", one).out);
  EXPECT_THAT(read_file(path("a/tune.plan")), HasSubstr("\nseed = 5\n"));
  EXPECT_FALSE(fs::is_empty(path("a/generations/0001/matches")));
  const json seven = json::parse(search("b", {"--generations", "1", "--seed", "7"}).out);
  EXPECT_THAT(read_file(path("b/tune.plan")), HasSubstr("\nseed = 7\n"));
  EXPECT_NE(five["history"], seven["history"]) << "other candidates and matches";
}

TEST_F(Tune, ResumesAfterKill) {
  copy_search("b");
  Command killed({cls_binary(), "tune", "run", "b", "--cycles", "10", "--quiet"}, {},
                 folder_.path());
  const auto begun = [&] { return fs::exists(path("b/generations/0002/tournament.db")); };
  for (int i = 0; i < 1200 && !begun(); ++i) std::this_thread::sleep_for(50ms);
  killed.send_signal(SIGKILL);
  EXPECT_EQ(killed.finish().signal, SIGKILL);
  const json resumed = json::parse(search("b").out);
  EXPECT_EQ(resumed, json::parse(search("a").out)) << "as if it was never interrupted";
}

TEST_F(Tune, RefusesAnotherSearchInItsFolder) {
  ASSERT_EQ(search("a", {"--generations", "1"}).exit_code, 3);
  replace("a/tune.toml", "pairs = 1 ", "pairs = 2 ");
  EXPECT_THAT(
      search("a"),
      Exits(78, HasSubstr("another search has begun here: 'pairs = 2', was 'pairs = 1'; --force")));
  EXPECT_EQ(json::parse(search("a", {"--force", "--generations", "1"}).out)["pairs"], 8);
  EXPECT_TRUE(fs::exists(path("a/generations.old")));
}

TEST_F(Tune, NamesErrors) {
  EXPECT_EQ(tune({"init", "a"}).exit_code, 73);
  EXPECT_EQ(tune({"run", "none"}).exit_code, 66);
  EXPECT_EQ(tune({"report", "a"}).exit_code, 66) << "nothing was played";
  replace("a/striker.json.in", "{speed}", "1");
  EXPECT_THAT(search("a"), Exits(78, "cls: a/striker.json.in: does not use {speed}\n"));
  replace("a/tune.toml", "min = -34", "min = 40");
  EXPECT_EQ(search("a").exit_code, 78);
}

TEST_F(Tune, PlaysCandidatesAgainstEachOther) {
  replace("a/tune.toml", "opponents = [\"mock:hold\"]", "method = \"spsa\"");
  replace("a/tune.toml", "population = 4", "population = 0");
  const CommandResult ran = search("a");
  EXPECT_EQ(ran.exit_code, 3) << ran.err;
  EXPECT_EQ(json::parse(ran.out)["pairs"], 2);
}

}  // namespace
}  // namespace cls::tests
