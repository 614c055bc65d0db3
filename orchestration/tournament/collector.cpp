// Result files in and out.
#include "orchestration/tournament/collector.h"

#include <fmt/format.h>

#include <charconv>
#include <map>
#include <thread>

#include "orchestration/tournament/folder.h"
#include "orchestration/tournament/match_attempt.h"
#include "orchestration/tournament/match_document.h"
#include "orchestration/whole_file.h"

namespace cls::orchestration {
namespace {

namespace fs = std::filesystem;
using soccer::Error;
using soccer::Result;

// {17, 2} for "000017.2.json".
std::optional<std::pair<int, int>> numbers_in(const std::string& name) {
  const std::size_t dot = name.find('.');
  if (!name.ends_with(".json") || dot == std::string::npos) return std::nullopt;
  int index = 0;
  int attempt = 0;
  const char* text = name.data();
  const auto first = std::from_chars(text, text + dot, index);
  const auto second = std::from_chars(text + dot + 1, text + name.size(), attempt);
  if (first.ptr != text + dot || second.ec != std::errc{}) return std::nullopt;
  return std::pair(index, attempt);
}

std::optional<DeliveredOutcome> read_delivery(const fs::path& file) {
  const auto text = read_file(file);
  if (!text) return std::nullopt;
  auto read = outcome_from_document(*text);
  if (!read) return std::nullopt;
  return *std::move(read);
}

}  // namespace

std::vector<Delivery> collect_results(const fs::path& folder,
                                      std::span<const ScheduledMatch> matches) {
  std::map<int, int> latest;
  std::error_code code;
  for (const auto& entry : fs::directory_iterator(folder / kResultsFolder, code)) {
    const auto numbers = numbers_in(entry.path().filename().string());
    if (numbers) latest[numbers->first] = std::max(latest[numbers->first], numbers->second);
  }
  std::vector<Delivery> deliveries;
  for (const auto& [index, attempt] : latest) {
    if (index < 1 || index > static_cast<int>(matches.size())) continue;
    const ScheduledMatch& match = matches[static_cast<std::size_t>(index) - 1];
    if (match.outcome || attempt <= match.settled) continue;
    auto delivered = read_delivery(folder / result_file(index, attempt));
    if (!delivered || delivered->seed != match.fixture.seed) continue;
    deliveries.push_back({index, std::move(delivered->outcome)});
  }
  return deliveries;
}

Result<std::optional<Outcome>> work(const fs::path& folder, int index, int attempt,
                                    const fs::path& program, const std::atomic<int>& stop_signal) {
  constexpr std::chrono::milliseconds kLook{5};
  if (auto delivered = read_delivery(folder / result_file(index, attempt))) {
    return std::optional<Outcome>(std::move(delivered->outcome));
  }
  const auto config = read_plan(folder);
  if (!config) return config.error();
  const auto fixture = read_fixture(folder, index);
  if (!fixture) return fixture.error();
  auto host = ProcessHost::create();
  if (!host) return host.error();
  auto played = MatchAttempt::start(*host, *config, *fixture, attempt, folder, program);
  if (!played) return played.error();
  while (!played->ended()) {
    std::this_thread::sleep_for(kLook);
    played->enforce_limit();
    if (stop_signal != 0) played->interrupt();
  }
  auto outcome = played->outcome();
  if (!outcome || !*outcome) return outcome;
  const bool keep = keeps_folder(*config, **outcome);
  if (!keep) (*outcome)->folder.clear();
  std::error_code code;
  fs::create_directories(folder / kResultsFolder, code);
  const auto written =
      write_file(folder / result_file(index, attempt), outcome_document(*fixture, **outcome));
  if (!written) return written.error();
  if (!keep) fs::remove_all(folder / match_folder(*config, *fixture, attempt), code);
  return outcome;
}

}  // namespace cls::orchestration
