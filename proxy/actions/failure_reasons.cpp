// Why actions fail; docs/actions.md has the same texts.
#include "proxy/actions/failure_reasons.h"

#include <algorithm>
#include <array>

namespace cls::proxy {
namespace {

struct Row {
  std::string_view reason;
  std::array<std::string_view, 8> actions;  // the rest is empty
};

constexpr std::array kRows{
    Row{"the player lies on the ground; a number is not finite", {"dash", "turn", "tackle"}},
    Row{"ball not kickable; the player lies on the ground; a number is not finite", {"kick"}},
    Row{"not the goalie; wrong play mode; ball unknown; the player lies on the ground", {"catch"}},
    Row{"wrong play mode; the player lies on the ground; a number is not finite", {"move"}},
    Row{"a number is not finite", {"turn_neck", "neck_turn_to_relative"}},
    Row{"width unchanged; no such width", {"change_view", "view_change_width"}},
    Row{"arm locked; own position unknown; a number is not finite", {"point_to"}},
    Row{"arm locked", {"point_to_of"}},
    Row{"own uniform number; no such uniform number", {"attention_to"}},
    Row{"it does not fit or cannot be encoded (unknown uniform number, value out of range)",
        {"say"}},
    Row{"no field set", {"log"}},
    Row{"already there",
        {"body_go_to_point", "body_go_to_point_dodge", "bhv_go_to_point_look_ball"}},
    Row{"first cycles of the match", {"bhv_before_kick_off"}},
    Row{"the player does not move", {"body_stop_dash"}},
    Row{"already facing (point, ball)",
        {"body_turn_to_angle", "body_turn_to_point", "body_turn_to_ball"}},
    Row{"the player lies on the ground",
        {"body_intercept", "body_dribble", "helios_basic_move", "helios_goalie",
         "helios_goalie_move", "bhv_goalie_free_kick", "helios_set_play",
         "helios_basic_offensive"}},
    Row{"ball not kickable",
        {"body_kick_one_step", "body_stop_ball", "body_hold_ball", "body_advance_ball",
         "body_clear_ball", "helios_goalie_kick"}},
    Row{"speed out of reach (the player holds the ball)", {"body_smart_kick"}},
    Row{"probability or speed too low", {"body_tackle_to_point"}},
    Row{"player unknown", {"neck_turn_to_ball_and_player", "neck_turn_to_player_or_scan"}},
    Row{"width unchanged", {"view_normal", "view_synch", "view_wide"}},
    Row{"own position unknown", {"focus_move_to_point", "focus_reset"}},
    Row{"no tackle would win the ball", {"helios_basic_tackle"}},
    Row{"no such shot exists", {"helios_shoot"}},
    Row{"no penalty shoot-out", {"helios_penalty"}},
    Row{"ball not kickable; no choice made with `server_side_decision`",
        {"helios_offensive_planner"}},
    Row{"no announced pass", {"bhv_do_heard_pass_recieve"}},
    Row{"ball not contested", {"bhv_do_force_kick"}},
    Row{"nothing seen", {"helios_communication"}},
};

}  // namespace

std::string_view fails_when(std::string_view action) {
  const auto* const found = std::ranges::find_if(kRows, [action](const Row& row) {
    return !action.empty() && std::ranges::find(row.actions, action) != row.actions.end();
  });
  return found != kRows.end() ? found->reason : std::string_view();
}

}  // namespace cls::proxy
