// Files with parameters of the planner: values, errors, and the file that `cls init` writes.
#include "match/terms/planner_file.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>
#include <string>

#include "base/io/whole_file.h"
#include "match/terms/endpoint.h"
#include "player/world/planner_parameters.h"
#include "tests/support/files.h"
#include "tests/support/temporary_folder.h"

namespace cls::match {
namespace {

using testing::HasSubstr;

std::string error_of(std::string_view text) {
  const auto parameters = parse_planner_file(text, "p.toml");
  return parameters ? "accepted" : parameters.error().message;
}

TEST(PlannerFile, SetsNamedParametersOnly) {
  const auto parameters = parse_planner_file(
      "# bolder\npass_margin = 0.1\n\nhold_cycles = 8\nx_weight = 2\npass_age = 7.0\n", "p.toml");
  ASSERT_TRUE(parameters) << parameters.error().message;
  EXPECT_EQ((*parameters)->pass_margin, 0.1);
  EXPECT_EQ((*parameters)->hold_cycles, 8);
  EXPECT_EQ((*parameters)->x_weight, 2.0);
  EXPECT_EQ((*parameters)->pass_age, 7);
  EXPECT_EQ((*parameters)->goal_weight, player::PlannerParameters().goal_weight);
}

TEST(PlannerFile, IsTheExampleAgainstStrongTeams) {
  const std::optional<std::string> text =
      base::read_file(tests::source_folder() / "examples/tuning/strong.toml");
  ASSERT_TRUE(text);
  const auto parameters = parse_planner_file(*text, "strong.toml");
  ASSERT_TRUE(parameters) << parameters.error().message;
  EXPECT_EQ((*parameters)->goalie_across, 1);
  EXPECT_EQ((*parameters)->fast_backs, 1);
}

TEST(PlannerFile, ReportsPlaceAndRemedyOfErrors) {
  EXPECT_EQ(error_of("x_weight = 1\npas_margin = 1\n"),
            "p.toml:2: unknown parameter 'pas_margin'; did you mean 'pass_margin'?");
  EXPECT_EQ(error_of("\npass_margin = 3.5"),
            "p.toml:2: pass_margin: must be a number from 0 to 3 (m)");
  EXPECT_EQ(error_of("pass_margin = nan"),
            "p.toml:1: pass_margin: must be a number from 0 to 3 (m)");
  EXPECT_EQ(error_of("hold_cycles = 2.5"),
            "p.toml:1: hold_cycles: must be a whole number from 0 to 100 (cycles)");
  EXPECT_EQ(error_of("x_weight = -9223372036854775808"),
            "p.toml:1: x_weight: must be a number from 0 to 10 (points/m)");
  EXPECT_EQ(error_of("x_weight = \"1\""), "p.toml:1: x_weight: must be a number");
  EXPECT_EQ(error_of("[evaluation]\nx_weight = 1"), "p.toml:1: evaluation: must be a number");
  EXPECT_EQ(error_of("x_weight = 99\nshift_normal = 99"),
            "p.toml:1: x_weight: must be a number from 0 to 10 (points/m)")
      << "the first one in the file";
  EXPECT_THAT(error_of("x_weight = 1\n="), testing::StartsWith("p.toml:2: "));
}

TEST(PlannerFile, OfALaterFormatIsRefused) {
  EXPECT_EQ(error_of("schema = 1\nx_weight = 1\n"), "accepted");
  EXPECT_EQ(error_of("schema = 2\nz_weight = 1\n"),
            "p.toml:1: schema 2 is newer than this cls reads (1); update cls");
  for (const char* schema : {"1e308", "1.0", "\"new\""}) {
    EXPECT_EQ(error_of(std::string("schema = ") + schema),
              "p.toml:1: schema: must be a whole number from 1 to 1")
        << schema;
  }
}

TEST(PlannerFile, CommentedFileHasAllDefaults) {
  const std::string text = commented_planner_file();
  const auto parsed = parse_planner_file(text, "p.toml");
  ASSERT_TRUE(parsed) << parsed.error().message;
  const player::PlannerParameters defaults;
  for (const player::PlannerParameter& row : player::planner_parameter_table()) {
    EXPECT_EQ(value_of(**parsed, row), value_of(defaults, row)) << row.name;
    EXPECT_THAT(text, HasSubstr("\n" + std::string(row.name) + " = ")) << row.name;
  }
  EXPECT_THAT(text, HasSubstr("\npass_margin = 0.35  # 0 to 3 m: extra reach of opponents"));
}

TEST(PlannerFile, IsReadWithItsSide) {
  const cls::tests::TemporaryFolder folder;
  const std::string file = (folder.path() / "p.toml").string();
  auto side = parse_endpoint("planner:" + file + "=mock:planner");
  const auto missing = load_files(*side);
  ASSERT_FALSE(missing);
  EXPECT_EQ(missing.error().message, file + ": no such file; `cls init --planner` writes one");
  EXPECT_EQ(missing_file(*side), file);
  ASSERT_TRUE(base::write_file(file, "cycle_cost = 0.5\n"));
  ASSERT_TRUE(load_files(*side));
  EXPECT_EQ(missing_file(*side), "");
  EXPECT_EQ(side->planner->cycle_cost, 0.5);
}

}  // namespace
}  // namespace cls::match
