// Behavior numbers of whole roles: weights, distances and patience.
#pragma once

namespace cls::player {

/// Say messages and attention. Source: chosen for cls.
struct CommunicationParameters {
  double near_ball = 60.0;   ///< relevance of a seen player: this over `softening` plus meters
  double near_agent = 10.0;  ///< the same by the distance from the agent
  double softening = 5.0;    ///< meters
  double opponent = 1.5;     ///< factor of the relevance of opponents
  int number_age = 10;       ///< maximum of a seen number, cycles
  double say_ball = 12.0;    ///< distance from the ball within which the agent reports it, meters
  double attention = 40.0;   ///< maximum distance of the teammate to listen to, meters
};

/// Dash powers on the way to home positions; planner_parameters.h has those that users tune.
/// Source: docs/spec/proxy-behavior.md 6.4.
struct PaceParameters {
  double slowest = 0.5;  ///< factor of the usual pace
  double fastest = 1.3;
  double rest = 25.0;          ///< below the income of stamina while recovering
  double behind_line = 20.0;   ///< full power behind our line, with the ball less far ahead, meters
  double chase_x = 10.0;       ///< passed players run back while the ball is behind this x
  double close_ball = 20.0;    ///< power near a teammate with the ball, meters
  double attack_x = 25.0;      ///< saves stamina with a safe ball beyond this x
  double attack_ahead = 10.0;  ///< and so far ahead of the agent, meters
  int safe_lead = 6;           ///< cycles
  double attack_share = 0.5;   ///< of the income
  double attack_power = 10.0;  ///< minimum
};

/// Open part of the goal for a position of the goalie. Source: chosen for cls, in penalty kicks and
/// matches against helios teams.
struct GoalieParameters {
  double shot_speed = 2.8;      ///< first, meters per cycle
  double arms = 0.9;            ///< of the catchable area
  double run = 0.85;            ///< of the run from rest
  double passed_weight = 0.35;  ///< of a shot after a pass
  double open_shot = 0.5;       ///< of a shot that is not covered, besides the meters missing
  double max_missing = 3.0;     ///< meters
  double way = 0.12;            ///< cost per meter from the agent
  double line = 0.05;           ///< cost per meter from the usual line
  double run_speed = 0.8;       ///< on short distances, meters per cycle
};

/// A goalie across the way of the ball. Source: shots of the teams of competitions at this goalie,
/// played again.
struct SaveParameters {
  double line = -50.7;     ///< x of its place
  double deepest = -52.0;  ///< least x beside the goal
  double widest = 8.5;     ///< from the middle of the goal, meters
  double inside_post = 0.5;
  double range = 28.0;       ///< distance of the ball from our goal from which it slides, meters
  double slides = 5.0;       ///< farther places it runs to, meters
  double body_angle = 75.0;  ///< between body and way of the ball, toward the far post, degrees
  double body_error = 25.0;  ///< turns first beyond this
  double exact_body = 6.0;
  double near_place = 0.3;       ///< meters
  double direction_step = 15.0;  ///< of the dashes that are tried, degrees
  double margin = 0.45;          ///< of the reach, meters
  double turn = 0.2;             ///< cost, meters: the next look may want another one
  double middle = 3.0;           ///< y of balls within which the body stays on its side, meters
  double before_line = 0.15;     ///< the ball must be met so far in front of the line
  double tackle_chance = 0.05;   ///< of the last tackle
  double shot_speed = 1.2;       ///< slower balls are intercepted as usual, meters per cycle
  int look_ahead = 12;           ///< cycles until somebody has the ball
};

struct BehaviorParameters {
  CommunicationParameters communication;
  PaceParameters pace;
  GoalieParameters goalie;
  SaveParameters save;
};
constexpr BehaviorParameters kBehaviors{};

}  // namespace cls::player
