// End-to-end tests of `cls dataset` and of Arrow files.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/stat.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <thread>
#include <vector>

#include "tests/support/command.h"
#include "tests/support/command_matchers.h"
#include "tests/support/files.h"
#include "tests/support/json.h"
#include "tests/support/temporary_folder.h"

namespace cls::tests {
namespace {

namespace fs = std::filesystem;
using json = base::Json;
using testing::HasSubstr;

class Dataset : public testing::Test {
 protected:
  void SetUp() override {
    std::ofstream(folder_.path() / "spec.toml") << "[tournament]\nrounds = 2\ncycles = 60\n"
                                                   "[server]\nkick_off_wait = 2\n"
                                                   "[teams.RED]\nendpoint = \"mock\"\n"
                                                   "[teams.BLUE]\nendpoint = \"mock:hold\"\n";
  }

  CommandResult cls(std::vector<std::string> words) const {
    words.insert(words.begin(), cls_binary().string());
    return Command(words, {}, folder_.path()).finish();
  }

  CommandResult make(const std::string& name, std::vector<std::string> more = {}) const {
    return cls(joined({"dataset", "make", "spec.toml", name}, more));
  }

  // All that belongs to the data set: what is not below work/.
  std::map<std::string, std::string> files_of(const std::string& name) const {
    std::map<std::string, std::string> files;
    for (const auto& entry : fs::recursive_directory_iterator(folder_.path() / name)) {
      const std::string path = entry.path().lexically_relative(folder_.path() / name).string();
      if (entry.is_regular_file() && !path.starts_with("work/")) files[path] = read_file(entry);
    }
    return files;
  }

  std::vector<json> matches_of(const std::string& name) const {
    std::ifstream lines(folder_.path() / name / "matches.jsonl");
    std::vector<json> matches;
    for (std::string line; std::getline(lines, line);) matches.push_back(json::parse(line));
    return matches;
  }

