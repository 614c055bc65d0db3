// Counts losses, recoveries and pressure.
#include "analysis/measures/pressing.h"

#include <algorithm>

#include "soccer/pitch.h"

namespace cls::analysis {
namespace {

using soccer::Vec2;

constexpr double kPressureDistance = 3.0;
constexpr std::uint32_t kSoon = 20;
constexpr double kOpponents60Percent = -soccer::kHalfLength + 0.6 * soccer::kPitchLength;

// True inside the own 60 % of the pitch of the team in possession, which sees the pitch as `seen`.
bool in_opponents_60_percent(Vec2 seen) { return seen.x < kOpponents60Percent; }

void add_pressure(const Flow& flow, PressingStats& result) {
  const gamelog::MatchRecord& record = *flow.record;
  for (std::size_t i = 0; i < record.frames(); ++i) {
    if (!flow.is_live(i) || flow.owner[i] == kNoPlayer) continue;
    const std::size_t owner = slot_index(flow.owner[i]);
    Pressing& team = result.teams[1 - team_of(owner)];
    ++team.opponent_frames;

    const Vec2 at = record.players.position[entry_of(i, owner)];
    team.pressure_frames +=
        std::ranges::any_of(kTeamSlots[1 - team_of(owner)], [&](std::size_t slot) {
          const std::size_t entry = entry_of(i, slot);
          return gamelog::is_enabled(record, entry) &&
                 soccer::squared_distance(record.players.position[entry], at) <=
                     kPressureDistance * kPressureDistance;
        });
  }
}

void add_actions(const Flow& flow, const std::vector<Pass>& passes, const Stoppages& stoppages,
                 PressingStats& result) {
  const gamelog::MatchRecord& record = *flow.record;
  for (const Pass& pass : passes) {
    const std::size_t opponents = 1 - team_of(pass.passer);
    result.teams[opponents].opponent_passes += in_opponents_60_percent(pass.from);
    if (pass.outcome != PassOutcome::kIntercepted) continue;
    ++result.interceptions[slot_index(pass.receiver)];
    result.teams[opponents].defensive_actions += in_opponents_60_percent(pass.to);
  }

  for (std::size_t i = 1; i < record.frames(); ++i) {
    if (!flow.is_live(i) || record.time[i] < record.time[i - 1]) continue;
    for (std::size_t slot = 0; slot < gamelog::kSlots; ++slot) {
      if (!has_executed(record, gamelog::Counter::kTackle, entry_of(i, slot))) continue;
      const Vec2 seen = Vec2(record.ball_position[i - 1]) * -attack_sign(slot);
      result.teams[team_of(slot)].defensive_actions += in_opponents_60_percent(seen);
    }
  }

  for (const Foul& foul : stoppages.fouls) {
    const soccer::Side side = soccer::side(foul.mode);
    const Vec2 seen = Vec2(record.ball_position[foul.frame]) * -soccer::sign(side);
    result.teams[team_of(side)].defensive_actions += in_opponents_60_percent(seen);
  }
}

void add_recoveries(const Flow& flow, PressingStats& result) {
  PerTeam<std::int64_t> lost_at = {-1, -1};  // frame of a loss that is not regained yet
  PerTeam<std::int32_t> lost_in = {-1, -1};  // live phase of that loss
  std::int8_t before = kNoPlayer;
  std::int32_t phase_before = -1;

  for (const Touch& touch : flow.touches) {
    if (touch.contested() || touch.live_phase < 0) continue;
    const std::size_t slot = slot_index(touch.slot);
    const std::size_t team = team_of(slot);

    if (before != kNoPlayer && team_of(before) != team) {
      ++result.recoveries[slot];
      ++result.teams[team].recoveries;
      if (lost_in[team] == touch.live_phase) {
        const auto frames = static_cast<std::uint32_t>(touch.frame - lost_at[team]);
        ++result.teams[team].regained;
        result.teams[team].regained_soon += frames <= kSoon;
        result.teams[team].regain_cycles += frames;
      }

      if (phase_before == touch.live_phase) {
        ++result.teams[1 - team].losses;
        lost_at[1 - team] = touch.frame;
        lost_in[1 - team] = touch.live_phase;
      }
      lost_in[team] = -1;
    }

    before = touch.slot;
    phase_before = touch.live_phase;
  }

  for (Pressing& team : result.teams) {
    if (team.regained > 0) team.regain_cycles /= team.regained;
  }
}

}  // namespace

PressingStats measure_pressing(const Flow& flow, const std::vector<Pass>& passes,
                               const Stoppages& stoppages) {
  PressingStats result;
  add_pressure(flow, result);
  add_actions(flow, passes, stoppages, result);
  add_recoveries(flow, result);
  return result;
}

}  // namespace cls::analysis
