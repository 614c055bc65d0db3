// Checks of a scenario: one value per element of "expect".
#pragma once

#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "base/text/enum_names.h"
#include "mock-server/script/comparison.h"
#include "mock-server/script/expectations.h"
#include "mock-server/script/field_path.h"
#include "scenario/run_record.h"
#include "soccer/geometry.h"

namespace cls::scenario {

/// Player by slot (soccer::slot_of), or the ball.
constexpr int kBallObject = -1;

/// Conditions on one object after one step; all must hold.
struct ObjectTest {
  struct Quantity {
    enum class What { kX, kY, kSpeed, kBody, kStamina, kCards, kOnPitch };
    static constexpr auto kNames =
        base::enum_names<What>("x", "y", "speed", "body", "stamina", "cards", "on_pitch");

    What what = What::kX;
    mock_server::Comparison expected;
  };
  struct Nearness {
    std::optional<int> object;  ///< else `point`
    soccer::Vec2 point;
    double within = 0.0;
  };

  int object = kBallObject;
  std::vector<Quantity> quantities;
  std::vector<std::string> areas;  ///< names of areas.h
  std::optional<Nearness> near;

  bool holds(const StepFrame& frame) const;
  /// Describes the object with the quantities that the test compares.
  std::string describe(const StepFrame& frame) const;
};

/// A condition on the world after one step: exactly one member is given.
struct StepTest {
  std::optional<ObjectTest> object;
  std::vector<soccer::PlayMode> modes;       ///< one of these
  std::optional<int> goals;                  ///< minimum, both sides together
  std::optional<std::vector<int>> touch_by;  ///< slots: one of them touches the ball

  bool holds(const StepFrame& frame, const RunRecord& record) const;
};

/// The steps at which a StepTest must hold.
struct CheckTiming {
  enum class How { kAt, kEnd, kSometime, kAlways, kNever };
  How how = How::kEnd;
  int from = 0;  ///< first step
  int to = 0;
};

struct StepCheck {
  StepTest test;
  CheckTiming timing;
};

struct ScoreCheck {
  std::array<std::optional<mock_server::Comparison>, 2> goals;
};

struct RefereeCheck {
  std::string message;
  mock_server::Comparison count;
};

struct TouchCheck {
  enum class Which { kFirst, kLast, kCount };
  Which which = Which::kCount;
  std::vector<int> slots;
  std::string who;
  mock_server::Comparison count;
};

/// Actions in the replies of a Playmaker.
struct ActionCheck {
  std::string kind;  ///< name of a PlayerAction field; "*": any
  soccer::Side side = soccer::Side::kLeft;
  std::vector<int> unums;   ///< empty: all
  bool first_only = false;  ///< counts only the first of each reply
  int from = 0;
  int to = 0;
  std::vector<mock_server::Condition> where;
  mock_server::Comparison count;
};

/// Commands sent by the agents of a side.
struct CommandCheck {
  std::string kind;
  soccer::Side side = soccer::Side::kLeft;
  std::vector<int> unums;
  mock_server::Comparison count;
};

struct RpcCheck {
  soccer::Side side = soccer::Side::kLeft;
  mock_server::Expectation expectation;
  std::size_t index = 0;  ///< in RunRecord::rpc_failures
};

/// The only check that depends on wall time.
struct LatencyCheck {
  soccer::Side side = soccer::Side::kLeft;
  std::map<std::string, mock_server::Comparison> percentiles_ms;  ///< p50, p95, p99, max
};

struct MissedCheck {
  soccer::Side side = soccer::Side::kLeft;
  mock_server::Comparison count;
};

struct EndCheck {
  match::EndReason reason = match::EndReason::kFinished;
};

/// Golden values: fingerprints stored beside the scenario (`cls test --accept`).
struct GoldenCheck {
  std::string what;    ///< "game_log", "score", "touches"
  std::string golden;  ///< empty: none accepted yet
};

struct Check {
  std::variant<StepCheck, ScoreCheck, RefereeCheck, TouchCheck, ActionCheck, CommandCheck, RpcCheck,
               LatencyCheck, MissedCheck, EndCheck, GoldenCheck>
      what;
  std::string name;  ///< for reports
  int line = 0;      ///< in the scenario's file
  /// Number of runs in which it must hold (nothing: all).
  std::optional<mock_server::Comparison> runs;
};

/// Evaluates a check. Returns an empty string if it holds, otherwise what was found instead.
std::string failure(const Check& check, const RunRecord& record);

/// The side whose Playmaker or cls agents a check requires; nothing for checks that an external
/// team can pass too.
std::optional<soccer::Side> playmaker_of(const Check& check);

/// The value that a golden check compares.
std::string fingerprint(const GoldenCheck& check, const RunRecord& record);

}  // namespace cls::scenario
