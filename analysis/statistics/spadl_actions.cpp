// Maps each event, and adds what an opponent did to it.
#include "analysis/statistics/spadl_actions.h"

#include <algorithm>

#include "analysis/statistics/event_list.h"
#include "base/text/enum_names.h"
#include "soccer/pitch.h"
#include "soccer/play_mode.h"

namespace cls::analysis {
namespace {

using gamelog::MatchRecord;
using soccer::PlayMode;
using soccer::Vec2;

constexpr auto kTypeNames = base::enum_names<SpadlType>(
    "pass", "cross", "throw_in", "freekick_crossed", "freekick_short", "corner_crossed",
    "corner_short", "take_on", "foul", "tackle", "interception", "shot", "shot_penalty",
    "shot_freekick", "keeper_save", "keeper_claim", "keeper_punch", "keeper_pick_up", "clearance",
    "bad_touch", "non_action", "dribble", "goalkick");
constexpr auto kResultNames = base::enum_names<SpadlResult>("fail", "success", "offside", "owngoal",
                                                            "yellow_card", "red_card");
// A card follows its foul within these frames.
constexpr std::size_t kCardFrames = 30;

Vec2 on_pitch(Vec2 point) {
  return {std::clamp(point.x, -soccer::kHalfLength, soccer::kHalfLength) + soccer::kHalfLength,
          soccer::kHalfWidth - std::clamp(point.y, -soccer::kHalfWidth, soccer::kHalfWidth)};
}

SpadlType pass_type(const Pass& pass, PlayMode before) {
  switch (before) {
    case PlayMode::kKickInLeft:
      return SpadlType::kThrowIn;
    case PlayMode::kCornerKickLeft:
      return pass.cross ? SpadlType::kCornerCrossed : SpadlType::kCornerShort;
    case PlayMode::kFreeKickLeft:
    case PlayMode::kIndirectFreeKickLeft:
      return pass.cross ? SpadlType::kFreeKickCrossed : SpadlType::kFreeKickShort;
    case PlayMode::kGoalKickLeft:
      return SpadlType::kGoalKick;
    default:
      return pass.cross       ? SpadlType::kCross
             : pass.clearance ? SpadlType::kClearance
                              : SpadlType::kPass;
  }
}

class SpadlList {
 public:
  explicit SpadlList(const MatchStatistics& all)
      : all_(all), record_(*all.flow.record), events_(list_events(all)) {}

  std::vector<SpadlAction> collect() {
    for (std::size_t i = 0; i < events_.size(); ++i) add(events_[i], i);
    std::ranges::stable_sort(actions_, {}, &Ranked::order);

    std::vector<SpadlAction> actions;
    for (const Ranked& one : actions_) actions.push_back(one.action);
    return actions;
  }

 private:
  // Who wins the ball does so before the pass that the same touch is.
  struct Ranked {
    SpadlAction action;
    int rank;

    std::pair<std::uint32_t, int> order() const { return {action.frame, rank}; }
  };

  SpadlAction action_of(const Event& event, std::size_t index, SpadlType type) const {
    return {.frame = event.frame,
            .slot = event.slot,
            .start = on_pitch(event.from),
            .end = on_pitch(event.to),
            .type = type,
            .event = index};
  }

  void push(SpadlAction action, SpadlResult result, int rank = 1) {
    action.result = result;
    if (action.slot != kNoPlayer) actions_.push_back({action, rank});
  }

  void add(const Event& event, std::size_t index) {
    switch (event.kind) {
      case EventKind::kPass:
        return add_pass(event, index);
      case EventKind::kCarry:
        return add_carry(event, index);
      case EventKind::kShot:
        return add_shot(event, index);
      case EventKind::kTackle:
        return add_tackle(event, index);
      case EventKind::kFoul:
        return add_foul(event, index);
      case EventKind::kGoal:
        if (!all_.goals[event.index].own_goal) return;
        return push(action_of(event, index, SpadlType::kBadTouch), SpadlResult::kOwnGoal);
    }
  }

  PlayMode mode_before(const Event& event) const {
    return soccer::without_side(record_.mode[event.frame == 0 ? 0 : event.frame - 1]);
  }

  void add_pass(const Event& event, std::size_t index) {
    const Pass& pass = all_.passes[event.index];
    const SpadlAction action = action_of(event, index, pass_type(pass, mode_before(event)));
    push(action, pass.completed()                        ? SpadlResult::kSuccess
                 : pass.outcome == PassOutcome::kOffside ? SpadlResult::kOffside
                 : action.type == SpadlType::kClearance  ? SpadlResult::kSuccess
                                                         : SpadlResult::kFail);
    if (pass.outcome == PassOutcome::kIntercepted) add_interception(pass);
  }

