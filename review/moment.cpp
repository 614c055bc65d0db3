// Takes ball, players and their condition from the frames of a game log.
#include "review/moment.h"

#include <algorithm>

#include "base/index.h"
#include "simulator/world/rules.h"
#include "soccer/math.h"

namespace cls::review {
namespace {

using analysis::entry_of;
using gamelog::MatchRecord;
using soccer::Side;

// Cycles that a state has lasted until `frame`, this one included.
int cycles_in_state(const MatchRecord& record, std::size_t frame, std::size_t slot,
                    std::uint32_t bits) {
  int cycles = 0;
  for (std::size_t at = frame + 1; at-- > 0;) {
    if ((record.players.state[entry_of(at, slot)] & bits) == 0) break;
    ++cycles;
  }
  return cycles;
}

training::StartPlayer player_at(const MatchRecord& record, std::size_t frame, std::size_t slot) {
  const std::size_t entry = entry_of(frame, slot);
  const gamelog::PlayerColumns& players = record.players;

  training::StartPlayer player;
  player.on_pitch =
      gamelog::is_enabled(record, entry) && (players.state[entry] & gamelog::kStateRedCard) == 0;
  player.type = players.type[entry];
  player.position = players.position[entry];
  player.velocity = players.velocity[entry];
  player.body = soccer::math::to_radians(players.body[entry]);
  player.neck = soccer::math::to_radians(players.neck[entry]);
  player.stamina = {players.stamina[entry], players.effort[entry], players.recovery[entry],
                    players.capacity[entry]};

  const auto left = [&](std::uint32_t bits, int cycles) {
    const int spent = cycles_in_state(record, frame, slot, bits);
    return spent == 0 ? 0 : std::max(0, cycles - spent);
  };
  player.tackle_cycles =
      left(gamelog::kStateTackle | gamelog::kStateTackleFailed, record.server.tackle_cycles);
  player.foul_cycles = left(gamelog::kStateCharged, record.server.foul_cycles);
  return player;
}

int goalie_slot(const MatchRecord& record, Side side) {
  for (int unum = 1; unum <= soccer::kPlayersPerTeam; ++unum) {
    const int slot = soccer::slot_of(side, unum);
    if (analysis::was_goalie(record, base::index(slot))) return slot;
  }
  return soccer::kNoPlayer;
}

}  // namespace

std::string why_not_played(const MatchRecord& record) {
  if (record.version <= gamelog::RcgVersion::kV3) {
    return "game logs of versions 1 to 3 lack the stamina of players";
  }
  if (record.types.empty()) return "the log has no player types";
  return {};
}

base::Result<std::shared_ptr<const training::Setup>> setup_of(
    const MatchRecord& record, soccer::PerSide<training::Driver> drivers) {
  soccer::ServerParams server = record.server;
  server.synch_mode = true;
  server.auto_mode = true;
  server.coach = false;

  TRY_INIT(auto rules, simulator::make_rules(server, record.player, record.types));
  return training::make_watched_setup(
      std::move(rules), drivers,
      {goalie_slot(record, Side::kLeft), goalie_slot(record, Side::kRight)});
}

bool has_warm_up(const analysis::Flow& flow, std::size_t frame) {
  const MatchRecord& record = *flow.record;
  if (frame < kWarmUp) return false;
  for (std::size_t at = frame - kWarmUp; at <= frame; ++at) {
    if (!flow.is_live(at) || record.time[at] != record.time[frame] - static_cast<int>(frame - at)) {
      return false;
    }
  }
  return true;
}

training::Start start_at(const analysis::Flow& flow, std::size_t frame) {
  const MatchRecord& record = *flow.record;
  const gamelog::TeamFrames& teams = gamelog::teams_at(record, frame);

  training::Start start;
  start.mode = record.mode[frame];
  start.time = record.time[frame];
  start.score = {teams[0].score, teams[1].score};
  start.last_touch = flow.owner[frame];

  for (std::size_t at = frame - kWarmUp; at <= frame; ++at) {
    training::StartFrame& to = start.frames.emplace_back();
    to.ball = record.ball_position[at];
    to.ball_velocity = record.ball_velocity[at];
    for (std::size_t slot = 0; slot < to.players.size(); ++slot) {
      to.players[slot] = player_at(record, at, slot);
    }
  }
  return start;
}

}  // namespace cls::review
