// `cls match --save-at` and `--resume`: the same bytes, or another course with another seed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "tests/support/cls_folder.h"
#include "tests/support/command.h"
#include "tests/support/command_matchers.h"
#include "tests/support/files.h"

namespace cls::tests {
namespace {

using testing::HasSubstr;
using Words = std::vector<std::string>;

class SaveMatch : public testing::Test, public cls::tests::ClsFolder {
 protected:
  CommandResult match(Words words, const std::string& folder) const {
    Words all = joined({"match"}, words);
    for (const char* word : {"--dir", folder.c_str(), "--quiet"}) all.emplace_back(word);
    return run(std::move(all));
  }
  std::string game_log(const std::string& folder) const {
    return read_file(folder_.path() / folder / "match.rcg");
  }
  // A match of 60 cycles, saved at cycle 30.
  void save() const {
    ASSERT_THAT(match({"mock", "mock", "--seed", "5", "--cycles", "60", "--set",
                       "server::player_rand=0.2", "--save-at", "30", "saved"},
                      "whole"),
                Exits(0));
  }
};

// The number of equal bytes at the start.
std::size_t common(const std::string& one, const std::string& other) {
  const auto end = std::mismatch(one.begin(), one.end(), other.begin(), other.end());
  return static_cast<std::size_t>(end.first - one.begin());
}

TEST_F(SaveMatch, ResumedMatchGivesTheSameBytes) {
  save();
  const auto resumed = match({"mock", "mock", "--cycles", "60", "--resume", "saved"}, "resumed");
  ASSERT_EQ(resumed.exit_code, 0) << resumed.err;
  EXPECT_EQ(game_log("resumed"), game_log("whole"));
}

TEST_F(SaveMatch, AnotherSeedBranchesAtTheSavedCycle) {
  save();
  ASSERT_THAT(
      match({"mock", "mock", "--cycles", "60", "--resume", "saved", "--seed", "6"}, "branch"),
      Exits(0));
  const std::string whole = game_log("whole");
  const std::string branch = game_log("branch");
  ASSERT_NE(branch, whole);
  const std::size_t same = common(whole, branch);
  EXPECT_GT(same, whole.find("(show 30 "));
  EXPECT_LT(same, whole.find("(show 32 "));
}

TEST_F(SaveMatch, OtherSidesTakeOverAtTheSavedCycle) {
  save();
  const auto other =
      match({"mock:hold", "mock:hold", "--cycles", "60", "--resume", "saved"}, "other");
  ASSERT_EQ(other.exit_code, 0) << other.err;
  const std::string whole = game_log("whole");
  const std::string log = game_log("other");
  ASSERT_NE(log, whole);
  EXPECT_GT(common(whole, log), whole.find("(show 30 "));
}

TEST_F(SaveMatch, SavesWhatASecondMatchSavesToo) {
  save();
  ASSERT_THAT(
      match({"mock", "mock", "--cycles", "60", "--resume", "saved", "--save-at", "30", "again"},
            "two"),
      Exits(0));
  EXPECT_EQ(read_file(folder_.path() / "again"), read_file(folder_.path() / "saved"));
}

TEST_F(SaveMatch, NamesWhatIsWrong) {
  int number = 0;
  const auto expect = [&](Words words, int code, const std::string& text) {
    EXPECT_THAT(match(std::move(words), "wrong-" + std::to_string(++number)),
                Exits(code, HasSubstr(text)));
  };

  write("text", "no match");
  expect({"mock", "mock", "--resume", "none"}, 66, "--resume none: no such file");
  expect({"mock", "mock", "--resume", "text"}, 65, "text: not a saved match, or truncated");
  expect({"mock", "mock", "--resume", "text", "--half-time", "10"}, 2, "no --half-time");

  expect({"mock", "mock", "--save-at", "x", "f"}, 2, "--save-at 'x'");
  expect({"mock", "mock", "--save-at", "99999999999", "f"}, 2,
         "--save-at '99999999999': too large");
  expect({"mock", "mock", "--save-at", "0", "f"}, 2, "must be positive");
  expect({"mock", "mock", "--mode", "synch", "--save-at", "5", "f"}, 2, "lockstep");
  expect({"mock:hold", "mock:hold", "--cycles", "5", "--save-at", "50", "f"}, 74,
         "the match ended at cycle 5");
  expect({"mock", "mock", "--save-at", "5", "text"}, 73, "text exists");
}

TEST_F(SaveMatch, TruncatedFileIsAnError) {
  save();
  const std::string bytes = read_file(folder_.path() / "saved");
  write("half", bytes.substr(0, bytes.size() / 2));
  EXPECT_THAT(match({"mock", "mock", "--resume", "half"}, "wrong"), Exits(65));
}

}  // namespace
}  // namespace cls::tests
