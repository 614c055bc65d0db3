// Counts changes of the play mode.
#include "analysis/play/stoppages.h"

#include <algorithm>
#include <limits>

namespace cls::analysis {
namespace {

using soccer::PlayMode;
using soccer::Side;

constexpr std::size_t kTackleFrames = 2;  // frames before the foul
constexpr std::size_t kTackle = static_cast<std::size_t>(gamelog::Counter::kTackle);

int* counter_of(PlayMode mode, TeamStoppages& team) {
  if (soccer::side(mode) == Side::kNeutral) return nullptr;

  switch (soccer::for_side(mode, Side::kLeft)) {
    case PlayMode::kKickOffLeft:
      return &team.kick_offs;
    case PlayMode::kKickInLeft:
      return &team.kick_ins;
    case PlayMode::kCornerKickLeft:
      return &team.corners;
    case PlayMode::kGoalKickLeft:
      return &team.goal_kicks;
    case PlayMode::kFreeKickLeft:
      return &team.free_kicks;
    case PlayMode::kIndirectFreeKickLeft:
      return &team.indirect_free_kicks;
    case PlayMode::kOffsideLeft:
      return &team.offsides;
    case PlayMode::kFoulChargeLeft:
    case PlayMode::kFoulPushLeft:
      return &team.fouls;
    case PlayMode::kBackPassLeft:
      return &team.back_passes;
    case PlayMode::kFreeKickFaultLeft:
      return &team.free_kick_faults;
    case PlayMode::kCatchFaultLeft:
      return &team.catch_faults;
    case PlayMode::kIllegalDefenseLeft:
      return &team.illegal_defenses;
    default:
      return nullptr;
  }
}

bool is_foul(PlayMode mode) {
  return mode == PlayMode::kFoulChargeLeft || mode == PlayMode::kFoulChargeRight ||
         mode == PlayMode::kFoulPushLeft || mode == PlayMode::kFoulPushRight;
}

// A goalie's catch immediately leads to a free kick of the same side.
bool is_goalie_catch(const Flow& flow, std::size_t frame, std::size_t team) {
  const PlayMode mode = flow.record->mode[frame];
  if (mode != PlayMode::kFreeKickLeft && mode != PlayMode::kFreeKickRight) return false;

  for (const std::size_t slot : kTeamSlots[team]) {
    const std::uint32_t state = flow.record->players.state[entry_of(frame, slot)];
    if ((state & gamelog::kStateGoalie) != 0 && (state & gamelog::kStateCatch) != 0 &&
        (state & gamelog::kStateCatchFailed) == 0) {
      return true;
    }
  }
  return false;
}

// The player of the team that started a tackle within kTackleFrames, nearest to the ball.
std::int8_t fouler_of(const gamelog::MatchRecord& record, std::size_t frame, std::size_t team) {
  std::int8_t found = kNoPlayer;
  double nearest = std::numeric_limits<double>::max();
  const std::size_t first = frame > kTackleFrames ? frame - kTackleFrames : 1;

  for (const std::size_t slot : kTeamSlots[team]) {
    for (std::size_t i = first; i <= frame; ++i) {
      const std::size_t entry = entry_of(i, slot);
      const bool counted = record.players.counters[entry][kTackle] >
                           record.players.counters[entry - gamelog::kSlots][kTackle];
      const bool began =
          (record.players.state[entry] & gamelog::kStateTackle) != 0 &&
          (record.players.state[entry - gamelog::kSlots] & gamelog::kStateTackle) == 0;
      const double distance =
          soccer::distance(record.players.position[entry], record.ball_position[i]);

      if ((counted || began) && distance < nearest) {
        nearest = distance;
        found = static_cast<std::int8_t>(slot);
      }
    }
  }
  return found;
}

std::int8_t victim_of(const gamelog::MatchRecord& record, std::size_t frame, std::size_t team) {
  const std::size_t first = frame > kTackleFrames ? frame - kTackleFrames : 1;
  for (const std::size_t slot : kTeamSlots[team]) {
    for (std::size_t i = first; i <= std::min(frame + 1, record.frames() - 1); ++i) {
      const std::size_t entry = entry_of(i, slot);
      const std::uint32_t newly_set =
          record.players.state[entry] & ~record.players.state[entry - gamelog::kSlots];
      if ((newly_set & gamelog::kStateCharged) != 0) return static_cast<std::int8_t>(slot);
    }
  }
  return kNoPlayer;
}

void add_foul(const gamelog::MatchRecord& record, std::size_t frame, std::size_t team,
              Stoppages& result) {
  Foul foul;
  foul.frame = static_cast<std::uint32_t>(frame);
  foul.mode = record.mode[frame];
  foul.fouler = fouler_of(record, frame, team);
  foul.victim = victim_of(record, frame, 1 - team);
  if (foul.fouler != kNoPlayer) ++result.fouls_by[slot_index(foul.fouler)];
  if (foul.victim != kNoPlayer) ++result.fouls_against[slot_index(foul.victim)];
  result.fouls.push_back(foul);
}

void add_cards(const gamelog::MatchRecord& record, std::size_t frame, Stoppages& result) {
  for (std::size_t slot = 0; slot < gamelog::kSlots; ++slot) {
    const std::size_t entry = entry_of(frame, slot);
    const std::uint32_t newly_set =
        record.players.state[entry] & ~record.players.state[entry - gamelog::kSlots];
    const bool yellow = (newly_set & gamelog::kStateYellowCard) != 0;
    const bool red = (newly_set & gamelog::kStateRedCard) != 0;
    result.yellow_cards[slot] += yellow;
    result.red_cards[slot] += red;
    result.teams[team_of(slot)].yellow_cards += yellow;
    result.teams[team_of(slot)].red_cards += red;
  }
}

}  // namespace

Stoppages count_stoppages(const Flow& flow) {
  const gamelog::MatchRecord& record = *flow.record;
  Stoppages result;
  for (std::size_t i = 0; i < record.frames(); ++i) {
    if (i > 0) add_cards(record, i, result);

    const PlayMode mode = record.mode[i];
    const Side side = soccer::side(mode);
    if (side == Side::kNeutral) continue;
    const std::size_t team = side == Side::kLeft ? 0 : 1;
    result.teams[team].restart_frames += flow.phase[i] == Phase::kSet;
    if (i > 0 && record.mode[i - 1] == mode) continue;

    if (is_goalie_catch(flow, i, team)) {
      ++result.teams[team].goalie_catches;
    } else if (int* counter = counter_of(mode, result.teams[team])) {
      ++*counter;
    }

    if (is_foul(mode) && i > 0) add_foul(record, i, team, result);
  }
  return result;
}

}  // namespace cls::analysis
