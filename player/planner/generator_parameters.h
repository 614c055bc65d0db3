// Behavior numbers of the planner's generators that users do not tune (planner_parameters.h has the
// others).
#pragma once

namespace cls::player {

/// Later actions with coarse checks. Source: docs/spec/proxy-behavior.md 5.2.
struct CoarseParameters {
  int pass_age = 10;      ///< maximum of the receiver's position, cycles
  double min_pass = 4.0;  ///< meters
  double max_pass = 35.0;
  double own_x = -33.0;  ///< no passes behind this x within `own_y` of the middle
  double own_y = 23.0;
  double lane_angle = 14.5;       ///< free angle of a pass at `lane_speed`, degrees
  double back_lane_angle = 17.5;  ///< of a back pass, or one to the goalie
  double lane_speed = 2.5;        ///< meters per cycle
  int dribble_age = 5;            ///< maximum of the holder's position, cycles
  double longest_dribble = 5.25;  ///< meters
  double dribble_step = 1.75;
  double shot_speed = 1.5;  ///< mean speed of a shot, meters per cycle
};

/// Source: docs/spec/proxy-behavior.md 5.2, changed where noted there.
struct DribbleSearchParameters {
  double back_angle = 100.0;  ///< no short dribbles beyond in front of `back_x`, degrees
  double back_x = 16.0;
  double near_radius = 0.2;   ///< distance of the ball after it, of the kickable margin
  double far_radius = 0.4;    ///< the same after a self pass
  double inset = 1.0;         ///< of the end of a short dribble, meters inside the lines
  double long_inset_x = 2.5;  ///< of the end of a self pass
  double long_inset_y = 3.0;
  double own_goal = 18.0;         ///< least distance of that end from our goal, meters
  double long_back_angle = 85.0;  ///< no self passes beyond in front of `long_back_x`, degrees
  double long_back_x = 41.0;
  int long_per_heading = 10;  ///< maximum self passes along one heading
  double body_gap = 0.05;     ///< minimum distance between ball and body, meters
};

/// Source: docs/spec/proxy-behavior.md 5.2.
struct PassSearchParameters {
  double shortest = 2.2;  ///< of direct passes and crosses, of the kickable area
  double longest = 0.8;   ///< of the longest roll
  double longest_through = 0.9;
  double own_goal = 18.0;    ///< no passes back so near to our goal, meters
  double goalie_x = -22.0;   ///< a goalie behind this x receives no pass
  double direct_push = 1.8;  ///< fastest ball at a receiver: its control plus so many dashes
  double lead_push = 1.5;
  double care = 1.05;  ///< factor of a receiver's way
};

struct GeneratorParameters {
  CoarseParameters coarse;
  DribbleSearchParameters dribble;
  PassSearchParameters pass;
};
constexpr GeneratorParameters kGenerators{};

}  // namespace cls::player
