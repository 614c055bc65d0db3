// Decisions that were played again, for the page of their match.
#include "viewer/page/page_review.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "gamelog/rcg/rcg_reader.h"
#include "tests/support/files.h"
#include "viewer/page/match_page.h"

namespace cls::viewer {
namespace {

using base::Json;
using testing::HasSubstr;
using testing::Not;

Json decision(std::size_t match, const char* better) {
  const Json alternatives = {
      {{"decision", "hold"}, {"target", {1.0, 2.0}}, {"worths", {0.0, 0.25}}},
      {{"decision", "clear"}, {"target", {30.0, -4.0}}, {"worths", {0.5, 0.75}}}};
  return {{"match", match},
          {"cycle", 12},
          {"unum", 7},
          {"decision", "pass to 9"},
          {"better", better == nullptr ? Json() : Json(better)},
          {"cost", {{"value", 0.5}, {"low", 0.25}, {"high", 0.75}}},
          {"worths", {-1.0, 0.125}},
          {"alternatives", alternatives}};
}

// Two matches: the team is on the left of the first one, on the right of the second.
Json review() {
  const Json matches = {{{"file", "a/match.rcg"}, {"side", "left"}},
                        {{"file", "b/match.rcg"}, {"side", "right"}}};
  return {{"schema", "cls.review/1"},
          {"matches", matches},
          {"decisions", {decision(0, "clear"), decision(1, "hold"), decision(0, nullptr)}}};
}

std::string error_of(const std::string& text, const std::string& log = "a/match.rcg") {
  const auto read = page_review(text, log);
  return read ? "" : read.error().message;
}

TEST(PageReview, HasTheDecisionsOfItsMatchAsTheServerSeesThePitch) {
  const Json left = page_review(review().dump(), "a/match.rcg").value();
  ASSERT_EQ(left.size(), 1U) << "the others have nothing better, or are of the other match";
  EXPECT_EQ(left.at(0).dump(),
            R"({"cycle":12,"player":"l7","cost":[0.5,0.25,0.75],"better":2,"choices":[)"
            R"({"text":"pass to 9","target":null,"worths":[-1.0,0.125]},)"
            R"({"text":"hold","target":[1.0,2.0],"worths":[0.0,0.25]},)"
            R"({"text":"clear","target":[30.0,-4.0],"worths":[0.5,0.75]}]})");

  const Json right = page_review(review().dump(), "b/match.rcg").value();
  EXPECT_EQ(right.at(0)["player"], "r7");
  EXPECT_EQ(right.at(0)["choices"].at(2)["target"].dump(), "[-30.0,4.0]");
}

TEST(PageReview, NamesWhatIsWrong) {
  EXPECT_EQ(error_of(review().dump(), "c/match.rcg"),
            "has no decision of c/match.rcg that another one is better than");
  EXPECT_EQ(error_of("{\"schema\": \"cls.stats/1\"}"), "is not a review");
  for (const char* text : {"", "{", "[]", "7", "{\"schema\": \"cls.review/1\"}"}) {
    EXPECT_THAT(error_of(text), HasSubstr("is not a review")) << text;
  }

  // Whatever is missing or of another type.
  const std::string whole = review().dump();
  for (std::size_t at = 0; at < whole.size(); ++at) {
    static_cast<void>(error_of(whole.substr(0, at) + "9" + whole.substr(at + 1)));
  }
}

TEST(PageReview, IsPartOfTheSettingsOfAPage) {
  const auto record =
      gamelog::read_rcg_file(tests::fixture("gamelog/rcg-v6-excerpt.rcg.gz").string());
  ASSERT_TRUE(record);
  PageSettings settings;
  EXPECT_THAT(match_page(*record, nullptr, "match.rcg", {.settings = settings}),
              Not(HasSubstr("\"review\":")));
  settings.review = page_review(review().dump(), "a/match.rcg").value();
  EXPECT_THAT(match_page(*record, nullptr, "match.rcg", {.settings = settings}),
              HasSubstr("\"review\":[{\"cycle\":12,\"player\":\"l7\","));
}

}  // namespace
}  // namespace cls::viewer
