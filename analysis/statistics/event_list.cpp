// Merges events of all kinds by frame.
#include "analysis/statistics/event_list.h"

#include <algorithm>
#include <utility>

#include "base/text/enum_names.h"
#include "soccer/pitch.h"

namespace cls::analysis {
namespace {

using soccer::Vec2;

constexpr auto kKindNames =
    base::enum_names<EventKind>("pass", "carry", "shot", "tackle", "foul", "goal");

class EventList {
 public:
  explicit EventList(const MatchStatistics& all) : all_(all), record_(*all.flow.record) {}

  std::vector<Event> collect() {
    for (std::size_t i = 0; i < all_.passes.size(); ++i) add_pass(i);
    for (std::size_t i = 0; i < all_.carries.size(); ++i) add_carry(i);
    for (std::size_t i = 0; i < all_.shots.size(); ++i) add_shot(i);
    for (std::size_t i = 0; i < all_.stoppages.fouls.size(); ++i) add_foul(i);
    for (std::size_t i = 0; i < all_.goals.size(); ++i) add_goal(i);
    for (std::size_t i = 0; i < all_.flow.touches.size(); ++i) add_tackle(i);

    std::ranges::stable_sort(events_, {}, &Event::frame);
    return std::move(events_);
  }

 private:
  Event& add(EventKind kind, std::size_t index, std::uint32_t frame, std::int8_t slot) {
    Event& event = events_.emplace_back();
    event.kind = kind;
    event.index = index;
    event.frame = frame;
    event.cycle = record_.time[frame];
    event.stopped = record_.stopped[frame];
    event.slot = slot;
    event.from = record_.ball_position[frame];
    event.to = event.from;
    return event;
  }

  const Touch& touch(const auto& action) const { return all_.flow.touches[action.touch]; }

  void add_pass(std::size_t index) {
    const Pass& pass = all_.passes[index];
    Event& event = add(EventKind::kPass, index, touch(pass).frame, pass.passer);
    event.from = pass.from * attack_sign(pass.passer);
    event.to = pass.to * attack_sign(pass.passer);
    event.other = pass.receiver;
    event.result = name(pass.outcome);

    for (const auto& [applies, mark] :
         {std::pair(pass.through, "through"), std::pair(pass.cross, "cross"),
          std::pair(pass.switched, "switch"), std::pair(pass.cutback, "cutback"),
          std::pair(pass.clearance, "clearance")}) {
      if (applies) event.marks.emplace_back(mark);
    }
  }

  void add_carry(std::size_t index) {
    const Carry& carry = all_.carries[index];
    Event& event = add(EventKind::kCarry, index, touch(carry).frame, carry.slot);
    event.from = carry.from * attack_sign(carry.slot);
    event.to = carry.to * attack_sign(carry.slot);
    event.result = carry.passed > 0 ? "take_on" : carry.dribble ? "dribble" : "touch";
  }

  void add_shot(std::size_t index) {
    const Shot& shot = all_.shots[index];
    Event& event = add(EventKind::kShot, index, touch(shot).frame, shot.slot);
    event.from = touch(shot).contact;
    event.to = Vec2{soccer::kHalfLength, shot.goal_y} * attack_sign(shot.slot);
    event.result = name(shot.outcome);
  }

  void add_foul(std::size_t index) {
    const Foul& foul = all_.stoppages.fouls[index];
    Event& event = add(EventKind::kFoul, index, foul.frame, foul.fouler);
    event.other = foul.victim;
    event.result = soccer::name(foul.mode);
  }

  void add_goal(std::size_t index) {
    const Goal& goal = all_.goals[index];
    Event& event = add(EventKind::kGoal, index, goal.frame, goal.scorer);
    event.result = goal.own_goal ? "own_goal" : "goal";
  }

  void add_tackle(std::size_t index) {
    const Touch& touch = all_.flow.touches[index];
    if (touch.kind != TouchKind::kTackle || touch.contested()) return;
    Event& event = add(EventKind::kTackle, index, touch.frame, touch.slot);
    event.from = touch.contact;
    event.other = all_.flow.owner[touch.frame - 1];
    event.result = "hit";
  }

  const MatchStatistics& all_;
  const gamelog::MatchRecord& record_;
  std::vector<Event> events_;
};

}  // namespace

std::string_view name(EventKind kind) { return kKindNames.name(kind); }

std::vector<Event> list_events(const MatchStatistics& statistics) {
  return EventList(statistics).collect();
}

}  // namespace cls::analysis
