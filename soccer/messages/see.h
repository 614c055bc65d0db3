// The see message: what a player sees from where it stands.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "soccer/protocol/team_name.h"

namespace cls::soccer {

enum class ObservedKind : std::uint8_t {
  kLandmark,     ///< flag or goal; `index` counts as kLandmarks in soccer/pitch.h
  kBall,         ///< (b)
  kPlayer,       ///< (p ...), with what could be recognised of team and number
  kLine,         ///< (l l) ..; `index` is a PitchLine
  kCloseFlag,    ///< (F): near but outside the view cone, unnamed
  kCloseGoal,    ///< (G)
  kCloseBall,    ///< (B)
  kClosePlayer,  ///< (P)
};

/// How much of an object a message tells; each step has all before it except that direction-only
/// (low quality) has no distance.
enum class ObservedDetail : std::uint8_t {
  kDirection,  ///< direction
  kPosition,   ///< distance, direction
  kMotion,     ///< and distance_change, direction_change
  kPose,       ///< and body, head (players whose number is seen)
};

/// What a seen player does.
enum class ActionMark : std::uint8_t { kNone, kTackling, kKicked, kFoulCharged };

/// One object of a see message. Metres and degrees; directions relative to body plus neck.
struct Observation {
  ObservedKind kind = ObservedKind::kLandmark;
  ObservedDetail detail = ObservedDetail::kPosition;
  std::uint8_t index = 0;
  std::uint8_t unum = 0;  ///< 0: not recognised
  bool goalie = false;
  bool pointing = false;  ///< point_direction holds
  ActionMark mark = ActionMark::kNone;
  std::int16_t direction = 0;
  std::int16_t body = 0;  ///< the other's body angle, seen from here
  std::int16_t head = 0;  ///< the other's body plus neck angle, seen from here
  std::int16_t point_direction = 0;
  TeamName team;  ///< empty: not recognised
  double distance = 0.0;
  double distance_change = 0.0;   ///< metres per cycle
  double direction_change = 0.0;  ///< degrees per cycle
};

struct See {
  int time = 0;
  std::vector<Observation> objects;  ///< in message order
};

/// Most objects a real message can have: landmarks, ball, other players, lines.
constexpr std::size_t kMaxObservations = 55 + 1 + 21 + 4;

/// Reads a see message of version 8 or later. On failure the message names the byte and `out` is
/// unspecified. Does not allocate on success once `out.objects` has grown; more than
/// kMaxObservations objects are refused.
base::Result<void> parse(std::string_view message, See& out);

/// Appends the message; its form is the same for versions 8 to 19.
void format(const See& see, std::string& out);

}  // namespace cls::soccer
