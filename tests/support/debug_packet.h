// A strict parser of packets for soccerwindow2's debug server (docs/formats/debug-view.md).
#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace cls::tests {

struct DebugPacket {
  int cycle = 0;
  int stopped = 0;
  char side = ' ';  ///< of the player
  int unum = 0;
  std::map<std::string, std::vector<std::string>> items;  ///< by name, as written
  std::string error;  ///< the text that is no item of the format; empty: all is
};

DebugPacket parse_debug_packet(std::string_view text);

/// The packets of a *.dcl file; a line that has another form is a packet with an error.
std::vector<DebugPacket> parse_debug_file(const std::string& text);

}  // namespace cls::tests
