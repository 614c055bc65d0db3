// Result files in and out.
#include "orchestration/tournament/store/collector.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <charconv>
#include <map>
#include <thread>

#include "base/io/whole_file.h"
#include "base/system/host.h"
#include "orchestration/tournament/store/folder.h"
#include "orchestration/tournament/store/match_attempt.h"
#include "orchestration/tournament/store/match_document.h"

namespace cls::orchestration::tournament {
namespace {

namespace fs = std::filesystem;
using base::Error;
using base::Result;

// {17, 2} for "000017.2.json".
std::optional<ResultName> numbers_in(const std::string& name) {
  const std::size_t dot = name.find('.');
  if (!name.ends_with(".json") || dot == std::string::npos) return std::nullopt;
  ResultName numbers;
  const char* text = name.data();
  const auto first = std::from_chars(text, text + dot, numbers.index);
  const auto second = std::from_chars(text + dot + 1, text + name.size(), numbers.attempt);
  if (first.ptr != text + dot || second.ec != std::errc{}) return std::nullopt;
  return numbers;
}

// Unlike anything that plays the same match elsewhere.
std::string this_execution() {
  std::string host = base::host_name();
  std::replace(host.begin(), host.end(), '/', '-');
  return fmt::format("{}-{}", host, ::getpid());
}

// Gives the match folder its final name. Of several executions the first has it; what a broken-off
// one of another kind left there makes room.
fs::path place_folder(const fs::path& tournament, const fs::path& unfinished,
                      const fs::path& final_name) {
  std::error_code code;
  fs::create_directories((tournament / final_name).parent_path(), code);
  fs::rename(tournament / unfinished, tournament / final_name, code);
  if (!code) return final_name;
  fs::remove_all(tournament / final_name, code);
  fs::rename(tournament / unfinished, tournament / final_name, code);
  return code ? unfinished : final_name;
}

// Makes the result file, whole or not at all, unless somebody else has: then theirs counts.
Result<Outcome> publish(const fs::path& tournament, const Fixture& fixture, int attempt,
                        Outcome outcome) {
  const fs::path file = tournament / result_file(fixture.index, attempt);
  const fs::path own = file.string() + "." + this_execution();
  std::error_code code;
  fs::create_directories(file.parent_path(), code);
  if (const auto written = base::write_file(own, outcome_document(fixture, outcome)); !written) {
    return written.error();
  }
  fs::create_hard_link(own, file, code);
  if (code) {
    if (auto theirs = read_result(tournament, fixture, attempt)) {
      fs::remove(own, code);
      return *std::move(theirs);
    }
    fs::rename(own, file, code);  // no links on this file system, or a broken file
    if (code) return Error{fmt::format("cannot create {}: {}", file.string(), code.message())};
    return outcome;
  }
  fs::remove(own, code);
  return outcome;
}

// Plays in a folder of its own. Nothing: interrupted.
Result<std::optional<Outcome>> play(const TournamentConfig& config, const Fixture& fixture,
                                    int attempt, const AttemptPlace& place,
                                    const std::atomic<int>& stop_signal) {
  constexpr std::chrono::milliseconds kLook{5};
  auto host = process::ProcessHost::create();
  if (!host) return host.error();
  auto played = MatchAttempt::start(*host, config, fixture, attempt, place);
  if (!played) return played.error();
  while (!played->ended()) {
    std::this_thread::sleep_for(kLook);
    played->enforce_limit();
    if (stop_signal != 0) played->interrupt();
  }
  return played->outcome();
}

}  // namespace

std::vector<ResultName> result_names(const fs::path& folder) {
  std::vector<ResultName> names;
  std::error_code code;
  for (const auto& entry : fs::directory_iterator(folder / kResultsFolder, code)) {
    if (const auto numbers = numbers_in(entry.path().filename().string())) {
      names.push_back(*numbers);
    }
  }
  return names;
}

std::optional<Outcome> read_result(const fs::path& folder, const Fixture& fixture, int attempt) {
  const auto text = base::read_file(folder / result_file(fixture.index, attempt));
  if (!text) return std::nullopt;
  auto read = outcome_from_document(*text);
  if (!read || read->seed != fixture.seed) return std::nullopt;
  return std::move(read->outcome);
}

std::vector<Delivery> collect_results(const fs::path& folder,
                                      std::span<const ScheduledMatch> matches) {
  std::map<int, int> latest;
  for (const ResultName& name : result_names(folder)) {
    latest[name.index] = std::max(latest[name.index], name.attempt);
  }
  std::vector<Delivery> deliveries;
  for (const auto& [index, attempt] : latest) {
    if (index < 1 || index > static_cast<int>(matches.size())) continue;
    const ScheduledMatch& match = matches[static_cast<std::size_t>(index) - 1];
    if (match.outcome || attempt <= match.settled) continue;
    if (auto outcome = read_result(folder, match.fixture, attempt)) {
      deliveries.push_back({index, *std::move(outcome)});
    }
  }
  return deliveries;
}

Result<std::optional<Outcome>> work(const fs::path& folder, const Fixture& fixture, int attempt,
                                    const fs::path& program, const std::atomic<int>& stop_signal) {
  if (auto there = read_result(folder, fixture, attempt)) {
    return std::optional<Outcome>(*std::move(there));
  }
  const auto config = read_plan(folder);
  if (!config) return config.error();
  const fs::path unfinished = unfinished_folder(fixture.index, attempt, this_execution());
  auto outcome = play(*config, fixture, attempt, {folder, unfinished, program, {}}, stop_signal);
  std::error_code code;
  if (!outcome || !*outcome || !keeps_folder(*config, **outcome)) {
    fs::remove_all(folder / unfinished, code);
    if (!outcome || !*outcome) return outcome;
    (*outcome)->folder.clear();
  } else if (auto theirs = read_result(folder, fixture, attempt)) {
    fs::remove_all(folder / unfinished, code);
    return std::optional<Outcome>(*std::move(theirs));
  } else {
    (*outcome)->folder =
        place_folder(folder, unfinished, match_folder(*config, fixture, attempt)).string();
  }
  auto published = publish(folder, fixture, attempt, **std::move(outcome));
  if (!published) return published.error();
  return std::optional<Outcome>(*std::move(published));
}

}  // namespace cls::orchestration::tournament
