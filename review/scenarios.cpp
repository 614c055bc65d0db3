// Copies ball and players of a frame into a scenario.
#include "review/scenarios.h"

#include <fmt/format.h>

#include "analysis/play/flow.h"
#include "analysis/statistics/fields.h"
#include "base/index.h"

namespace cls::review {
namespace {

using analysis::point_json;
using base::Json;
using gamelog::MatchRecord;
using soccer::Side;

constexpr int kSeeds = 10;

Json players_json(const MatchRecord& record, std::size_t frame, Side side) {
  Json players = Json::object();
  for (int unum = 1; unum <= soccer::kPlayersPerTeam; ++unum) {
    const std::size_t entry = analysis::entry_of(frame, base::index(soccer::slot_of(side, unum)));
    const gamelog::PlayerColumns& columns = record.players;
    const bool sent_off = (columns.state[entry] & gamelog::kStateRedCard) != 0;
    if (!gamelog::is_enabled(record, entry) || sent_off) continue;

    players[fmt::to_string(unum)] = {{"at", point_json(columns.position[entry])},
                                     {"velocity", point_json(columns.velocity[entry])},
                                     {"body", columns.body[entry]},
                                     {"stamina", columns.stamina[entry]}};
  }
  return players;
}

}  // namespace

Json scenario_of(const MatchRecord& record, const Verdict& verdict, const ScenarioTerms& terms) {
  const Decision& decision = verdict.played.decision;
  const std::size_t frame = decision.frame;
  const Side side = soccer::side_of_slot(decision.slot);
  const char* own = soccer::side_name(side);
  const char* other = soccer::side_name(soccer::opponent(side));

  std::string about = fmt::format("{}, cycle {}: player {} chose {}", terms.match, decision.cycle,
                                  soccer::unum_of_slot(decision.slot), text_of(decision));
  if (verdict.better) about += fmt::format("; playouts prefer {}", verdict.best()->text);

  Json scenario = {{"about", about + "."},
                   {"mode", "play_on"},
                   {"cycle", decision.cycle},
                   {"ball",
                    {{"at", point_json(record.ball_position[frame])},
                     {"velocity", point_json(record.ball_velocity[frame])}}}};
  for (const Side each : soccer::kBothSides) {
    scenario[soccer::side_name(each)] = {
        {"playmaker", each == side ? terms.playmaker : "mock:planner"},
        {"players", players_json(record, frame, each)}};
  }
  scenario["under_test"] = own;
  scenario["seeds"] = kSeeds;
  scenario["steps"] = terms.steps;
  scenario["expect"] = {
      {{"name", "no goal against"}, {"score", {{other, 0}}}, {"runs", {{">=", kSeeds - 1}}}},
      {{"name", "keeps the ball"}, {"last_touch", own}, {"runs", {{">", kSeeds / 2}}}}};
  return analysis::rounded(scenario);
}

}  // namespace cls::review
