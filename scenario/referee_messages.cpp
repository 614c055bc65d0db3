// Referee messages: play modes, announcements, numbered messages.
#include "scenario/referee_messages.h"

#include <algorithm>
#include <array>

#include "base/text/number_text.h"
#include "soccer/play_mode.h"
#include "soccer/side.h"

namespace cls::scenario {
namespace {

constexpr std::array<std::string_view, 16> kAnnouncements = {
    "half_time",           "time_extended",       "time_up",        "time_up_without_a_team",
    "goalie_catch_ball_l", "goalie_catch_ball_r", "foul_l",         "foul_r",
    "penalty_onfield_l",   "penalty_onfield_r",   "penalty_foul_l", "penalty_foul_r",
    "penalty_winner_l",    "penalty_winner_r",    "penalty_draw",   "training Keepaway 1"};

/// A message that ends with the number of a goal or a player.
struct Numbered {
  std::string_view begin;
  int max;
};
constexpr int kMaxGoals = 1000;
constexpr std::array<Numbered, 6> kNumbered = {{{"goal_l_", kMaxGoals},
                                                {"goal_r_", kMaxGoals},
                                                {"yellow_card_l_", soccer::kPlayersPerTeam},
                                                {"yellow_card_r_", soccer::kPlayersPerTeam},
                                                {"red_card_l_", soccer::kPlayersPerTeam},
                                                {"red_card_r_", soccer::kPlayersPerTeam}}};

}  // namespace

bool is_referee_message(std::string_view message) {
  const auto& plain = referee_messages();
  if (std::ranges::find(plain, message) != plain.end()) return true;
  return std::ranges::any_of(kNumbered, [message](const Numbered& kind) {
    if (!message.starts_with(kind.begin)) return false;
    const auto number = base::parse_int(message.substr(kind.begin.size()));
    return number && *number >= 1 && *number <= kind.max;
  });
}

const std::vector<std::string_view>& referee_messages() {
  static const std::vector<std::string_view> messages = [] {
    std::vector<std::string_view> all(kAnnouncements.begin(), kAnnouncements.end());
    for (int i = 1; i < soccer::kPlayModeCount; ++i) {
      const auto mode = static_cast<soccer::PlayMode>(i);
      const bool goal = mode == soccer::PlayMode::kGoalLeft || mode == soccer::PlayMode::kGoalRight;
      if (!goal) all.push_back(name(mode));  // goal messages are numbered
    }
    all.insert(all.end(), {"goal_l_1", "goal_r_1", "yellow_card_l_1", "yellow_card_r_1",
                           "red_card_l_1", "red_card_r_1"});
    return all;
  }();
  return messages;
}

}  // namespace cls::scenario
