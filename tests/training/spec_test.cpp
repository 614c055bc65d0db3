// The catalog: documents, tables, and the page that shows them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "tests/support/files.h"
#include "tests/training/stage.h"
#include "training/pool/spec_tables.h"
#include "training/pool/specification.h"

namespace cls::tests {
namespace {

using testing::HasSubstr;

TEST(TrainingSpec, ManualShowsTheTables) {
  const std::string page = read_file(source_folder() / "docs" / "training.md");
  const std::string begin = "<!-- cls train spec --format markdown -->\n\n";
  const std::size_t first = page.find(begin);
  ASSERT_NE(first, std::string::npos);
  const std::size_t last = page.find("\n<!-- end -->", first);
  ASSERT_NE(last, std::string::npos);
  const std::string shown = page.substr(first + begin.size(), last - first - begin.size());
  EXPECT_EQ(shown, training::format_markdown(training::overview_tables()))
      << "copy the output of `cls train spec --format markdown` into docs/training.md";
}

TEST(TrainingSpec, NamesAreDistinct) {
  const auto names = training::spec_names();
  EXPECT_EQ(std::set<std::string_view>(names.begin(), names.end()).size(), names.size());
}

TEST(TrainingSpec, TablesHaveARowPerColumn) {
  const auto tables = training::tables_of(training::kEgoFeatures, 1, 2);
  const std::string text = training::format_text(tables, 0);
  for (const training::Column& column : training::kEgoFeatures.columns(1, 2)) {
    EXPECT_THAT(text, HasSubstr(" " + column.name + " ")) << column.name;
  }
}

TEST(TrainingSpec, CatalogNamesUnitsAndBounds) {
  const base::Json catalog = training::catalog();
  EXPECT_EQ(catalog["reward_version"], 1);
  for (const auto& term : catalog["reward_terms"]) {
    EXPECT_LT(term["low"].get<double>(), term["high"].get<double>()) << term["name"].dump();
    EXPECT_FALSE(term["unit"].get<std::string>().empty()) << term["name"].dump();
  }
  for (const auto& set : catalog["feature_sets"]) {
    for (const auto& column : set["items_1v1"]) {
      EXPECT_LT(column["low"].get<double>(), column["high"].get<double>()) << column["name"].dump();
    }
  }
}

TEST(TrainingSpec, RewardTermsStayWithinTheirBounds) {
  for (const char* config :
       {R"({"task": "HalfFieldOffense", "offense": 2, "defense": 2, "actions": "hfo",
            "autoreset": "next_step"})",
        R"({"task": "Match", "agents": "both", "actions": "hfo", "autoreset": "next_step"})"}) {
    BoundPool pool(config, 3);
    soccer::RandomStream random(5, "actions");
    for (int step = 0; step < 300; ++step) {
      pool.draw_actions(random);
      ASSERT_EQ(pool.step(), CLS_TRAINING_OK) << cls_training_error();
      for (std::size_t i = 0; i < training::kRewardTerms; ++i) {
        const training::RewardTerm& term = training::reward_terms()[i];
        ASSERT_GE(static_cast<double>(pool.reward_terms[i]), term.low - 1e-6) << term.name;
        ASSERT_LE(static_cast<double>(pool.reward_terms[i]), term.high + 1e-6) << term.name;
      }
    }
  }
}

}  // namespace
}  // namespace cls::tests
