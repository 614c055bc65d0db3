// Behavior numbers of the ball skills: costs, scores and margins.
#pragma once

namespace cls::player {

/// Costs of a ball position by the worst that an opponent can do there, points. Source: kick
/// sequences of helios, which cost 300 to 600 (docs/spec/proxy-behavior.md 4.2).
struct ThreatCosts {
  double kickable = 600.0;  ///< in the kickable area of a coasting opponent
  double tackle = 300.0;    ///< in its tackle area
  double dash = 150.0;      ///< where a dash reaches it
};

/// Source: chosen for cls; the order of attempts is that of Body_Dribble
/// (docs/spec/proxy-behavior.md 4.2).
struct DribbleParameters {
  double body_gap = 0.05;         ///< minimum distance between ball and body, meters
  double pitch_inset = 0.3;       ///< the ball stays so far inside the lines, meters
  double feet_share = 0.45;       ///< distance of the ball after a run, of the kickable margin
  double offset_cost = 0.2;       ///< points per degree off the body direction, before a run
  double enough = 100.0;          ///< a kick that costs less ends the search, points
  double turn_offset_cost = 0.3;  ///< points per degree off the heading, before a turn
  double turn_room = 20.0;        ///< points per meter to the nearest opponent, before a turn
  double max_turn_room = 4.0;     ///< an opponent farther away counts as this far, meters
  double turn_noise = 0.1;        ///< margin of the kickable area in a turn, meters
  double leg_turn_noise = 0.05;   ///< the same in addition in a turn by a two-leg dash
  double dash_noise = 0.15;       ///< margin of the kickable area in a dash, meters
  double last_dash_margin = 0.1;  ///< the same at the end of a run
};

/// Source: chosen for cls.
struct HoldParameters {
  double noise = 0.1;         ///< margin of the kickable area, meters
  double kick_rate = 1000.0;  ///< points per kick rate at the new position
  double room = 40.0;         ///< points per meter to the nearest opponent
  double max_room = 4.0;      ///< an opponent farther away counts as this far, meters
  double front_share = 0.4;   ///< distance of the ball in front, of the kickable margin
};

/// Long kicks. Source: chosen for cls.
struct ClearParameters {
  double reach = 1.2;              ///< lateral reach of an opponent, meters
  double fading = 0.95;            ///< weight per cycle of an opponent's age beyond three
  double free_angle = 25.0;        ///< of the first attempt to find a direction, degrees
  double narrower = 0.7;           ///< factor of it for each further attempt
  double single_kick = 0.7;        ///< speed with which one kick suffices, of ball_speed_max
  double advance_threshold = 0.9;  ///< least speed of a sequence, of ball_speed_max
  double clear_threshold = 0.85;
  double min_clear_speed = 2.5;  ///< meters per cycle
};

/// Source: scores of shots in helios, with 50 points for one kick instead of several.
struct ShotParameters {
  double one_kick = 251.0;  ///< points
  double several_kicks = 201.0;
  double goalie_angle = 10.0;  ///< width of the factor for shots beside the goalie, degrees
  double middle = 4.0;         ///< targets up to this distance from the goal's middle are equal
  double wide = 5.5;           ///< width of the factor for others, meters
  double sure_length = 8.0;    ///< a shorter shot hits any target, meters
};

/// Kick sequences, points. Source: docs/spec/proxy-behavior.md 4.2; the noise is chosen for cls.
struct SequenceParameters {
  double base = 1000.0;
  double kicks[4] = {0.0, 0.0, 50.0, 200.0};  ///< cost by number of kicks
  double effort = 50.0;                       ///< cost of a last kick with full power
  double too_slow = 10000.0;                  ///< cost of a speed below the threshold
  double slower = 1000.0;                     ///< cost of a speed below the desired one
  double speed = 100.0;                       ///< value of each meter per cycle of such a speed
  double noise = 400.0;                       ///< cost of an error beyond the slack, per slack
  double typical_error = 1.4;                 ///< of a kick, per kick_rand and share of the power
};

struct SkillParameters {
  ThreatCosts threat;
  DribbleParameters dribble;
  HoldParameters hold;
  ClearParameters clear;
  ShotParameters shot;
  SequenceParameters sequence;
};
constexpr SkillParameters kSkills{};

}  // namespace cls::player
