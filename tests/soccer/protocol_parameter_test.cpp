// Parameter messages by table and client version.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "soccer/messages/parameter_message.h"

namespace cls::soccer {
namespace {

template <typename Params>
int pairs_for(int version) {
  std::string text;
  format(Params{}, version, text);
  return static_cast<int>(std::count(text.begin(), text.end(), '(')) - 1;
}

TEST(ParameterMessage, ContainsParametersOfClientVersion) {
  EXPECT_EQ(pairs_for<ServerParams>(14), 187);
  EXPECT_EQ(pairs_for<ServerParams>(15), 188);
  EXPECT_EQ(pairs_for<ServerParams>(16), 194);
  EXPECT_EQ(pairs_for<ServerParams>(17), 196);
  EXPECT_EQ(pairs_for<ServerParams>(18), 196);
  EXPECT_EQ(pairs_for<ServerParams>(19), 200);
  EXPECT_EQ(pairs_for<ServerParams>(kAllVersions), 202);
  EXPECT_EQ(pairs_for<PlayerParams>(14), 29);
  EXPECT_EQ(pairs_for<PlayerType>(14), 15);
  EXPECT_EQ(pairs_for<PlayerType>(18), 26);
  EXPECT_EQ(pairs_for<PlayerType>(19), 30);
}

TEST(ParameterMessage, FormatsDefaultTypeLikeRcssserver) {
  std::string text;
  format(PlayerType{}, 18, text);
  EXPECT_EQ(text,
            "(player_type (id 0)(player_speed_max 1.05)(stamina_inc_max 45)(player_decay 0.4)"
            "(inertia_moment 5)(dash_power_rate 0.006)(player_size 0.3)(kickable_margin 0.7)"
            "(kick_rand 0.1)(extra_stamina 50)(effort_max 1)(effort_min 0.6)"
            "(kick_power_rate 0.027)(foul_detect_probability 0.5)(catchable_area_l_stretch 1)"
            "(unum_far_length 20)(unum_too_far_length 40)(team_far_length 125.096)"
            "(team_too_far_length 125.096)(player_max_observation_length 125.096)"
            "(ball_vel_far_length 20)(ball_vel_too_far_length 40)"
            "(ball_max_observation_length 125.096)(flag_chg_far_length 20)"
            "(flag_chg_too_far_length 40)(flag_max_observation_length 125.096))");
}

TEST(ParameterMessage, ParsesAllTypesOfValues) {
  ServerParams params;

  ASSERT_TRUE(
      parse("(server_param (goal_width 7.32)(half_time -1)(synch_mode 1)(use_offside 0)"
            "(text_log_dir \"a dir)/(x\")(team_l_start \"\"))",
            params));
  EXPECT_EQ(params.goal_width, 7.32);
  EXPECT_EQ(params.half_time, -1);
  EXPECT_TRUE(params.synch_mode);
  EXPECT_FALSE(params.use_offside);
  EXPECT_EQ(params.text_log_dir, "a dir)/(x");
  EXPECT_EQ(params.ball_decay, 0.94);
}

// The end of a match fits an int, whatever a server sends.
TEST(ParameterMessage, LimitsLengthOfMatch) {
  ServerParams params;
  ASSERT_TRUE(
      parse("(server_param (half_time 2147483647)(nr_normal_halfs -2147483648)"
            "(extra_half_time 2147483647)(nr_extra_halfs -2147483648))",
            params));
  EXPECT_EQ(params.nr_normal_halfs, std::numeric_limits<int>::min());
  EXPECT_EQ(params.half_time_cycles(), 1 << 20);
  EXPECT_EQ(params.total_time_cycles(), -2000 * (1 << 20));
}

TEST(ParameterMessage, SkipsUnknownNames) {
  ServerParams params;
  ASSERT_TRUE(parse("(server_param (new_thing 1.5)(new_text \"(a) b\")(goal_width 7))", params));
  EXPECT_EQ(params.goal_width, 7);
}

TEST(ParameterMessage, ReportsByteOfError) {
  const auto error = [](std::string_view text) {
    ServerParams params;
    const base::Result<void> done = parse(text, params);
    return done ? "no error" : done.error().message;
  };

  EXPECT_EQ(error("(server_param (goal_width x))"),
            "server_param: byte 26: expected 'a number', found 'x))'");
  EXPECT_EQ(error("(server_param (synch_mode 2))"),
            "server_param: byte 26: expected '0 or 1', found '2))'");
  EXPECT_EQ(error("(server_param (half_time 1.5))"),
            "server_param: byte 26: expected ')', found '.5))'");
  EXPECT_EQ(error("(server_param (text_log_dir \"x))"),
            "server_param: byte 29: expected 'a closing quote', found 'x))'");
  EXPECT_EQ(error("(server_param (goal_width 7)"),
            "server_param: byte 28: expected ')', found the end");
}

}  // namespace
}  // namespace cls::soccer
