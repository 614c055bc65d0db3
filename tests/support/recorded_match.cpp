// Putting a match together from its two logs.
#include "tests/support/recorded_match.h"

#include <stdexcept>
#include <string_view>

#include "soccer/protocol/parameter_message.h"
#include "soccer/protocol/scanner.h"
#include "tests/support/files.h"
#include "tests/support/rcg_lines.h"

namespace cls::tests {
namespace {

using gamelog::Frame;
using soccer::Side;

template <typename Params>
void read_params(std::string_view line, Params& params) {
  const auto read = soccer::parse(line, params);
  if (!read) throw std::runtime_error(read.error().message);
}

void read_rcg(const std::filesystem::path& path, RecordedMatch& match) {
  const std::string text = read_file(path);
  for (Frame& frame : read_frames(text)) {
    const bool same_time = !match.shows.empty() && match.shows.back().frame.time == frame.time;
    const int stoppage = same_time ? match.shows.back().stoppage + 1 : 0;
    match.shows.push_back({std::move(frame), stoppage});
  }
  for (const std::string_view line : split_lines(text)) {
    if (line.starts_with("(server_param ")) read_params(line, match.server);
    if (line.starts_with("(player_param ")) read_params(line, match.player);
    if (line.starts_with("(player_type ")) read_params(line, match.types.emplace_back());
  }
}

Side side_of_team(const RecordedMatch& match, std::string_view team) {
  const gamelog::TeamFrames& teams = match.shows.front().frame.teams;
  if (team == teams[0].name) return Side::kLeft;
  if (team == teams[1].name) return Side::kRight;
  return Side::kNeutral;
}

// "Recv TEAM_7: (dash 100)", "Recv TEAM_Coach: ..."; other senders have no part in the game.
void read_received(std::string_view text, const RecordedMatch& match,
                   std::vector<RecordedMatch::Line>& out) {
  text.remove_prefix(std::string_view("Recv ").size());
  const std::size_t colon = text.find(": ");
  const std::string_view sender = text.substr(0, colon);
  const std::size_t underline = sender.rfind('_');
  if (colon == std::string_view::npos || underline == std::string_view::npos) return;
  const Side side = side_of_team(match, sender.substr(0, underline));
  if (side == Side::kNeutral) return;
  const std::string_view number = sender.substr(underline + 1);
  const int unum = number == "Coach" ? 0 : soccer::int_from_text(number).value_or(-1);
  if (unum < 0 || unum > soccer::kPlayersPerTeam) return;
  out.push_back(RecordedMatch::Received{side, unum, std::string(text.substr(colon + 2))});
}

void read_rcl(const std::filesystem::path& path, RecordedMatch& match) {
  constexpr std::string_view kReferee = "(referee ";
  const std::string text = read_file(path);
  for (const std::string_view line : split_lines(text)) {
    soccer::Scanner in(line);
    int time = 0;
    int stoppage = 0;
    if (!in.integer(time) || !in.literal(",") || !in.integer(stoppage) || !in.literal("\t")) {
      continue;
    }
    const std::string_view rest = in.rest();
    std::vector<RecordedMatch::Line>& lines = match.lines[{time, stoppage}];
    if (rest.starts_with(kReferee)) {
      lines.push_back(RecordedMatch::Called{
          std::string(rest.substr(kReferee.size(), rest.size() - kReferee.size() - 1))});
    } else if (rest.starts_with("Recv ")) {
      read_received(rest, match, lines);
    }
  }
}

}  // namespace

RecordedMatch read_recorded_match(const std::filesystem::path& rcg,
                                  const std::filesystem::path& rcl) {
  RecordedMatch match;
  read_rcg(rcg, match);
  if (match.shows.empty()) throw std::runtime_error("no frames in " + rcg.string());
  read_rcl(rcl, match);
  return match;
}

}  // namespace cls::tests
