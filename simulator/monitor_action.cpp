// The human referee's calls.
#include "simulator/monitor_action.h"

#include <variant>

#include "simulator/referee.h"
#include "simulator/referee/areas.h"
#include "simulator/referee/calls.h"
#include "simulator/referee/cards.h"
#include "simulator/referee/clearing.h"
#include "simulator/roster.h"
#include "simulator/trainer.h"

namespace cls::simulator {
namespace {

struct Executor {
  World& world;
  Events& events;

  void operator()(const soccer::DispStart&) const { kick_off(world, events); }

  void operator()(const soccer::DispFoul& foul) const {
    if (soccer::is_penalty_mode(world.mode)) return;
    world.ball_catcher = kNobody;
    const Vec2 place = truncated(foul.position);
    if (foul.side == Side::kNeutral) {
      world.ball = {place, {}, {}};
      drop_ball(world, events);
      return;
    }
    announce(world, "foul", opponent(foul.side), events);
    keep_players_in_field(world);
    place_ball(world, for_side(PlayMode::kFreeKickLeft, foul.side), foul.side, place, events);
  }

  void operator()(const soccer::DispPlayer& placed) const {
    if (!world.player(placed.side, placed.unum).enabled) return;
    move_player(world, soccer::slot_of(placed.side, placed.unum), placed.position, placed.body,
                Vec2{}, events);
  }

  void operator()(const soccer::DispDiscard& discard) const {
    Player& player = world.player(discard.side, discard.unum);
    if (!player.enabled) return;
    leave(world, player.slot());
    player.state |= state::kDiscard;
  }

  void operator()(const soccer::DispCard& card) const {
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
