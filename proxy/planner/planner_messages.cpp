// Converts plan nodes to protobuf messages.
#include "proxy/planner/planner_messages.h"

#include <algorithm>
#include <array>
#include <string>

#include "base/index.h"
#include "base/text/enum_names.h"
#include "proto/playmaker.pb.h"
#include "proxy/messages/state_message.h"

namespace cls::proxy {
namespace {

// By PlanCategory.
constexpr std::array kCategories = {protos::AC_Hold,    protos::AC_Dribble, protos::AC_Pass,
                                    protos::AC_Shoot,   protos::AC_Clear,   protos::AC_Move,
                                    protos::AC_NoAction};

constexpr auto kDescriptions = base::enum_names<player::PlanTag>(
    "Hold", "strictDirect", "strictLead", "strictThrough", "cross", "shortDribble", "SelfPass",
    "actgenDirect", "actgenDribble", "shoot");

void fill_action(const player::PlanNode& node, int index, protos::RpcCooperativeAction& out) {
  const player::PlanAction& action = node.action;
  out.set_category(kCategories.at(base::index(action.category)));
  out.set_index(index);
  out.set_sender_unum(action.sender);
  out.set_target_unum(action.target);
  fill(action.target_point, *out.mutable_target_point());
  out.set_first_ball_speed(action.first_speed);
  out.set_duration_step(action.duration);
  out.set_kick_count(action.kicks);
  out.set_turn_count(action.turns);
  out.set_dash_count(action.dashes);
  out.set_final_action(action.final);
  out.set_description(std::string(kDescriptions.name(action.tag)));
  out.set_parent_index(node.parent > 0 ? node.parent : -1);
}

void fill_state(const player::WorldModel& world, const player::PlanNode& node,
                protos::RpcPredictState& out) {
  out.set_spend_time(node.time);
  out.set_ball_holder_unum(node.holder);
  fill(node.ball, *out.mutable_ball_position());
  fill({}, *out.mutable_ball_velocity());
  out.set_our_defense_line_x(node.our_defense_line);
  double foremost = std::max(world.self.position.x, node.ball.x);
  for (const player::PlayerState& teammate : world.teammates) {
    if (teammate.position_valid()) foremost = std::max(foremost, teammate.position.x);
  }
  out.set_our_offense_line_x(foremost);
}

}  // namespace

void fill_planner_request(const player::WorldModel& world, const player::Plan& plan,
                          const protos::State& state, protos::BestPlannerActionRequest& out) {
  *out.mutable_register_response() = state.register_response();
  *out.mutable_state() = state;

  auto& pairs = *out.mutable_pairs();
  pairs.clear();
  int index = 0;
  for (const player::PlanNode& node : plan.nodes) {
    protos::RpcActionState& pair = pairs[index];
    fill_action(node, index++, *pair.mutable_action());
    fill_state(world, node, *pair.mutable_predict_state());
    pair.set_evaluation(node.value);
  }
}

int first_action_of(const player::Plan& plan, int chosen) {
  const bool known = chosen >= 0 && chosen < std::ssize(plan.nodes);
  return plan.first_of(known ? chosen : plan.best);
}

}  // namespace cls::proxy
