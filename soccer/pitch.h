// The pitch: sizes, lines and landmarks.
#pragma once

#include <array>
#include <optional>
#include <string_view>

#include "soccer/geometry.h"

namespace cls::soccer {

// Sizes in meters (docs/spec/simulation-model.md 1.2). Goal width, ball and player size are
// parameters.
constexpr double kPitchLength = 105.0;
constexpr double kPitchWidth = 68.0;
constexpr double kPitchMargin = 5.0;
constexpr double kHalfLength = kPitchLength / 2;
constexpr double kHalfWidth = kPitchWidth / 2;
constexpr double kCenterCircleRadius = 9.15;
constexpr double kPenaltyAreaLength = 16.5;
constexpr double kPenaltyAreaWidth = 40.32;
constexpr double kGoalAreaLength = 5.5;
constexpr double kGoalAreaWidth = 18.32;
constexpr double kPenaltySpotDistance = 11.0;
constexpr double kGoalDepth = 2.44;
constexpr double kGoalPostRadius = 0.06;

/// Players stay within this distance of the center lines: pitch plus margin.
constexpr double kOuterHalfLength = kHalfLength + kPitchMargin;
constexpr double kOuterHalfWidth = kHalfWidth + kPitchMargin;

/// A flag or goal. `name` is its short name without parentheses ("f r t 20", "g l"),
/// `first_version` the lowest client version that sees it.
struct Landmark {
  std::string_view name;
  Vec2 position;
  int first_version;

  constexpr bool is_goal() const { return name.front() == 'g'; }
};

constexpr int kLandmarkCount = 55;

/// All landmarks, in the order of see messages.
extern const std::array<Landmark, kLandmarkCount> kLandmarks;

/// Index in kLandmarks of a short name; nothing for unknown names.
std::optional<int> landmark_index(std::string_view name);

/// The four border lines, in the order of see messages: (l l), (l r), (l t), (l b).
enum class PitchLine : unsigned char { kLeft, kRight, kTop, kBottom };
constexpr int kPitchLineCount = 4;

/// 'l', 'r', 't' or 'b'.
constexpr char letter(PitchLine line) { return "lrtb"[static_cast<int>(line)]; }

}  // namespace cls::soccer
