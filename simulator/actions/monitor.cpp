// Commands of monitors: the human referee.
#include <variant>

#include "simulator/actions/trainer.h"
#include "simulator/referee/areas.h"
#include "simulator/referee/calls.h"
#include "simulator/referee/clearing.h"
#include "simulator/referee/collision.h"
#include "simulator/referee/referee.h"
#include "simulator/world/angles.h"
#include "simulator/world/roster.h"

namespace cls::simulator {
namespace {

struct Executor {
  World& world;
  Events& events;

  void operator()(const soccer::DispStart&) const { kick_off(world, events); }

  void operator()(const soccer::DispFoul& foul) const {
    if (foul.side == Side::kNeutral) return drop_ball(world, clamp_to_pitch(foul.position), events);
    if (soccer::is_penalty_mode(world.mode)) return;
    announce(world, {"foul", opponent(foul.side)}, events);
    world.ball_catcher = kNoPlayer;
    place_ball(world, for_side(PlayMode::kFreeKickLeft, foul.side), foul.side,
               clamp_to_pitch(foul.position), events);
    keep_players_in_field(world);
    world.ball_catcher = kNoPlayer;
  }

  void operator()(const soccer::DispPlayer& placed) const {
    if (placed.side == Side::kNeutral) return;
    Player& player = world.player(placed.side, placed.unum);
    player.position = placed.position;
    player.velocity = {};
    player.body = exact_radians(placed.body);  // not clamped, unlike a trainer's
    player.pending_body = player.body;
    resolve_collisions(world, events);
  }

  void operator()(const soccer::DispDiscard& discard) const {
    if (discard.side == Side::kNeutral) return;
    Player& player = world.player(discard.side, discard.unum);
    if (!player.enabled) return;
    leave(world, player.slot());
    player.state |= state::kDiscard;
    report(events, world, SentOff{player.slot()});
  }

  void operator()(const soccer::DispCard& card) const {
    if (card.side == Side::kNeutral) return;
    Player& player = world.player(card.side, card.unum);
    if (!player.enabled) return;
    if (card.red) {
      show_red_card(world, player, events);
    } else {
      show_yellow_card(world, player, events);
    }
  }

  void operator()(const soccer::DispBye&) const {}
  void operator()(const soccer::Compression&) const {}
};

}  // namespace

void apply(World& world, const soccer::MonitorCommand& command, Events& events) {
  std::visit(Executor{world, events}, command);
}

}  // namespace cls::simulator
