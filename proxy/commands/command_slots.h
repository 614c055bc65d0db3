// The commands an agent is about to send in this cycle: one slot of each kind, checked on entry.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "proxy/world/world_model.h"
#include "soccer/commands/player_command.h"

namespace cls::proxy {

/// The server takes one of these a cycle; monostate: none chosen yet.
using BodyCommand = std::variant<std::monostate, soccer::Turn, soccer::Dash, soccer::Kick,
                                 soccer::Tackle, soccer::Catch, soccer::Move>;

/// Fill it during one decision, then compose() the datagram. Every setter clamps to what the
/// server accepts and returns false, changing nothing, when the command would be refused or an
/// argument is not finite (proxy behaviour 2.7). A later command of the same kind replaces an
/// earlier one. Refers to the world it was made for, which must outlive it.
class CommandSlots {
 public:
  explicit CommandSlots(const WorldModel& world) : world_(&world) {}

  // Body. Angles in degrees relative to the body.
  /// Power is cut to what stamina can pay; the direction goes onto the server's grid.
  bool dash(double power, double direction = 0.0);
  /// `angle` is the wanted change of the body: the moment makes up for the player's speed.
  bool turn(double angle);
  bool kick(double power, double direction);
  bool tackle(double direction, bool foul = false);
  /// Goalie only; aims by itself.
  bool catch_ball();
  bool move(soccer::Vec2 point);

  // Neck, eyes, arm, ears, mouth.
  /// Relative to the neck now; sent in whole degrees.
  bool turn_neck(double moment);
  bool change_view(soccer::ViewWidth width);
  /// Change of the focus point's distance (metres) and of its direction.
  bool change_focus(double distance_moment, double direction_moment);
  bool point_to(soccer::Vec2 point);
  bool point_to_off();
  bool attention_to(soccer::Side side, int unum);
  bool attention_to_off();
  /// Appends to this cycle's text as long as it fits into one message.
  bool say(std::string_view text);

  const BodyCommand& body() const { return body_; }
  bool has_body() const { return !std::holds_alternative<std::monostate>(body_); }
  bool has_neck() const { return turn_neck_.has_value(); }
  bool has_attention() const { return !std::holds_alternative<std::monostate>(attention_); }
  bool has_focus() const { return change_focus_.has_value(); }
  /// True when a change of view was asked for, even one to the width we have.
  bool view_asked() const { return view_asked_; }
  const std::string& say_text() const { return say_; }

  // What the commands so far make of the next cycle, without noise and collisions.
  soccer::Vec2 next_position() const;
  soccer::AngleDeg next_body() const;
  /// Relative to the body.
  double next_neck() const;
  soccer::AngleDeg next_face() const { return next_body() + next_neck(); }
  soccer::ViewWidth next_view_width() const;

  /// Replaces `out` with the commands in the order of sending: body (`turn 0` if there is none and
  /// the player is not frozen), turn_neck, change_view, change_focus, pointto, attentionto, done
  /// (if asked), say.
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

}  // namespace cls::proxy
