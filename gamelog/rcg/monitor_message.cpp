// Selects the format by version and formats the text versions.
#include "gamelog/rcg/monitor_message.h"

#include "base/text/number_text.h"
#include "gamelog/rcg/binary_writer.h"
#include "gamelog/rcg/rcg_json_text.h"
#include "gamelog/rcg/rcg_text.h"
#include "soccer/messages/parameter_message.h"
#include "soccer/parameters/parameter.h"

namespace cls::gamelog {
namespace {

using base::append_int;

// Shows sent to monitors have the layout of logs one version higher.
RcgVersion log_version(MonitorVersion version) {
  if (version == MonitorVersion::k3) return RcgVersion::kV4;
  return version == MonitorVersion::k4 ? RcgVersion::kV5 : RcgVersion::kV6;
}

void append_score(const TeamFrames& teams, std::string& out) {
  out += " (tm";
  for (const TeamFrame& team : teams) {
    out += ' ';
    out += team.name.empty() ? std::string_view("null") : std::string_view(team.name);
  }

  const auto append = [&out](int value) {
    out += ' ';
    append_int(value, out);
  };

  for (const TeamFrame& team : teams) append(team.score);
  if (teams[0].penalties_taken() > 0 || teams[1].penalties_taken() > 0) {
    for (const TeamFrame& team : teams) {
      append(team.penalty_scored);
      append(team.penalty_missed);
    }
  }

  out += ')';
}

template <typename Params>
void append_parameters(MonitorVersion version, const Params& params, std::string& out) {
  if (is_binary(version)) return append_binary_parameters(params, out);
  if (version != MonitorVersion::kJson) return soccer::format(params, soccer::kAllVersions, out);

  std::string line;
  soccer::format(params, soccer::kAllVersions, line);
  append_json_parameters(line, out);
}

}  // namespace

void append_monitor_parameters(MonitorVersion version, const soccer::ServerParams& params,
                               std::string& out) {
  append_parameters(version, params, out);
}

void append_monitor_parameters(MonitorVersion version, const soccer::PlayerParams& params,
                               std::string& out) {
  append_parameters(version, params, out);
}

void append_monitor_parameters(MonitorVersion version, const soccer::PlayerType& type,
                               std::string& out) {
  append_parameters(version, type, out);
}

void append_monitor_show(MonitorVersion version, const Frame& frame, std::string& out) {
  if (version == MonitorVersion::kJson) return append_json_show(frame, out, JsonShow::kMonitor);
  if (version == MonitorVersion::k1) return append_short_show(frame, out);
  if (version == MonitorVersion::k2) return append_long_show(frame, out);

  out += "(show ";
  append_int(frame.time, out);
  out += " (pm ";
  append_int(static_cast<int>(frame.mode), out);
  out += ')';

  append_score(frame.teams, out);
  append_objects(frame, out, log_version(version));
  out += ')';
}

void append_monitor_text(MonitorVersion version, int time, int stopped, int board,
                         std::string_view text, std::string& out) {
  if (version == MonitorVersion::kJson) {
    Message message;
    message.board = board;
    message.text = text;
    return append_json_message(time, stopped, message, out);
  }

  if (is_binary(version)) return append_binary_text(static_cast<int>(version), board, text, out);

  out += "(msg ";
  append_int(time, out);
  out += ' ';
  append_int(board, out);
  out += " \"";
  out += text;
  out += "\")";
}

}  // namespace cls::gamelog
