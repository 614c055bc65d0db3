// Dispatches a player command to its implementation.
#include "simulator/actions/actions.h"

#include <variant>

#include "simulator/actions/commands.h"

namespace cls::simulator {
namespace {

using Reply = std::optional<soccer::ServerReply>;

/// One overload per command.
struct Executor {
  World& world;
  Player& player;
  Events& events;

  Reply operator()(const soccer::Turn& c) { return run(actions::turn, c); }
  Reply operator()(const soccer::Dash& c) {
    actions::dash(world, player, c);
    return {};
  }
  Reply operator()(const soccer::LegDash& c) {
    actions::dash(world, player, c);
    return {};
  }
  Reply operator()(const soccer::TurnNeck& c) { return run(actions::turn_neck, c); }
  Reply operator()(const soccer::ChangeFocus& c) { return run(actions::change_focus, c); }
  Reply operator()(const soccer::ChangeView& c) { return run(actions::change_view, c); }
  Reply operator()(const soccer::PointTo& c) { return run(actions::point_to, c); }
  Reply operator()(const soccer::AttentionTo& c) { return run(actions::attend, c); }
  Reply operator()(const soccer::Kick& c) { return run_with_events(actions::kick, c); }
  Reply operator()(const soccer::Tackle& c) { return run_with_events(actions::tackle, c); }
  Reply operator()(const soccer::Catch& c) { return run_with_events(actions::catch_ball, c); }
  Reply operator()(const soccer::Say& c) { return run_with_events(actions::say, c); }
  Reply operator()(const soccer::Move& c) { return actions::move(world, player, c, events); }
  Reply operator()(const soccer::Ear& c) { return actions::set_ears(world, player, c); }
  Reply operator()(const soccer::PointToOff&) {
    actions::stop_pointing(world, player);
    return {};
  }
  Reply operator()(const soccer::AttentionToOff&) {
    actions::stop_attending(player);
    return {};
  }
  Reply operator()(const soccer::SynchSee&) {
    player.view.synchronous = true;
    player.view.quality = soccer::ViewQuality::kHigh;
    return soccer::OkSynchSee{};
  }
  Reply operator()(const soccer::GaussianSee&) {
    player.view.gaussian = true;
    return soccer::OkGaussianSee{};
  }
  Reply operator()(const soccer::RequestScore&) {
    const Team& others = world.team(opponent(player.side));
    return soccer::ScoreReply{world.clock.time, world.team(player.side).score,
                              others.connected ? others.score : 0};
  }
  // Handled by the session.
  Reply operator()(const soccer::Clang&) { return {}; }
  Reply operator()(const soccer::RequestSenseBody&) { return {}; }
  Reply operator()(const soccer::Done&) { return {}; }
  Reply operator()(const soccer::Bye&) { return {}; }
  Reply operator()(const soccer::Compression&) { return {}; }
  // In the grammar of rcssserver, without an effect (docs/spec/simulation-model.md 4.5).
  Reply operator()(const soccer::LongKick&) { return {}; }

 private:
  template <typename Action, typename Command>
  Reply run(Action action, const Command& command) {
    action(world, player, command);
    return {};
  }
  template <typename Action, typename Command>
  Reply run_with_events(Action action, const Command& command) {
    action(world, player, command, events);
    return {};
  }
};

}  // namespace

std::optional<soccer::ServerReply> apply(World& world, Slot slot,
                                         const soccer::PlayerCommand& command, Events& events) {
  Player& player = world.player(slot);
  if (!player.enabled) return std::nullopt;
  return std::visit(Executor{world, player, events}, command);
}

}  // namespace cls::simulator
