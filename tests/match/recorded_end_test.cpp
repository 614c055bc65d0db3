// The end of a match read from result.json beside its logs.
#include "match/result/recorded_end.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "analysis/results/results_text.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace cls::match {
namespace {

using testing::HasSubstr;

namespace fs = std::filesystem;

// Reads the start of a match, 1:0 after 234 cycles without an end, beside a document.
class RecordedEndTest : public testing::Test {
 protected:
  analysis::MatchSummary read(const std::string& document) {
    const fs::path folder = folder_.path();
    std::ofstream(folder / "match.rcg")
        << tests::read_file(tests::fixture("gamelog/match-start.rcg.gz"));
    std::ofstream(folder / "result.json") << document;
    const auto found = gamelog::find_logs({(folder / "match.rcg").string()});
    const auto results = analysis::read_results(with_recorded_ends(found.matches), 1);
    return results.at(0).summary;
  }

  static std::string document(const std::string& end_reason, const std::string& log) {
    return R"({"schema": "cls.match/1", "end_reason": ")" + end_reason +
           R"(", "log_files": {"rcg": ")" + log + R"(", "rcl": "match.rcl"}})";
  }

  tests::TemporaryFolder folder_;
};

TEST_F(RecordedEndTest, MarksPlannedEndAsComplete) {
  const analysis::MatchSummary summary = read(document("finished", "match.rcg"));
  EXPECT_TRUE(summary.complete);
  EXPECT_EQ(summary.end_reason, "finished");
  EXPECT_EQ(summary.winner, analysis::Winner::kLeft);
  EXPECT_THAT(analysis::format_results({summary}, analysis::ResultsFormat::kJson),
              HasSubstr("\"end_reason\": \"finished\""));
}

TEST_F(RecordedEndTest, ReportsEndReasonOfAbortedMatch) {
  const analysis::MatchSummary summary = read(document("stalled", "match.rcg"));
  EXPECT_FALSE(summary.complete);
  EXPECT_EQ(summary.winner, analysis::Winner::kNone);
  const std::string table = analysis::format_results({summary}, analysis::ResultsFormat::kTable);
  EXPECT_THAT(table, AllOf(HasSubstr("incomplete"), HasSubstr("stalled, ")));
}

TEST_F(RecordedEndTest, IgnoresDocumentsOfOtherLogsAndSchemas) {
  for (const std::string& odd :
       {document("finished", "another.rcg"), std::string("{\"schema\": \"cls.match/1\"}"),
        std::string("[1]"), std::string("no json"),
        std::string("{\"schema\": 5, \"log_files\": 7}"),
        std::string("{\"schema\": \"cls.match/1\", \"log_files\": []}")}) {
    const analysis::MatchSummary summary = read(odd);
    EXPECT_FALSE(summary.complete) << odd;
    EXPECT_EQ(summary.end_reason, "") << odd;
  }
}

TEST_F(RecordedEndTest, TakesDateFromManifestNameOrFile) {
  setenv("TZ", "UTC", 1);
  const fs::path folder = folder_.path();
  const auto write = [&](const char* name, const std::string& text) {
    std::ofstream(folder / name) << text;
    return (folder / name).string();
  };
  const std::string log = write("match.rcg", "");
  write("manifest.json", R"({"started": "2026-11-21T01:02:03Z"})");

  EXPECT_EQ(recorded_date(log), "202611210102");
  EXPECT_EQ(recorded_date(write("20251020304050-A_1-vs-B_0.rcg", "")), "202510203040");

  const std::string other = write("other.rcg", "");
  fs::last_write_time(other, fs::last_write_time(log) - std::chrono::hours(24 * 365));
  EXPECT_EQ(recorded_date(other).size(), 12u);
  EXPECT_LT(recorded_date(other), "2030");
  EXPECT_GT(recorded_date(other), "2020");
  EXPECT_EQ(recorded_date("-"), "");
}

TEST_F(RecordedEndTest, KeepsDateOfLogUnlessItIsConstant) {
  std::ofstream(folder_.path() / "manifest.json") << R"({"started": "2026-11-21T01:02:03Z"})";
  EXPECT_EQ(read(document("finished", "match.rcg")).date.substr(0, 6), "202611");
}

}  // namespace
}  // namespace cls::match
