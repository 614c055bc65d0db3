// Sums over the players of a side, and a look into the logs of its programs.
#include "match/result/late_warnings.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <string_view>
#include <utility>

#include "base/io/whole_file.h"
#include "process/printed_exception.h"
#include "proxy/actions/failure_reasons.h"

namespace cls::match {
namespace {

constexpr std::size_t kManyRepetitions = 100;
// A team that stands still for a while is not worth a warning.
constexpr std::int64_t kMinReplies = 50;

// "; most often failed: body_hold_ball (ball not kickable)"; empty when nothing failed.
std::string most_failed(const TeamResult& team) {
  std::map<std::string, std::int64_t> failed;
  for (const PlayerResult& player : team.players) {
    for (const auto& [action, outcomes] : player.actions) {
      const auto found = outcomes.find("failed");
      if (found != outcomes.end()) failed[action] += found->second;
    }
  }

  const auto most =
      std::ranges::max_element(failed, {}, [](const auto& one) { return one.second; });
  if (most == failed.end()) return {};
  const std::string_view reason = proxy::fails_when(most->first);
  return fmt::format("; most often failed: {}{}", most->first,
                     reason.empty() ? "" : fmt::format(" ({})", reason));
}

}  // namespace

std::vector<std::string> action_warnings(const TeamResult& team) {
  const ReplySummary sum = reply_summary(team);
  if (sum.lists < kMinReplies || 2 * sum.useless < sum.lists) return {};
  return {fmt::format("{}: {} of {} replies had no executable action ({} were empty){}", team.name,
                      sum.useless, sum.lists, sum.empty, most_failed(team))};
}

std::vector<std::string> missed_cycle_warnings(const MatchResult& result) {
  if (result.server_missed_cycles == 0) return {};
  return {fmt::format(
      "the soccer server did not wait for all clients in {} of {} cycles: a slow program "
      "or a busy host; those players did nothing",
      result.server_missed_cycles, result.cycles)};
}

bool is_reported(const MatchResult& result, const std::string& exception) {
  const auto reports = [&exception](const TeamResult& team) {
    return team.errors.first && team.errors.first->message.find(exception) != std::string::npos;
  };
  return reports(result.left) || reports(result.right);
}

std::string remedy_of(const std::string& exception) {
  constexpr std::pair<std::string_view, std::string_view> kRemedies[] = {
      {"No module named 'cls_",
       "./bootstrap python in the checkout of cls makes an environment that has it, and "
       ". .venv/bin/activate there uses it; pip install ./python adds it to another one"},
      {"No module named 'grpc", "install grpcio: pip install grpcio, on Debian python3-grpcio"},
      {"No module named 'google",
       "install protobuf: pip install protobuf, on Debian python3-protobuf"},
      {"No module named 'numpy", "install NumPy: pip install numpy, on Debian python3-numpy"},
      {"Cannot find module '@grpc/", "./run build in the folder of the project installs it"}};
  for (const auto& [text, remedy] : kRemedies) {
    if (exception.find(text) != std::string::npos) return std::string(remedy);
  }
  return {};
}

std::vector<std::string> output_warnings(MatchResult& result, const std::filesystem::path& folder) {
  std::vector<std::string> warnings;
  for (ProcessResult& process : result.processes) {
    if (process.log.empty()) continue;
    if (!process.log_error.empty()) {
      warnings.push_back(
          fmt::format("{}: {}; the log is incomplete", process.name, process.log_error));
    }

    const auto log = base::read_file(folder / process.log);
    if (!log) continue;

    process.exception = process::printed_exception(*log);
    if (!process.exception.empty() && !is_reported(result, process.exception)) {
      warnings.push_back(fmt::format("{} printed an exception: {}; its output is in {}",
                                     process.name, process.exception,
                                     (folder / process.log).string()));
    }

    const process::RepeatedLine line = process::most_repeated_line(*log);
    if (line.times >= kManyRepetitions) {
      warnings.push_back(fmt::format("{} printed a line {} times in a row ({}): {}", process.name,
                                     line.times, process.log, line.text));
    }
  }
  return warnings;
}

}  // namespace cls::match
