// What a soccer server prints about the match: version, seed, who joined, how it ended.
#pragma once

#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace cls::orchestration::match {

/// A team as the server's lines tell it.
struct AnnouncedTeam {
  std::string name;
  std::set<int> players;  ///< uniform numbers that joined
  bool coach = false;
  std::vector<int> departed;  ///< uniform numbers that left, in order
};

/// Everything learned so far; a copy of it can be looked at while lines come in.
struct ServerNews {
  std::string version;                ///< "19.0.0"
  std::optional<std::uint64_t> seed;  ///< that it drew
  std::vector<AnnouncedTeam> teams;   ///< in the order of their first player: left, right
  std::int64_t missed_cycles = 0;     ///< cycles in which some client did not answer
  bool gave_up = false;               ///< clients did not answer for too long
  bool game_over = false;             ///< it ended because the match was over
  std::string complaint;              ///< the first line that looks like an error

  const AnnouncedTeam* team(std::string_view name) const;
};

/// Reads the lines of rcssserver (server protocol 7.4), and those of `cls server`, which are fewer.
/// Lines come in on one thread, questions on others.
class ServerOutput {
 public:
  void read_line(std::string_view line);
  ServerNews news() const;

 private:
  AnnouncedTeam& team(std::string_view name);
  bool read_connection(std::string_view line);
  bool read_start(std::string_view line);

  mutable std::mutex mutex_;
  ServerNews news_;
};

}  // namespace cls::orchestration::match
