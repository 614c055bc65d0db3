// Behavior numbers of movement: weights of intercepts, tackles and support.
#pragma once

namespace cls::player {

/// Scores of intercept plans, points. Source: as in helios, with higher costs of turns and cycles:
/// plans with low ones oscillate.
struct InterceptParameters {
  double opponent_lead = 5.0;  ///< cost per cycle by which an opponent is there earlier
  double teammate_lead = 0.5;  ///< the same for a teammate
  int others_delay = 3;        ///< cycles by which others may be later and count as earlier
  int max_opponent_age = 5;    ///< credit for the age of the first opponent's position, cycles
  double turn = 0.4;           ///< cost of turning
  double turn_degree = 0.025;  ///< per degree, if the ball is far from the body at the end
  double back_degree = 0.1;    ///< per degree beyond 90 before dashing backward
  double outrun = 20.0;        ///< cost per meter per cycle of a ball slower than the agent
  double outrun_share = 0.8;   ///< of the agent's top speed
  double slow_ball = 70.0;     ///< cost per squared meter per cycle below `min_ball_speed`
  double min_ball_speed = 0.55;
  double goal_meter = 0.2;  ///< cost per meter from `goal_x` in front of their goal
  double goal_x = 44.0;     ///< meters
  double cycle = 0.35;      ///< cost; an earlier intercept is worth more than one upfield
  double run = 0.3;         ///< cost per meter of the run
  double edge = 0.3;        ///< a ball is at the edge of the kickable area so near, meters
  double edge_run = 0.5;    ///< additional cost per meter of a run to the edge
  double wide_edge = 0.4;   ///< meters
  double wide_edge_cost = 0.5;
  double wide_edge_meter = 3.0;  ///< cost per meter beyond the wide edge
  double stamina = 1e-4;         ///< value per unit that is left
  double duel = 100.0;           ///< cost of plans without a turn to the ball, in a duel
  double impossible = 1000.0;    ///< cost of an intercept outside the pitch
};

/// Values of tackles, points. Source: chosen for cls.
struct TackleParameters {
  double goal = 1e6;        ///< a tackle into a goal
  double own_goal = 2.0;    ///< per meter of the ball from our goal
  double possession = 6.0;  ///< per cycle of the lead in the race for the ball
  int max_lead = 5;         ///< cycles
};

/// Scores of points to receive a pass, points per meter. Source: chosen for cls.
struct SupportParameters {
  double lane = 1.6;      ///< of margin of the pass lane, up to `max_lane`
  double max_lane = 2.5;  ///< meters
  double room = 0.5;      ///< to the nearest opponent, up to `max_room`
  double max_room = 5.0;  ///< meters
  double goal = 0.25;     ///< cost of the distance to their goal
  double home = 0.25;     ///< to the home position
  double way = 0.15;      ///< to the agent
  double crowd = 0.5;     ///< cost of each meter that a teammate's home is nearer than `apart`
  double apart = 7.0;     ///< meters
};

struct MovementParameters {
  InterceptParameters intercept;
  TackleParameters tackle;
  SupportParameters support;
};
constexpr MovementParameters kMovement{};

}  // namespace cls::player
