// Detects touches from counters, and assigns the ball to the last toucher.
#include "analysis/play/flow.h"

#include <limits>
#include <optional>

namespace cls::analysis {
namespace {

using gamelog::Counter;
using gamelog::RcgVersion;

// A larger displacement than ball_speed_max plus this margin (m) means that the ball was placed.
constexpr double kPlacedMargin = 0.3;
// Above this speed (m per cycle) a free ball cannot stop within one step.
constexpr double kStillRolls = 1e-3;

// Counters only grow until another match begins.
bool follows(const gamelog::MatchRecord& record, std::size_t frame) {
  return frame > 0 && record.time[frame] >= record.time[frame - 1];
}

// True for a state with the bit of a command, and without that of its failure.
bool succeeded(std::uint32_t state, std::uint32_t command, std::uint32_t failure) {
  return (state & (command | failure)) == command;
}

// A player's touch between two frames. Versions 1 and 2 have no counters and version 3 none for
// tackles: the state bits are used.
std::optional<TouchKind> touch_kind(const gamelog::MatchRecord& record, std::size_t entry) {
  const std::uint32_t now = record.players.state[entry];
  const std::uint32_t before = record.players.state[entry - gamelog::kSlots];
  if ((before & now & gamelog::kStateEnabled) == 0) return std::nullopt;

  const auto executed = [&](Counter command, RcgVersion first_counted, bool by_state) {
    return record.version >= first_counted ? has_executed(record, command, entry) : by_state;
  };

  if (executed(Counter::kKick, RcgVersion::kV3,
               succeeded(now, gamelog::kStateKick, gamelog::kStateKickFailed))) {
    return TouchKind::kKick;
  }

  if (succeeded(now, gamelog::kStateTackle, gamelog::kStateTackleFailed) &&
      executed(Counter::kTackle, RcgVersion::kV4, (before & gamelog::kStateTackle) == 0)) {
    return TouchKind::kTackle;
  }

  if ((now & gamelog::kStateCatch) != 0 &&
      executed(Counter::kCatch, RcgVersion::kV3,
               has_caught(now) && (before & gamelog::kStateCatch) == 0)) {
    return has_caught(now) ? TouchKind::kCatch : TouchKind::kPunch;
  }
  return std::nullopt;
}

// The logged velocity is zero if the referee stops the ball in the same step. The displacement is
// not, unless the ball was placed.
soccer::Vec2 launch_of(const gamelog::MatchRecord& record, std::size_t frame) {
  const soccer::Vec2 moved =
      soccer::Vec2(record.ball_position[frame]) - record.ball_position[frame - 1];
  if (moved.length() <= record.server.ball_speed_max + kPlacedMargin) return moved;
  return soccer::Vec2(record.ball_velocity[frame]) / record.server.ball_decay;
}

// In play_on the referee drops a stuck ball and a trainer may move the ball. No play mode shows
// this, but the ball jumps or stops abruptly.
bool was_placed(const gamelog::MatchRecord& record, std::size_t frame) {
  const soccer::Vec2 before = record.ball_velocity[frame - 1];
  const soccer::Vec2 now = record.ball_velocity[frame];
  const double moved =
      soccer::distance(record.ball_position[frame], record.ball_position[frame - 1]);
  return moved > record.server.ball_speed_max + kPlacedMargin ||
         (now == soccer::Vec2{} && before.length() > kStillRolls);
}

// The touch in the step to `frame` by all its touchers.
std::optional<Touch> touch_in(const gamelog::MatchRecord& record, std::size_t frame) {
  Touch touch;
  const soccer::Vec2 ball = record.ball_position[frame - 1];
  PerTeam<double> nearest;
  nearest.fill(std::numeric_limits<double>::max());
  PerTeam<TouchKind> kinds = {};

  for (std::size_t slot = 0; slot < gamelog::kSlots; ++slot) {
    const std::size_t entry = entry_of(frame, slot);
    const auto kind = touch_kind(record, entry);
    if (!kind) continue;

    touch.touchers |= std::uint32_t{1} << slot;
    const std::size_t team = team_of(slot);
    const double distance =
        soccer::distance(record.players.position[entry - gamelog::kSlots], ball);

    if (distance >= nearest[team]) continue;
    nearest[team] = distance;
    touch.nearest[team] = static_cast<std::int8_t>(slot);
    kinds[team] = *kind;
  }

  if (touch.touchers == 0) return std::nullopt;
  const bool both = touch.nearest[0] != kNoPlayer && touch.nearest[1] != kNoPlayer;
  const std::size_t first = nearest[0] <= nearest[1] ? 0 : 1;
  touch.slot = both ? kNoPlayer : touch.nearest[first];
  touch.kind = kinds[first];
  touch.frame = static_cast<std::uint32_t>(frame);
  touch.contact = ball;
  touch.launch = launch_of(record, frame);
  return touch;
}

void find_phases(Flow& flow) {
  const gamelog::MatchRecord& record = *flow.record;
  std::int32_t phases = 0;

  for (std::size_t i = 0; i < record.frames(); ++i) {
    flow.phase.push_back(phase_of(record.mode[i]));
    bool continues = i > 0 && flow.is_live(i) && flow.is_live(i - 1) && follows(record, i);
    if (continues && was_placed(record, i)) {
      flow.placed.push_back(static_cast<std::uint32_t>(i));
      continues = false;
    }

    if (flow.is_live(i) && !continues) ++phases;
    flow.live_phase.push_back(flow.is_live(i) ? phases - 1 : -1);
  }
}

// A goal kick is in play when it leaves the penalty area: the touch precedes its live phase by some
// frames.
void attach_goal_kick(Flow& flow, std::size_t frame) {
  if (flow.touches.empty() || flow.phase[frame - 1] != Phase::kSet) return;
  Touch& touch = flow.touches.back();
  if (touch.live_phase >= 0 || flow.phase[touch.frame] != Phase::kSet) return;
  for (std::size_t i = touch.frame; i < frame; ++i) {
    if (flow.record->mode[i] != flow.record->mode[touch.frame]) return;
  }
  touch.live_phase = flow.live_phase[frame];
  flow.owner[frame] = touch.slot;
}

}  // namespace

Phase phase_of(soccer::PlayMode mode) {
  if (mode == soccer::PlayMode::kPlayOn) return Phase::kLive;
  if (mode == soccer::PlayMode::kTimeOver) return Phase::kOver;
  if (soccer::is_set_play(mode)) return Phase::kSet;
  if (soccer::is_penalty_mode(mode)) return Phase::kPenalty;
  return Phase::kStopped;
}

std::size_t Flow::end_of_play(const Touch& touch) const {
  std::size_t frame = touch.frame;
  const bool ends_here =
      live_phase[frame] != touch.live_phase && live_phase[frame - 1] == touch.live_phase;
  if (ends_here) return frame;
  // The live phase of a goal kick begins some frames after the touch.
  while (frame < live_phase.size() && live_phase[frame] != touch.live_phase) ++frame;
  while (frame < live_phase.size() && live_phase[frame] == touch.live_phase) ++frame;
  return frame;
}

bool was_goalie(const gamelog::MatchRecord& record, std::size_t slot) {
  for (std::size_t frame = 0; frame < record.frames(); ++frame) {
    if (is_goalie(record, entry_of(frame, slot))) return true;
  }
  return false;
}

Flow build_flow(const gamelog::MatchRecord& record) {
  Flow flow;
  flow.record = &record;
  find_phases(flow);
  flow.owner.assign(record.frames(), kNoPlayer);

  for (std::size_t i = 1; i < record.frames(); ++i) {
    if (!follows(record, i)) continue;
    const bool live = flow.is_live(i);
    const bool continues = live && flow.live_phase[i] == flow.live_phase[i - 1];
    const bool begins = live && !flow.is_live(i - 1);
    if (continues) flow.owner[i] = flow.owner[i - 1];

    auto touch = touch_in(record, i);
    if (touch) {
      // If the referee then placed the ball, the touch ends the previous phase.
      touch->live_phase = flow.live_phase[begins ? i : i - 1];
      if (continues || begins) flow.owner[i] = touch->slot;
      flow.touches.push_back(*touch);
    } else if (live && !continues) {
      attach_goal_kick(flow, i);
    }
  }
  return flow;
}

const soccer::PlayerType& type_of(const gamelog::MatchRecord& record, std::size_t entry) {
  static const soccer::PlayerType kDefault;
  const int type = record.players.type[entry];
  return type >= 0 && type < std::ssize(record.types) ? record.types[base::index(type)] : kDefault;
}

double kickable_radius(const gamelog::MatchRecord& record, std::size_t entry) {
  return type_of(record, entry).kickable_area(record.server.ball_size);
}

}  // namespace cls::analysis
