// From the action that was executed to an option.
#include "match/hooks/played_option.h"

#include <algorithm>

#include "base/index.h"
#include "player/options/played_options.h"
#include "player/world/motion.h"
#include "proxy/actions/action_handlers.h"
#include "proxy/messages/state_message.h"
#include "soccer/geometry.h"

namespace cls::match {
namespace {

using protos::PlayerAction;
using soccer::Vec2;

/// The main action of the list that was executed; null: none.
const PlayerAction* executed_action(const proxy::Decision& decision) {
  const player::DecisionTrace& trace = decision.agent.trace();
  if (decision.reply == nullptr || trace.by != player::DecidedBy::kActions) return nullptr;

  const int tried =
      std::min(decision.reply->actions_size(), static_cast<int>(trace.outcomes.size()));
  for (int i = 0; i < tried; ++i) {
    const PlayerAction& action = decision.reply->actions(i);
    const bool main = proxy::action_entry(action.action_case()).kind == proxy::ActionClass::kMain;
    if (main && trace.outcomes[base::index(i)] == player::ActionOutcome::kExecuted) return &action;
  }
  return nullptr;
}

/// Where the ball would come to rest.
Vec2 target_of(const player::WorldModel& world, const protos::Kick& kick) {
  const Vec2 relative = world.ball.position - world.self.position;
  const double rate = player::kick_rate(world, relative, world.self.body);
  const double direction = world.self.body.degrees() + kick.relative_direction();
  const Vec2 velocity = world.ball.velocity + soccer::polar_degrees(kick.power() * rate, direction);
  return player::rest_point(world.ball.position, velocity, world.server().ball_decay);
}

int option_of_plan(const player::WorldModel& world, const player::OptionTable& table,
                   const player::PlanChoice& choice) {
  const bool replied = choice.chooser == player::PlanChoice::Chooser::kReplied && choice.node >= 0;
  return option_of_plan(world, table, choice.plan, replied ? choice.node : choice.plan.best);
}

int option_of_action(const PlayerAction& action, const player::WorldModel& world,
                     const player::OptionTable& table, const player::PlanChoice& choice) {
  switch (action.action_case()) {
    case PlayerAction::kHeliosOffensivePlanner:
    case PlayerAction::kHeliosBasicOffensive:
      return option_of_plan(world, table, choice);
    case PlayerAction::kHeliosShoot:
      return player::kShootOption;
    case PlayerAction::kKick:
      return option_of_kick(world, table, target_of(world, action.kick()));
    case PlayerAction::kBodySmartKick:
      return option_of_kick(world, table, proxy::vec(action.body_smart_kick().target_point()));
    case PlayerAction::kBodyKickOneStep:
      return option_of_kick(world, table, proxy::vec(action.body_kick_one_step().target_point()));
    case PlayerAction::kBodyDribble:
      return option_of_dribble(world, table, proxy::vec(action.body_dribble().target_point()));
    case PlayerAction::kBodyAdvanceBall:
    case PlayerAction::kBodyClearBall:
    case PlayerAction::kBhvDoForceKick:
      return player::kClearOption;
    case PlayerAction::kBodyHoldBall:
    case PlayerAction::kBodyStopBall:
    case PlayerAction::kTurn:
    case PlayerAction::kBodyTurnToAngle:
    case PlayerAction::kBodyTurnToBall:
    case PlayerAction::kBodyTurnToPoint:
      return player::kHoldOption;
    default:
      return -1;
  }
}

/// What a side without a Playmaker chose; -1: nothing.
int weighed_option(const player::PlanChoice& choice) {
  const auto chosen = std::ranges::find(choice.weighed, true, &player::WeighedOption::chosen);
  return chosen == choice.weighed.end() ? -1 : chosen->id;
}

}  // namespace

PlayedOption played_option(const proxy::Decision& decision, const player::OptionTable& table) {
  const proxy::PlayerAgent& agent = decision.agent;
  PlayedOption played;
  if (agent.has_own_play()) {
    played = {weighed_option(agent.plan()), "policy"};
  } else if (const PlayerAction* action = executed_action(decision)) {
    const auto* field = PlayerAction::descriptor()->FindFieldByNumber(action->action_case());
    played = {option_of_action(*action, agent.decision_world(), table, agent.plan()),
              field->name()};
  }
  if (played.id >= 0 && !table.legal[base::index(played.id)]) played.id = -1;
  return played;
}

}  // namespace cls::match
