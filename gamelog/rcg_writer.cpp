// The rules by which a game log gets its lines.
#include "gamelog/rcg_writer.h"

#include "gamelog/rcg_text.h"
#include "soccer/protocol/number_text.h"

namespace cls::gamelog {
namespace {

using soccer::PlayMode;

constexpr std::string_view kNoDate = "197001010000";
constexpr int kMessageBoard = 1;

void append_team_result(const TeamFrame& team, bool with_penalties, std::string& out) {
  if (team.name.empty()) {
    out += "null";
    return;
  }
  out += team.name;
  out += '_';
  soccer::append_int(team.score, out);
  if (with_penalties) {
    out += '_';
    soccer::append_int(team.penalty_scored, out);
  }
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

soccer::ServerParams without_places(const soccer::ServerParams& params) {
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

void RcgWriter::begin(const soccer::ServerParams& server, const soccer::PlayerParams& player,
                      const std::vector<soccer::PlayerType>& types) {
  line_.clear();
  append_header(without_places(server), player, types, line_);
  sink_.write(line_);
}

void RcgWriter::step(const Frame& frame) {
  if (frame.mode == PlayMode::kBeforeKickOff) return;
  if (frame.mode == PlayMode::kTimeOver && written_mode_ == PlayMode::kTimeOver) return;
  line_.clear();
  if (frame.mode != written_mode_) {
    append_play_mode(frame.time, frame.mode, line_);
    written_mode_ = frame.mode;
  }
  if (!team_written_ || frame.teams != written_teams_) {
    append_team(frame.time, frame.teams, line_);
    written_teams_ = frame.teams;
    team_written_ = true;
  }
  append_show(frame, line_);
  sink_.write(line_);
}

void RcgWriter::message(int time, int board, std::string_view text) {
  line_.clear();
  append_message(time, board, text, line_);
  sink_.write(line_);
}

void RcgWriter::end(int time, const TeamFrames& teams) {
  std::string result = "(result ";
  result += kNoDate;
  result += ' ';
  result += match_name(teams);
  result += ')';
  message(time, kMessageBoard, result);
  line_.clear();
  append_team(time, teams, line_);
  sink_.write(line_);
}

}  // namespace cls::gamelog
