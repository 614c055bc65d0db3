// The server's lines by their beginnings.
#include "orchestration/match/server/server_output.h"

#include <algorithm>
#include <charconv>

namespace cls::orchestration::match {
namespace {

bool contains(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

template <typename Number>
std::optional<Number> number_at_start(std::string_view text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{}) return std::nullopt;
  return value;
}

// What stands in the last brackets: "TEAM 7" or "TEAM".
std::string_view in_brackets(std::string_view line) {
  const std::size_t open = line.rfind('(');
  const std::size_t close = line.rfind(')');
  if (open == std::string_view::npos || close == std::string_view::npos || close < open) return {};
  return line.substr(open + 1, close - open - 1);
}

}  // namespace

const AnnouncedTeam* ServerNews::team(std::string_view name) const {
  const auto found =
      std::find_if(teams.begin(), teams.end(), [&](const auto& team) { return team.name == name; });
  return found == teams.end() ? nullptr : &*found;
}

AnnouncedTeam& ServerOutput::team(std::string_view name) {
  for (AnnouncedTeam& known : news_.teams) {
    if (known.name == name) return known;
  }
  news_.teams.push_back({std::string(name), {}, false, {}});
  return news_.teams.back();
}

bool ServerOutput::read_connection(std::string_view line) {
  const std::string_view who = in_brackets(line);
  if (who.empty()) return false;
  if (contains(line, " online coach (") && contains(line, "connected")) {
    team(who).coach = true;
    return true;
  }
  const std::size_t blank = who.rfind(' ');
  if (blank == std::string_view::npos || !contains(line, " player ")) return false;
  const auto unum = number_at_start<int>(who.substr(blank + 1));
  if (!unum) return false;
  AnnouncedTeam& known = team(who.substr(0, blank));
  if (contains(line, "disconnected")) {
    known.departed.push_back(*unum);
  } else if (contains(line, "connected")) {
    known.players.insert(*unum);
  } else {
    return false;
  }
  return true;
}

bool ServerOutput::read_start(std::string_view line) {
  constexpr std::string_view kVersion = "rcssserver-";
  constexpr std::string_view kSeed = "Simulator Random Seed: ";
  if (line.starts_with(kVersion) && news_.version.empty()) {
    news_.version = line.substr(kVersion.size());
  } else if (line.starts_with(kSeed)) {
    news_.seed = number_at_start<std::uint64_t>(line.substr(kSeed.size()));
  } else {
    return false;
  }
  return true;
}

void ServerOutput::read_line(std::string_view line) {
  const std::lock_guard lock(mutex_);
  if (read_start(line) || read_connection(line)) return;
  if (line.starts_with("Someone missed a cycle")) {
    ++news_.missed_cycles;
  } else if (line.starts_with("Waiting too long for clients")) {
    news_.gave_up = true;
  } else if (line.starts_with("Game Over")) {
    news_.game_over = true;
  } else if (news_.complaint.empty() && (contains(line, "rror") || contains(line, "ailed"))) {
    news_.complaint = line;
  }
}

ServerNews ServerOutput::news() const {
  const std::lock_guard lock(mutex_);
  return news_;
}

}  // namespace cls::orchestration::match
