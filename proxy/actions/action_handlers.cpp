// From action messages to skills, one table entry per action.
#include "proxy/actions/action_handlers.h"

#include <array>
#include <optional>
#include <utility>

#include "base/index.h"
#include "player/ball_skills/ball_skills.h"
#include "player/behaviors/behaviors.h"
#include "player/looking/looking.h"
#include "player/movement/movement.h"
#include "player/planner/plan_execution.h"
#include "proxy/messages/say_payload.h"
#include "proxy/messages/state_message.h"
#include "proxy/planner/offensive_planner.h"

namespace cls::proxy {
namespace {

using soccer::AngleDeg;
using soccer::Vec2;
using soccer::ViewWidth;

using Action = protos::PlayerAction;
using Context = ReplyContext;

soccer::Side side(protos::Side side) {
  return side == protos::RIGHT ? soccer::Side::kRight : soccer::Side::kLeft;
}

/// The player named by a neck action; null when not tracked.
const player::PlayerState* player(const player::WorldModel& world, protos::Side team, int unum) {
  return side(team) == world.our_side ? world.teammate(unum) : world.opponent(unum);
}

bool change_width(Context& c, protos::ViewWidth wanted) {
  for (const auto& [width, wire] : {std::pair{ViewWidth::kNarrow, protos::NARROW},
                                    {ViewWidth::kNormal, protos::NORMAL},
                                    {ViewWidth::kWide, protos::WIDE}}) {
    if (wire == wanted) return c.slots.change_view(width);
  }
  return false;
}

bool say(const protos::Say& say, Context& c) {
  const std::size_t kind = base::index(say.message_case());
  player::ActionCounts& counts = c.report.say[kind < c.report.say.size() ? kind : 0];

  const std::optional<player::SayMessage> message = say_message_of(say, c.world.server());
  if (!message) {
    ++counts.unimplemented;  // member of a later interface
    return false;
  }

  std::string text;
  const bool fits = append_say_message(*message, c.world.server(), text) && c.slots.say(text);
  ++(fits ? counts.done : counts.failed);
  return fits;
}

bool offensive_planner(const protos::HeliosOffensivePlanner& action, Context& c) {
  const bool can_kick = c.world.self.kickable && !c.world.self.frozen();
  if (can_kick && must_leave_ball(c.world, c.memory)) return leave_ball(c);
  return run_offensive_planner(action, c);
}

/// Default plan with the ball, otherwise basic move.
bool basic_offensive(Context& c) {
  if (c.world.self.kickable && must_leave_ball(c.world, c.memory)) return leave_ball(c);
  if (execute_default_plan(c)) return true;
  if (c.world.self.kickable) return hold_ball(c.world, c.slots, false, {});
  return basic_move(c);
}

bool basic_tackle_and_look(const protos::HeliosBasicTackle& action, Context& c) {
  if (!basic_tackle(c.world, c.slots, action.min_prob())) return false;
  c.neck.kind = player::NeckPlan::Kind::kBall;
  return true;
}

bool kick_and_scan(bool kicked, Context& c) {
  if (kicked) c.neck.kind = player::NeckPlan::Kind::kScan;
  return kicked;
}

bool dribble(const protos::Body_Dribble& action, Context& c) {
  return dribble(
      c.world, c.memory.intention, c.slots, vec(action.target_point()),
      {action.distance_threshold(), action.dash_power(), action.dash_count(), action.dodge()});
}

bool hold(const protos::Body_HoldBall& action, Context& c) {
  return hold_ball(c.world, c.slots, action.do_turn(), vec(action.turn_target_point()));
}

constexpr ActionClass kMain = ActionClass::kMain;
constexpr ActionClass kSide = ActionClass::kSide;

// clang-format off
// Inside an expression, m is the member's message and c the context; w, v and s are its world,
// view memory and command slots.
#define CLS_ACTION(kind, member, name, expression)                             \
  ActionEntry{Action::member, kind,                                            \
              [](const Action& action, [[maybe_unused]] Context& c) -> bool {  \
                [[maybe_unused]] const auto& m = action.name();                \
                [[maybe_unused]] const player::WorldModel& w = c.world;        \
                [[maybe_unused]] auto& v = c.memory.view;                      \
                [[maybe_unused]] player::CommandSlots& s = c.slots;            \
                return expression;                                             \
              }}
#define CLS_MAIN(...) CLS_ACTION(kMain, __VA_ARGS__)
#define CLS_SIDE(...) CLS_ACTION(kSide, __VA_ARGS__)

/// In the order of PlayerAction; null: no member set.
constexpr std::array kEntries{
    ActionEntry{Action::ACTION_NOT_SET, kSide, nullptr},
    CLS_MAIN(kDash, dash, s.dash(m.power(), m.relative_direction())),
    CLS_MAIN(kTurn, turn, s.turn(m.relative_direction())),
    CLS_MAIN(kKick, kick, s.kick(m.power(), m.relative_direction())),
    CLS_MAIN(kTackle, tackle, s.tackle(m.power_or_dir(), m.foul())),
    CLS_MAIN(kCatch, catch_, s.catch_ball()),
    CLS_MAIN(kMove, move, s.move({m.x(), m.y()})),
    CLS_SIDE(kTurnNeck, turn_neck, s.turn_neck(m.moment())),
    CLS_SIDE(kChangeView, change_view, change_width(c, m.view_width())),
    CLS_SIDE(kSay, say, say(m, c)),
    CLS_SIDE(kPointTo, point_to, s.point_to({m.x(), m.y()})),
    CLS_SIDE(kPointToOf, point_to_of, s.point_to_off()),
    CLS_SIDE(kAttentionTo, attention_to, s.attention_to(side(m.side()), m.unum())),
    CLS_SIDE(kAttentionToOf, attention_to_of, s.attention_to_off()),
    CLS_SIDE(kLog, log, m.log_case() != protos::Log::LOG_NOT_SET),
    CLS_SIDE(kDebugClient, debug_client, true),
    CLS_MAIN(kBodyGoToPoint, body_go_to_point,
             go_to_point(w, s, vec(m.target_point()), m.distance_threshold(), m.max_dash_power())),
    CLS_MAIN(kBodySmartKick, body_smart_kick,
             smart_kick(w, s, vec(m.target_point()), m.first_speed(), m.first_speed_threshold(),
                 m.max_steps())),
    CLS_MAIN(kBhvBeforeKickOff, bhv_before_kick_off, before_kick_off(w, v, s, vec(m.point()))),
    CLS_MAIN(kBhvBodyNeckToBall, bhv_body_neck_to_ball, body_neck_to_ball(w, v, s)),
    CLS_MAIN(kBhvBodyNeckToPoint, bhv_body_neck_to_point,
             body_neck_to_point(w, v, s, vec(m.point()))),
    CLS_SIDE(kBhvEmergency, bhv_emergency, emergency(w, v, s)),
    CLS_MAIN(kBhvGoToPointLookBall, bhv_go_to_point_look_ball,
             go_to_point_look_ball(w, v, s, c.neck, vec(m.target_point()),
                 m.distance_threshold(), m.max_dash_power())),
    CLS_MAIN(kBhvNeckBodyToBall, bhv_neck_body_to_ball, neck_body_to_ball(w, v, s, m.angle_buf())),
    CLS_MAIN(kBhvNeckBodyToPoint, bhv_neck_body_to_point,
             neck_body_to_point(w, v, s, vec(m.point()), m.angle_buf())),
    CLS_MAIN(kBhvScanField, bhv_scan_field, scan_field(w, v, s)),
    CLS_MAIN(kBodyAdvanceBall, body_advance_ball, advance_ball(w, s)),
    CLS_MAIN(kBodyClearBall, body_clear_ball, clear_ball(w, s)),
    CLS_MAIN(kBodyDribble, body_dribble, dribble(m, c)),
    CLS_MAIN(kBodyGoToPointDodge, body_go_to_point_dodge,
             go_to_point_dodge(w, s, vec(m.target_point()), m.dash_power())),
    CLS_MAIN(kBodyHoldBall, body_hold_ball, hold(m, c)),
    CLS_MAIN(kBodyIntercept, body_intercept,
             intercept(w, s, m.save_recovery(), vec(m.face_point()))),
    CLS_MAIN(kBodyKickOneStep, body_kick_one_step,
             kick_one_step(w, s, vec(m.target_point()), m.first_speed(), m.force_mode())),
    CLS_MAIN(kBodyStopBall, body_stop_ball, stop_ball(w, s)),
    CLS_MAIN(kBodyStopDash, body_stop_dash, stop_dash(w, s, m.save_recovery())),
    CLS_MAIN(kBodyTackleToPoint, body_tackle_to_point,
             tackle_to_point(w, s, vec(m.target_point()), m.min_probability(), m.min_speed())),
    CLS_MAIN(kBodyTurnToAngle, body_turn_to_angle, turn_to_angle(w, s, AngleDeg(m.angle()))),
    CLS_MAIN(kBodyTurnToBall, body_turn_to_ball, turn_to_ball(w, s, m.cycle())),
    CLS_MAIN(kBodyTurnToPoint, body_turn_to_point,
             turn_to_point(w, s, vec(m.target_point()), m.cycle())),
    CLS_SIDE(kFocusMoveToPoint, focus_move_to_point, focus_to_point(w, s, vec(m.target_point()))),
    CLS_SIDE(kFocusReset, focus_reset, focus_reset(w, s)),
    CLS_SIDE(kNeckScanField, neck_scan_field, neck_scan_field(w, v, s)),
    CLS_SIDE(kNeckScanPlayers, neck_scan_players, neck_scan_players(w, v, s)),
    CLS_SIDE(kNeckTurnToBallAndPlayer, neck_turn_to_ball_and_player,
             neck_turn_to_ball_and_player(w, v, s, player(w, m.side(), m.uniform_number()),
                 m.count_threshold())),
    CLS_SIDE(kNeckTurnToBallOrScan, neck_turn_to_ball_or_scan,
             neck_turn_to_ball_or_scan(w, v, s, m.count_threshold())),
    CLS_SIDE(kNeckTurnToBall, neck_turn_to_ball, neck_turn_to_ball(w, v, s)),
    CLS_SIDE(kNeckTurnToGoalieOrScan, neck_turn_to_goalie_or_scan,
             neck_turn_to_goalie_or_scan(w, v, s, m.count_threshold())),
    CLS_SIDE(kNeckTurnToLowConfTeammate, neck_turn_to_low_conf_teammate,
             neck_turn_to_low_conf_teammate(w, v, s)),
    CLS_SIDE(kNeckTurnToPlayerOrScan, neck_turn_to_player_or_scan,
             neck_turn_to_player_or_scan(w, v, s, player(w, m.side(), m.uniform_number()),
                 m.count_threshold())),
    CLS_SIDE(kNeckTurnToPoint, neck_turn_to_point,
             neck_turn_to_point(w, v, s, vec(m.target_point()))),
    CLS_SIDE(kNeckTurnToRelative, neck_turn_to_relative, neck_turn_to_relative(w, s, m.angle())),
    CLS_SIDE(kViewChangeWidth, view_change_width, change_width(c, m.view_width())),
    CLS_SIDE(kViewNormal, view_normal, s.change_view(ViewWidth::kNormal)),
    CLS_SIDE(kViewSynch, view_synch, view_synch(s)),
    CLS_SIDE(kViewWide, view_wide, s.change_view(ViewWidth::kWide)),
    CLS_MAIN(kHeliosGoalie, helios_goalie, play_goalie(c)),
    CLS_MAIN(kHeliosGoalieMove, helios_goalie_move, goalie_move(c)),
    CLS_MAIN(kHeliosGoalieKick, helios_goalie_kick, goalie_kick(c)),
    CLS_MAIN(kHeliosShoot, helios_shoot, shoot_and_look(c)),
    CLS_MAIN(kHeliosOffensivePlanner, helios_offensive_planner, offensive_planner(m, c)),
    CLS_MAIN(kHeliosBasicOffensive, helios_basic_offensive, basic_offensive(c)),
    CLS_MAIN(kHeliosBasicMove, helios_basic_move, basic_move(c)),
    CLS_MAIN(kHeliosSetPlay, helios_set_play, play_set_play(c)),
    CLS_MAIN(kHeliosPenalty, helios_penalty, play_penalty(c)),
    CLS_SIDE(kHeliosCommunication, helios_communication, communicate(c)),
    CLS_MAIN(kBhvDoForceKick, bhv_do_force_kick, kick_and_scan(force_kick(w, s), c)),
    CLS_MAIN(kBhvDoHeardPassRecieve, bhv_do_heard_pass_recieve, receive_heard_pass(c)),
    CLS_MAIN(kHeliosBasicTackle, helios_basic_tackle, basic_tackle_and_look(m, c)),
    CLS_SIDE(kNeckOffensiveInterceptNeck, neck_offensive_intercept_neck,
             neck_offensive_intercept(w, v, s)),
    CLS_MAIN(kBhvGoalieFreeKick, bhv_goalie_free_kick, goalie_free_kick(c)),
};
#undef CLS_SIDE
#undef CLS_MAIN
#undef CLS_ACTION
// clang-format on

constexpr bool in_field_order() {
  for (std::size_t i = 0; i < kEntries.size(); ++i) {
    if (base::index(kEntries[i].member) != i) return false;
  }
  return true;
}
static_assert(kEntries.size() == player::kActionKinds && in_field_order());

}  // namespace

const ActionEntry& action_entry(int member) {
  return kEntries[member > 0 && member < std::ssize(kEntries) ? base::index(member) : 0];
}

}  // namespace cls::proxy