  TemporaryFolder folder_;
};

TEST_F(Dataset, HasTheSameBytesWithAnyNumberOfParallelMatches) {
  const CommandResult one = make("one", {"--concurrency", "1"});
  ASSERT_EQ(one.exit_code, 0) << one.err;
  EXPECT_THAT(one.out, HasSubstr("one/: 4 matches"));
  ASSERT_EQ(make("three", {"--concurrency", "3"}).exit_code, 0);
  const auto files = files_of("one");
  EXPECT_EQ(files.size(), 3U + 4 * 3);
  EXPECT_TRUE(files == files_of("three"));
  EXPECT_THAT(files.at("README.md"), HasSubstr("| matches | 4, 4 with files |"));
  const std::vector<json> matches = matches_of("one");
  ASSERT_EQ(matches.size(), 4U);
  EXPECT_EQ(matches[3]["files"][0]["path"], "shards/000/000004.view.gz");
  EXPECT_EQ(matches[0]["seed"], matches[1]["seed"]);
  EXPECT_NE(matches[0]["seed"], matches[2]["seed"]);
  EXPECT_TRUE(fs::is_empty(folder_.path() / "one" / "work" / "matches"));
}

TEST_F(Dataset, ResumesAfterKill) {
  ASSERT_EQ(make("whole").exit_code, 0);
  {
    Command run(
        {cls_binary().string(), "dataset", "make", "spec.toml", "cut", "--concurrency", "1"}, {},
        folder_.path());
    ASSERT_TRUE(run.wait_for_errors("match 2/4"));
    run.send_signal(SIGKILL);
    EXPECT_EQ(run.finish().signal, SIGKILL);
  }

  EXPECT_FALSE(fs::exists(folder_.path() / "cut/matches.jsonl"));
  EXPECT_EQ(cls({"dataset", "verify", "cut"}).exit_code, 66);

  std::ofstream(folder_.path() / "cut/shards/000/000002.abc.view.gz") << "half a file";
  // The matches of the killed run end within a second.
  CommandResult resumed;
  for (int i = 0; i < 20; ++i) {
    resumed = make("cut");
    if (resumed.exit_code != 75) break;
    std::this_thread::sleep_for(std::chrono::milliseconds(200));
  }

  ASSERT_EQ(resumed.exit_code, 0) << resumed.err;
  EXPECT_THAT(resumed.err, testing::Not(HasSubstr("match 1/4")));
  EXPECT_TRUE(files_of("cut") == files_of("whole"));
}

TEST_F(Dataset, IsVerifiedByHashesAndByPlayingAgain) {
  ASSERT_EQ(make("data").exit_code, 0);
  const CommandResult verified = cls({"dataset", "verify", "data", "--sample", "2", "--json"});
  EXPECT_EQ(verified.exit_code, 0) << verified.err;
  EXPECT_EQ(json::parse(verified.out)["played_again"], 2);
  EXPECT_TRUE(json::parse(verified.out)["problems"].empty());
  for (const char* command : {"stats", "results", "review"}) {
    EXPECT_THAT(cls({command, "data"}).err,
                HasSubstr("a data set, which has no logs; cls convert data --tables DIR reads it"));
  }

  // Without the folder of the work, the specification is enough.
  fs::remove_all(folder_.path() / "data/work");
  EXPECT_EQ(cls({"dataset", "verify", "data"}).exit_code, 0);

  // Another seed is another match.
  const std::string list = read_file(folder_.path() / "data/matches.jsonl");
  std::string changed;
  for (json match : matches_of("data")) {
    match["seed"] = match["seed"].get<int>() + 1;
    changed += match.dump() + "\n";
  }
  std::ofstream(folder_.path() / "data/matches.jsonl") << changed;
  const CommandResult other = cls({"dataset", "verify", "data"});
  EXPECT_EQ(other.exit_code, 1);
  EXPECT_THAT(other.err, HasSubstr("view.gz: other bytes when it is played again"));
  EXPECT_EQ(cls({"dataset", "verify", "data", "--sample", "0"}).exit_code, 0);

  std::ofstream(folder_.path() / "data/matches.jsonl") << list;
  std::fstream file(folder_.path() / "data/shards/000/000002.view.gz",
                    std::ios::in | std::ios::out | std::ios::binary);
  file.seekp(100);
  file.put('x');
  file.close();
  fs::remove(folder_.path() / "data/shards/000/000003.left.world-models");
  EXPECT_THAT(cls({"dataset", "verify", "data"}),
              Exits(65,
                    "cls: shards/000/000002.view.gz: other bytes\n"
                    "cls: shards/000/000003.left.world-models: missing\n"));
}

TEST_F(Dataset, RunsProgramsOfOthersOnlyWhenAsked) {
  ASSERT_EQ(make("data").exit_code, 0);
  fs::remove_all(folder_.path() / "data/work");
  const fs::path plan = folder_.path() / "data/dataset.toml";
  const std::string text = read_file(plan);

  for (const char* side :
       {"run:touch ran; sleep 9 --port {port}", "team:.", "localhost:9", "mock:script.json",
        "planner:file=mock", "mix:coach=run:touch ran {port};others=mock"}) {
    std::string changed = text;
    changed.replace(changed.find("\"mock:hold\""), 11, "\"" + std::string(side) + "\"");
    std::ofstream(plan) << changed;
    EXPECT_THAT(cls({"dataset", "verify", "data"}),
                Exits(0, HasSubstr("BLUE is '" + std::string(side) + "'; --run-programs")))
        << side;
    EXPECT_FALSE(fs::exists(folder_.path() / "data/ran")) << side;
    EXPECT_FALSE(fs::exists(folder_.path() / "ran")) << side;
  }

  for (const char* option : {"server = \"localhost:6000\"", "book = \"/dev/zero\""}) {
    std::string changed = text;
    changed.insert(changed.find("[tournament]\n") + 13, option + std::string("\n"));
    std::ofstream(plan) << changed;
    EXPECT_THAT(cls({"dataset", "verify", "data"}), Exits(0, HasSubstr("; --run-programs")))
        << option;
  }
}

TEST_F(Dataset, ReadsRegularFilesInsideOfItOnly) {
  ASSERT_EQ(make("data").exit_code, 0);
  const fs::path list = folder_.path() / "data/matches.jsonl";
  const std::string text = read_file(list);
  const std::string first = "shards/000/000001.view.gz";
  std::ofstream(folder_.path() / "outside") << "secret";
  fs::create_symlink("/dev/zero", folder_.path() / "data/zero");
  fs::create_symlink("../outside", folder_.path() / "data/link");
  ASSERT_EQ(::mkfifo((folder_.path() / "data/pipe").c_str(), 0600), 0);

  const std::pair<std::string, std::string> cases[] = {
      {"zero", "not a regular file"},
      {"pipe", "not a regular file"},
      {"link", "a link that leads out of the data set"},
      {"../outside", "not a path inside of the data set"},
      {"/dev/zero", "not a path inside of the data set"},
      {"shards", "a folder, not a file"}};
  for (const auto& [path, why] : cases) {
    std::string changed = text;
    changed.replace(changed.find(first), first.size(), path);
    std::ofstream(list) << changed;
    const std::string line = path + ": " + why;
    EXPECT_THAT(cls({"dataset", "verify", "data", "--sample", "0"}), Exits(65, HasSubstr(line)));
    fs::remove_all(folder_.path() / "out");
    EXPECT_THAT(cls({"convert", "data", "--tables", "out"}), Exits(65, HasSubstr(line)));
    EXPECT_TRUE(fs::exists(folder_.path() / "out/shards/000/000002.tracking.csv"))
        << "the others are written";
  }
}

TEST_F(Dataset, AnotherSpecificationIsRefused) {
  ASSERT_EQ(make("data").exit_code, 0);
  EXPECT_THAT(make("data", {"--seed", "9"}),
              Exits(78, HasSubstr("holds another plan: seed is 9, was 1")));
}

// Reads files with the JavaScript implementation of Arrow: rows, units, and some sums.
constexpr const char* kReader = R"(
const { tableFromIPC } = require('apache-arrow');
const table = tableFromIPC(require('fs').readFileSync(process.argv[1]));
const units = {};
for (const field of table.schema.fields) units[field.name] = field.metadata.get('unit') ?? '';
const row = table.get(table.numRows - 1).toJSON();
for (const key in row) {
  const value = row[key];
  row[key] = typeof value === 'bigint' ? Number(value)
    : value !== null && typeof value === 'object' ? [...value] : value;
}
console.log(JSON.stringify({ rows: table.numRows, units, row }));
)";

TEST_F(Dataset, IsReadByAnotherImplementationOfArrow) {
  if (Command({"node", "-e", "require('apache-arrow')"}, {}, folder_.path()).finish().exit_code !=
      0) {
    GTEST_SKIP() << "needs node with apache-arrow: npm install apache-arrow, NODE_PATH";
  }

  ASSERT_EQ(make("data").exit_code, 0);
  ASSERT_EQ(cls({"convert", "data", "--tables", "out", "--format", "arrow"}).exit_code, 0);
  ASSERT_EQ(cls({"convert", "data", "--tables", "csv"}).exit_code, 0);

  const auto read = [&](const std::string& table) {
    const CommandResult result =
        Command({"node", "-e", kReader, "out/shards/000/000002." + table + ".arrow"}, {},
                folder_.path())
            .finish();
    EXPECT_EQ(result.exit_code, 0) << result.err;
    return json::parse(result.out);
  };

  const json frames = read("frames");
  const std::string csv = read_file(folder_.path() / "csv/shards/000/000002.tracking.csv");
  EXPECT_EQ(frames["rows"], std::ranges::count(csv, '\n') - 1);
  EXPECT_EQ(frames["units"]["b_vx"], "m/cycle");
  EXPECT_EQ(frames["row"]["cycle"], 60);
  EXPECT_EQ(frames["row"]["r_name"], "RED");

  const json models = read("world_models");
  EXPECT_GT(models["rows"], 22 * 60);
  EXPECT_EQ(models["units"]["self_body"], "deg");
  EXPECT_EQ(models["row"]["side"], "right");
  EXPECT_EQ(models["row"]["unum"], 11);
  EXPECT_EQ(models["row"]["x"].size(), 22U);
  EXPECT_THAT(models["row"]["commands"].get<std::string>(), HasSubstr("("));
}

TEST_F(Dataset, MatchFoldersHaveCommandsAndWorldModels) {
  ASSERT_THAT(cls({"match", "mock", "mock:hold", "--cycles", "20", "--seed", "3", "--dir", "m",
                   "--record-world-models", "--quiet"}),
              Exits(0));
  ASSERT_THAT(cls({"convert", "m", "--tables", "out", "--format", "arrow"}), Exits(0));
  for (const char* table : {"frames.arrow", "events.arrow", "commands.arrow", "world_models.arrow",
                            "player_types.csv"}) {
    EXPECT_TRUE(fs::exists(folder_.path() / "out" / (std::string("match.") + table))) << table;
  }
  EXPECT_THAT(cls({"convert", "m/match.rcg", "x.rcg", "--format", "arrow"}),
              Exits(2, "cls: --format arrow: only with --tables DIR\n"));

  std::ofstream(folder_.path() / "m/left.world-models") << "cut";
  EXPECT_THAT(cls({"convert", "m", "--tables", "out", "--format", "arrow", "--force"}),
              Exits(65, HasSubstr("left.world-models: ")));
}

TEST_F(Dataset, StreamsAreGameLogs) {
  ASSERT_EQ(make("data").exit_code, 0);
  const std::string stream = "data/shards/000/000001.view.gz";
  ASSERT_EQ(cls({"convert", stream, "1.rcg"}).exit_code, 0);
  ASSERT_EQ(cls({"convert", stream, "1.tracking.csv"}).exit_code, 0);
  ASSERT_EQ(cls({"convert", "1.rcg", "2.tracking.csv"}).exit_code, 0);
  EXPECT_EQ(read_file(folder_.path() / "1.tracking.csv"),
            read_file(folder_.path() / "2.tracking.csv"));
}

}  // namespace
}  // namespace cls::tests
