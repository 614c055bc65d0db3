// Step: the outcomes of the actions of a team on the embedded server.
#include <fmt/format.h>

#include "checks/playmaker/playmaker_subject.h"
#include "match/terms/match_options.h"
#include "proxy/agent/team.h"
#include "simulator/actions/trainer.h"
#include "simulator/referee/referee.h"
#include "simulator/server/lockstep_server.h"

namespace cls::checks {
namespace {

constexpr int kPlayedCycles = 100;

/// Sums over all players and kinds.
struct Outcomes {
  std::int64_t replies = 0;
  std::int64_t useless = 0;
  std::int64_t executed = 0;
  std::int64_t failed = 0;
  std::int64_t skipped = 0;
  std::int64_t invalid = 0;
  std::int64_t unimplemented = 0;

  std::string text() const {
    return fmt::format(
        "{} replies, {} of them useless; actions: {} executed, {} failed, {} "
        "skipped, {} invalid, {} unknown",
        replies, useless, executed, failed, skipped, invalid, unimplemented);
  }
};

Outcomes outcomes_of(const proxy::Team& team) {
  player::ActionReport sum;
  for (const auto& player : team.players()) add(sum, player->statistics().actions);

  Outcomes outcomes;
  outcomes.replies = sum.lists;
  outcomes.useless = sum.useless;
  for (const player::ActionCounts& counts : sum.actions) {
    outcomes.executed += counts.done;
    outcomes.failed += counts.failed;
    outcomes.skipped += counts.skipped;
    outcomes.invalid += counts.invalid;
    outcomes.unimplemented += counts.unimplemented;
  }
  return outcomes;
}

base::Result<void> enter(proxy::Team& team, simulator::LockstepServer& server) {
  return team.connect([&server] { return server.connect(); },
                      [&server] {
                        server.accept_clients();
                        return true;
                      });
}

// The team alone in its half, the ball in play at the center spot.
void begin_play(simulator::World& world, simulator::Events& events) {
  for (int unum = 1; unum <= soccer::kPlayersPerTeam; ++unum) {
    const soccer::Vec2 position{-52.0 + 4.5 * unum, (unum % 2 == 0 ? -2.5 : 2.5) * (unum - 1)};
    simulator::move_player(world, soccer::slot_of(soccer::Side::kLeft, unum), position, 0.0, {},
                           events);
  }
  simulator::change_mode(world, soccer::PlayMode::kPlayOn, events);
}

Finding actions_in_play(PlaymakerSubject& subject) {
  constexpr std::uint64_t kSeed = 1;
  auto created = simulator::LockstepServer::create(match::server_config({}, kSeed));
  if (!created) return fail(created.error().message);
  simulator::LockstepServer& server = **created;

  const auto playmaker = subject.connect();
  proxy::TeamOptions options;
  options.name = soccer::TeamName("Check_P");
  options.decision_timeout = subject.deadline;
  options.start_timeout = subject.start_timeout;
  proxy::Team team(options, *playmaker);

  if (const auto entered = enter(team, server); !entered) return fail(entered.error().message);
  if (const auto status = team.register_agents(); !status.ok()) return fail(to_text(status));
  server.modify_world(begin_play);

  for (int cycle = 0; cycle < kPlayedCycles; ++cycle) {
    server.run_cycle();
    team.run_cycle();
  }

  team.leave();
  if (team.errors().first) return fail(team.errors().first->describe());

  const Outcomes outcomes = outcomes_of(team);
  const bool wrong = outcomes.invalid + outcomes.unimplemented > 0;
  const bool useless = 2 * outcomes.useless > outcomes.replies;
  return wrong || useless ? fail(outcomes.text()) : pass(outcomes.text());
}

}  // namespace

std::vector<PlaymakerStep> play_steps() {
  return {
      {"actions_in_play",
       "In 100 cycles on the pitch, most replies must have an action that can be executed.",
       actions_in_play},
  };
}

}  // namespace cls::checks
