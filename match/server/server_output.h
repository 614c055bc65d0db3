// Parser of the output of a soccer server: version, seed, connections, end of the match.
#pragma once

#include <cstdint>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "soccer/per_side.h"

namespace cls::match {

/// A team as the server reports it.
struct ReportedConnections {
  std::string name;
  std::set<int> players{};  ///< uniform numbers that connected
  bool coach = false;
  std::vector<int> disconnected{};  ///< uniform numbers, in the order of time
};

/// Begins a line of `cls server` in a match: the seconds that it has waited for left and right.
inline constexpr std::string_view kAwaitedLine = "Waited for sides (s): ";

/// The reports of a soccer server so far.
struct ServerStatus {
  std::string version;                     ///< "19.0.0"
  std::optional<std::uint64_t> seed;       ///< drawn by the server
  std::vector<ReportedConnections> teams;  ///< in the order of their first player: left, right
  std::int64_t missed_cycles = 0;          ///< cycles without a reply of some client
  std::int64_t connections = 0;            ///< of all clients, in all
  std::optional<soccer::PerSide<double>> awaited_s;  ///< how long it has waited for each side
  std::vector<std::string> intrusions;  ///< requests of clients that belong to another side
  bool gave_up = false;                 ///< clients stopped responding
  bool game_over = false;               ///< it exited because the match was over
  std::string first_error;              ///< the first line that looks like an error

  const ReportedConnections* team(std::string_view name) const;
};

/// Reads the lines of rcssserver (docs/spec/server-protocol.md 7.4), and those of `cls server`,
/// which are fewer. read_line() and status() may be called on different threads.
class ServerOutput {
 public:
  void read_line(std::string_view line);
  ServerStatus status() const;

 private:
  ReportedConnections& team(std::string_view name);
  bool read_connection(std::string_view line);
  bool read_start(std::string_view line);

  mutable std::mutex mutex_;
  ServerStatus status_;
};

}  // namespace cls::match
