// Parameters: defaults, lookup, values from text.
#include "soccer/parameters/parameter.h"

#include <gtest/gtest.h>

#include "soccer/parameters/player_params.h"
#include "soccer/parameters/server_params.h"

namespace cls::soccer {
namespace {

int sent_to(int version) {
  int count = 0;
  for (const auto& row : server_param_table()) count += row.since <= version ? 1 : 0;
  return count;
}

TEST(ServerParams, HaveAsManyRowsPerVersionAsRcssserver) {
  EXPECT_EQ(sent_to(14), 187);
  EXPECT_EQ(sent_to(15), 188);
  EXPECT_EQ(sent_to(16), 194);
  EXPECT_EQ(sent_to(17), 196);
  EXPECT_EQ(sent_to(18), 196);
  EXPECT_EQ(sent_to(19), 200);
  EXPECT_EQ(sent_to(kAllVersions), 202);
  EXPECT_EQ(player_param_table().size(), 29u);
}

TEST(ServerParams, ConvertHalfTimeToCycles) {
  ServerParams params;
  EXPECT_EQ(params.half_time_cycles(), 3000);
  EXPECT_EQ(params.normal_time_cycles(), 6000);
  EXPECT_EQ(params.total_time_cycles(), 8000);
  params.half_time = 10;
  EXPECT_EQ(params.half_time_cycles(), 100);
  params.half_time = -1;
  EXPECT_LT(params.half_time_cycles(), 0);
}

TEST(SetParameter, AcceptsSpellingsOfRcssserver) {
  ServerParams params;
  const auto set = [&](std::string_view name, std::string_view text) {
    return set_parameter(params, server_param_table(), name, text);
  };

  EXPECT_TRUE(set("ball_decay", "0.9"));
  EXPECT_EQ(params.ball_decay, 0.9);
  EXPECT_TRUE(set("ball_decay", "1"));
  EXPECT_TRUE(set("half_time", "100.0"));
  EXPECT_EQ(params.half_time, 100);
  EXPECT_TRUE(set("synch_mode", "True"));
  EXPECT_TRUE(params.synch_mode);
  EXPECT_TRUE(set("synch_mode", "0"));
  EXPECT_FALSE(params.synch_mode);
  EXPECT_TRUE(set("game_log_dir", "'./a b'"));
  EXPECT_EQ(params.game_log_dir, "./a b");
}

TEST(SetParameter, ReportsInvalidNamesAndValues) {
  ServerParams params;
  const auto message = [&](std::string_view name, std::string_view text) {
    const auto result = set_parameter(params, server_param_table(), name, text);
    return result ? std::string("accepted") : result.error().message;
  };

  EXPECT_EQ(message("half_tine", "3"), "unknown parameter 'half_tine'; did you mean 'half_time'?");
  EXPECT_EQ(message("zzz", "3"), "unknown parameter 'zzz'");
  EXPECT_EQ(message("half_tiem", "3"), "unknown parameter 'half_tiem'; did you mean 'half_time'?");
  EXPECT_EQ(message("half_time", "3.5"), "parameter 'half_time': '3.5' is not a whole number");
  EXPECT_EQ(message("ball_decay", "fast"), "parameter 'ball_decay': 'fast' is not a number");
  EXPECT_EQ(message("ball_decay", "nan"), "parameter 'ball_decay': 'nan' is not a number");
  EXPECT_EQ(message("coach", "2"), "parameter 'coach': '2' is not on or off");
}

}  // namespace
}  // namespace cls::soccer
