// Acting before the Playmaker does.
#include "proxy/actions/preprocess.h"

#include "proxy/looking/looking.h"
#include "proxy/looking/view.h"
#include "proxy/movement/home_positions.h"
#include "proxy/movement/movement.h"

namespace cls::proxy {
namespace {

using soccer::PlayMode;

bool no_play(PlayMode mode) {
  return mode == PlayMode::kBeforeKickOff || mode == PlayMode::kGoalLeft ||
         mode == PlayMode::kGoalRight;
}

bool ball_lost(const WorldModel& world) {
  const int limit = world.goalie ? 10 : 5;
  const int seen_limit = world.goalie ? 20 : 15;
  return world.ball.pos_count > limit ||
         (world.game.mode != PlayMode::kPlayOn && world.ball.seen_pos_count > seen_limit);
}

}  // namespace

std::optional<PreprocessReason> preprocess_reason(const WorldModel& world) {
  if (world.self.frozen()) return PreprocessReason::kFrozen;
  if (no_play(world.game.mode)) return PreprocessReason::kNoPlay;
  if (!world.self.position_valid()) return PreprocessReason::kPlaceUnknown;
  if (ball_lost(world)) return PreprocessReason::kBallLost;
  return std::nullopt;
}

void preprocess(PreprocessReason reason, const WorldModel& world, const SightMemory& sight,
                CommandSlots& slots, NeckPlan& neck) {
  switch (reason) {
    case PreprocessReason::kFrozen:
      view_tactical(world, slots);
      neck.kind = NeckPlan::Kind::kBallOrScan;
      return;
    case PreprocessReason::kNoPlay:
      view_tactical(world, slots);
      before_kick_off(world, sight, slots, own_home_position(world));
      return;
    case PreprocessReason::kPlaceUnknown:
      emergency(world, sight, slots);
      return;
    case PreprocessReason::kBallLost:
      view_tactical(world, slots);
      if (world.ball.ghost_count > 0) {
        scan_field(world, sight, slots);  // it is not where we believe it
      } else {
        neck_body_to_ball(world, sight, slots, 0.0);
      }
      return;
  }
}

}  // namespace cls::proxy
