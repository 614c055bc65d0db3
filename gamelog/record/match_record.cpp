// Resizes the columns of a record and copies frames out of them.
#include "gamelog/record/match_record.h"

#include <cmath>

namespace cls::gamelog {
namespace {

using soccer::Side;

constexpr std::array<std::string_view, kCounterCount> kCounterNames = {
    "kick",        "dash", "turn",   "catch",   "move",        "turn_neck",
    "change_view", "say",  "tackle", "pointto", "attentionto", "change_focus"};

template <typename Function>
void for_frame_columns(MatchRecord& record, Function function) {
  function(record.time);
  function(record.stopped);
  function(record.mode);
  function(record.team_state);
  function(record.ball_position);
  function(record.ball_velocity);
  function(record.ball_height);
}

template <typename Function>
void for_player_columns(PlayerColumns& players, Function function) {
  function(players.state);
  function(players.type);
  function(players.position);
  function(players.velocity);
  function(players.body);
  function(players.neck);
  function(players.pointing_at);
  function(players.view_width);
  function(players.high_quality);
  function(players.focus);
  function(players.stamina);
  function(players.effort);
  function(players.recovery);
  function(players.capacity);
  function(players.attention);
  function(players.counters);
}

CommandCounts counts_of(const Counters& c) {
  return {c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7], c[8], c[9], c[10], c[11]};
}

PlayerFrame player_at(const PlayerColumns& players, std::size_t entry) {
  PlayerFrame player;
  player.state = players.state[entry];
  player.type = players.type[entry];
  player.position = players.position[entry];
  player.velocity = players.velocity[entry];
  player.body = players.body[entry];
  player.neck = players.neck[entry];
  if (!std::isnan(players.pointing_at[entry].x)) player.pointing_at = players.pointing_at[entry];

  player.high_quality = players.high_quality[entry] != 0;
  player.view_width = players.view_width[entry];
  player.focus_distance = players.focus[entry].x;
  player.focus_direction = players.focus[entry].y;

  player.stamina = players.stamina[entry];
  player.effort = players.effort[entry];
  player.recovery = players.recovery[entry];
  player.capacity = players.capacity[entry];

  if (const int slot = players.attention[entry]; slot >= 0) {
    player.attention_side = soccer::side_of_slot(slot);
    player.attention_unum = soccer::unum_of_slot(slot);
  }

  player.counts = counts_of(players.counters[entry]);
  return player;
}

}  // namespace

std::string_view name(Counter counter) { return kCounterNames[static_cast<std::size_t>(counter)]; }

void reserve_frames(MatchRecord& record, std::size_t frames) {
  for_frame_columns(record, [frames](auto& column) { column.reserve(frames); });
  for_player_columns(record.players, [frames](auto& column) { column.reserve(frames * kSlots); });
}

void resize_frames(MatchRecord& record, std::size_t frames) {
  for_frame_columns(record, [frames](auto& column) { column.resize(frames); });
  for_player_columns(record.players, [frames](auto& column) { column.resize(frames * kSlots); });
}

Frame frame_at(const MatchRecord& record, std::size_t frame) {
  Frame result;
  result.time = record.time[frame];
  result.stopped = record.stopped[frame];
  result.mode = record.mode[frame];
  result.teams = teams_at(record, frame);

  result.ball_position = record.ball_position[frame];
  result.ball_velocity = record.ball_velocity[frame];
  if (record.has_ball_height) result.ball_height = record.ball_height[frame];
  for (std::size_t slot = 0; slot < kSlots; ++slot) {
    result.players[slot] = player_at(record.players, frame * kSlots + slot);
  }

  return result;
}

}  // namespace cls::gamelog
