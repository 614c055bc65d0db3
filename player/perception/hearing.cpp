// Handles referee messages: play modes, goals, catches, shoot-out; and say messages.
#include "player/perception/perception.h"

#include <algorithm>
#include <optional>

#include "base/text/number_text.h"
#include "player/perception/player_types_message.h"
#include "player/tracking/tracking.h"
#include "soccer/pitch.h"
#include "soccer/protocol/scanner.h"

namespace cls::player {
namespace {

std::optional<Side> side_of_letter(char letter) {
  if (letter == 'l') return Side::kLeft;
  if (letter == 'r') return Side::kRight;
  return std::nullopt;
}

/// Places the ball by the rules of the mode (docs/spec/simulation-model.md 9.2); exact in a few
/// modes only.
void set_ball(WorldModel& world, PlayMode mode) {
  constexpr double kExact = 0.02;
  const double toward =
      soccer::side(mode) == world.our_side ? 1.0 : -1.0;  // 1: their goal, -1: our goal
  const Vec2 estimated = world.ball.position;
  const double half = estimated.y > 0.0 ? 1.0 : -1.0;
  const bool tracked = world.ball_tracker.tracked;
  const double blurred = 1.0 + world.ball.position_deviation;

  switch (without_side(mode)) {
    case PlayMode::kBeforeKickOff:
    case PlayMode::kKickOffLeft:
      return place_ball(world, {0.0, 0.0}, kExact);
    case PlayMode::kCornerKickLeft: {
      const double margin = world.server().ckick_margin;
      const double x = toward * (soccer::kHalfLength - margin);
      return place_ball(world, {x, half * (soccer::kHalfWidth - margin)}, kExact);
    }
    case PlayMode::kGoalKickLeft: {
      const double x = -toward * (soccer::kHalfLength - soccer::kGoalAreaLength);
      return place_ball(world, {x, half * 0.5 * soccer::kGoalAreaWidth}, kExact);
    }
    case PlayMode::kKickInLeft: {
      const double x = std::clamp(estimated.x, -soccer::kHalfLength, soccer::kHalfLength);
      if (tracked) place_ball(world, {x, half * soccer::kHalfWidth}, blurred);
      return;
    }
    case PlayMode::kFreeKickLeft:
    case PlayMode::kIndirectFreeKickLeft:
      if (tracked) place_ball(world, estimated, blurred);
      return;
    default:
      return;
  }
}

/// Modes in which players use move commands or the server moves them.
bool players_are_placed(PlayMode mode) {
  return before_play(mode) || without_side(mode) == PlayMode::kPenaltySetupLeft;
}

void count_penalty(WorldModel& world, PlayMode mode, int time) {
  PenaltyState& penalty = world.game.penalty;
  const bool our_team = soccer::side(mode) == world.our_side;
  const PlayMode kind = without_side(mode);
  const bool begins = kind == PlayMode::kPenaltySetupLeft;

  if (begins) ++(our_team ? penalty.our_taken : penalty.their_taken);
  if (kind == PlayMode::kPenaltyScoreLeft) ++(our_team ? penalty.our_score : penalty.their_score);
  if (begins || kind == PlayMode::kPenaltyReadyLeft || kind == PlayMode::kPenaltyTakenLeft) {
    penalty.taker = soccer::side(mode);
    penalty.cycle = time;
  }
}

void change_mode(WorldModel& world, PlayMode mode, int time) {
  GameState& game = world.game;
  game.goalie_catch = game.caught_side != Side::kNeutral && game.caught_time == time &&
                      without_side(mode) == PlayMode::kFreeKickLeft &&
                      soccer::side(mode) == game.caught_side;

  game.mode = mode;
  game.mode_start = time == game.time.cycle ? game.time : GameTime{time, 0};

  if (soccer::is_penalty_mode(mode)) {
    count_penalty(world, mode, time);
  } else if (mode != PlayMode::kPlayOn) {
    game.last_set_play_start = time;
    game.set_play_count = 0;
  }

  if (!game.goalie_catch) set_ball(world, mode);
  if (players_are_placed(mode)) forget_positions(world);
}

/// Handles "goal_l_2": sets the score of that side and the goal mode, which has no message of its
/// own.
bool hear_goal(WorldModel& world, std::string_view message, int time) {
  constexpr std::string_view kStart = "goal_";
  if (message.size() < 8 || !message.starts_with(kStart) || message[6] != '_') return false;

  const std::optional<Side> side = side_of_letter(message[5]);
  const std::optional<int> score = base::parse_int(message.substr(7));
  if (!side || !score || *score < 0 || *score > soccer::kMaxInteger) return false;

  (*side == world.our_side ? world.game.our_score : world.game.their_score) = *score;
  change_mode(world, soccer::for_side(PlayMode::kGoalLeft, *side), time);
  return true;
}

/// Handles the opponents' player types sent by our coach.
void hear_types(WorldModel& world, std::string_view text) {
  const std::optional<TypeIds> said = parse_player_types(text);
  if (!said) return;
  for (std::size_t i = 0; i < said->size(); ++i) {
    if ((*said)[i] >= 0) world.their_types[i] = (*said)[i];
  }
}

}  // namespace

void hear_referee(WorldModel& world, int time, std::string_view message) {
  if (const std::optional<PlayMode> mode = soccer::parse_play_mode(message)) {
    change_mode(world, *mode, time);
    return;
  }

  if (hear_goal(world, message, time)) return;
  const std::optional<Side> side = message.empty() ? std::nullopt : side_of_letter(message.back());
  if (!side) return;

  if (message.starts_with("goalie_catch_ball_")) {
    world.game.caught_side = *side;
    world.game.caught_time = time;
  } else if (message.starts_with("penalty_onfield_")) {
    world.game.penalty.field_side = *side;
  }
}

void hear_message(WorldModel& world, const soccer::Hear& hear) {
  using Sender = soccer::Hear::Sender;
  if (hear.partial) return;

  HeardMessage message{.time = world.game.time, .text = hear.text};

  switch (hear.sender) {
    case Sender::kTeammate:
      message.side = world.our_side;
      message.unum = hear.unum;
      apply_say_messages(world, hear.unum, hear.text);
      message.direction = world.self.body + hear.direction;
      break;
    case Sender::kOpponent:
      message.side = world.their_side();
      message.direction = world.self.body + hear.direction;
      break;
    case Sender::kSelf:
      message.side = world.our_side;
      message.unum = world.unum;
      break;
    case Sender::kOnlineCoachLeft:
    case Sender::kOnlineCoachRight:
      message.side = hear.sender == Sender::kOnlineCoachLeft ? Side::kLeft : Side::kRight;
      message.coach = true;
      if (message.side == world.our_side) hear_types(world, hear.text);
      break;
    case Sender::kTrainer:
      message.coach = true;
      break;
    case Sender::kReferee:
    case Sender::kPlayer:
      return;
  }

  world.heard.push_back(message);
}

}  // namespace cls::player
