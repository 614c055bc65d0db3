// Frames and commands; event_table.cpp writes events, in both formats.
#include "analysis/tables/log_tables.h"

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/io/arrow_file.h"
#include "base/text/enum_names.h"
#include "gamelog/rcl/logged_commands.h"
#include "soccer/play_mode.h"

namespace cls::analysis {
namespace {

using base::ArrowField;
using base::ArrowType;
using base::ArrowWriter;
using gamelog::MatchRecord;
using gamelog::RcgVersion;

constexpr const char* kMeters = "m";
constexpr const char* kMetersPerCycle = "m/cycle";
constexpr const char* kDegrees = "deg";
constexpr const char* kCycles = "cycle";

std::vector<ArrowField> frame_fields(bool has_ball_height) {
  std::vector<ArrowField> fields = {{"#", ArrowType::kInt32},
                                    {"cycle", ArrowType::kInt32, kCycles},
                                    {"stopped", ArrowType::kInt32, kCycles},
                                    {"playmode", ArrowType::kText}};
  for (const char* side : {"l", "r"}) {
    fields.push_back({std::string(side) + "_name", ArrowType::kText});
    fields.push_back({std::string(side) + "_score", ArrowType::kInt32});
    fields.push_back({std::string(side) + "_pen_score", ArrowType::kInt32});
  }
  for (const char* name : {"b_x", "b_y"}) fields.push_back({name, ArrowType::kFloat32, kMeters});
  for (const char* name : {"b_vx", "b_vy"}) {
    fields.push_back({name, ArrowType::kFloat32, kMetersPerCycle});
  }

  for (int slot = 0; slot < soccer::kPlayersOnPitch; ++slot) {
    const std::string player = letter(side_of(slot)) + std::to_string(unum_of(slot));
    fields.push_back({player + "_t", ArrowType::kInt16});
    for (const auto& [cell, unit] :
         {std::pair("_x", kMeters), std::pair("_y", kMeters), std::pair("_vx", kMetersPerCycle),
          std::pair("_vy", kMetersPerCycle), std::pair("_body", kDegrees),
          std::pair("_neck", kDegrees), std::pair("_vwidth", kDegrees),
          std::pair("_stamina", "")}) {
      fields.push_back({player + cell, ArrowType::kFloat32, unit});
    }
  }
  if (has_ball_height) fields.push_back({"b_z", ArrowType::kFloat32, kMeters});
  return fields;
}

void add_known(bool known, double value, ArrowWriter& table) {
  known ? table.add(value) : table.add_null();
}

void add_player(const MatchRecord& record, std::size_t entry, ArrowWriter& table) {
  const gamelog::PlayerColumns& players = record.players;
  const bool there = players.state[entry] != 0;
  const bool motion = there && record.version >= RcgVersion::kV3;
  add_known(motion, players.type[entry], table);
  add_known(there, players.position[entry].x, table);
  add_known(there, players.position[entry].y, table);
  add_known(motion, players.velocity[entry].x, table);
  add_known(motion, players.velocity[entry].y, table);
  add_known(there, players.body[entry], table);
  add_known(motion, players.neck[entry], table);
  add_known(motion, players.view_width[entry], table);
  add_known(motion, players.stamina[entry], table);
}

// Empty for those that send no commands.
constexpr auto kSourceNames =
    base::enum_names<gamelog::RclSource>("player", "coach", "trainer", "", "");

}  // namespace

void write_frames_arrow(const MatchRecord& record, base::ByteSink& sink) {
  ArrowWriter table(sink, frame_fields(record.has_ball_height), {{"schema", "cls.frames/1"}});
  const bool motion = record.version >= RcgVersion::kV3;
  int time = 0;
  int stopped = 0;

  for (std::size_t frame = 0; frame < record.frames(); ++frame) {
    stopped = record.time[frame] == std::exchange(time, record.time[frame]) ? stopped + 1 : 0;
    table.add(static_cast<double>(frame + 1));
    table.add(record.time[frame]);
    table.add(stopped);
    table.add(name(record.mode[frame]));

    for (const gamelog::TeamFrame& team : gamelog::teams_at(record, frame)) {
      table.add(std::string_view(team.name));
      table.add(team.score);
      table.add(team.penalty_scored);
    }

    table.add(record.ball_position[frame].x);
    table.add(record.ball_position[frame].y);
    add_known(motion, record.ball_velocity[frame].x, table);
    add_known(motion, record.ball_velocity[frame].y, table);
    for (std::size_t slot = 0; slot < gamelog::kSlots; ++slot) {
      add_player(record, entry_of(frame, slot), table);
    }
    if (record.has_ball_height) table.add(record.ball_height[frame]);
  }
  table.close();
}

void write_commands_arrow(const gamelog::RclRecord& text, base::ByteSink& sink) {
  ArrowWriter table(sink,
                    {{"cycle", ArrowType::kInt32, kCycles},
                     {"stopped", ArrowType::kInt32, kCycles},
                     {"source", ArrowType::kText},
                     {"team", ArrowType::kText},
                     {"unum", ArrowType::kInt8},
                     {"command", ArrowType::kText},
                     {"arguments", ArrowType::kText}},
                    {{"schema", "cls.commands/1"}});

  for (const gamelog::RclLine& line : text.lines) {
    const std::string_view source = kSourceNames.name(line.source);
    if (source.empty()) continue;

    const bool of_team = line.source != gamelog::RclSource::kTrainer;
    gamelog::CommandCursor cursor(text.text_of(line));
    for (gamelog::LoggedCommand command; cursor.next(command);) {
      table.add(line.time);
      table.add(line.stopped);
      table.add(source);
      table.add(of_team ? std::string_view(text.teams.at(line.team)) : std::string_view());
      add_known(line.source == gamelog::RclSource::kPlayer, line.unum, table);
      table.add(name(command.kind));
      table.add(command.arguments);
    }
  }
  table.close();
}

}  // namespace cls::analysis
