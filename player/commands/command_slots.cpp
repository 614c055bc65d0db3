// Validates and clamps commands, and predicts their effect on the next cycle.
#include "player/commands/command_slots.h"

#include <algorithm>
#include <cmath>

#include "base/index.h"
#include "player/world/leg_dash.h"
#include "player/world/motion.h"
#include "player/world/places.h"
#include "player/world/view_cone.h"
#include "soccer/commands/rounding.h"
#include "soccer/interval.h"

namespace cls::player {
namespace {

// Arguments and results: parameters and senses of a faulty server may be anything.
bool finite(double one, double other = 0.0) { return std::isfinite(one) && std::isfinite(other); }
bool finite(Vec2 v) { return finite(v.x, v.y); }

/// Sets a slot; true, as its setter returns.
template <typename Slot, typename Command>
bool put(Slot& slot, const Command& command) {
  slot = command;
  return true;
}

}  // namespace

bool CommandSlots::dash(double power, double direction) {
  const auto& server = world_->server();
  const SelfState& self = world_->self;
  if (self.frozen() || !finite(power, direction)) return false;

  power = soccer::between(power, server.min_dash_power, server.max_dash_power);
  direction = soccer::between(direction, server.min_dash_angle, server.max_dash_angle);
  direction = math::quantize(direction, server.dash_angle_step);
  const double payable = self.stamina + world_->self_type().extra_stamina;
  power = power >= 0.0 ? std::min(power, payable) : std::max(power, -payable / 2.0);

  if (!finite(power, direction)) return false;
  return put(body_, soccer::Dash{soccer::rounded_for_command(power), direction});
}

bool CommandSlots::dash(const soccer::LegDash& legs) {
  if (world_->self.frozen() || (!legs.left && !legs.right)) return false;
  const auto& server = world_->server();
  soccer::LegDash command = legs;
  double cost = 0.0;

  for (std::optional<soccer::Dash>* leg : {&command.left, &command.right}) {
    if (!*leg) continue;
    if (!finite((*leg)->power, (*leg)->direction)) return false;
    const double direction =
        soccer::between((*leg)->direction, server.min_dash_angle, server.max_dash_angle);
    (*leg)->power = soccer::between((*leg)->power, server.min_dash_power, server.max_dash_power);
    (*leg)->direction = math::quantize(direction, server.dash_angle_step);
    cost += (*leg)->power >= 0.0 ? (*leg)->power / 2.0 : -(*leg)->power;
  }

  const double payable = world_->self.stamina + world_->self_type().extra_stamina;
  const double share = cost > payable ? payable / cost : 1.0;
  for (std::optional<soccer::Dash>* leg : {&command.left, &command.right}) {
    if (!*leg) continue;
    (*leg)->power = soccer::rounded_for_command((*leg)->power * share);
    if (!finite((*leg)->power, (*leg)->direction)) return false;
  }
  return put(body_, command);
}

bool CommandSlots::turn(double angle) {
  const auto& server = world_->server();
  if (world_->self.frozen() || !finite(angle)) return false;
  const double needed = angle * turn_resistance(world_->self_type(), world_->self.velocity);
  const double moment = soccer::between(needed, server.minmoment, server.maxmoment);
  return finite(moment) && put(body_, soccer::Turn{soccer::rounded_for_command(moment)});
}

bool CommandSlots::kick(double power, double direction) {
  if (!world_->self.kickable || world_->self.frozen()) return false;
  if (!finite(power, direction)) return false;
  power = soccer::between(power, 0.0, world_->server().maxpower);
  if (!finite(power)) return false;
  return put(body_, soccer::Kick{soccer::rounded_for_command(power),
                                 soccer::rounded_for_command(math::normalize_degrees(direction))});
}

bool CommandSlots::tackle(double direction, bool foul) {
  if (world_->self.frozen() || !finite(direction)) return false;
  return put(body_,
             soccer::Tackle{soccer::rounded_for_command(math::normalize_degrees(direction)), foul});
}

bool CommandSlots::catch_ball() {
  const auto& server = world_->server();
  const PlayMode mode = without_side(world_->game.mode);
  const bool allowed = mode == PlayMode::kPlayOn || mode == PlayMode::kPenaltyTakenLeft;
  if (!world_->goalie || !allowed || world_->self.frozen()) return false;
  if (!world_->ball.relative_position_valid()) return false;

  // The far corner of the catch rectangle has the longest reach: aim it at the ball.
  const double corner =
      math::to_degrees(math::atan2(server.catchable_area_w / 2.0, server.catchable_area_l));
  const double ball = (world_->ball.angle_from_self - world_->self.body).degrees();
  const double direction = soccer::between(ball > 0.0 ? ball - corner : ball + corner,
                                           server.min_catch_angle, server.max_catch_angle);

  return finite(direction) && put(body_, soccer::Catch{soccer::rounded_for_command(direction)});
}

bool CommandSlots::move(Vec2 point) {
  const auto& server = world_->server();
  const bool caught = world_->goalie && holds_caught_ball(*world_);
  const bool allowed = caught || before_play(world_->game.mode);
  if (world_->self.frozen() || !finite(point) || !allowed) return false;
  point = clamped_to_pitch(point);

  if (caught) {
    constexpr double kInset = 1.0;
    const double half_width = soccer::kPenaltyAreaWidth / 2.0 - kInset;
    point.x = std::clamp(point.x, -soccer::kHalfLength + kInset,
                         -soccer::kHalfLength + soccer::kPenaltyAreaLength - kInset);
    point.y = std::clamp(point.y, -half_width, half_width);
  } else if (server.forbid_kick_off_offside && point.x > 0.0) {
    point.x = -0.1;
  }

  return put(body_, soccer::Move{soccer::rounded_for_command(point.x),
                                 soccer::rounded_for_command(point.y)});
}

bool CommandSlots::turn_neck(double moment) {
  const auto& server = world_->server();
  if (!finite(moment)) return false;

  const double neck = world_->self.neck.degrees();
  const double target = soccer::between(neck + std::clamp(moment, -360.0, 360.0), server.minneckang,
                                        server.maxneckang);
  const double turn =
      soccer::between(std::rint(target - neck), server.minneckmoment, server.maxneckmoment);

  return finite(turn) && put(turn_neck_, soccer::TurnNeck{turn});
}

bool CommandSlots::change_view(soccer::ViewWidth width) {
  view_asked_ = true;
  if (width == world_->self.view_width) {
    change_view_.reset();
    return false;
  }
  return put(change_view_, width);
}

bool CommandSlots::change_focus(double distance_moment, double direction_moment) {
  constexpr double kMaxFocusDistance = 40.0;
  if (!finite(distance_moment, direction_moment)) return false;

  const SelfState& self = world_->self;
  const double half = view_angle(world_->server(), next_view_width()) / 2.0;
  const double distance = std::clamp(self.focus_distance + distance_moment, 0.0, kMaxFocusDistance);
  const double direction = soccer::between(
      math::normalize_degrees(self.focus_direction.degrees() + direction_moment), -half, half);

  const double farther = distance - self.focus_distance;
  const double turn = direction - self.focus_direction.degrees();
  if (!finite(farther, turn)) return false;
  change_focus_ =
      soccer::ChangeFocus{soccer::rounded_for_command(farther), soccer::rounded_for_command(turn)};
  return true;
}

bool CommandSlots::point_to(Vec2 point) {
  const SelfState& self = world_->self;
  if (self.arm.movable_in > 0 || !self.position_valid() || !finite(point)) return false;

  const Vec2 relative = point - self.position;
  const double direction = (AngleDeg::of(relative) - self.face()).degrees();
  if (!finite(relative.length(), direction)) return false;
  return put(arm_, soccer::PointTo{soccer::rounded_for_command(relative.length()),
                                   soccer::rounded_for_command(direction)});
}

bool CommandSlots::point_to_off() {
  if (world_->self.arm.movable_in > 0) return false;
  return put(arm_, soccer::PointToOff{});
}

bool CommandSlots::attention_to(Side side, int unum) {
  const bool ours = side == world_->our_side;
  if (side == Side::kNeutral || unum < 1 || unum > soccer::kPlayersPerTeam) return false;
  if (ours && unum == world_->unum) return false;
  using Kind = soccer::TeamReference::Kind;
  return put(attention_, soccer::AttentionTo{{ours ? Kind::kOur : Kind::kOpponent, {}}, unum});
}

bool CommandSlots::attention_to_off() { return put(attention_, soccer::AttentionToOff{}); }

bool CommandSlots::say(std::string_view text) {
  const auto room = base::index(std::max(0, world_->server().say_msg_size));
  if (!soccer::is_sayable(text) || say_.size() + text.size() > room) return false;
  say_ += text;
  return true;
}

Vec2 CommandSlots::next_position() const {
  const SelfState& self = world_->self;
  if (const auto* to = std::get_if<soccer::Move>(&body_)) return {to->x, to->y};

  std::optional<Vec2> push;
  if (const auto* command = std::get_if<soccer::Dash>(&body_)) {
    push = dash_acceleration(*world_, command->power, command->direction);
  } else if (const auto* legs = std::get_if<soccer::LegDash>(&body_)) {
    push = leg_dash_effect(*world_, self.body, *legs).acceleration;
  }

  const double limit = world_->self_type().player_speed_max;
  return self.position + (push ? speed_limited(self.velocity + *push, limit) : self.velocity);
}

AngleDeg CommandSlots::next_body() const {
  const SelfState& self = world_->self;
  if (const auto* legs = std::get_if<soccer::LegDash>(&body_)) {
    return self.body + leg_dash_effect(*world_, self.body, *legs).turn;
  }
  if (const auto* command = std::get_if<soccer::Turn>(&body_)) {
    return self.body + command->moment / turn_resistance(world_->self_type(), self.velocity);
  }
  return self.body;
}

double CommandSlots::next_neck() const {
  return world_->self.neck.degrees() + (turn_neck_ ? turn_neck_->moment : 0.0);
}

soccer::ViewWidth CommandSlots::next_view_width() const {
  return change_view_.value_or(world_->self.view_width);
}

void CommandSlots::compose(std::vector<soccer::PlayerCommand>& out, bool with_done) const {
  out.clear();

  const auto append = [&out](const auto& command) {
    if constexpr (!std::is_same_v<std::decay_t<decltype(command)>, std::monostate>) {
      out.emplace_back(command);
    }
  };

  if (has_body()) {
    std::visit(append, body_);
  } else if (!world_->self.frozen()) {
    out.emplace_back(soccer::Turn{0.0});
  }

  if (turn_neck_) out.emplace_back(*turn_neck_);
  if (change_view_) out.emplace_back(soccer::ChangeView{*change_view_, {}});
  if (change_focus_) out.emplace_back(*change_focus_);
  std::visit(append, arm_);
  std::visit(append, attention_);
  if (with_done) out.emplace_back(soccer::Done{});
  if (!say_.empty()) out.emplace_back(soccer::Say{say_});
}

}  // namespace cls::player
