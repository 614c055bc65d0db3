// Appends notes and frames, and counts stopped cycles.
#include "gamelog/record/record_builder.h"

#include <limits>
#include <utility>

namespace cls::gamelog {
namespace {

constexpr Point kNotPointing = {std::numeric_limits<float>::quiet_NaN(),
                                std::numeric_limits<float>::quiet_NaN()};

Point point(soccer::Vec2 v) { return {static_cast<float>(v.x), static_cast<float>(v.y)}; }

Counters counters_of(const CommandCounts& c) {
  return {c.kick,        c.dash, c.turn,   c.catches, c.move,        c.turn_neck,
          c.change_view, c.say,  c.tackle, c.pointto, c.attentionto, c.change_focus};
}

void set_player(PlayerColumns& players, std::size_t entry, const PlayerFrame& player) {
  players.state[entry] = player.state;
  players.type[entry] = static_cast<std::int16_t>(player.type);
  players.position[entry] = point(player.position);
  players.velocity[entry] = point(player.velocity);
  players.body[entry] = static_cast<float>(player.body);
  players.neck[entry] = static_cast<float>(player.neck);
  players.pointing_at[entry] = player.pointing_at ? point(*player.pointing_at) : kNotPointing;

  players.view_width[entry] = static_cast<float>(player.view_width);
  players.high_quality[entry] = player.high_quality ? 1 : 0;
  players.focus[entry] = point({player.focus_distance, player.focus_direction});

  players.stamina[entry] = static_cast<float>(player.stamina);
  players.effort[entry] = static_cast<float>(player.effort);
  players.recovery[entry] = static_cast<float>(player.recovery);
  players.capacity[entry] = static_cast<float>(player.capacity);

  const bool attentive = player.attention_side != soccer::Side::kNeutral;
  players.attention[entry] = static_cast<std::int8_t>(
      attentive ? soccer::slot_of(player.attention_side, player.attention_unum) : -1);
  players.counters[entry] = counters_of(player.counts);
}

}  // namespace

void RecordBuilder::add(int time, decltype(Note::content) content) {
  Note& note = record_.notes.emplace_back();
  note.frame = static_cast<std::uint32_t>(record_.frames());
  note.time = time;
  note.content = std::move(content);

  if (!record_.time.empty() && record_.time.back() == time) note.stopped = record_.stopped.back();
  note_bytes_ += sizeof(Note);
}

void RecordBuilder::add_play_mode(int time, soccer::PlayMode mode) {
  add(time, mode);
  mode_ = mode;
}

void RecordBuilder::add_teams(int time, const TeamFrames& teams) {
  add(time, teams);
  record_.teams.push_back(teams);
  note_bytes_ += sizeof(TeamFrames);
}

void RecordBuilder::rename_teams(const TeamFrames& before, const TeamFrames& now) {
  const auto correct = [&](TeamFrames& teams) {
    if (teams[0].name != before[0].name || teams[1].name != before[1].name) return;
    teams[0].name = now[0].name;
    teams[1].name = now[1].name;
  };

  for (TeamFrames& teams : record_.teams) correct(teams);
  for (Note& note : record_.notes) {
    if (auto* teams = std::get_if<TeamFrames>(&note.content)) correct(*teams);
  }
}

void RecordBuilder::add_message(int time, int board, std::string text) {
  note_bytes_ += text.size();
  add(time, Message{board, std::move(text)});
}

void RecordBuilder::add_unknown_line(std::string text) {
  note_bytes_ += text.size();
  add(record_.time.empty() ? 0 : record_.time.back(), UnknownLine{std::move(text)});
}

void RecordBuilder::add_parameter_line(std::string text) {
  note_bytes_ += text.size();
  record_.parameter_lines.push_back(std::move(text));
}

bool RecordBuilder::set_player_type(const soccer::PlayerType& type) {
  if (type.id < 0 || type.id > kMaxPlayerType) return false;

  const auto id = static_cast<std::size_t>(type.id);
  if (record_.types.size() <= id) record_.types.resize(id + 1);

  record_.types[id] = type;
  return true;
}

void RecordBuilder::set_stopped(int stopped) { record_.notes.back().stopped = stopped; }

std::size_t RecordBuilder::begin_frame(int time, int stopped) {
  const std::size_t index = record_.frames();
  const bool stands = index > 0 && record_.time.back() == time;
  if (stopped == 0 && stands) stopped = record_.stopped.back() + 1;

  for (std::size_t i = record_.notes.size(); i > 0 && record_.notes[i - 1].frame == index; --i) {
    if (record_.notes[i - 1].time == time) record_.notes[i - 1].stopped = stopped;
  }

  resize_frames(record_, index + 1);
  record_.time[index] = time;
  record_.stopped[index] = stopped;
  record_.mode[index] = mode_;
  record_.team_state[index] = static_cast<std::uint32_t>(record_.teams.size() - 1);
  return index;
}

void RecordBuilder::drop_frame() { resize_frames(record_, record_.frames() - 1); }

void RecordBuilder::fill_frame(std::size_t index, const Frame& frame) {
  record_.ball_position[index] = point(frame.ball_position);
  record_.ball_velocity[index] = point(frame.ball_velocity);
  record_.ball_height[index] = static_cast<float>(frame.ball_height.value_or(0.0));
  if (frame.ball_height) record_.has_ball_height = true;
  for (std::size_t slot = 0; slot < kSlots; ++slot) {
    set_player(record_.players, index * kSlots + slot, frame.players[slot]);
  }
}

void RecordBuilder::append_frame(const Frame& frame) {
  if (frame.mode != mode_ && frame.mode != soccer::PlayMode::kNull) {
    add_play_mode(frame.time, frame.mode);
  }
  if (record_.teams.size() == 1 || frame.teams != record_.teams.back()) {
    add_teams(frame.time, frame.teams);
  }

  fill_frame(begin_frame(frame.time), frame);
}

bool RecordBuilder::has_room() const {
  return record_.frames() < kMaxFrames && note_bytes_ < kMaxNoteBytes;
}

void RecordBuilder::add_error(const base::InputBuffer& input, std::string message,
                              std::size_t column) {
  record_.errors.add(error_at(input, std::move(message), column));
}

void RecordBuilder::add_cause(const base::InputBuffer& input, std::string message) {
  record_.errors.add_cause(error_at(input, std::move(message), 0));
}

ParseError RecordBuilder::error_at(const base::InputBuffer& input, std::string message,
                                   std::size_t column) const {
  const int cycle = record_.time.empty() ? 0 : record_.time.back();
  const bool text = record_.version >= RcgVersion::kV4;
  return {text ? input.line_number() : 0, input.offset() + column, cycle, std::move(message)};
}

void clear_player(PlayerColumns& players, std::size_t entry) {
  set_player(players, entry, PlayerFrame{});
}

}  // namespace cls::gamelog
