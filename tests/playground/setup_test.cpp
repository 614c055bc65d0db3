// Setups as JSON, and the names of teams.
#include "playground/setup.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "analysis/situations/book_file.h"
#include "base/io/byte_sink.h"
#include "base/text/json.h"
#include "tests/support/error_of.h"

namespace cls::playground {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using tests::error_of;

TEST(PlaygroundSetup, ReadsAllMembers) {
  const auto setup = parse_setup(
      R"({"left": "mock:planner", "right": "function", "leftName": "A", "rightName": "B",)"
      R"( "seed": 9007199254740991, "cycles": 300, "set": ["server::wind_none=on"], "view": true, "decisions": true})");

  ASSERT_TRUE(setup) << setup.error().message;
  EXPECT_EQ(setup->sides.left, "mock:planner");
  EXPECT_EQ(setup->sides.right, kFunctionSide);
  EXPECT_EQ(setup->names.left, "A");
  EXPECT_EQ(setup->names.right, "B");
  EXPECT_EQ(setup->seed, 9007199254740991U);
  EXPECT_EQ(setup->cycles, 300);
  EXPECT_THAT(setup->settings, ElementsAre("server::wind_none=on"));
  EXPECT_TRUE(setup->view);
  EXPECT_TRUE(setup->decisions);
}

TEST(PlaygroundSetup, HasDefaultsForAllButTheSides) {
  const auto setup = parse_setup(R"({"left": "mock", "right": "mock"})");
  ASSERT_TRUE(setup);
  EXPECT_EQ(setup->seed, 0U);
  EXPECT_FALSE(setup->cycles);
  EXPECT_FALSE(setup->view);
  EXPECT_FALSE(setup->decisions);
}

TEST(PlaygroundSetup, NamesTheMemberThatIsWrong) {
  const auto error = [](const char* json) { return error_of(parse_setup(json)); };
  EXPECT_THAT(error(R"({"left": "mock"})"), HasSubstr("'right' is missing"));
  EXPECT_THAT(error(R"({"left": "mock", "right": "mock", "sed": 7})"), HasSubstr("seed"));
  EXPECT_THAT(error(R"({"left": "mock", "right": "mock", "seed": 1.5})"),
              HasSubstr("/seed: must be a whole number"));
  EXPECT_THAT(error(R"({"left": "mock", "right": "mock", "cycles": 0})"), HasSubstr("/cycles"));
  EXPECT_THAT(error(R"({"left": "mock", "right": "mock", "set": "server::coach=on"})"),
              HasSubstr("/set: must be an array"));
  EXPECT_THAT(error("{"), HasSubstr("match"));
}

TEST(PlaygroundSetup, ReadsABookOfSituations) {
  const auto error = [](const char* json) { return error_of(parse_setup(json)); };
  EXPECT_THAT(error(R"({"left": "mock", "right": "mock", "book": "{}", "cycles": 9})"),
              HasSubstr("/book: line 1: 'format' is missing"));

  analysis::Book book;
  book.logs.push_back({"match.rcg", {"a", "b"}, std::vector<soccer::PlayerType>(1)});
  book.situations.emplace_back().frames.resize(1);
  base::StringSink text;
  analysis::write_book(book, text);
  base::Json json = {{"left", "mock"}, {"right", "mock"}, {"book", text.bytes()}};
  EXPECT_THAT(error_of(parse_setup(json.dump())), HasSubstr("'book' needs 'situations'"));
  json["situations"] = 1;
  EXPECT_THAT(error_of(parse_setup(json.dump())), HasSubstr("'book' needs 'cycles'"));
  json["cycles"] = 30;
  const auto setup = parse_setup(json.dump());
  ASSERT_TRUE(setup) << setup.error().message;
  EXPECT_EQ(setup->book->situations.size(), 1U);
  EXPECT_EQ(setup->situations, 1);
}

TEST(PlaygroundSetup, NamesTeamsAsAMatchDoes) {
  MatchSetup setup;
  setup.sides = {"mock:planner", "mock:planner"};
  EXPECT_EQ(team_names(setup)->left, "planner_l");
  EXPECT_EQ(team_names(setup)->right, "planner_r");
  setup.sides.left = "mock";
  EXPECT_EQ(team_names(setup)->left, "mock");
  setup.names.right = "Red";
  EXPECT_EQ(team_names(setup)->right, "Red");
}

}  // namespace
}  // namespace cls::playground
