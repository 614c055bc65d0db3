// Connects players to slots, sends them off, finds teams and players.
#include "simulator/world/roster.h"

#include <algorithm>
#include <string>

namespace cls::simulator {
namespace {

constexpr std::uint32_t kCards = state::kYellowCard | state::kRedCard;

void move_to_bench(Player& player) {
  player.position = bench_position(player);
  player.velocity = {};
  player.acceleration = {};
}

bool has_joined(const Player& player, Side side) { return player.joined && player.side == side; }

// `name` with the side at the end: another name, as long as the protocol allows.
soccer::TeamName marked_name(std::string_view name, Side side) {
  constexpr std::size_t kMarkSize = 2;
  const std::string start(name.substr(0, soccer::TeamName::kMaxSize - kMarkSize));
  const std::string end(1, side == Side::kLeft ? 'l' : 'r');
  const std::string marked = start + '_' + end;
  return soccer::TeamName(marked == name ? start + '-' + end : marked);
}

// The name in the match, as its own clients and as those of its opponent know it.
soccer::TeamName known_name(const World& world, Side viewer, Side side) {
  const Team& team = world.team(side);
  if (viewer == side && !team.own_name.empty()) return team.own_name;
  if (viewer != opponent(side) || team.name.empty()) return team.name;
  const soccer::TeamName& chosen = world.team(viewer).own_name;
  return chosen == team.name ? marked_name(team.name.view(), side) : team.name;
}

}  // namespace

std::optional<Slot> join(World& world, Side side, bool goalie, int client_version) {
  const auto free = std::ranges::find_if(world.players, [side](const Player& player) {
    return player.side == side && !player.joined;
  });
  const bool has_goalie = std::ranges::any_of(world.players, [side](const Player& player) {
    return has_joined(player, side) && player.goalie;
  });
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
  return static_cast<int>(std::ranges::count_if(
      world.players, [side](const Player& player) { return has_joined(player, side); }));
}

void name_team(World& world, Side side, std::string_view name) {
  Team& team = world.team(side);
  team.name = soccer::TeamName(name);
  if (name.empty() || !(world.team(opponent(side)).name == team.name)) return;
  team.own_name = team.name;
  team.name = marked_name(name, side);
}

bool has_name(const World& world, Side viewer, Side side, std::string_view name) {
  const soccer::TeamName known = known_name(world, viewer, side);
  return !known.empty() && known.view() == name;
}

Side find_side(const World& world, std::string_view team, Side viewer) {
  for (const Side side : {Side::kLeft, Side::kRight}) {
    if (has_name(world, viewer, side, team)) return side;
  }
  return Side::kNeutral;
}

soccer::TeamName visible_team_name(const World& world, Side viewer, Side side) {
  const soccer::TeamName name = known_name(world, viewer, side);
  const soccer::ServerParams& params = world.params();
  const std::string& fixed =
      side == Side::kLeft ? params.fixed_teamname_l : params.fixed_teamname_r;
  const bool replaced = viewer == opponent(side) && !name.empty() && !fixed.empty();
  return replaced ? soccer::TeamName(fixed) : name;
}

soccer::TeamName visible_team_name(const World& world, Side own, Side side,
                                   const soccer::TeamName& own_name) {
  const soccer::TeamName name = visible_team_name(world, own, side);
  if (own_name.empty() || name.empty()) return name;
  if (side == own) return own_name;
  return name == own_name ? marked_name(name.view(), side) : name;
}

std::optional<Slot> find_player(const World& world, Side side, int unum) {
  if (side == Side::kNeutral || !soccer::is_unum(unum)) return std::nullopt;
  const Player& player = world.player(side, unum);
  if (!player.joined) return std::nullopt;
  return player.slot();
}

bool has_enabled_goalie(const World& world, Side side) {
  return std::ranges::any_of(world.players, [side](const Player& player) {
    return player.enabled && player.goalie && player.side == side;
  });
}

}  // namespace cls::simulator
