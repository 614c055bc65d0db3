// Connects players to slots, sends them off, finds teams and players.
#include "simulator/world/roster.h"

#include <algorithm>

namespace cls::simulator {
namespace {

// Clients of this version and later are in synchronous view mode from the start
// (docs/spec/simulation-model.md 7.1).
constexpr int kFirstSynchronousVersion = 18;

constexpr std::uint32_t kCards = state::kYellowCard | state::kRedCard;

void move_to_bench(Player& player) {
  player.position = bench_position(player);
  player.velocity = {};
  player.acceleration = {};
}

bool has_joined(const Player& player, Side side) { return player.joined && player.side == side; }

}  // namespace

std::optional<Slot> join(World& world, Side side, bool goalie, int client_version) {
  const auto free =
      std::find_if(world.players.begin(), world.players.end(),
                   [side](const Player& player) { return player.side == side && !player.joined; });
  const bool has_goalie = std::any_of(
      world.players.begin(), world.players.end(),
      [side](const Player& player) { return has_joined(player, side) && player.goalie; });
  if (free == world.players.end() || (goalie && has_goalie)) return std::nullopt;

  Player& player = *free;
  player.joined = true;
  player.enabled = true;
  player.goalie = goalie;
  player.client_version = client_version;
  player.view.synchronous = client_version >= kFirstSynchronousVersion;
  player.state = state::kStand | (goalie ? state::kGoalie : 0);
  // Sets only the committed angle: the next step turns the right team to 0 too
  // (docs/spec/simulation-model.md 15.1).
  player.body = side == Side::kRight ? soccer::math::kPi : 0.0;
  move_to_bench(player);
  world.team(side).connected = true;
  return player.slot();
}

void rejoin(World& world, Slot slot) {
  Player& player = world.player(slot);
  player.joined = true;
  player.enabled = true;
  player.state = (player.state & kCards) | state::kStand | (player.goalie ? state::kGoalie : 0);
  move_to_bench(player);
  world.team(player.side).connected = true;
}

void leave(World& world, Slot slot) {
  Player& player = world.player(slot);
  player.enabled = false;
  player.state &= kCards;
  move_to_bench(player);
  if (world.ball_catcher == slot) world.ball_catcher = kNoPlayer;
}

void send_off(World& world, Slot slot, Events& events) {
  leave(world, slot);
  Player& player = world.player(slot);
  player.state = (player.state | state::kDiscard | state::kRedCard) & ~state::kYellowCard;
  player.cards = 2;
  report(events, world, SentOff{slot});
}

int joined_count(const World& world, Side side) {
  return static_cast<int>(
      std::count_if(world.players.begin(), world.players.end(),
                    [side](const Player& player) { return has_joined(player, side); }));
}

Side find_side(const World& world, std::string_view team) {
  for (const Side side : {Side::kLeft, Side::kRight}) {
    if (!team.empty() && world.team(side).name.view() == team) return side;
  }
  return Side::kNeutral;
}

soccer::TeamName visible_team_name(const World& world, Side viewer, Side side) {
  const soccer::TeamName& name = world.team(side).name;
  const soccer::ServerParams& params = world.params();
  const std::string& fixed =
      side == Side::kLeft ? params.fixed_teamname_l : params.fixed_teamname_r;
  const bool replaced = viewer == opponent(side) && !name.empty() && !fixed.empty();
  return replaced ? soccer::TeamName(fixed) : name;
}

std::optional<Slot> find_player(const World& world, Side side, int unum) {
  if (side == Side::kNeutral || unum < 1 || unum > soccer::kPlayersPerTeam) return std::nullopt;
  const Player& player = world.player(side, unum);
  if (!player.joined) return std::nullopt;
  return player.slot();
}

bool has_enabled_goalie(const World& world, Side side) {
  return std::any_of(world.players.begin(), world.players.end(), [side](const Player& player) {
    return player.enabled && player.goalie && player.side == side;
  });
}

}  // namespace cls::simulator
