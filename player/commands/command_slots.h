// Commands of the current cycle: one slot per kind, validated on entry.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "player/world/world_model.h"
#include "soccer/commands/player_command.h"

namespace cls::player {

/// The server executes one body command per cycle; monostate: none set.
using BodyCommand = std::variant<std::monostate, soccer::Turn, soccer::Dash, soccer::LegDash,
                                 soccer::Kick, soccer::Tackle, soccer::Catch, soccer::Move>;

/// Collects commands during one decision; compose() returns them. Every setter clamps to the
/// server's limits and returns false without change when the server would reject the command, or
/// when a number would not be finite (docs/spec/proxy-behavior.md 2.7). A later command of the same
/// kind replaces an earlier one. The world model must outlive the object.
class CommandSlots {
 public:
  explicit CommandSlots(const WorldModel& world) : world_(&world) {}

  // Body. Angles in degrees relative to the body.
  /// Limits power to the available stamina and quantizes the direction.
  bool dash(double power, double direction = 0.0);
  /// A dash of both legs, each with its own power and direction. If stamina is short, both get the
  /// same share of their power.
  bool dash(const soccer::LegDash& legs);
  /// `angle` is the desired change of the body; the moment compensates for inertia.
  bool turn(double angle);
  bool kick(double power, double direction);
  bool tackle(double direction, bool foul = false);
  /// Goalie only; aims automatically.
  bool catch_ball();
  bool move(Vec2 point);

  // Neck, view, focus, arm, attention, say.
  /// Relative to the current neck; sent in whole degrees.
  bool turn_neck(double moment);
  bool change_view(soccer::ViewWidth width);
  /// Changes the distance (meters) and direction of the focus point.
  bool change_focus(double distance_moment, double direction_moment);
  bool point_to(Vec2 point);
  bool point_to_off();
  bool attention_to(Side side, int unum);
  bool attention_to_off();
  /// Appends to the say message of this cycle if it fits.
  bool say(std::string_view text);

  const BodyCommand& body() const { return body_; }
  bool has_body() const { return !std::holds_alternative<std::monostate>(body_); }
  bool has_attention() const { return !std::holds_alternative<std::monostate>(attention_); }
  bool has_focus() const { return change_focus_.has_value(); }
  /// True after change_view(), even to the current width.
  bool view_requested() const { return view_asked_; }
  const std::string& say_text() const { return say_; }

  // Predicted state in the next cycle, without noise and collisions.
  Vec2 next_position() const;
  AngleDeg next_body() const;
  /// Relative to the body.
  double next_neck() const;
  AngleDeg next_face() const { return next_body() + next_neck(); }
  soccer::ViewWidth next_view_width() const;

  /// Replaces `out` with the commands in sending order: body (`turn 0` if none and the player is
  /// not frozen), turn_neck, change_view, change_focus, pointto, attentionto, done (if
  /// `with_done`), say.
  void compose(std::vector<soccer::PlayerCommand>& out, bool with_done = false) const;

 private:
  const WorldModel* world_;
  BodyCommand body_;
  std::optional<soccer::TurnNeck> turn_neck_;
  std::optional<soccer::ViewWidth> change_view_;
  bool view_asked_ = false;
  std::optional<soccer::ChangeFocus> change_focus_;
  std::variant<std::monostate, soccer::PointTo, soccer::PointToOff> arm_;
  std::variant<std::monostate, soccer::AttentionTo, soccer::AttentionToOff> attention_;
  std::string say_;
};

}  // namespace cls::player
