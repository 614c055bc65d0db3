// pointto, attentionto, say, ear (docs/spec/simulation-model.md 4.12 to 4.14, 8.5).
#include <algorithm>
#include <optional>

#include "simulator/actions/actions.h"
#include "simulator/actions/commands.h"
#include "simulator/world/angles.h"
#include "simulator/world/roster.h"

namespace cls::simulator {

bool is_pointing(const World& world, const Player& player) {
  return player.arm.age < world.params().point_to_duration;
}

bool can_point(const World& world, const Player& player) {
  return player.arm.age >= world.params().point_to_ban;
}

namespace actions {
namespace {

using soccer::TeamReference;

constexpr double kMaxArmDistance = 1e6;

// Returns neutral for an unknown team name.
Side referred_side(const World& world, const Player& player, const TeamReference& team) {
  switch (team.kind) {
    case TeamReference::Kind::kOur:
      return player.side;
    case TeamReference::Kind::kOpponent:
      return opponent(player.side);
    case TeamReference::Kind::kLeft:
      return Side::kLeft;
    case TeamReference::Kind::kRight:
      return Side::kRight;
    case TeamReference::Kind::kNamed:
      break;
  }
  for (const Side side : {Side::kLeft, Side::kRight}) {
    if (world.team(side).connected && has_name(world, player.side, side, team.name)) return side;
  }
  return Side::kNeutral;
}

void set_ear_mode(Ears& ears, Side side, const soccer::Ear& command) {
  const std::size_t index = side == Side::kRight ? 1 : 0;
  if (command.mode != soccer::EarMode::kPartial) ears.complete[index] = command.on;
  if (command.mode != soccer::EarMode::kComplete) ears.partial[index] = command.on;
}

}  // namespace

void point_to(World& world, Player& player, const soccer::PointTo& command) {
  if (!can_point(world, player)) return;
  // Computed from the point relative to the face, as in rcssserver. The distance is limited,
  // because rcssserver writes huge ones into the game log as numbers that readers reject, or as
  // infinite.
  const double distance = std::clamp(command.distance, -kMaxArmDistance, kMaxArmDistance);
  const Vec2 to = soccer::polar_radians(distance, exact_radians(command.direction));
  const double direction = soccer::direction_radians(to) + (player.body + player.neck);
  player.arm = {soccer::polar_radians(to.length(), direction) + player.position, 0};
  ++player.counters.pointto;
}

void stop_pointing(World& world, Player& player) {
  if (!can_point(world, player)) return;
  player.arm = {{}, world.params().point_to_duration};
  ++player.counters.pointto;
}

void attend(World& world, Player& player, const soccer::AttentionTo& command) {
  const Side side = referred_side(world, player, command.team);
  if (side == Side::kNeutral || !world.team(side).connected) return;
  if (command.unum < 1 || command.unum > joined_count(world, side)) return;
  const Slot slot = soccer::slot_of(side, command.unum);
  if (slot == player.slot()) return;
  player.attention = slot;
  ++player.counters.attentionto;
}

void stop_attending(Player& player) {
  player.attention = kNoPlayer;
  ++player.counters.attentionto;
}

void say(World& world, Player& player, const soccer::Say& command, Events& events) {
  if (command.text.size() > static_cast<std::size_t>(world.params().say_msg_size)) return;
  ++player.counters.say;
  report(events, world, PlayerSaid{player.slot(), player.position, command.text});
}

std::optional<soccer::ServerReply> set_ears(World& world, Player& player,
                                            const soccer::Ear& command) {
  if (!command.team) {
    set_ear_mode(player.ears, Side::kLeft, command);
    set_ear_mode(player.ears, Side::kRight, command);
    return std::nullopt;
  }
  const Side side = referred_side(world, player, *command.team);
  if (side == Side::kNeutral) {
    return soccer::ErrorReply{"no team with name " + command.team->name, std::nullopt};
  }
  set_ear_mode(player.ears, side, command);
  return std::nullopt;
}

}  // namespace actions
}  // namespace cls::simulator
