// `cls challenge stp` from whole matches to scores.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "base/io/byte_source.h"
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

class Challenge : public testing::Test {
 protected:
  Challenge() {
    auto source = cls::base::open_source(fixture("stp/match.tracking.csv.gz").string());
    put("csv/cup/1.tracking.csv", cls::base::read_all(**source));
    put("csv/cup/2.tracking.csv", "#,cycle,playmode\n1,1,\"play_on\"\n");
  }

  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }

  void put(const std::string& name, const std::string& text) const {
    fs::create_directories(fs::path(path(name)).parent_path());
    std::ofstream(path(name), std::ios::binary) << text;
  }

  CommandResult stp(const std::vector<std::string>& arguments) const {
    return Command(joined({cls_binary().string(), "challenge", "stp"}, arguments), {},
                   folder_.path())
        .finish();
  }

  void make() const {
    EXPECT_THAT(stp({"make", "csv", "tests"}),
                Prints(0, "cup-1  cycle 139\n1 of 2 matches have a test\n"));
    EXPECT_EQ(stp({"predict", "tests", "mine"}).out, "1 predictions\n");
  }

  TemporaryFolder folder_;
};

TEST_F(Challenge, MakesPredictsChecksAndScores) {
  put("csv/cup/1.event.csv",
      "a,b,c,d,e,f,g,h,i,Time2\n1,1,1,1,1,1,1,1,1,139\n1,1,1,1,1,1,1,1,1,140\n");
  make();

  EXPECT_FALSE(fs::exists(path("tests/cup-2.tracking.csv")));
  EXPECT_EQ(read_file(path("tests/cup-1.event.csv")),
            "a,b,c,d,e,f,g,h,i,Time2\n1,1,1,1,1,1,1,1,1,139\n");
  EXPECT_THAT(stp({"validate", "tests", "mine"}), Prints(0, "Submission is valid.\n"));
  EXPECT_THAT(
      stp({"score", "csv", "tests", "mine"}),
      Prints(0,
             "Number of Evaluated Sequences: 1\nAverage Error: 3.3825\nEndpoint Error: 5.2666\n"));

  const json document = json::parse(stp({"score", "csv", "tests", "mine", "--json"}).out);
  EXPECT_EQ(document["schema"], "cls.challenge/1");
  EXPECT_EQ(document["matches"][0]["name"], "cup-1.tracking.csv");
  EXPECT_NEAR(document["endpoint_error"].get<double>(), 5.2666, 1e-4);
  EXPECT_EQ(stp({"make", "csv", "tests"}).exit_code, 73) << "tests exist";
}

TEST_F(Challenge, NamesWhatIsWrongWithPredictions) {
  make();
  put("mine/more.tracking.csv", "#\n1\n");
  fs::copy_file(path("tests/cup-1.tracking.csv"), path("tests/other.tracking.csv"));
  CommandResult checked = stp({"validate", "tests", "mine"});
  EXPECT_EQ(checked.exit_code, 1);
  EXPECT_EQ(checked.out,
            "more.tracking.csv: no test of this name\n"
            "other.tracking.csv: no prediction of this test\n");
  put("mine/other.tracking.csv", "#,l1_x\n1,2\n");
  checked = stp({"validate", "tests", "mine", "--json"});
  const json document = json::parse(checked.out);
  EXPECT_EQ(document["valid"], false);
  EXPECT_THAT(document["problems"][1].get<std::string>(),
              HasSubstr("other.tracking.csv: line 1: has no column l1_y"));
}

TEST_F(Challenge, ReportsFailuresByExitCode) {
  EXPECT_EQ(stp({"make", "nothing", "tests"}).exit_code, 66);
  fs::create_directory(path("empty"));
  EXPECT_EQ(stp({"validate", "empty", "empty"}).err, "cls: empty: no file NAME.tracking.csv\n");
  put("bad/m.tracking.csv", "#,cycle,playmode\n1,x,\"p\"\n");
  const CommandResult bad = stp({"make", "bad", "tests"});
  EXPECT_EQ(bad.exit_code, 65);
  EXPECT_EQ(bad.err, "cls: bad/m.tracking.csv: line 2: cycle: 'x' must be a number\n");
  EXPECT_EQ(stp({"predict", "csv", "out", "--model", "rnn"}).exit_code, 2);
  EXPECT_EQ(stp({"predict", "csv", "out"}).exit_code, 65) << "a table without places";
}

}  // namespace
}  // namespace cls::tests
