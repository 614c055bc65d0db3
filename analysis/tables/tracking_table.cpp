// Formats rows into one buffer, because a match has a million numbers.
#include "analysis/tables/tracking_table.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "analysis/play/flow.h"
#include "base/text/number_text.h"
#include "soccer/play_mode.h"

namespace cls::analysis {
namespace {

using gamelog::MatchRecord;
using gamelog::RcgVersion;

constexpr std::size_t kCell = base::kMaxNumberLength + 1;
constexpr std::size_t kPlayerCells = 9;
constexpr std::size_t kNumberCells = 8 + gamelog::kSlots * kPlayerCells;
constexpr std::size_t kMaxModeLength = 64;

char* write_text(std::string_view text, char* to) { return std::ranges::copy(text, to).out; }

char* write_number(float value, char* to) {
  *to = ',';
  return base::write_g(value, to + 1);
}

char* write_integer(std::int64_t value, char* to) {
  *to = ',';
  return base::write_int(value, to + 1);
}

char* write_point(const gamelog::Point& point, char* to) {
  return write_number(point.y, write_number(point.x, to));
}

char* write_empty_cells(std::size_t count, char* to) { return std::fill_n(to, count, ','); }

// In quotation marks, with a backslash before quotation marks and backslashes.
std::string quoted(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') out += '\\';
    out += c;
  }
  return out + '"';
}

// Text logs call a team that never connected "null"; records leave its name empty.
std::string_view name_in_log(const MatchRecord& record, std::uint32_t state,
                             const gamelog::TeamFrame& team) {
  const bool text = record.version >= RcgVersion::kV4 && record.version != RcgVersion::kJson;
  return text && state > 0 && team.name.empty() ? "null" : std::string_view(team.name);
}

bool has_motion(RcgVersion version) { return version >= RcgVersion::kV3; }

}  // namespace

TrackingTable::TrackingTable(base::ByteSink& sink, TrackingColumns columns)
    : sink_(sink), columns_(columns) {}

void TrackingTable::write_heading() {
  std::string line =
      "#,cycle,stopped,playmode,l_name,l_score,l_pen_score,r_name,r_score,r_pen_score,"
      "b_x,b_y,b_vx,b_vy";
  for (int slot = 0; slot < soccer::kPlayersOnPitch; ++slot) {
    const std::string player = fmt::format(",{}{}", soccer::letter(side_of(slot)), unum_of(slot));
    for (const char* cell : {"_t", "_x", "_y", "_vx", "_vy", "_body", "_neck"}) {
      line += player + cell;
    }
    if (columns_ == TrackingColumns::kAll) line += player + "_vwidth" + player + "_stamina";
  }
  if (has_ball_height_) line += ",b_z";
  sink_.write(line + '\n');
}

// Rows count from 1. The time before the first row is 0, so a log that starts at 0 starts stopped.
void TrackingTable::count(int time) {
  ++rows_;
  stopped_ = time == time_ ? stopped_ + 1 : 0;
  time_ = time;
}

void TrackingTable::set_teams(const MatchRecord& record, std::uint32_t state) {
  if (state == team_state_ && !teams_.empty()) return;
  team_state_ = state;
  teams_.clear();
  for (const gamelog::TeamFrame& team : record.teams[state]) {
    teams_ += ',' + quoted(name_in_log(record, state, team));
    teams_ += ',' + std::to_string(team.score) + ',' + std::to_string(team.penalty_scored);
  }
}

void TrackingTable::on_frame(const MatchRecord& record, std::size_t frame) {
  if (rows_ == 0) {
    has_ball_height_ = record.has_ball_height;
    write_heading();
  }
  count(record.time[frame]);
  set_teams(record, record.team_state[frame]);

  row_.resize(kNumberCells * kCell + kMaxModeLength + teams_.size());
  char* to = write_start(record, frame, row_.data());
  to = write_players(record, frame, to);
  if (has_ball_height_) to = write_number(record.ball_height[frame], to);
  *to++ = '\n';
  sink_.write({row_.data(), base::index(to - row_.data())});
}

char* TrackingTable::write_start(const MatchRecord& record, std::size_t frame, char* to) const {
  to = base::write_int(static_cast<std::int64_t>(rows_), to);
  to = write_integer(time_, to);
  to = write_integer(stopped_, to);
  to = write_text(",\"", to);
  to = write_text(name(record.mode[frame]), to);
  to = write_text("\"", to);
  to = write_text(teams_, to);
  to = write_point(record.ball_position[frame], to);
  return has_motion(record.version) ? write_point(record.ball_velocity[frame], to)
                                    : write_empty_cells(2, to);
}

char* TrackingTable::write_players(const MatchRecord& record, std::size_t frame, char* to) const {
  const gamelog::PlayerColumns& players = record.players;
  const bool all = columns_ == TrackingColumns::kAll;
  const std::size_t cells = all ? kPlayerCells : kPlayerCells - 2;
  const bool motion = has_motion(record.version);

  for (std::size_t slot = 0; slot < gamelog::kSlots; ++slot) {
    const std::size_t entry = entry_of(frame, slot);
    if (players.state[entry] == 0) {
      to = write_empty_cells(cells, to);
      continue;
    }
    to = motion ? write_integer(players.type[entry], to) : write_empty_cells(1, to);
    to = write_point(players.position[entry], to);
    to = motion ? write_point(players.velocity[entry], to) : write_empty_cells(2, to);
    to = write_number(players.body[entry], to);
    if (!motion) {
      to = write_empty_cells(all ? 3 : 1, to);
      continue;
    }
    to = write_number(players.neck[entry], to);
    if (!all) continue;
    to = write_number(players.view_width[entry], to);
    to = write_number(players.stamina[entry], to);
  }
  return to;
}

}  // namespace cls::analysis
