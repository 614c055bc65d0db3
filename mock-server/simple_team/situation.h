// What the simple team wants to know of a State, in the words of soccer.
#pragma once

#include <vector>

#include "proto/playmaker.pb.h"
#include "soccer/geometry.h"

namespace cls::mock_server {

/// Reaching the ball takes this many cycles when nobody knows how.
constexpr int kNeverReached = 1000;

soccer::Vec2 point_of(const protos::RpcVector2D& vector);

/// A read-only view of one State; keeps a reference to it. Coordinates are those of the wire: the
/// own team attacks +x.
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
  /// A dead ball that our team will bring into play, or theirs.
  bool is_our_set_play() const { return world_.is_our_set_play(); }
  bool is_their_set_play() const { return world_.is_their_set_play(); }

  bool can_kick() const { return self().is_kickable(); }
  /// Cycles until the agent, a teammate or an opponent can have the ball.
  int own_reach() const;
  int mates_reach() const;
  int opponents_reach() const;
  bool mate_has_ball() const { return world_.kickable_teammate_existance(); }
  bool opponent_has_ball() const { return world_.kickable_opponent_existance(); }

  /// Where our attackers become offside.
  double offside_line() const { return world_.offside_line_x(); }

  /// Distance of the nearest opponent to a point; far when none is known.
  double nearest_opponent_to(soccer::Vec2 point) const;
  /// Room that a ball has on its straight way: the smallest distance of an opponent beside it,
  /// less what he can run while the ball comes there (`base` metres where he stands, `spread`
  /// metres for each metre of the way). Negative: he gets it.
  double lane_margin(soccer::Vec2 from, soccer::Vec2 to, double base, double spread) const;

  /// No teammate is clearly nearer to the ball; equal distances go to the lower number.
  bool is_nearest_to_ball() const;

 private:
  const protos::WorldModel& world_;
  soccer::Vec2 self_position_;
  soccer::Vec2 ball_;
  soccer::Vec2 ball_velocity_;
  std::vector<soccer::Vec2> opponents_;
};

}  // namespace cls::mock_server
