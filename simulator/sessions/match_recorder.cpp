// Converts worlds and messages to log records.
#include "simulator/sessions/match_recorder.h"

#include "simulator/actions/actions.h"
#include "simulator/world/angles.h"
#include "soccer/math.h"

namespace cls::simulator {
namespace {

namespace math = soccer::math;

void to_frame(const World& world, const Player& player, gamelog::PlayerFrame& out) {
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
  if (player.attention != kNoPlayer) {
    out.attention_side = soccer::side_of_slot(player.attention);
    out.attention_unum = soccer::unum_of_slot(player.attention);
  }
  out.counts = player.counters;
}

void to_frame(const Team& team, gamelog::TeamFrame& out) {
  out.name = team.name.view();
  out.score = team.score;
  out.penalty_scored = team.penalty_goals;
  out.penalty_missed = team.penalty_kicks - team.penalty_goals;
}

// Board numbers of messages in game logs, and the maximum length of a message.
constexpr int kMessageBoard = 1;
constexpr int kCommandBoard = 2;
constexpr std::size_t kMaxMessageLength = 2047;

constexpr std::size_t kTextCapacity = 1024;  // bytes

gamelog::Stamp stamp(Clock clock) { return {clock.time, clock.stoppage}; }

void append_datagram(const World& world, ClientId client, std::string_view text, std::string& out) {
  if (client == kTrainer) return gamelog::append_trainer_command(text, out);

  const Side side = is_player(client)      ? soccer::side_of_slot(client)
                    : client == kLeftCoach ? Side::kLeft
                                           : Side::kRight;
  const std::string_view team = world.team(side).name.view();
  if (!is_player(client)) return gamelog::append_coach_command(team, text, out);
  gamelog::append_player_command(team, soccer::unum_of_slot(client), text, out);
}

}  // namespace

void to_frame(const World& world, gamelog::Frame& out) {
  out.time = world.clock.time;
  out.stopped = world.clock.stoppage;
  out.mode = world.mode;
  for (std::size_t i = 0; i < out.teams.size(); ++i) to_frame(world.teams[i], out.teams[i]);

  out.ball_position = world.ball.position;
  out.ball_velocity = world.ball.velocity;

  for (std::size_t i = 0; i < out.players.size(); ++i) {
    to_frame(world, world.players[i], out.players[i]);
  }
}

void MatchRecorder::begin(const LogSinks& sinks, const Rules& rules) {
  if (sinks.game != nullptr) {
    game_log_ = sinks.game;
    rcg_.emplace(*sinks.game, sinks.version, sinks.date);
    rcg_->write_header(rules.server, rules.player, rules.types);
  }
  if (sinks.text != nullptr) rcl_.emplace(*sinks.text);

  text_.reserve(kTextCapacity);
  record_messages_ = rules.server.record_messages;
  record_referee_ = record_messages_ || sinks.version == gamelog::RcgVersion::kV1;
}

void MatchRecorder::step(const World& world) {
  if (!rcg_ || world.mode == PlayMode::kBeforeKickOff) return;

  const PlayMode last_mode = frame_.mode;
  to_frame(world, frame_);
  rcg_->write_step(frame_);
  // Readers that follow the log of a running match see mode changes immediately.
  if (world.mode != last_mode) game_log_->flush();
}

void MatchRecorder::command(const World& world, ClientId client, std::string_view text) {
  const bool to_rcg = records_messages() && world.mode != PlayMode::kTimeOver;
  if (!rcl_ && !to_rcg) return;

  text_.clear();
  append_datagram(world, client, text, text_);

  if (rcl_) rcl_->write_command(stamp(world.clock), text_);
  if (to_rcg) {
    rcg_->write_message(stamp(world.clock), kCommandBoard,
                        std::string_view(text_).substr(0, kMaxMessageLength));
  }
}

void MatchRecorder::tile(const World& world, const TeamGraphicTile& tile) {
  if (rcg_) rcg_->write_message(stamp(world.clock), kMessageBoard, format_tile(tile));
}

void MatchRecorder::referee(Clock clock, std::string_view text) {
  if (rcl_) rcl_->write_referee(stamp(clock), text);
  if (!rcg_ || !record_referee_) return;

  text_ = "(referee ";
  text_ += text;
  text_ += ')';
  rcg_->write_message(stamp(clock), kMessageBoard, text_);
}

void MatchRecorder::message(const World& world, Clock clock, std::string_view text) {
  if (!records_messages() || world.mode == PlayMode::kBeforeKickOff ||
      world.mode == PlayMode::kTimeOver) {
    return;
  }

  rcg_->write_message(stamp(clock), kMessageBoard, text.substr(0, kMaxMessageLength));
}

void MatchRecorder::substitution(const World& world, Clock clock, std::string_view text) {
  if (!records_messages() || world.mode == PlayMode::kTimeOver) return;
  rcg_->write_message(stamp(clock), kCommandBoard, text);
}

void MatchRecorder::finish(const World& world) {
  if (!rcg_) return;
  to_frame(world, frame_);
  rcg_->write_end(frame_);
}

void KeepawayRecorder::step(const World& world) {
  const KeepawayState& state = world.referee.keepaway;
  if (state.episode == episode_) return;

  if (episode_ == 0) {
    log_.write_header(state.keepers, state.takers, world.params().keepaway_length,
                      world.params().keepaway_width);
  } else {
    using gamelog::KeepawayLoss;
    log_.write_episode(episode_, start_, world.clock.time,
                       state.won_by_takers() ? KeepawayLoss::kTaken : KeepawayLoss::kOutOfBounds);
    start_ = world.clock.time;
  }

  episode_ = state.episode;
}

}  // namespace cls::simulator
