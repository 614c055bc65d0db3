// `cls book`: which moments of a match become situations.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/support/command.h"
#include "tests/support/command_matchers.h"
#include "tests/support/json.h"
#include "tests/support/temporary_folder.h"

namespace cls::tests {
namespace {

using json = base::Json;
using testing::HasSubstr;

class BookCommand : public testing::Test {
 protected:
  CommandResult cls(const std::vector<std::string>& words) const {
    Command command(joined({cls_binary()}, words), {}, folder_.path());
    return command.finish();
  }

  TemporaryFolder folder_;
};

TEST_F(BookCommand, TakesTheClassesThatAreChosen) {
  ASSERT_EQ(
      cls({"match", "mock", "mock", "--cycles", "300", "--seed", "1", "--dir", "m"}).exit_code, 0);
  const CommandResult made =
      cls({"book", "make", "m", "--classes", "build_up,build_up", "--out", "one.book", "--json"});
  ASSERT_EQ(made.exit_code, 0) << made.err;
  const json summary = json::parse(made.out);
  EXPECT_GT(summary["situations"], 0);
  EXPECT_EQ(summary["classes"]["build_up"], summary["situations"]);
  EXPECT_THAT(made.err, HasSubstr("--count 400: there are fewer moments; the book has "));

  const CommandResult shown = cls({"book", "show", "one.book"});
  EXPECT_THAT(shown.out, HasSubstr("(build_up "));
  EXPECT_THAT(cls({"book", "make", "m", "--classes", "attack,rest", "--out", "two.book"}),
              Exits(2, HasSubstr("--classes 'rest': must be one of attack, defense, set_play, "
                                 "turnover, build_up\n")));
  EXPECT_THAT(cls({"book", "make", "m", "--classes", "attack,defense,set_play,turnover,build_up",
                   "--count", "4", "--out", "two.book"}),
              Exits(2, HasSubstr("--count 4: less than one situation of each of 5 classes\n")));
}

}  // namespace
}  // namespace cls::tests
