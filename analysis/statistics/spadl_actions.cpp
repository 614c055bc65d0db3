// Maps each event, and adds what an opponent did to it.
#include "analysis/statistics/spadl_actions.h"

#include <algorithm>
#include <array>

#include "analysis/statistics/event_list.h"
#include "soccer/pitch.h"
#include "soccer/play_mode.h"

namespace cls::analysis {
namespace {

using gamelog::MatchRecord;
using soccer::PlayMode;
using soccer::Vec2;

constexpr std::array<std::string_view, 23> kTypeNames = {
    "pass",           "cross",          "throw_in",     "freekick_crossed",
    "freekick_short", "corner_crossed", "corner_short", "take_on",
    "foul",           "tackle",         "interception", "shot",
    "shot_penalty",   "shot_freekick",  "keeper_save",  "keeper_claim",
    "keeper_punch",   "keeper_pick_up", "clearance",    "bad_touch",
    "non_action",     "dribble",        "goalkick"};
constexpr std::array<std::string_view, 6> kResultNames = {"fail",    "success",     "offside",
                                                          "owngoal", "yellow_card", "red_card"};
// A card follows its foul within these frames.
constexpr std::size_t kCardFrames = 30;

Vec2 on_pitch(Vec2 point) {
  return {std::clamp(point.x, -soccer::kHalfLength, soccer::kHalfLength) + soccer::kHalfLength,
          soccer::kHalfWidth - std::clamp(point.y, -soccer::kHalfWidth, soccer::kHalfWidth)};
}

bool has_mark(const Event& event, std::string_view mark) {
  return std::find(event.marks.begin(), event.marks.end(), mark) != event.marks.end();
}

SpadlType pass_type(const Event& event, PlayMode before) {
  const bool cross = has_mark(event, "cross");
  switch (soccer::without_side(before)) {
    case PlayMode::kKickInLeft:
      return SpadlType::kThrowIn;
    case PlayMode::kCornerKickLeft:
      return cross ? SpadlType::kCornerCrossed : SpadlType::kCornerShort;
    case PlayMode::kFreeKickLeft:
    case PlayMode::kIndirectFreeKickLeft:
      return cross ? SpadlType::kFreeKickCrossed : SpadlType::kFreeKickShort;
    case PlayMode::kGoalKickLeft:
      return SpadlType::kGoalKick;
    default:
      return cross                          ? SpadlType::kCross
             : has_mark(event, "clearance") ? SpadlType::kClearance
                                            : SpadlType::kPass;
  }
}

class SpadlList {
 public:
  explicit SpadlList(const MatchStatistics& all)
      : all_(all), record_(*all.flow.record), events_(list_events(all)) {}

  std::vector<SpadlAction> collect() {
    for (std::size_t i = 0; i < events_.size(); ++i) add(events_[i], i);
    std::stable_sort(actions_.begin(), actions_.end(),
                     [](const Ranked& a, const Ranked& b) { return a.order() < b.order(); });
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
    SpadlAction action;
    action.frame = event.frame;
    action.slot = event.slot;
    action.start = on_pitch(event.from);
    action.end = on_pitch(event.to);
    action.type = type;
    action.event = index;
    return action;
  }

  void push(SpadlAction action, SpadlResult result, int rank = 1) {
    action.result = result;
    if (action.slot != kNoPlayer) actions_.push_back({action, rank});
  }

  void add(const Event& event, std::size_t index) {
    if (event.kind == "pass") add_pass(event, index);
    if (event.kind == "carry") add_carry(event, index);
    if (event.kind == "shot") add_shot(event, index);
    if (event.kind == "tackle") add_tackle(event, index);
    if (event.kind == "foul") add_foul(event, index);
    if (event.kind == "goal" && event.result == "own_goal") {
      push(action_of(event, index, SpadlType::kBadTouch), SpadlResult::kOwnGoal);
    }
  }

  PlayMode mode_before(const Event& event) const {
    return record_.mode[event.frame == 0 ? 0 : event.frame - 1];
  }

