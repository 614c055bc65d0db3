// The programs of examples/analysis on tables of a fixture, compared with `cls
// stats`.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <string>
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

class AnalysisExamples : public testing::Test {
 protected:
  void SetUp() override {
    if (run({"python3", "-c", "pass"}).exit_code != 0) GTEST_SKIP() << "needs python3";
    ASSERT_THAT(cls({"match", "mock", "mock:simple", "--seed", "5", "--cycles", "1000", "--dir",
                     "m", "--quiet"}),
                Exits(0));
    std::ofstream(path("events.csv")) << cls({"stats", "m", "--format", "csv-events"}).out;
    statistics_ = json::parse(cls({"stats", "m", "--json"}).out)["matches"][0];
  }

  fs::path path(const std::string& name) const { return folder_.path() / name; }
  CommandResult run(std::vector<std::string> words) const {
    return Command(std::move(words), {}, folder_.path()).finish();
  }
  CommandResult cls(std::vector<std::string> words) const {
    words.insert(words.begin(), cls_binary().string());
    return run(std::move(words));
  }
  CommandResult example(const std::string& name, const std::vector<std::string>& words) const {
    const fs::path program = source_folder() / "examples" / name;
    return Command(joined({"python3", program.string()}, words), {"CLS=" + cls_binary().string()},
                   folder_.path())
        .finish();
  }
  int stat(const std::string& side, const char* group, const char* name) const {
    return statistics_[side][group][name].get<int>();
  }

  TemporaryFolder folder_;
  json statistics_;
};

TEST_F(AnalysisExamples, PassNetworkAgreesWithStatistics) {
  for (const std::string side : {"left", "right"}) {
    const CommandResult result =
        example("analysis/pass_network.py", {"events.csv", side, "out.svg"});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const int attempted = stat(side, "passes", "attempted");
    EXPECT_GT(attempted, 0);
    EXPECT_THAT(result.out, HasSubstr("attempted " + std::to_string(attempted) + "\n"));
    EXPECT_THAT(result.out,
                HasSubstr("completed " + std::to_string(stat(side, "passes", "completed")) + "\n"));
    EXPECT_THAT(read_file(path("out.svg")), HasSubstr("</svg>"));
  }
}

TEST_F(AnalysisExamples, ExpectedThreatAgreesWithStatistics) {
  const CommandResult result = example("analysis/expected_threat.py", {"events.csv", "out.svg"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const int shots = stat("left", "shots", "total") + stat("right", "shots", "total");
  const int goals = stat("left", "shots", "goal") + stat("right", "shots", "goal");
  EXPECT_GT(shots, 0);
  EXPECT_THAT(result.out, HasSubstr("shots " + std::to_string(shots) + "\n"));
  EXPECT_THAT(result.out, HasSubstr("goals " + std::to_string(goals) + "\n"));
}

TEST_F(AnalysisExamples, FormationClustersReadTrackingTables) {
  ASSERT_EQ(cls({"convert", "m", "m.tracking.csv"}).exit_code, 0);
  ASSERT_THAT(example("analysis/formation_clusters.py", {"m.tracking.csv", "left", "out.svg"}),
              Prints(0, HasSubstr(" frames, mean x ")));
  EXPECT_THAT(read_file(path("out.svg")), HasSubstr("% of "));
}

}  // namespace
}  // namespace cls::tests
