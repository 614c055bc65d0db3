// From world to log.
#include "simulator/sessions/match_recorder.h"

#include "simulator/actions/actions.h"
#include "simulator/world/angles.h"
#include "simulator/world/logged_counters.h"
#include "soccer/math.h"

namespace cls::simulator {
namespace {

namespace math = soccer::math;

void describe(const World& world, const Player& player, gamelog::PlayerFrame& out) {
  out.state = player.state;
  out.type = player.type;
  out.position = player.position;
  out.velocity = player.velocity;
  out.body = exact_degrees(player.body);
  out.neck = exact_degrees(player.neck);
  out.pointing_at.reset();
  if (is_pointing(world, player)) out.pointing_at = player.arm.target;
  out.high_quality = player.view.quality == soccer::ViewQuality::kHigh;
  out.view_width = exact_degrees(view_cone(player.view, world.params().visible_angle));
  out.focus_distance = player.view.focus_distance;
  out.focus_direction = exact_degrees(player.view.focus_direction);
  out.stamina = player.stamina.value;
  out.effort = player.stamina.effort;
  out.recovery = player.stamina.recovery;
  out.capacity = player.stamina.capacity;
  out.attention_side = Side::kNeutral;
  if (player.attention != kNobody) {
    out.attention_side = soccer::side_of_slot(player.attention);
    out.attention_unum = soccer::unum_of_slot(player.attention);
  }
  out.counts = counts_of(player.counters);
}

void describe(const Team& team, gamelog::TeamFrame& out) {
  out.name = team.name.view();
  out.score = team.score;
  out.penalty_scored = team.penalty_goals;
  out.penalty_missed = team.penalty_kicks - team.penalty_goals;
}

// Boards of a game log's messages, and the longest message.
constexpr int kMessageBoard = 1;
constexpr int kCommandBoard = 2;
constexpr std::size_t kLongestMessage = 2047;

constexpr std::size_t kUsualText = 1024;  // bytes

gamelog::Stamp stamp(Clock clock) { return {clock.time, clock.stoppage}; }

void append_received(const World& world, ClientId client, std::string_view text, std::string& out) {
  if (client == kTrainer) return gamelog::append_trainer_command(text, out);
  const Side side = is_player(client)      ? soccer::side_of_slot(client)
                    : client == kLeftCoach ? Side::kLeft
                                           : Side::kRight;
  const std::string_view team = world.team(side).name.view();
  if (!is_player(client)) return gamelog::append_coach_command(team, text, out);
  gamelog::append_player_command(team, soccer::unum_of_slot(client), text, out);
}

}  // namespace

void describe(const World& world, gamelog::Frame& out) {
  out.time = world.clock.time;
  out.stopped = world.clock.stoppage;
  out.mode = world.mode;
  for (std::size_t i = 0; i < out.teams.size(); ++i) describe(world.teams[i], out.teams[i]);
  out.ball_position = world.ball.position;
  out.ball_velocity = world.ball.velocity;
  for (std::size_t i = 0; i < out.players.size(); ++i) {
    describe(world, world.players[i], out.players[i]);
  }
}

void MatchRecorder::begin(const LogSinks& sinks, const Rules& rules) {
  if (sinks.game != nullptr) {
    game_log_ = sinks.game;
    rcg_.emplace(*sinks.game, sinks.version, sinks.date);
    rcg_->begin(rules.server, rules.player, rules.types);
  }
  if (sinks.text != nullptr) rcl_.emplace(*sinks.text);
  text_.reserve(kUsualText);
  records_messages_ = rules.server.record_messages;
  records_referee_ = records_messages_ || sinks.version == gamelog::RcgVersion::kV1;
}

void MatchRecorder::step(const World& world) {
  if (!rcg_ || world.mode == PlayMode::kBeforeKickOff) return;
  const PlayMode last_mode = frame_.mode;
  describe(world, frame_);
  rcg_->step(frame_);
  // Who follows the log of a match that is being played learns of the game's turns at once.
  if (world.mode != last_mode) game_log_->flush();
}

void MatchRecorder::command(const World& world, ClientId client, std::string_view text) {
  const bool into_rcg = hears() && world.mode != PlayMode::kTimeOver;
  if (!rcl_ && !into_rcg) return;
  text_.clear();
  append_received(world, client, text, text_);
  if (rcl_) rcl_->command(stamp(world.clock), text_);
  if (into_rcg) {
    rcg_->message(stamp(world.clock), kCommandBoard,
                  std::string_view(text_).substr(0, kLongestMessage));
  }
}

void MatchRecorder::tile(const World& world, const Tile& tile) {
  if (rcg_) rcg_->message(stamp(world.clock), kMessageBoard, text_of(tile));
}

void MatchRecorder::referee(Clock clock, std::string_view text) {
  if (rcl_) rcl_->referee(stamp(clock), text);
  if (!rcg_ || !records_referee_) return;
  text_ = "(referee ";
  text_ += text;
  text_ += ')';
  rcg_->message(stamp(clock), kMessageBoard, text_);
}

void MatchRecorder::said(const World& world, Clock clock, std::string_view text) {
  if (!hears() || world.mode == PlayMode::kBeforeKickOff || world.mode == PlayMode::kTimeOver) {
    return;
  }
  rcg_->message(stamp(clock), kMessageBoard, text.substr(0, kLongestMessage));
}

void MatchRecorder::substitution(const World& world, Clock clock, std::string_view text) {
  if (!hears() || world.mode == PlayMode::kTimeOver) return;
  rcg_->message(stamp(clock), kCommandBoard, text);
}

void MatchRecorder::finish(const World& world) {
  if (!rcg_) return;
  describe(world, frame_);
  rcg_->end(frame_);
}

}  // namespace cls::simulator