  void add_pass(const Event& event, std::size_t index) {
    const Pass& pass = all_.passes[static_cast<std::size_t>(event.pass)];
    SpadlAction action = action_of(event, index, pass_type(event, mode_before(event)));
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
    SpadlAction action;
    action.frame = touch.frame;
    action.slot = touch.slot;
    action.start = on_pitch(touch.contact);
    action.end = action.start;
    action.type = type;
    const bool by_hand = touch.kind == TouchKind::kCatch || touch.kind == TouchKind::kPunch;
    action.body_part = by_hand ? SpadlBodyPart::kOther : SpadlBodyPart::kFoot;
    push(action, SpadlResult::kSuccess, 0);
  }

  void add_carry(const Event& event, std::size_t index) {
    if (event.result == "touch") return;
    const bool take_on = event.result == "take_on";
    push(action_of(event, index, take_on ? SpadlType::kTakeOn : SpadlType::kDribble),
         SpadlResult::kSuccess);
  }

  void add_shot(const Event& event, std::size_t index) {
    const PlayMode before = soccer::without_side(mode_before(event));
    const bool free_kick = before == PlayMode::kFreeKickLeft;
    push(action_of(event, index, free_kick ? SpadlType::kShotFreeKick : SpadlType::kShot),
         event.result == "goal" ? SpadlResult::kSuccess : SpadlResult::kFail);
    const auto shot = std::find_if(all_.shots.begin(), all_.shots.end(), [&](const Shot& one) {
      return all_.flow.touches[one.touch].frame == event.frame && one.slot == event.slot;
    });
    if (shot == all_.shots.end() || shot->outcome != ShotOutcome::kSaved) return;
    if (shot->touch + 1 < all_.flow.touches.size()) {
      push_answer(all_.flow.touches[shot->touch + 1], SpadlType::kKeeperSave);
    }
  }

  // Only for the ball of an opponent; a tackle of the own ball is a hard kick.
  void add_tackle(const Event& event, std::size_t index) {
    if (event.other == kNoPlayer || same_team(slot_index(event.other), slot_index(event.slot))) {
      return;
    }
    SpadlAction action = action_of(event, index, SpadlType::kTackle);
    action.end = action.start;
    push(action, wins_ball(event) ? SpadlResult::kSuccess : SpadlResult::kFail, 0);
  }

  // True if the team touches the ball next in the same live phase.
  bool wins_ball(const Event& event) const {
    const std::vector<Touch>& touches = all_.flow.touches;
    const auto next = std::find_if(touches.begin(), touches.end(),
                                   [&](const Touch& touch) { return touch.frame > event.frame; });
    if (next == touches.begin() || next == touches.end() || next->contested()) return false;
    return next->live_phase == (next - 1)->live_phase &&
           same_team(slot_index(next->slot), slot_index(event.slot));
  }

  void add_foul(const Event& event, std::size_t index) {
    if (event.slot == kNoPlayer) return;
    push(action_of(event, index, SpadlType::kFoul), card_after(event));
  }

  SpadlResult card_after(const Event& event) const {
    const std::size_t slot = slot_index(event.slot);
    const std::size_t end = std::min(record_.frames(), event.frame + kCardFrames);
    for (std::size_t i = event.frame; i < end; ++i) {
      const std::uint32_t newly_set =
          record_.players.state[entry_of(i, slot)] & ~record_.players.state[entry_of(i - 1, slot)];
      if ((newly_set & gamelog::kStateRedCard) != 0) return SpadlResult::kRedCard;
      if ((newly_set & gamelog::kStateYellowCard) != 0) return SpadlResult::kYellowCard;
    }
    return SpadlResult::kFail;
  }

  const MatchStatistics& all_;
  const MatchRecord& record_;
  std::vector<Event> events_;
  std::vector<Ranked> actions_;
};

}  // namespace

std::string_view name(SpadlType type) { return kTypeNames[static_cast<std::size_t>(type)]; }
std::string_view name(SpadlResult result) { return kResultNames[static_cast<std::size_t>(result)]; }
std::string_view name(SpadlBodyPart part) {
  return part == SpadlBodyPart::kFoot ? "foot" : "other";
}

std::vector<SpadlAction> spadl_actions(const MatchStatistics& statistics) {
  return SpadlList(statistics).collect();
}

}  // namespace cls::analysis
