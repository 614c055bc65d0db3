// Recognizes output lines by their beginnings.
#include "match/server/server_output.h"

#include <algorithm>

#include "base/text/value_text.h"
#include "match/server/client_binding.h"

namespace cls::match {
namespace {

bool contains(std::string_view text, std::string_view part) {
  return text.find(part) != std::string_view::npos;
}

// The number of the word at the start.
template <typename Number>
std::optional<Number> number_at_start(std::string_view text) {
  constexpr std::string_view kNumber = "+-.0123456789e";
  return base::value_of<Number>(text.substr(0, text.find_first_not_of(kNumber)));
}

// The text in the last parentheses: "TEAM 7" or "TEAM".
std::string_view in_parentheses(std::string_view line) {
  const std::size_t open = line.rfind('(');
  const std::size_t close = line.rfind(')');
  if (open == std::string_view::npos || close == std::string_view::npos || close < open) return {};
  return line.substr(open + 1, close - open - 1);
}

}  // namespace

const ReportedConnections* ServerStatus::team(std::string_view name) const {
  const auto found = std::ranges::find(teams, name, &ReportedConnections::name);
  return found == teams.end() ? nullptr : &*found;
}

ReportedConnections& ServerOutput::team(std::string_view name) {
  const auto known = std::ranges::find(status_.teams, name, &ReportedConnections::name);
  if (known != status_.teams.end()) return *known;
  return status_.teams.emplace_back(ReportedConnections{.name = std::string(name)});
}

bool ServerOutput::read_connection(std::string_view line) {
  const std::string_view who = in_parentheses(line);
  if (who.empty()) return false;
  if (contains(line, " online coach (") && contains(line, "connected")) {
    team(who).coach = true;
    return true;
  }

  const std::size_t space = who.rfind(' ');
  if (space == std::string_view::npos || !contains(line, " player ")) return false;
  const auto unum = number_at_start<int>(who.substr(space + 1));
  if (!unum) return false;

  ReportedConnections& known = team(who.substr(0, space));
  if (contains(line, "disconnected")) {
    known.disconnected.push_back(*unum);
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
  if (line.starts_with(kVersion) && status_.version.empty()) {
    status_.version = line.substr(kVersion.size());
  } else if (line.starts_with(kSeed)) {
    status_.seed = number_at_start<std::uint64_t>(line.substr(kSeed.size()));
  } else {
    return false;
  }
  return true;
}

void ServerOutput::read_line(std::string_view line) {
  const std::lock_guard lock(mutex_);
  if (contains(line, "connected")) ++status_.connections;
  if (!line.starts_with(kIntrusionLine) && (read_start(line) || read_connection(line))) return;

  if (line.starts_with(kIntrusionLine)) {
    status_.intrusions.emplace_back(line.substr(kIntrusionLine.size()));
  } else if (line.starts_with(kAwaitedLine)) {
    const std::string_view numbers = line.substr(kAwaitedLine.size());
    const auto left = number_at_start<double>(numbers);
    const auto right = number_at_start<double>(numbers.substr(numbers.find(' ') + 1));
    if (left && right) status_.awaited_s = soccer::PerSide<double>{*left, *right};
  } else if (line.starts_with("Someone missed a cycle")) {
    ++status_.missed_cycles;
  } else if (line.starts_with("Waiting too long for clients")) {
    status_.gave_up = true;
  } else if (line.starts_with("Game Over")) {
    status_.game_over = true;
  } else if (status_.first_error.empty() && (contains(line, "rror") || contains(line, "ailed"))) {
    status_.first_error = line;
  }
}

ServerStatus ServerOutput::status() const {
  const std::lock_guard lock(mutex_);
  return status_;
}

}  // namespace cls::match
