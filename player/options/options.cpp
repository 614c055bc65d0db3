// Sorts the planner's candidates into classes, and executes what is chosen.
#include "player/options/options.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/index.h"
#include "base/text/decimal_text.h"
#include "player/ball_skills/ball_skills.h"
#include "player/behaviors/automatic_play.h"
#include "player/options/option_classes.h"
#include "player/options/played_options.h"
#include "player/planner/plan_execution.h"
#include "player/world/places.h"

namespace cls::player {
namespace {

bool in_open_play(const WorldModel& world) {
  return !world.game.goalie_catch &&
         (world.game.mode == PlayMode::kPlayOn || world.game.mode == PlayMode::kDropBall);
}

/// Which candidate stands for its class: the one with more room, as far as room counts, and of
/// those the one that leads farther ahead.
double preference(const OptionTarget& target) {
  constexpr double kEnoughRoom = 4.0;
  constexpr double kRoomWeight = 4.0;
  return kRoomWeight * std::min(target.room, kEnoughRoom) + target.action.target_point.x;
}

void find_targets(const PlannerField& field, OptionTable& out) {
  for (const PlanAction& action : ball_candidates(field)) {
    const int id = option_class(field.world, action);
    if (id < 0) continue;
    const OptionTarget target{id, action, nearest_opponent(field, action.target_point)};
    const auto known = std::ranges::find(out.targets, id, &OptionTarget::id);
    if (known == out.targets.end()) {
      out.targets.push_back(target);
    } else if (preference(target) > preference(*known)) {
      *known = target;
    }
  }
  std::ranges::sort(out.targets, {}, &OptionTarget::id);
}

void find_ball_options(const WorldModel& world, OptionTable& out) {
  out.choice = OptionTable::Choice::kWithBall;
  find_targets(PlannerField(world, out.held(world)), out);

  const std::optional<Gap> gap = gap_in_range(world);
  const bool play_on = world.game.mode == PlayMode::kPlayOn;
  out.shot_gap = gap && play_on ? gap->degrees : 0.0;
  out.legal[kShootOption] = out.shot_gap > 0.0;
  out.legal[kHoldOption] = true;
  out.legal[kLayOffOption] = play_on && lay_off_receiver(world) != nullptr;
  out.legal[kClearOption] = true;
  for (const OptionTarget& target : out.targets) out.legal[base::index(target.id)] = true;
}

void find_moves(const WorldModel& world, const ActionMemory& memory, OptionTable& out) {
  out.choice = OptionTable::Choice::kWithoutBall;
  out.moves = moves_of(world, memory);
  const auto allow = [&out](MoveKind kind, bool offered) {
    out.legal[base::index(move_option(kind))] = offered;
  };

  out.legal[kAutoOption] = true;
  allow(MoveKind::kTackle, out.moves.may_tackle);
  allow(MoveKind::kIntercept, out.moves.may_intercept);
  allow(MoveKind::kPress, out.moves.press.has_value());
  allow(MoveKind::kBlock, out.moves.block.has_value());
  allow(MoveKind::kSupport, out.moves.support.has_value());
  allow(MoveKind::kMark, out.moves.mark.has_value());
  std::fill(out.legal.begin() + kHomeOption, out.legal.end(), true);
}

bool play_with_ball(ActionContext& c, const OptionTable& table, int id) {
  if (const OptionTarget* target = table.target(id)) return execute_action(c, target->action);
  switch (id) {
    case kShootOption:
      return shoot_into_gap(c);
    case kLayOffOption:
      return lay_off(c);
    case kClearOption:
      return kick_outlet(c);
    default:
      return c.world.game.mode == PlayMode::kPlayOn && keep_ball(c);
  }
}

/// A distance from the home position, in meters and degrees.
struct HomeShift {
  double meters = 0.0;
  double direction = 0.0;

  Vec2 vector() const { return soccer::polar_degrees(meters, direction); }
};

HomeShift home_shift(int id) {
  const int shift = id - kShiftedHomeOption;
  return {kShifts[base::index(shift / kShiftDirections)],
          360.0 / kShiftDirections * (shift % kShiftDirections) - 180.0};
}

/// Of a move, a home position that is shifted included.
bool play_move(ActionContext& c, const OptionTable& table, int id) {
  if (id < kShiftedHomeOption) {
    return make_move(c, table.moves, static_cast<MoveKind>(id - kMoveOption));
  }
  return make_move(c, table.moves, MoveKind::kHome, home_shift(id).vector());
}

std::optional<Vec2> target_of_move(const Moves& moves, int id) {
  if (id >= kShiftedHomeOption) return moves.home + home_shift(id).vector();
  switch (static_cast<MoveKind>(id - kMoveOption)) {
    case MoveKind::kPress:
      return moves.press;
    case MoveKind::kBlock:
      return moves.block;
    case MoveKind::kSupport:
      return moves.support;
    case MoveKind::kMark:
      return moves.mark;
    case MoveKind::kHome:
      return moves.home;
    case MoveKind::kTackle:
    case MoveKind::kIntercept:
      break;
  }
  return std::nullopt;
}

/// A decision whose commands are not used.
struct Trial {
  Trial(const WorldModel& world, const ActionMemory& before)
      : memory(before), slots(world), context{world, memory, slots, neck, report, choice} {}
  Trial(const Trial&) = delete;
  Trial& operator=(const Trial&) = delete;