  // A tackle that wins the ball is an event of its own.
  void add_interception(const Pass& pass) {
    const Touch& touch = all_.flow.touches[pass.touch + 1];
    if (touch.kind == TouchKind::kTackle) return;
    const SpadlType type = touch.kind == TouchKind::kPunch ? SpadlType::kKeeperPunch
                           : touch.kind == TouchKind::kCatch
                               ? (pass.cross ? SpadlType::kKeeperClaim : SpadlType::kKeeperPickUp)
                               : SpadlType::kInterception;
    push_answer(touch, type);
  }

  void push_answer(const Touch& touch, SpadlType type) {
    const bool by_hand = touch.kind == TouchKind::kCatch || touch.kind == TouchKind::kPunch;
    push({.frame = touch.frame,
          .slot = touch.slot,
          .start = on_pitch(touch.contact),
          .end = on_pitch(touch.contact),
          .type = type,
          .body_part = by_hand ? SpadlBodyPart::kOther : SpadlBodyPart::kFoot},
         SpadlResult::kSuccess, 0);
  }

  void add_carry(const Event& event, std::size_t index) {
    const Carry& carry = all_.carries[event.index];
    if (carry.passed == 0 && !carry.dribble) return;
    push(action_of(event, index, carry.passed > 0 ? SpadlType::kTakeOn : SpadlType::kDribble),
         SpadlResult::kSuccess);
  }

  void add_shot(const Event& event, std::size_t index) {
    const Shot& shot = all_.shots[event.index];
    const bool free_kick = mode_before(event) == PlayMode::kFreeKickLeft;
    push(action_of(event, index, free_kick ? SpadlType::kShotFreeKick : SpadlType::kShot),
         shot.outcome == ShotOutcome::kGoal ? SpadlResult::kSuccess : SpadlResult::kFail);

    if (shot.outcome == ShotOutcome::kSaved && shot.touch + 1 < all_.flow.touches.size()) {
      push_answer(all_.flow.touches[shot.touch + 1], SpadlType::kKeeperSave);
    }
  }

  // Only for the ball of an opponent; a tackle of the own ball is a hard kick.
  void add_tackle(const Event& event, std::size_t index) {
    if (event.other == kNoPlayer || same_team(event.other, event.slot)) return;
    SpadlAction action = action_of(event, index, SpadlType::kTackle);
    action.end = action.start;
    push(action, wins_ball(event) ? SpadlResult::kSuccess : SpadlResult::kFail, 0);
  }

  // True if the team touches the ball next in the same live phase.
  bool wins_ball(const Event& event) const {
    const std::vector<Touch>& touches = all_.flow.touches;
    if (event.index + 1 == touches.size() || touches[event.index + 1].contested()) return false;

    const Touch& next = touches[event.index + 1];
    return next.live_phase == touches[event.index].live_phase && same_team(next.slot, event.slot);
  }

  void add_foul(const Event& event, std::size_t index) {
    if (event.slot == kNoPlayer) return;
    push(action_of(event, index, SpadlType::kFoul), card_after(event));
  }

  SpadlResult card_after(const Event& event) const {
    const std::size_t slot = slot_index(event.slot);
    const std::size_t end = std::min(record_.frames(), event.frame + kCardFrames);
    for (std::size_t i = event.frame; i < end; ++i) {
      const std::uint32_t cards = newly_set(record_, entry_of(i, slot));
      if ((cards & gamelog::kStateRedCard) != 0) return SpadlResult::kRedCard;
      if ((cards & gamelog::kStateYellowCard) != 0) return SpadlResult::kYellowCard;
    }
    return SpadlResult::kFail;
  }

  const MatchStatistics& all_;
  const MatchRecord& record_;
  std::vector<Event> events_;
  std::vector<Ranked> actions_;
};

}  // namespace

std::string_view name(SpadlType type) { return kTypeNames.name(type); }
std::string_view name(SpadlResult result) { return kResultNames.name(result); }
std::string_view name(SpadlBodyPart part) {
  return part == SpadlBodyPart::kFoot ? "foot" : "other";
}

std::vector<SpadlAction> spadl_actions(const MatchStatistics& statistics) {
  return SpadlList(statistics).collect();
}

}  // namespace cls::analysis
