// The record of one run of a scenario; checks are evaluated on it.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "match/result/match_result.h"
#include "mock-server/script/expectations.h"
#include "proto/playmaker.pb.h"
#include "proxy/playmaker/playmaker_errors.h"
#include "soccer/geometry.h"
#include "soccer/play_mode.h"
#include "soccer/side.h"

namespace cls::scenario {

/// The ball or a player after a step. Members that do not apply to the ball are 0.
struct ObjectFrame {
  soccer::Vec2 position;
  soccer::Vec2 velocity;
  bool on_pitch = false;
  double body = 0.0;  ///< degrees
  double stamina = 0.0;
  int cards = 0;  ///< 1 yellow, 2 red
};

/// The world after a step; step 0 is the start.
struct StepFrame {
  int step = 0;
  int cycle = 0;  ///< game time
  soccer::PlayMode mode = soccer::PlayMode::kNull;
  std::array<int, 2> score{};
  ObjectFrame ball;
  std::array<ObjectFrame, soccer::kPlayersOnPitch> players;
};

/// A kick, tackle, catch or collision with the ball.
struct Touch {
  int step = 0;
  int slot = 0;
};

/// A message of the referee.
struct RefereeMessage {
  int step = 0;
  std::string message;
};

/// One reply of a Playmaker to a player.
struct ReceivedReply {
  int step = 0;
  int unum = 0;
  protos::PlayerActions actions;
};

struct RunRecord {
  std::uint64_t seed = 0;
  std::vector<StepFrame> frames;
  std::vector<Touch> touches;
  std::vector<RefereeMessage> referee_messages;
  std::array<std::vector<ReceivedReply>, 2> replies;  ///< ordered by step and uniform number
  /// Failures of the RPC checks, by RpcCheck::index.
  std::vector<std::vector<std::string>> rpc_failures;
  /// Failed expectations of the scripts of mock sides.
  std::vector<std::string> script_failures;
  match::MatchResult result;
  /// The first call that the Playmaker of each side answered with an error.
  std::array<std::optional<proxy::PlaymakerError>, 2> errors;
  std::string game_log;
  std::string text_log;
  double seconds = 0.0;  ///< wall time, for reports; not used by checks
};

}  // namespace cls::scenario
