// Shows are parts of what monitors of versions 1 and 2 are sent.
#include "gamelog/rcg/rcg_binary_records.h"

#include "gamelog/rcg/binary_params.h"
#include "gamelog/rcg/monitor_binary.h"
#include "gamelog/rcg/rcg_binary_layout.h"

namespace cls::gamelog {
namespace {

using namespace rcg_binary;

constexpr std::size_t kLongObjects = 44;  // where they begin in what monitors get
constexpr std::size_t kLongestMessage = 2048;

void append_team(const TeamFrame& team, std::string& out) {
  std::string name = team.name;
  name.resize(kNameSize, '\0');
  out += name;
  write_int16(team.score, out);
}

}  // namespace

void append_binary_header(RcgVersion version, const soccer::ServerParams& server,
                          const soccer::PlayerParams& player,
                          const std::vector<soccer::PlayerType>& types, std::string& out) {
  if (version == RcgVersion::kV1) return;
  out += "ULG";
  out += static_cast<char>(version);
  if (version == RcgVersion::kV2) return;
  write_int16(kServerParam, out);
  write_server_params(server, out);
  write_int16(kPlayerParam, out);
  write_player_params(player, out);
  for (const soccer::PlayerType& type : types) {
    write_int16(kType, out);
    write_player_type(type, out);
  }
}

void append_binary_play_mode(RcgVersion version, soccer::PlayMode mode, std::string& out) {
  if (version != RcgVersion::kV3) return;
  write_int16(kMode, out);
  out += static_cast<char>(mode);
}

void append_binary_teams(RcgVersion version, const TeamFrames& teams, std::string& out) {
  if (version != RcgVersion::kV3) return;
  write_int16(kTeams, out);
  for (const TeamFrame& team : teams) append_team(team, out);
}

void append_binary_show(RcgVersion version, const Frame& frame, std::string& out) {
  if (version == RcgVersion::kV1) return append_short_show(frame, out);
  const std::size_t start = out.size();
  if (version == RcgVersion::kV2) {
    append_short_show(frame, out);
    out.resize(start + kKindSize + kShortShowSize);
    return;
  }
  append_long_show(frame, out);
  out.erase(start + kKindSize, kLongObjects - kKindSize);
  out.resize(start + kKindSize + kLongShowSize);
}

void append_binary_message(RcgVersion version, int board, std::string_view text, std::string& out) {
  if (version == RcgVersion::kV1) return append_binary_text(MonitorVersion::k1, board, text, out);
  text = text.substr(0, kLongestMessage);
  if (text.empty()) text = std::string_view("\0", 1);
  write_int16(kMessage, out);
  write_int16(board, out);
  write_int16(static_cast<int>(text.size()), out);
  out += text;
}

}  // namespace cls::gamelog
