// Why actions fail, by action; docs/actions.md has the same texts.
#include "proxy/actions/failure_reasons.h"

#include <algorithm>
#include <array>
#include <utility>

namespace cls::proxy {
namespace {

using Reason = std::pair<std::string_view, std::string_view>;

constexpr std::string_view kLies = "the player lies on the ground";
constexpr std::string_view kNotKickable = "ball not kickable";
constexpr std::string_view kThere = "already there";
constexpr std::string_view kFacing = "already facing (point, ball)";
constexpr std::string_view kDown = "the player lies on the ground; a number is not finite";
constexpr std::string_view kWidth = "width unchanged";
constexpr std::string_view kAnyWidth = "width unchanged; no such width";
constexpr std::string_view kPlayer = "player unknown";

constexpr std::array kReasons{
    Reason{"dash", kDown},
    Reason{"turn", kDown},
    Reason{"kick", "ball not kickable; the player lies on the ground; a number is not finite"},
    Reason{"tackle", kDown},
    Reason{"catch", "not the goalie; wrong play mode; ball unknown; the player lies on the ground"},
    Reason{"move", "wrong play mode; the player lies on the ground; a number is not finite"},
    Reason{"turn_neck", "a number is not finite"},
    Reason{"change_view", kAnyWidth},
    Reason{"point_to", "arm locked; own position unknown; a number is not finite"},
    Reason{"point_to_of", "arm locked"},
    Reason{"attention_to", "own uniform number; no such uniform number"},
    Reason{"say",
           "it does not fit or cannot be encoded (unknown uniform number, value out of range)"},
    Reason{"log", "no field set"},
    Reason{"body_go_to_point", kThere},
    Reason{"body_go_to_point_dodge", kThere},
    Reason{"bhv_go_to_point_look_ball", kThere},
    Reason{"bhv_before_kick_off", "first cycles of the match"},
    Reason{"body_stop_dash", "the player does not move"},
    Reason{"body_turn_to_angle", kFacing},
    Reason{"body_turn_to_point", kFacing},
    Reason{"body_turn_to_ball", kFacing},
    Reason{"body_intercept", kLies},
    Reason{"body_kick_one_step", kNotKickable},
    Reason{"body_smart_kick", "speed out of reach (the player holds the ball)"},
    Reason{"body_stop_ball", kNotKickable},
    Reason{"body_hold_ball", kNotKickable},
    Reason{"body_dribble", kLies},
    Reason{"body_advance_ball", kNotKickable},
    Reason{"body_clear_ball", kNotKickable},
    Reason{"body_tackle_to_point", "probability or speed too low"},
    Reason{"neck_turn_to_ball_and_player", kPlayer},
    Reason{"neck_turn_to_player_or_scan", kPlayer},
    Reason{"neck_turn_to_relative", "a number is not finite"},
    Reason{"view_change_width", kAnyWidth},
    Reason{"view_normal", kWidth},
    Reason{"view_synch", kWidth},
    Reason{"view_wide", kWidth},
    Reason{"focus_move_to_point", "own position unknown"},
    Reason{"focus_reset", "own position unknown"},
    Reason{"helios_basic_move", kLies},
    Reason{"helios_basic_tackle", "no tackle would win the ball"},
    Reason{"helios_shoot", "no such shot exists"},
    Reason{"helios_goalie", kLies},
    Reason{"helios_goalie_move", kLies},
    Reason{"helios_goalie_kick", kNotKickable},
    Reason{"bhv_goalie_free_kick", kLies},
    Reason{"helios_set_play", kLies},
    Reason{"helios_penalty", "no penalty shoot-out"},
    Reason{"helios_offensive_planner",
           "ball not kickable; no choice made with `server_side_decision`"},
    Reason{"helios_basic_offensive", kLies},
    Reason{"bhv_do_heard_pass_recieve", "no announced pass"},
    Reason{"bhv_do_force_kick", "ball not contested"},
    Reason{"helios_communication", "nothing seen"},
};

}  // namespace

std::string_view fails_when(std::string_view action) {
  const auto found = std::find_if(kReasons.begin(), kReasons.end(),
                                  [action](const Reason& each) { return each.first == action; });
  return found != kReasons.end() ? found->second : std::string_view();
}

}  // namespace cls::proxy
