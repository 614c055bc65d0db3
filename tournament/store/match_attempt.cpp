// Starts `cls match` and reads its result.
#include "tournament/store/match_attempt.h"

#include <fmt/format.h>
#include <signal.h>

#include <algorithm>
#include <cerrno>
#include <iterator>
#include <string_view>
#include <utility>

#include "base/io/replacement.h"
#include "base/io/whole_file.h"
#include "base/system/host.h"
#include "base/text/number_text.h"
#include "match/result/match_folder.h"
#include "match/result/recorded_end.h"
#include "match/terms/endpoint.h"
#include "match/terms/option_table.h"
#include "match/terms/server_choice.h"
#include "tournament/store/folder.h"
#include "tournament/store/match_document.h"

namespace cls::tournament {
namespace {

namespace fs = std::filesystem;
using base::Error;
using base::Result;

// A match that respects its own limit exits long before.
constexpr double kKillAfterLimitS = 15.0;
constexpr int kLogCompression = 1;  // higher levels cost several times the CPU time
constexpr std::chrono::milliseconds kGracePeriod{4000};
// More than the match's guard takes, if it is alive.
constexpr std::chrono::milliseconds kRestGrace{2000};

void add_option(std::vector<std::string>& argv, const char* option, const std::string& value) {
  argv.emplace_back(option);
  argv.push_back(value);
}

// Logs of many matches are large. Running servers have settings of their own.
void add_log_compression(std::vector<std::string>& argv, const TournamentConfig& config) {
  const match::ServerChoice server = match_options(config.conditions).server_choice;
  if (server.kind == match::ServerChoice::Kind::kAddress) return;
  for (const char* name : {"server::game_log_compression", "server::text_log_compression"}) {
    if (!config.conditions.sets(name)) {
      add_option(argv, "--set", fmt::format("{}={}", name, kLogCompression));
    }
  }
}

// Events of all matches go to one file, from which `run` passes them on (event_feed.h).
void add_events(std::vector<std::string>& argv, const fs::path& tournament) {
  const std::string file = process::shell_quoted((tournament / kMatchEvents).string());
  add_option(argv, "--on-event", fmt::format("exec cat >>{}", file));
}

// The outcome in the result.json of a match folder; nothing when there is none, a corrupt one, or
// one of another seed.
std::optional<Outcome> read_outcome(const fs::path& folder, const Fixture& fixture) {
  const auto text = base::read_file(folder / match::kResultFile);
  if (!text) return std::nullopt;
  const auto result = match::parse_match_result(*text);
  if (!result || result->seed != fixture.seed) return std::nullopt;
  return outcome_of(*result);
}

bool is_external(const TeamEntry& team) {
  const auto endpoint = match::parse_endpoint(team.endpoint);
  return endpoint && endpoint->kind == match::Endpoint::Kind::kTeam;
}

// True for the label of a `work` process that runs on this host (unfinished_label),
// also with an extension.
bool is_running(std::string_view label) {
  const std::string host = unfinished_host();
  if (!label.starts_with(host + "-")) return false;
  const std::string_view rest = label.substr(host.size() + 1);
  const auto pid = base::parse_int(rest.substr(0, rest.find('.')));
  return pid && *pid > 0 && (::kill(*pid, 0) == 0 || errno == EPERM);
}

// The reason in the output of a `cls match` without a result: its last message, else its last line.
std::string reason_in(const std::vector<std::string>& output,
                      const process::Child::Status& status) {
  constexpr std::string_view kMessage = "cls: ";
  std::string last_line;
  for (auto line = output.rbegin(); line != output.rend(); ++line) {
    if (line->starts_with(kMessage)) return line->substr(kMessage.size());
    if (last_line.empty() && line->find_first_not_of(' ') != std::string::npos) last_line = *line;
  }
  return last_line.empty() ? to_text(status.exit.value_or(process::ProcessExit{})) : last_line;
}

// `outcome` as that of an attempt whose process is not known.
Outcome at_attempt(Outcome outcome, int attempt, const fs::path& folder, std::string time) {
  outcome.attempts = attempt;
  outcome.folder = folder.string();
  outcome.started = time;
  outcome.ended = std::move(time);
  outcome.host = base::host_name();
  outcome.run_seconds = outcome.wall_seconds;
  return outcome;
}

bool interrupted(const Outcome& outcome) {
  return outcome.end_reason == soccer::EndReason::kInterrupted;
}

// Where this process alone plays an attempt: in `folder`, if it is not empty, else below matches/,
// unless another process has created that folder.
fs::path own_folder(const TournamentConfig& config, const Fixture& fixture, int attempt,
                    const fs::path& tournament, fs::path folder) {
  fs::path published = match_folder(config, fixture, attempt);
  if (folder.empty() && claim_folder(tournament / published)) return published;
  if (folder.empty()) folder = unfinished_folder(fixture.index, attempt, unfinished_label());
  std::error_code code;
  fs::remove_all(tournament / folder, code);  // of a killed process that had the same number
  return folder;
}

}  // namespace

process::CommandPlan match_plan(const TournamentConfig& config, const Fixture& fixture,
                                const fs::path& program, const fs::path& folder) {
  const std::vector<TeamEntry>& teams = config.competition.teams;
  const TeamEntry& left = teams[base::index(fixture.left)];
  const TeamEntry& right = teams[base::index(fixture.right)];
  process::CommandPlan plan;
  plan.name = fmt::format("match {}", fixture.index);
  plan.folder = config.execution.folder;
  plan.argv = {program.string(), "match", left.endpoint, right.endpoint};
  add_option(plan.argv, "--left-name", left.name);
  add_option(plan.argv, "--right-name", right.name);
  if (is_external(left) || is_external(right)) plan.argv.emplace_back("--own-names");
  plan.argv.emplace_back("--rated");
  add_option(plan.argv, "--seed", fmt::to_string(fixture.seed));

  std::ranges::move(match::option_words(config.conditions.options), std::back_inserter(plan.argv));
  for (const ServerSetting& setting : config.conditions.settings) {
    add_option(plan.argv, "--set", setting.name + "=" + setting.value);
  }
  if (fixture.decides) {
    if (!config.conditions.sets("server::nr_extra_halfs")) {
      add_option(plan.argv, "--set", "server::nr_extra_halfs=2");
    }
    add_option(plan.argv, "--set", "server::penalty_shoot_outs=on");
  }

  if (!folder.empty()) {
    add_log_compression(plan.argv, config);
    add_option(plan.argv, "--dir", folder.string());
  }
  plan.argv.emplace_back("--quiet");
  return plan;
}

Result<MatchAttempt> MatchAttempt::start(process::ProcessHost& host, const TournamentConfig& config,
                                         const Fixture& fixture, int attempt,
                                         AttemptOptions options) {
  MatchAttempt started;
  started.fixture_ = fixture;
  started.number_ = attempt;
  started.tournament_ = fs::absolute(options.tournament);
  started.folder_ =
      own_folder(config, fixture, attempt, started.tournament_, std::move(options.folder));
  started.begin_ = std::chrono::steady_clock::now();
  started.limit_s_ = match_options(config.conditions).time_limit_s;
  started.started_ = base::utc_now();

  process::CommandPlan plan =
      match_plan(config, fixture, options.program, started.tournament_ / started.folder_);
  plan.cpus = std::move(options.cpus);
  if (!config.execution.on_event.empty()) add_events(plan.argv, started.tournament_);

  TRY_INIT(auto child, host.start(plan));
  started.child_ = std::move(child);
  return started;
}

void MatchAttempt::end_overdue() {
  if (child_->status().exit && !std::exchange(ended_rest_, true)) child_->end(kRestGrace);
  if (!limit_s_ || timed_out_) return;
  const auto now = std::chrono::steady_clock::now();
  if (std::chrono::duration<double>(now - begin_).count() < *limit_s_ + kKillAfterLimitS) return;
  timed_out_ = true;
  child_->end(std::chrono::milliseconds(0));
}

void MatchAttempt::interrupt() {
  if (std::exchange(interrupted_, true)) return;
  child_->end(kGracePeriod, true);
}

Result<std::optional<Outcome>> MatchAttempt::outcome() const {
  const process::Child::Status status = child_->status();
  auto read = read_outcome(tournament_ / folder_, fixture_);
  if (read && interrupted(*read)) return std::optional<Outcome>();

  Outcome outcome;
  if (read) {
    outcome = *std::move(read);
  } else if (interrupted_) {
    return std::optional<Outcome>();
  } else if (timed_out_) {
    outcome.end_reason = soccer::EndReason::kTimedOut;
    outcome.message = fmt::format("did not exit at its time limit of {} s", *limit_s_);
  } else if (status.exit && status.exit->by_signal) {
    // The embedded server runs in this process.
    outcome.end_reason = soccer::EndReason::kServerFailed;
    outcome.message = "cls match was " + to_text(*status.exit);
  } else {
    return Error{fmt::format("match {} cannot be played: {}", fixture_.index,
                             reason_in(child_->last_lines(), status))};
  }

  outcome.attempts = number_;
  outcome.folder = folder_.string();
  outcome.started = started_;
  outcome.ended = base::utc_now();
  outcome.host = base::host_name();
  outcome.load = base::load_average();
  outcome.run_seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  return std::optional<Outcome>(std::move(outcome));
}

bool holds_result(const fs::path& folder) {
  const auto text = base::read_file(folder / match::kResultFile);
  const auto result = text ? match::parse_match_result(*text) : base::Error{""};
  return result && result->end_reason != soccer::EndReason::kInterrupted;
}

bool was_played(const fs::path& folder, const Fixture& fixture) {
  const auto outcome = read_outcome(folder, fixture);
  return outcome && !interrupted(*outcome);
}

bool was_interrupted(const fs::path& folder, const Fixture& fixture) {
  const auto outcome = read_outcome(folder, fixture);
  return outcome && interrupted(*outcome);
}

std::optional<Outcome> recover_result(const TournamentConfig& config, const Fixture& fixture,
                                      int attempt, const fs::path& tournament) {
  const fs::path folder = match_folder(config, fixture, attempt);
  auto outcome = read_outcome(tournament / folder, fixture);
  if (!outcome || !outcome->finished()) return std::nullopt;
  return at_attempt(*std::move(outcome), attempt, folder, base::utc_now());
}

std::optional<Outcome> read_again(const TournamentConfig& config, const Fixture& fixture,
                                  int attempt, const fs::path& tournament) {
  const fs::path folder = match_folder(config, fixture, attempt);
  auto outcome = read_outcome(tournament / folder, fixture);
  if (!outcome || interrupted(*outcome)) return std::nullopt;
  return at_attempt(*std::move(outcome), attempt, folder,
                    match::recorded_start(tournament / folder));
}

bool keeps_folder(const TournamentConfig& config, const Outcome& outcome) {
  if (config.execution.keep_logs == KeepLogs::kAll) return true;
  return config.execution.keep_logs == KeepLogs::kFailed && !outcome.played();
}

void clean_up(const TournamentConfig& config, const Fixture& fixture, const Outcome& outcome,
              const fs::path& tournament) {
  std::error_code code;
  for (int attempt = 1; attempt <= outcome.attempts; ++attempt) {
    const fs::path folder = match_folder(config, fixture, attempt);
    bool keep = folder == outcome.folder;
    if (attempt < outcome.attempts && config.execution.keep_logs != KeepLogs::kNone) {
      keep = holds_result(tournament / folder);
    }
    if (!keep) fs::remove_all(tournament / folder, code);
  }
}

void clean_up_unfinished(std::span<const ScheduledMatch> matches, const fs::path& tournament) {
  std::error_code code;
  for (const auto& entry : fs::directory_iterator(tournament / kUnfinishedFolder, code)) {
    const std::string name = entry.path().filename().string();
    const auto work = parse_attempt_name(name);
    if (!work || work->index < 1 || work->index > std::ssize(matches)) continue;
    const auto& outcome = matches[base::index(work->index) - 1].outcome;
    if (!outcome || work->attempt > outcome->attempts || is_running(work->rest)) continue;
    std::error_code ignored;
    if (name != fs::path(outcome->folder).filename()) fs::remove_all(entry.path(), ignored);
  }
  for (const char* part : {"", kUnfinishedFolder}) {
    base::remove_abandoned(tournament / part);
  }
}

}  // namespace cls::tournament
