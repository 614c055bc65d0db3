// Looks back from shots and goals to the pass before and to the loss of the ball.
#include "review/chances.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "analysis/play/pitch_areas.h"
#include "analysis/statistics/event_list.h"

namespace cls::review {
namespace {

using analysis::Event;
using analysis::EventKind;
using analysis::MatchStatistics;
using soccer::Side;

constexpr double kCloseShot = 8.0;  // meters to the goal
constexpr double kFarShot = 18.0;
constexpr std::uint32_t kRunUp = 60;  // frames before a shot in which its last pass is looked for

struct Attack {
  std::uint32_t frame = 0;  ///< of the shot; of a goal without one the goal
  Side side = Side::kNeutral;
  const analysis::Shot* shot = nullptr;
  bool own_goal = false;
};

bool is_of(const Event& event, Side side) {
  return event.slot != soccer::kNoPlayer && analysis::side_of(event.slot) == side;
}

bool has_mark(const Event& event, std::string_view mark) {
  return std::ranges::find(event.marks, mark) != event.marks.end();
}

bool from_set_play(const MatchStatistics& match, const Attack& attack) {
  if (attack.shot == nullptr) return false;
  const analysis::Chain* chain = chain_of(match.chains, *attack.shot);
  return chain != nullptr && chain->from_set_play;
}

// How the other team lost the ball before an attack.
std::string origin_of(const MatchStatistics& match, const std::vector<Event>& events,
                      const Attack& attack) {
  if (attack.own_goal) return "own goal";
  if (from_set_play(match, attack)) return "set play";

  const Side loser = soccer::opponent(attack.side);
  const Event* last = nullptr;
  for (const Event& event : events) {
    if (event.frame >= attack.frame) break;
    const bool plays = event.kind == EventKind::kPass || event.kind == EventKind::kCarry ||
                       event.kind == EventKind::kShot || event.kind == EventKind::kTackle;
    if (plays && is_of(event, loser)) last = &event;
  }
  if (last == nullptr) return "kick-off";

  const std::string where = analysis::third_name(soccer::sign(loser) * last->from.x);
  if (has_mark(*last, "clearance")) return fmt::format("clearance from {}", where);
  const char* kind = last->kind == EventKind::kPass    ? "pass"
                     : last->kind == EventKind::kCarry ? "dribble"
                     : last->kind == EventKind::kShot  ? "shot"
                                                       : "tackle";
  return fmt::format("{} lost in {}", kind, where);
}

// The last pass before a shot, and from where the shot came.
std::string finish_of(const std::vector<Event>& events, const Attack& attack) {
  if (attack.shot == nullptr) return "without a shot";
  const double distance = attack.shot->distance;
  const char* where = distance < kCloseShot ? "close" : distance > kFarShot ? "far" : "middle";

  const Event* last = nullptr;
  for (const Event& event : events) {
    const bool near = event.frame < attack.frame && event.frame + kRunUp >= attack.frame;
    if (near && event.kind == EventKind::kPass && is_of(event, attack.side) &&
        event.result == analysis::name(analysis::PassOutcome::kCompleted)) {
      last = &event;
    }
  }

  std::string how = last == nullptr ? "solo" : "pass";
  for (const char* mark : {"switch", "through", "cutback", "cross"}) {
    if (last != nullptr && has_mark(*last, mark)) how = mark;
  }
  return fmt::format("{}, {} shot", how, where);
}

Chance chance_of(const MatchStatistics& match, const std::vector<Event>& events,
                 const Attack& attack, double worth) {
  return {attack.frame, match.flow.record->time[attack.frame], worth,
          origin_of(match, events, attack), finish_of(events, attack)};
}

}  // namespace

Chances find_chances(const MatchStatistics& match, Side side) {
  const std::vector<Event> events = analysis::list_events(match);
  Chances chances;
  for (const analysis::Goal& goal : match.goals) {
    if (goal.side == side) continue;
    Attack attack{goal.frame, goal.side, nullptr, goal.own_goal};
    if (goal.shot >= 0) attack.shot = &match.shots[base::index(goal.shot)];
    chances.against.push_back(chance_of(match, events, attack, 1.0));
  }

  for (std::size_t i = 0; i < match.shots.size(); ++i) {
    const analysis::Shot& shot = match.shots[i];
    if (analysis::side_of(shot.slot) != side || shot.outcome == analysis::ShotOutcome::kGoal) {
      continue;
    }
    const Attack attack{match.flow.touches[shot.touch].frame, side, &shot};
    chances.wasted.push_back(chance_of(match, events, attack, match.expected[i]));
  }
  return chances;
}

std::vector<ChanceClass> classes_of(const std::vector<std::vector<Chance>>& chances,
                                    std::string Chance::*field) {
  std::map<std::string, std::pair<ChanceClass, double>> classes;
  for (std::size_t match = 0; match < chances.size(); ++match) {
    for (const Chance& chance : chances[match]) {
      auto& [sum, worst] = classes[chance.*field];
      sum.name = chance.*field;
      ++sum.chances;
      sum.worth += chance.worth;
      if (chance.worth <= worst) continue;
      worst = chance.worth;
      sum.worst = {match, chance.cycle};
    }
  }

  std::vector<ChanceClass> sorted;
  for (const auto& [name, entry] : classes) sorted.push_back(entry.first);
  std::ranges::stable_sort(sorted, std::ranges::greater{}, &ChanceClass::worth);
  return sorted;
}

}  // namespace cls::review
