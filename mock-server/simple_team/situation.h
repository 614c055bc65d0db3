// A State as the simple team uses it.
#pragma once

#include "proto/playmaker.pb.h"
#include "soccer/geometry.h"
#include "soccer/pitch.h"

namespace cls::mock_server {

/// Cycles to the ball when no player can reach it.
constexpr int kNeverReached = 1000;

/// The middle of each goal line.
constexpr soccer::Vec2 kOurGoal{-soccer::kHalfLength, 0.0};
constexpr soccer::Vec2 kTheirGoal{soccer::kHalfLength, 0.0};

soccer::Vec2 point_of(const protos::RpcVector2D& vector);

/// A read-only view of one State, which must outlive it. Coordinates of the State: the own team
/// attacks +x.
class Situation {
 public:
  explicit Situation(const protos::State& state);

  const protos::WorldModel& world() const { return world_; }
  const protos::Self& self() const { return world_.self(); }

  int unum() const { return self().uniform_number(); }
  bool is_goalie() const { return self().is_goalie(); }
  soccer::Vec2 self_position() const { return self_position_; }
  soccer::Vec2 ball() const { return ball_; }
  soccer::Vec2 ball_velocity() const { return ball_velocity_; }
  bool ball_is_known() const { return world_.ball().pos_count() < 10; }

  protos::GameModeType mode() const { return world_.game_mode_type(); }
  bool is_play_on() const { return mode() == protos::PlayOn; }
  bool is_before_kick_off() const {
    return mode() == protos::BeforeKickOff || mode() == protos::AfterGoal_;
  }
  /// A set play of the own team, or of the opponents.
  bool is_our_set_play() const { return world_.is_our_set_play(); }
  bool is_their_set_play() const { return world_.is_their_set_play(); }

  bool can_kick() const { return self().is_kickable(); }
  /// Cycles until the agent, a teammate or an opponent can have the ball.
  int own_reach() const;
  int teammates_reach() const;
  int opponents_reach() const;
  bool teammate_has_ball() const { return world_.kickable_teammate_existance(); }
  bool opponent_has_ball() const { return world_.kickable_opponent_existance(); }

  /// x at which teammates become offside.
  double offside_line() const { return world_.offside_line_x(); }

  /// Distance of the nearest opponent to a point; 1000 when none is known.
  double nearest_opponent_to(soccer::Vec2 point) const;
  /// Margin of a straight ball path: the smallest distance of an opponent from it, minus the
  /// distance the opponent covers meanwhile (`base` meters plus `spread` meters per meter of the
  /// path). Negative: an opponent intercepts.
  double lane_margin(soccer::Vec2 from, soccer::Vec2 to, double base, double spread) const;

  /// No teammate is nearer to the ball; equal distances go to the lower uniform number.
  bool is_nearest_to_ball() const;

 private:
  const protos::WorldModel& world_;
  soccer::Vec2 self_position_;
  soccer::Vec2 ball_;
  soccer::Vec2 ball_velocity_;
};

}  // namespace cls::mock_server
