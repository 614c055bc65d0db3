// Selects the records of a game log and their format.
#include "gamelog/rcg/rcg_writer.h"

#include <utility>

#include "gamelog/rcg/binary_writer.h"
#include "gamelog/rcg/rcg_json_text.h"
#include "gamelog/rcg/rcg_text.h"
#include "gamelog/record/match_record.h"
#include "soccer/messages/parameter_message.h"
#include "soccer/protocol/text_writer.h"

namespace cls::gamelog {
namespace {

using soccer::PlayMode;

constexpr int kMessageBoard = 1;
constexpr std::string_view kServerVersion = "19.0.0";  // the emulated version
constexpr std::string_view kNextElement = ",\n";

// In JSON logs every parameter message is an element.
template <typename Parameters>
void append_json_element(const Parameters& parameters, std::string& out) {
  std::string line;
  soccer::format(parameters, soccer::kAllVersions, line);

  out += kNextElement;
  append_json_parameters(line, out);
}

void append_json_header(const soccer::ServerParams& server, const soccer::PlayerParams& player,
                        const std::vector<soccer::PlayerType>& types, const LogDate& date,
                        std::string& out) {
  out += "[\n";
  append_json_text("version", kServerVersion, out);
  out += kNextElement;
  append_json_text("timestamp", date.second, out);

  append_json_element(server, out);
  append_json_element(player, out);
  for (const soccer::PlayerType& type : types) append_json_element(type, out);
}

void append_team_result(const TeamFrame& team, bool with_penalties, std::string& out) {
  if (team.name.empty()) {
    out += "null";
    return;
  }

  soccer::append(out, team.name, '_', team.score);
  if (with_penalties) soccer::append(out, '_', team.penalty_scored);
}

}  // namespace

std::string match_name(const TeamFrames& teams) {
  const bool with_penalties = teams[0].score == teams[1].score && teams[0].penalties_taken() > 0 &&
                              teams[1].penalties_taken() > 0;

  std::string name;
  append_team_result(teams[0], with_penalties, name);
  name += "-vs-";
  append_team_result(teams[1], with_penalties, name);
  return name;
}

soccer::ServerParams without_local_paths(const soccer::ServerParams& params) {
  const soccer::ServerParams defaults;
  soccer::ServerParams result = params;

  for (const auto member :
       {&soccer::ServerParams::game_log_dir, &soccer::ServerParams::game_log_fixed_name,
        &soccer::ServerParams::text_log_dir, &soccer::ServerParams::text_log_fixed_name,
        &soccer::ServerParams::keepaway_log_dir, &soccer::ServerParams::keepaway_log_fixed_name,
        &soccer::ServerParams::landmark_file, &soccer::ServerParams::coach_msg_file,
        &soccer::ServerParams::team_l_start, &soccer::ServerParams::team_r_start}) {
    result.*member = defaults.*member;
  }

  return result;
}

std::optional<RcgVersion> rcg_version(int game_log_version) {
  if (game_log_version == -1) return RcgVersion::kJson;
  if (game_log_version < 1 || game_log_version > 6) return std::nullopt;
  return static_cast<RcgVersion>(game_log_version);
}

RcgWriter::RcgWriter(base::ByteSink& sink, RcgVersion version, LogDate date)
    : sink_(sink), version_(version), date_(std::move(date)) {}

void RcgWriter::write_header(const soccer::ServerParams& server, const soccer::PlayerParams& player,
                             const std::vector<soccer::PlayerType>& types) {
  const soccer::ServerParams shown = without_local_paths(server);

  if (is_binary()) {
    append_binary_header(version_, shown, player, types, line_);
  } else if (version_ == RcgVersion::kJson) {
    append_json_header(shown, player, types, date_, line_);
  } else {
    append_header(version_, shown, player, types, line_);
  }

  flush();
}

void RcgWriter::write_step(const Frame& frame) {
  if (frame.mode == PlayMode::kBeforeKickOff) return;
  if (frame.mode == PlayMode::kTimeOver && written_mode_ == PlayMode::kTimeOver) return;

  if (frame.mode != written_mode_) {
    add_play_mode(frame);
    written_mode_ = frame.mode;
  }

  if (!team_written_ || frame.teams != written_teams_) {
    add_teams(frame);
    written_teams_ = frame.teams;
    team_written_ = true;
  }

  add_show(frame);
  flush();
}

void RcgWriter::write_message(Stamp stamp, int board, std::string_view text) {
  if (is_binary()) {
    append_binary_message(version_, board, text, line_);
  } else if (version_ == RcgVersion::kJson) {
    line_ += kNextElement;
    append_json_message(stamp.time, stamp.stopped, {board, std::string(text)}, line_);
  } else {
    append_message(stamp.time, board, text, line_);
  }

  flush();
}

void RcgWriter::write_end(const Frame& last) {
  write_message({last.time, last.stopped}, kMessageBoard,
                "(result " + date_.minute + ' ' + match_name(last.teams) + ')');

  if (is_binary()) return;
  add_teams(last);
  if (version_ == RcgVersion::kJson) line_ += "\n]\n";
  flush();
}

void RcgWriter::add_play_mode(const Frame& frame) {
  if (is_binary()) return append_binary_play_mode(version_, frame.mode, line_);
  if (version_ != RcgVersion::kJson) return append_play_mode(frame.time, frame.mode, line_);

  line_ += kNextElement;
  append_json_play_mode(frame.time, frame.stopped, frame.mode, line_);
}

void RcgWriter::add_teams(const Frame& frame) {
  if (is_binary()) return append_binary_teams(version_, frame.teams, line_);
  if (version_ != RcgVersion::kJson) return append_team(frame.time, frame.teams, line_);

  line_ += kNextElement;
  append_json_team(frame.time, frame.stopped, frame.teams, line_);
}

void RcgWriter::add_show(const Frame& frame) {
  if (is_binary()) return append_binary_show(version_, frame, line_);
  if (version_ != RcgVersion::kJson) return append_show(frame, line_, version_);

  line_ += kNextElement;
  append_json_show(frame, line_);
}

void RcgWriter::flush() {
  sink_.write(line_);
  line_.clear();
}

}  // namespace cls::gamelog