  ActionMemory memory;
  CommandSlots slots;
  NeckPlan neck;
  ActionReport report;
  PlanChoice choice;
  ActionContext context;
};

/// Of a decision that has begun.
void find_options_in(Trial& trial, OptionTable& out) {
  const WorldModel& world = trial.context.world;
  out.choice = OptionTable::Choice::kNothing;
  out.legal.fill(false);
  out.ball_since = trial.memory.ball_since;
  out.shot_gap = 0.0;
  out.targets.clear();
  out.moves = {};

  // What is played in set plays and by a goalie is not tried: it may be a plan, too.
  if (!in_open_play(world) || world.goalie || play_without_choice(trial.context)) {
    out.legal[kAutoOption] = true;
  } else if (world.self.kickable) {
    find_ball_options(world, out);
  } else {
    find_moves(world, trial.memory, out);
  }
}

}  // namespace

std::string option_name(int id) {
  constexpr std::array kWithBall = {"auto", "shoot", "hold", "lay_off", "clear"};
  constexpr std::array kPasses = {"feet", "ahead", "through", "cross"};
  constexpr std::array kMoves = {"tackle",  "intercept", "press", "block",
                                 "support", "mark",      "home"};

  if (id < kDribbleOption) return kWithBall[base::index(id)];
  if (id < kPassOption) return "dribble_" + std::to_string(id - kDribbleOption);
  if (id < kMoveOption) {
    const int pass = id - kPassOption;
    return "pass_" + std::to_string(pass / kPassKinds + 1) + "_" +
           kPasses[base::index(pass % kPassKinds)];
  }
  if (id < kShiftedHomeOption) return kMoves[base::index(id - kMoveOption)];
  const int shift = id - kShiftedHomeOption;
  return "home_" +
         std::to_string(static_cast<int>(kShifts[base::index(shift / kShiftDirections)])) + "_" +
         std::to_string(shift % kShiftDirections);
}

std::string option_text(int id) {
  constexpr std::array kPasses = {"pass to feet", "pass ahead", "through pass", "cross"};
  if (id >= kDribbleOption && id < kPassOption) {
    const double direction = 360.0 / kDribbleDirections * (id - kDribbleOption) - 180.0;
    return "dribble " + base::decimal_text(direction, 1) + " deg";
  }
  if (id >= kPassOption && id < kMoveOption) {
    return kPasses[base::index((id - kPassOption) % kPassKinds)];
  }
  if (id >= kShiftedHomeOption) {
    const HomeShift shift = home_shift(id);
    return "home " + base::decimal_text(shift.meters, 1) + " m at " +
           base::decimal_text(shift.direction, 1) + " deg";
  }
  std::string text = option_name(id);
  std::ranges::replace(text, '_', ' ');
  return text;
}

const OptionTarget* OptionTable::target(int id) const {
  const auto found = std::ranges::lower_bound(targets, id, {}, &OptionTarget::id);
  return found != targets.end() && found->id == id ? &*found : nullptr;
}

OptionAim aim_of(const WorldModel& world, const OptionTable& table, int id) {
  if (id >= kMoveOption) return {0, target_of_move(table.moves, id), std::nullopt};
  if (const OptionTarget* target = table.target(id)) {
    const int receiver = id < kPassOption ? 0 : target->action.target;
    return {receiver, target->action.target_point, target->room};
  }
  if (id == kShootOption) {
    if (const std::optional<Gap> gap = gap_in_range(world)) return {0, gap->target, std::nullopt};
  }
  if (id == kLayOffOption) {
    if (const PlayerState* receiver = lay_off_receiver(world)) {
      return {receiver->unum, receiver->position, std::nullopt};
    }
  }
  return {};
}

bool play_without_choice(ActionContext& c) {
  const WorldModel& world = c.world;
  if (play_automatically(c, {})) return true;
  if (soccer::is_penalty_mode(world.game.mode)) {
    play_penalty(c);
  } else if (!in_open_play(world)) {
    play_set_play(c);
  } else if (world.goalie) {
    play_goalie(c);
  } else if (world.self.kickable && must_leave_ball(world, c.memory)) {
    leave_ball(c);
  } else {
    return world.self.kickable && shoot_and_look(c);
  }
  return true;
}

void find_options(const WorldModel& world, const ActionMemory& memory, OptionTable& out) {
  Trial trial(world, memory);
  begin_decision(trial.context);
  find_options_in(trial, out);
}

void find_options(const ActionContext& begun, OptionTable& out) {
  Trial trial(begun.world, begun.memory);
  find_options_in(trial, out);
}

int planner_option(const WorldModel& world, const OptionTable& table,
                   const PlannerOptions& options) {
  if (table.choice == OptionTable::Choice::kNothing) return -1;
  if (table.choice == OptionTable::Choice::kWithoutBall) return move_option(table.moves.usual);
  if (is_ball_in_danger(world)) return kClearOption;

  const PlannerField field(world, table.held(world));
  const Plan plan = make_plan(field, options);
  return option_of_plan(world, table, plan, plan.best);
}

void play_option(ActionContext& c, const OptionTable& table, int id) {
  if (play_without_choice(c)) return;
  const bool legal = id >= 0 && id < kOptionCount && table.legal[base::index(id)];

  if (c.world.self.kickable) {
    if (legal && play_with_ball(c, table, id)) return;
    c.neck.kind = NeckPlan::Kind::kScan;
    hold_ball(c.world, c.slots, false, {});
  } else if (!legal || id == kAutoOption || !play_move(c, table, id)) {
    basic_move(c);
  }
}

}  // namespace cls::player
