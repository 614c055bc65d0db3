// Places ball and players, and counts the steps of a situation.
#include "match/hooks/situation_play.h"

#include "simulator/referee/referee.h"
#include "simulator/referee/substitution.h"
#include "soccer/math.h"
#include "soccer/side.h"

namespace cls::match {
namespace {

using simulator::Events;
using simulator::Player;
using simulator::World;
using soccer::Side;

constexpr std::uint32_t kKept = simulator::state::kStand | simulator::state::kGoalie;

// The team's goalie takes the place of number 1, and number 1 that of the goalie.
std::size_t place_of(const World& world, std::size_t slot) {
  const std::size_t first = slot < soccer::kPlayersPerTeam ? 0 : soccer::kPlayersPerTeam;
  if (world.players[slot].goalie) return first;
  if (slot != first) return slot;
  for (std::size_t i = first; i < first + soccer::kPlayersPerTeam; ++i) {
    if (world.players[i].goalie) return i;
  }
  return slot;
}

// Removes the rest of an earlier situation: blocks, arms and cards.
void refresh(Player& player) {
  player.kick_cycles = player.dash_cycles = -1;
  player.tackle_cycles = player.foul_cycles = player.catch_ban = player.moves_since_catch = 0;
  player.cards = 0;
  player.state &= kKept;
}

void place(Player& player, const analysis::BookPlayer& at, const analysis::BookStamina& stamina) {
  player.position = at.position;
  player.velocity = at.velocity;
  player.acceleration = {};
  player.body = player.pending_body = soccer::math::to_radians(at.body);
  player.stamina = {stamina.stamina, stamina.effort, stamina.recovery,
                    stamina.capacity < 0 ? player.stamina.capacity : stamina.capacity};
  player.legs = {};
}

int goals_in(const World& world) {
  return world.team(Side::kLeft).score + world.team(Side::kRight).score;
}

}  // namespace

SituationPlay::SituationPlay(const analysis::Book& book, std::uint64_t seed, int situations,
                             int cycles)
    : situations_(analysis::situations_of(book, seed, situations)), cycles_(cycles) {}

void SituationPlay::begin(World& world, Events& events) {
  const simulator::TimeState time = world.referee.time;
  world.referee = {};
  world.referee.time = time;
  world.ball_catcher = simulator::kNoPlayer;

  for (std::size_t slot = 0; slot < world.players.size(); ++slot) {
    Player& player = world.players[slot];
    refresh(player);
    const int type = situation().players[place_of(world, slot)].type;
    if (player.enabled && player.type != type) {
      simulator::substitute(world, static_cast<simulator::Slot>(slot), type, events);
    }
  }

  // Twice: the new mode clears players from the ball.
  shown_ = 0;
  show_step(world);
  simulator::change_mode(world, situation().mode, events);
  shown_ = 0;
  show_step(world);
}

void SituationPlay::show_step(World& world) {
  const analysis::BookFrame& frame = situation().frames[shown_++];
  world.ball = {frame.ball, frame.ball_velocity, {}};
  world.referee.touch.previous_ball = frame.ball;

  for (std::size_t slot = 0; slot < world.players.size(); ++slot) {
    Player& player = world.players[slot];
    if (!player.enabled) continue;

    const std::size_t from = place_of(world, slot);
    place(player, frame.players[from], situation().players[from]);
    player.command_done = !in_play();
  }
  played_ = 0;
  goals_ = goals_in(world);
}

void SituationPlay::after_step(World& world) {
  if (!in_play()) return show_step(world);
  ++played_;
  ended_ = goals_in(world) != goals_ || played_ >= cycles_;
}

void SituationPlay::next(World& world, Events& events) {
  ended_ = false;
  if (++at_ < situations_.size()) begin(world, events);
}

}  // namespace cls::match
