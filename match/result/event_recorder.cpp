// Events from the steps of the embedded server, or from the game log of an external one.
#include "match/result/event_recorder.h"

#include <variant>

#include "base/text/json_text.h"
#include "soccer/per_side.h"

namespace cls::match {
namespace {

using base::Json;
using soccer::Side;

}  // namespace

void EventRecorder::add(int time, std::string_view type, const Json& fields) {
  Json line = {{"schema", "cls.events/1"}, {"seq", next_++}, {"t", time}, {"type", type}};
  line.update(fields);
  sink_.write(base::json_line(line) + "\n");
}

void EventRecorder::add_goal(const Goal& goal) {
  add(goal.cycle, "goal",
      {{"side", side_name(goal.side)},
       {"unum", goal.unum == 0 ? Json(nullptr) : Json(goal.unum)},
       {"score", {scores_[0], scores_[1]}}});
}

void EventRecorder::add_play_mode(int time, soccer::PlayMode mode) {
  add(time, "play_mode", {{"mode", name(mode)}});
}

void EventRecorder::start(const TeamNames& names, std::uint64_t seed) {
  add(0, "started", {{"left", names.left}, {"right", names.right}, {"seed", seed}});
}

void EventRecorder::follow_kicks(const simulator::World& world) {
  for (std::size_t slot = 0; slot < world.players.size(); ++slot) {
    const int kicks = world.players[slot].counters.kick;
    if (kicks == kicks_[slot]) continue;

    kicks_[slot] = kicks;
    const int number = static_cast<int>(slot);
    last_kicker_[soccer::side_index(soccer::side_of_slot(number))] = soccer::unum_of_slot(number);
  }
}

void EventRecorder::follow_goals(const simulator::World& world) {
  for (const Side side : soccer::kBothSides) {
    const std::size_t i = soccer::side_index(side);
    const int score = world.team(side).score;
    if (score == scores_[i]) continue;

    scores_[i] = score;
    goals_.push_back({world.clock.time, side, last_kicker_[i]});
    add_goal(goals_.back());
    last_kicker_ = {};
  }
}

void EventRecorder::follow(const simulator::World& world) {
  follow_kicks(world);
  follow_goals(world);
  if (world.mode == mode_) return;
  mode_ = world.mode;
  add_play_mode(world.clock.time, mode_);
}

void EventRecorder::read_log(const gamelog::MatchRecord& log, const MatchResult& result) {
  auto goal = result.goals.begin();
  const auto add_goals_until = [&](int time) {
    for (; goal != result.goals.end() && goal->cycle <= time; ++goal) {
      ++scores_[soccer::side_index(goal->side)];
      add_goal(*goal);
    }
  };

  for (const gamelog::Note& note : log.notes) {
    const auto* mode = std::get_if<soccer::PlayMode>(&note.content);
    if (mode == nullptr) continue;
    add_goals_until(note.time);
    add_play_mode(note.time, *mode);
  }
  add_goals_until(result.cycles);
}

void EventRecorder::end(const MatchResult& result) {
  add(result.cycles, "ended",
      {{"end_reason", name(result.end_reason)},
       {"score", {result.left.score, result.right.score}}});
}

}  // namespace cls::match
