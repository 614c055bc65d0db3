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
constexpr std::string_view kBody = "the player lies on the ground; no ball; wrong play mode";
constexpr std::string_view kSide = "arm locked, width unchanged, own uniform number";
constexpr std::string_view kWidth = "width unchanged";

constexpr std::array kReasons{
    Reason{"dash", kBody},
    Reason{"turn", kBody},
    Reason{"kick", kBody},
    Reason{"tackle", kBody},
    Reason{"catch", kBody},
    Reason{"move", kBody},
    Reason{"turn_neck", kSide},
    Reason{"change_view", kSide},
    Reason{"point_to", kSide},
    Reason{"point_to_of", kSide},
    Reason{"attention_to", kSide},
    Reason{"attention_to_of", kSide},
    Reason{"say",
           "it does not fit or cannot be encoded (unknown uniform number, value out of range)"},
    Reason{"log", "no field set"},
    Reason{"debug_client", "no field set"},
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
    Reason{"view_change_width", kWidth},
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
  constexpr std::string_view kNeck = "neck_";
  const auto found = std::find_if(kReasons.begin(), kReasons.end(),
                                  [action](const Reason& each) { return each.first == action; });
  if (found != kReasons.end()) return found->second;
  return action.substr(0, kNeck.size()) == kNeck ? "player unknown" : std::string_view();
}

}  // namespace cls::proxy
