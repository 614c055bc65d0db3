// Counts changes of the play mode.
#include "analysis/play/stoppages.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace cls::analysis {
namespace {

using soccer::PlayMode;
using soccer::Side;

constexpr std::size_t kTackleFrames = 2;  // frames before the foul

// The counter of a team's play mode; the modes of the right team are those of the left one.
using CounterOfMode = std::pair<PlayMode, int TeamStoppages::*>;
constexpr CounterOfMode kCounters[] = {
    {PlayMode::kKickOffLeft, &TeamStoppages::kick_offs},
    {PlayMode::kKickInLeft, &TeamStoppages::kick_ins},
    {PlayMode::kCornerKickLeft, &TeamStoppages::corners},
    {PlayMode::kGoalKickLeft, &TeamStoppages::goal_kicks},
    {PlayMode::kFreeKickLeft, &TeamStoppages::free_kicks},
    {PlayMode::kIndirectFreeKickLeft, &TeamStoppages::indirect_free_kicks},
    {PlayMode::kOffsideLeft, &TeamStoppages::offsides},
    {PlayMode::kFoulChargeLeft, &TeamStoppages::fouls},
    {PlayMode::kFoulPushLeft, &TeamStoppages::fouls},
    {PlayMode::kBackPassLeft, &TeamStoppages::back_passes},
    {PlayMode::kFreeKickFaultLeft, &TeamStoppages::free_kick_faults},
    {PlayMode::kCatchFaultLeft, &TeamStoppages::catch_faults},
    {PlayMode::kIllegalDefenseLeft, &TeamStoppages::illegal_defenses},
};

// A goalie's catch immediately leads to a free kick of the same side.
bool is_goalie_catch(const Flow& flow, std::size_t frame, std::size_t team) {
  if (soccer::without_side(flow.record->mode[frame]) != PlayMode::kFreeKickLeft) return false;

  return std::ranges::any_of(kTeamSlots[team], [&](std::size_t slot) {
    const std::size_t entry = entry_of(frame, slot);
    return is_goalie(*flow.record, entry) && has_caught(flow.record->players.state[entry]);
  });
}

// The player of the team that started a tackle within kTackleFrames, nearest to the ball.
std::int8_t fouler_of(const gamelog::MatchRecord& record, std::size_t frame, std::size_t team) {
  std::int8_t found = kNoPlayer;
  double nearest = std::numeric_limits<double>::max();
  const std::size_t first = frame > kTackleFrames ? frame - kTackleFrames : 1;

  for (const std::size_t slot : kTeamSlots[team]) {
    for (std::size_t i = first; i <= frame; ++i) {
      const std::size_t entry = entry_of(i, slot);
      const bool counted = has_executed(record, gamelog::Counter::kTackle, entry);
      const bool began = (newly_set(record, entry) & gamelog::kStateTackle) != 0;
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
      if ((newly_set(record, entry_of(i, slot)) & gamelog::kStateCharged) != 0) {
        return static_cast<std::int8_t>(slot);
      }
    }
  }
  return kNoPlayer;
}

void add_foul(const gamelog::MatchRecord& record, std::size_t frame, std::size_t team,
              Stoppages& result) {
  const Foul foul = {.frame = static_cast<std::uint32_t>(frame),
                     .mode = record.mode[frame],
                     .fouler = fouler_of(record, frame, team),
                     .victim = victim_of(record, frame, 1 - team)};
  if (foul.fouler != kNoPlayer) ++result.fouls_by[slot_index(foul.fouler)];
  if (foul.victim != kNoPlayer) ++result.fouls_against[slot_index(foul.victim)];
  result.fouls.push_back(foul);
}

void add_cards(const gamelog::MatchRecord& record, std::size_t frame, Stoppages& result) {
  for (std::size_t slot = 0; slot < gamelog::kSlots; ++slot) {
    const std::uint32_t cards = newly_set(record, entry_of(frame, slot));
    const bool yellow = (cards & gamelog::kStateYellowCard) != 0;
    const bool red = (cards & gamelog::kStateRedCard) != 0;
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
    const std::size_t team = team_of(side);
    result.teams[team].restart_frames += flow.phase[i] == Phase::kSet;
    if (i > 0 && record.mode[i - 1] == mode) continue;

    const auto counter =
        std::ranges::find(kCounters, soccer::without_side(mode), &CounterOfMode::first);
    if (is_goalie_catch(flow, i, team)) {
      ++result.teams[team].goalie_catches;
    } else if (counter != std::end(kCounters)) {
      ++(result.teams[team].*counter->second);
      if (counter->second == &TeamStoppages::fouls && i > 0) add_foul(record, i, team, result);
    }
  }
  return result;
}

}  // namespace cls::analysis
