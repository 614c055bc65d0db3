// Forks an episode at a decision.
#include "review/playouts.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <utility>

#include "base/index.h"
#include "player/perception/perception.h"
#include "review/moment.h"
#include "review/state_value.h"

namespace cls::review {
namespace {

using base::Error;
using soccer::Side;
using training::Episode;
using training::MatchPlayer;

// A decision for one cycle of the player; false when it is carried out.
using Choice = std::function<bool(int cycle, MatchPlayer& player)>;

// Plays on from a copy of `moment`, first by `choice`.
double worth(const Episode& moment, const Decision& decision, int cycles, const Choice& choice) {
  Episode episode = moment;
  const Side side = soccer::side_of_slot(decision.slot);

  bool chooses = true;
  for (int cycle = 0; cycle < cycles && !episode.ended(); ++cycle) {
    if (!chooses) {
      episode.step({}, nullptr);
      continue;
    }
    const std::function<void(MatchPlayer&)> decide = [&](MatchPlayer& player) {
      chooses = choice(cycle, player);
    };
    episode.step_with({decision.slot, decide});
  }

  if (episode.status() == training::Status::kGoal) return soccer::sign(side);
  if (episode.status() == training::Status::kGoalConceded) return -soccer::sign(side);
  return state_value(view_of(episode.world()), side);
}

// What the player sent in the match.
Choice as_recorded(const simulator::TextLogIndex& sent, const Decision& decision) {
  const auto length = static_cast<int>(decision.end - decision.frame);
  return [&sent, &decision, length](int cycle, MatchPlayer& player) {
    player.senses.commands = commands_sent(sent, decision.slot, decision.cycle + cycle);
    player::record_sent_commands(player.senses.world, player.senses.commands);
    return cycle + 1 < length;
  };
}

// An alternative, as long as the player has the ball; then `driver` decides.
Choice instead(const Alternative& alternative, training::Driver driver) {
  return [&alternative, driver](int cycle, MatchPlayer& player) {
    if (cycle > 0 && !player.senses.world.self.kickable) {
      training::decide(driver, player);
      return false;
    }
    carry_out(alternative, player);
    return cycle + 1 < longest_cycles(alternative);
  };
}

training::OptionValues until_a_goal(const training::Setup& setup) {
  training::OptionValues values = setup.options;
  const auto& options = setup.task->options;
  const auto stop = std::ranges::find(options, "stop_play", &training::TaskOption::name);
  values[base::index(stop - options.begin())] = 1.0;
  return values;
}

}  // namespace

std::vector<soccer::PlayerCommand> commands_sent(const simulator::TextLogIndex& sent, int slot,
                                                 int cycle) {
  std::vector<soccer::PlayerCommand> commands;
  const simulator::LoggedStep* step = sent.at({cycle, 0});
  if (step == nullptr) return commands;
  for (const simulator::LoggedDatagram& datagram : step->received) {
    const bool is_own = datagram.source == gamelog::RclSource::kPlayer &&
                        soccer::slot_of(datagram.side, datagram.unum) == slot;
    if (is_own) parse_player_commands(datagram.text, commands);
  }
  return commands;
}

base::Result<PlayedDecision> play_again(std::shared_ptr<const training::Setup> setup,
                                        const analysis::Flow& flow,
                                        const simulator::TextLogIndex& sent,
                                        const Decision& decision, const PlayoutTerms& terms) {
  if (!has_warm_up(flow, decision.frame)) return Error{"play had just begun"};
  const training::Start start = start_at(flow, decision.frame);
  const training::OptionValues options = until_a_goal(*setup);
  Episode moment(setup);
  moment.reset_at(terms.seed, options, start);

  const MatchPlayer* player = moment.match_player(decision.slot);
  if (player == nullptr || moment.world().mode != soccer::PlayMode::kPlayOn ||
      !player->senses.world.self.kickable) {
    return Error{"the player does not know that it has the ball"};
  }

  PlayedDecision played;
  played.decision = decision;
  played.alternatives = alternatives_of(*player, terms.most_alternatives);
  played.worths.resize(played.alternatives.size());
  const Choice recorded = as_recorded(sent, decision);
  const bool right = soccer::side_of_slot(decision.slot) == Side::kRight;
  const training::Driver driver = (right ? setup->opponents : setup->teammates).front().driver;

  for (int i = 0; i < terms.seeds; ++i) {
    if (i > 0) moment.reset_at(terms.seed + static_cast<std::uint64_t>(i), options, start);
    played.recorded.push_back(worth(moment, decision, terms.cycles, recorded));
    for (std::size_t k = 0; k < played.alternatives.size(); ++k) {
      const Choice choice = instead(played.alternatives[k], driver);
      played.worths[k].push_back(worth(moment, decision, terms.cycles, choice));
    }
  }

  return played;
}

}  // namespace cls::review
