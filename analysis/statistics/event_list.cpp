// Merges events of all kinds by frame.
#include "analysis/statistics/event_list.h"

#include <algorithm>

#include "soccer/pitch.h"

namespace cls::analysis {
namespace {

using soccer::Vec2;

class EventList {
 public:
  explicit EventList(const MatchStatistics& all) : all_(all), record_(*all.flow.record) {}

  std::vector<Event> collect() {
    for (const Pass& pass : all_.passes) add_pass(pass);
    for (const Carry& carry : all_.carries) add_carry(carry);
    for (const Shot& shot : all_.shots) add_shot(shot);
    for (const Foul& foul : all_.stoppages.fouls) add_foul(foul);
    for (const Goal& goal : all_.goals) add_goal(goal);
    add_tackles();
    std::stable_sort(events_.begin(), events_.end(),
                     [](const Event& a, const Event& b) { return a.frame < b.frame; });
    return std::move(events_);
  }

 private:
  Event& add(std::uint32_t frame, std::string_view kind, std::int8_t slot) {
    Event& event = events_.emplace_back();
    event.frame = frame;
    event.cycle = record_.time[frame];
    event.stopped = record_.stopped[frame];
    event.kind = kind;
    event.slot = slot;
    return event;
  }

  static double sign(std::int8_t slot) { return attack_sign(slot_index(slot)); }

  void add_pass(const Pass& pass) {
    Event& event = add(all_.flow.touches[pass.touch].frame, "pass", pass.passer);
    event.from = pass.from * sign(pass.passer);
    event.to = pass.to * sign(pass.passer);
    event.other = pass.receiver;
    event.result = name(pass.outcome);
    event.pass = static_cast<std::int32_t>(&pass - all_.passes.data());
    const auto mark = [&event](bool applies, std::string_view text) {
      if (applies) event.marks.push_back(text);
    };
    mark(pass.through, "through");
    mark(pass.cross, "cross");
    mark(pass.switched, "switch");
    mark(pass.cutback, "cutback");
    mark(pass.clearance, "clearance");
  }

  void add_carry(const Carry& carry) {
    Event& event = add(all_.flow.touches[carry.touch].frame, "carry", carry.slot);
    event.from = carry.from * sign(carry.slot);
    event.to = carry.to * sign(carry.slot);
    event.result = carry.passed > 0 ? "take_on" : carry.dribble ? "dribble" : "touch";
  }

  void add_shot(const Shot& shot) {
    const Touch& touch = all_.flow.touches[shot.touch];
    Event& event = add(touch.frame, "shot", shot.slot);
    event.from = touch.contact;
    event.to = Vec2{soccer::kHalfLength, shot.goal_y} * sign(shot.slot);
    event.result = name(shot.outcome);
  }

  void add_foul(const Foul& foul) {
    Event& event = add(foul.frame, "foul", foul.fouler);
    event.from = record_.ball_position[foul.frame];
    event.to = event.from;
    event.other = foul.victim;
    event.result = soccer::name(foul.mode);
  }

  void add_goal(const Goal& goal) {
    Event& event = add(goal.frame, "goal", goal.scorer);
    event.from = record_.ball_position[goal.frame];
    event.to = event.from;
    event.result = goal.own_goal ? "own_goal" : "goal";
  }

  void add_tackles() {
    for (const Touch& touch : all_.flow.touches) {
      if (touch.kind != TouchKind::kTackle || touch.contested()) continue;
      Event& event = add(touch.frame, "tackle", touch.slot);
      event.from = touch.contact;
      event.to = record_.ball_position[touch.frame];
      event.other = all_.flow.owner[touch.frame - 1];
      event.result = "hit";
    }
  }

  const MatchStatistics& all_;
  const gamelog::MatchRecord& record_;
  std::vector<Event> events_;
};

}  // namespace

std::vector<Event> list_events(const MatchStatistics& statistics) {
  return EventList(statistics).collect();
}

}  // namespace cls::analysis
