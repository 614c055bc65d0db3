// From world to log.
#include "simulator/server/match_recorder.h"

#include "simulator/actions.h"
#include "simulator/angles.h"
#include "simulator/logged_counters.h"
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

gamelog::Stamp stamp(Clock clock) { return {clock.time, clock.stoppage}; }

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

void MatchRecorder::begin(gamelog::ByteSink* game_log, gamelog::ByteSink* text_log,
                          const Rules& rules) {
  game_log_ = game_log;
  if (game_log != nullptr) {
    rcg_.emplace(*game_log);
    rcg_->begin(rules.server, rules.player, rules.types);
  }
  if (text_log != nullptr) rcl_.emplace(*text_log);
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
  if (!rcl_) return;
  const gamelog::Stamp now = stamp(world.clock);
  if (client == kTrainer) return rcl_->trainer_command(now, text);
  const Side side = is_player(client)      ? soccer::side_of_slot(client)
                    : client == kLeftCoach ? Side::kLeft
                                           : Side::kRight;
  const soccer::TeamName& team = world.team(side).name;
  if (!is_player(client)) return rcl_->coach_command(now, team.view(), text);
  rcl_->player_command(now, team.view(), soccer::unum_of_slot(client), text);
}

void MatchRecorder::tile(const World& world, const Tile& tile) {
  if (rcg_) rcg_->message(world.clock.time, 1, text_of(tile));
}

void MatchRecorder::referee(Clock clock, std::string_view text) {
  if (rcl_) rcl_->referee(stamp(clock), text);
}

void MatchRecorder::finish(const World& world) {
  if (!rcg_) return;
  describe(world, frame_);
  rcg_->end(frame_.time, frame_.teams);
}

}  // namespace cls::simulator
