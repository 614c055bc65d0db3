// The see message: the objects that a player sees.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"
#include "soccer/protocol/team_name.h"

namespace cls::soccer {

enum class ObservedKind : std::uint8_t {
  kLandmark,     ///< flag or goal; `index` into kLandmarks
  kBall,         ///< (b)
  kPlayer,       ///< (p ...), with team and uniform number if recognized
  kLine,         ///< (l l) ..; `index` is a PitchLine
  kCloseFlag,    ///< (F): close but outside the view cone, unnamed
  kCloseGoal,    ///< (G)
  kCloseBall,    ///< (B)
  kClosePlayer,  ///< (P)
};

/// The data of an object in a message. Each level includes the previous ones.
enum class ObservedDetail : std::uint8_t {
  kDirection,  ///< direction
  kPosition,   ///< distance, direction
  kMotion,     ///< plus distance_change, direction_change
  kPose,       ///< plus body, head (players with known uniform number)
};

/// Steps to which the server rounds motion (docs/spec/simulation-model.md 7.5): the distance change
/// over the distance, the distance change itself with Gaussian noise, the direction change in
/// degrees.
constexpr double kDistanceChangeStep = 0.02;
constexpr double kGaussianDistanceChangeStep = 0.01;
constexpr double kDirectionChangeStep = 0.1;

/// The visible action of a player.
enum class ActionMark : std::uint8_t { kNone, kTackling, kKicked, kFoulCharged };

/// One object of a see message. Meters and degrees; directions relative to body plus neck.
struct Observation {
  ObservedKind kind = ObservedKind::kLandmark;
  ObservedDetail detail = ObservedDetail::kPosition;
  std::uint8_t index = 0;
  std::uint8_t unum = 0;  ///< 0: unknown
  bool goalie = false;
  bool pointing = false;  ///< point_direction is valid
  ActionMark mark = ActionMark::kNone;
  std::int16_t direction = 0;
  std::int16_t body = 0;  ///< body angle of the other player, relative to own body plus neck
  std::int16_t head =
      0;  ///< body plus neck angle of the other player, relative to own body plus neck
  std::int16_t point_direction = 0;
  TeamName team;  ///< empty: unknown
  double distance = 0.0;
  double distance_change = 0.0;   ///< meters per cycle
  double direction_change = 0.0;  ///< degrees per cycle
};

struct See {
  int time = 0;
  std::vector<Observation> objects;  ///< in message order
};

/// Maximum number of objects in a message: landmarks, ball, other players, lines.
constexpr std::size_t kMaxObservations = 55 + 1 + 21 + 4;

/// Parses a see message of version 8 or later. Errors name the byte and leave `out` unspecified.
/// More than kMaxObservations objects are an error. Does not allocate once `out.objects` has enough
/// capacity.
base::Result<void> parse(std::string_view message, See& out);

/// Appends the message; its form is the same for versions 8 to 19.
void format(const See& see, std::string& out);

}  // namespace cls::soccer
