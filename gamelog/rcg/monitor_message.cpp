// Selects the format by version and formats the text versions.
#include "gamelog/rcg/monitor_message.h"

#include "gamelog/rcg/binary_writer.h"
#include "gamelog/rcg/rcg_json_text.h"
#include "gamelog/rcg/rcg_text.h"
#include "soccer/messages/parameter_message.h"
#include "soccer/parameters/parameter.h"
#include "soccer/protocol/text_writer.h"

namespace cls::gamelog {
namespace {

using soccer::append;

// Shows sent to monitors have the layout of logs one version higher.
RcgVersion log_version(MonitorVersion version) {
  if (version == MonitorVersion::k3) return RcgVersion::kV4;
  return version == MonitorVersion::k4 ? RcgVersion::kV5 : RcgVersion::kV6;
}

}  // namespace

template <typename Params>
void append_monitor_parameters(MonitorVersion version, const Params& params, std::string& out) {
  if (is_binary(version)) return append_binary_parameters(params, out);
  if (version != MonitorVersion::kJson) return soccer::format(params, soccer::kAllVersions, out);

  std::string line;
  soccer::format(params, soccer::kAllVersions, line);
  append_json_parameters(line, out);
}

template void append_monitor_parameters(MonitorVersion, const soccer::ServerParams&, std::string&);
template void append_monitor_parameters(MonitorVersion, const soccer::PlayerParams&, std::string&);
template void append_monitor_parameters(MonitorVersion, const soccer::PlayerType&, std::string&);

void append_monitor_show(MonitorVersion version, const Frame& frame, std::string& out) {
  if (version == MonitorVersion::kJson) return append_json_show(frame, out, JsonShow::kMonitor);
  if (version == MonitorVersion::k1) return append_short_show(frame, out);
  if (version == MonitorVersion::k2) return append_long_show(frame, out);

  append(out, "(show ", frame.time, " (pm ", static_cast<int>(frame.mode), ") (tm");
  append_team_state(frame.teams, out);
  out += ')';
  append_objects(frame, out, log_version(version));
  out += ')';
}

void append_monitor_text(MonitorVersion version, int time, int stopped, int board,
                         std::string_view text, std::string& out) {
  if (version == MonitorVersion::kJson) {
    return append_json_message(time, stopped, {board, std::string(text)}, out);
  }

  if (is_binary(version)) return append_binary_text(static_cast<int>(version), board, text, out);

  append(out, "(msg ", time, ' ', board, " \"", text, "\")");
}

}  // namespace cls::gamelog
