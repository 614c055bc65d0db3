// Plays matches on hosts that share nothing with this one and are reached by a remote shell.
//
// Each match is one run of play_script() here, which copies what the host lacks, plays the match
// there with `cls tournament work`, and brings the result file and the match folder back
// (hosts_scripts.cpp). hosts/JOB.host records where a match was given to. It stays until the
// result is here: a later run asks the same host first, which plays only if it has no result.
// A host that cannot be reached pauses, and its match goes to another one.
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <deque>
#include <map>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>

#include "base/io/whole_file.h"
#include "match/terms/endpoint.h"
#include "process/process_host.h"
#include "tournament/config/config_file.h"
#include "tournament/run/hosts_scripts.h"
#include "tournament/run/match_executor.h"
#include "tournament/slots/concurrency.h"
#include "tournament/store/collector.h"
#include "tournament/store/event_file.h"
#include "tournament/store/folder.h"
#include "tournament/store/match_document.h"

namespace cls::tournament {
namespace {

namespace fs = std::filesystem;
using base::Error;
using base::Result;
using Clock = std::chrono::steady_clock;

constexpr std::chrono::seconds kHostPause{20};
constexpr std::chrono::minutes kPackTimeout{10};
constexpr std::chrono::milliseconds kJobGrace{2000};
constexpr int kMaxFruitless = 3;
constexpr std::string_view kEventLine = "{\"schema\":\"cls.event/1\"";

std::string job_name(int index, int attempt) { return fmt::format("{:06}.{}", index, attempt); }

fs::path record_file(const std::string& job) { return fs::path(kHostsFolder) / (job + ".host"); }

std::string with_host(std::string text, const std::string& host) {
  constexpr std::string_view kPlace = "{host}";
  for (std::size_t at = text.find(kPlace); at != std::string::npos; at = text.find(kPlace, at)) {
    const std::string quoted = process::shell_quoted(host);
    text.replace(at, kPlace.size(), quoted);
    at += quoted.size();
  }
  return text;
}

bool has_folder(const TeamEntry& team) { return team.endpoint.starts_with("team:"); }

// The plan for a folder that has a copy of each team.
TournamentConfig plan_there(TournamentConfig config) {
  config.execution.folder = ".";
  config.execution.executor = ExecutorKind::kLocal;
  config.execution.hosts.clear();
  config.execution.on_match_finish.clear();
  config.execution.on_finish.clear();
  for (TeamEntry& team : config.competition.teams) {
    if (has_folder(team)) team.endpoint = "team:teams/" + team.name;
  }
  return config;
}

// The token names this tournament on other hosts; one that starts again is another tournament.
Result<std::string> token_of(const fs::path& folder) {
  constexpr std::size_t kLength = 32;
  const fs::path file = folder / kHostsFolder / "token";
  if (auto text = base::read_file(file); text && text->size() == kLength) return *std::move(text);
  std::string text = base::read_file("/proc/sys/kernel/random/uuid").value_or("");
  std::erase_if(text, [](char c) { return c == '-' || c == '\n'; });
  if (text.size() != kLength) return Error{"/proc/sys/kernel/random/uuid cannot be read"};
  TRY(base::write_file_durably(file, text));
  return text;
}

// Appends the events of matches; the first error is kept until it is taken. Output of programs
// arrives on another thread.
class EventLines {
 public:
  explicit EventLines(fs::path file) : file_(std::move(file)) {}

  void add(std::string_view line) {
    const std::lock_guard lock(mutex_);
    if (const auto added = append_line(file_, line); !added && !failed_) {
      failed_ = true;
      error_ = added.error().message;
    }
  }

  /// Empty: none since the last call.
  std::string take_error() {
    const std::lock_guard lock(mutex_);
    return std::exchange(error_, {});
  }

 private:
  fs::path file_;
  std::mutex mutex_;
  bool failed_ = false;
  std::string error_;
};

class HostsExecutor : public MatchExecutor {
 public:
  HostsExecutor(const TournamentConfig& config, fs::path folder, process::ProcessHost host,
                std::vector<HostObject> objects, std::string token)
      : config_(config),
        folder_(std::move(folder)),
        host_(std::move(host)),
        objects_(std::move(objects)),
        token_(std::move(token)),
        events_(std::make_shared<EventLines>(folder_ / kMatchEvents)) {
    for (HostSlots& one : host_slots(config)) hosts_.push_back({std::move(one), 0, {}});
  }

  int free_slots() const override {
    int free = 0;
    for (const Host& host : hosts_) free += free_of(host);
    return std::max(0, free - static_cast<int>(waiting_.size()));
  }

  int running() const override { return static_cast<int>(jobs_.size() + waiting_.size()); }

  Result<void> start(std::span<const Assignment> assignments) override {
    waiting_.insert(waiting_.end(), assignments.begin(), assignments.end());
    return start_waiting();
  }

  Result<std::vector<int>> take_over(std::span<const ScheduledMatch> matches) override {
    std::vector<int> taken;
    std::error_code code;
    for (const auto& entry : fs::directory_iterator(folder_ / kHostsFolder, code)) {
      const std::string name = entry.path().filename().string();
      const auto job = parse_attempt_name(name);
      if (!job || job->rest != "host") continue;

      const ScheduledMatch* match = awaited_match(matches, job->index, job->attempt);
      Host* host = find_host(base::read_file(entry.path()).value_or(""));
      if (match == nullptr || host == nullptr) {
        std::error_code ignored;
        fs::remove(entry.path(), ignored);
        continue;
      }
      TRY(start_job({match->fixture, job->attempt}, *host));
      taken.push_back(job->index);
    }

    if (!taken.empty()) {
      notes_.push_back(
          fmt::format("{} matches of an earlier run may be on other hosts", taken.size()));
    }
    return taken;
  }

  Result<std::vector<FinishedMatch>> wait(std::chrono::milliseconds limit) override {
    constexpr std::chrono::milliseconds kPollInterval{10};
    const auto end = Clock::now() + limit;
    while (true) {
      TRY(collect());
      TRY(start_waiting());
      if (!finished_.empty() || Clock::now() >= end) return std::exchange(finished_, {});
      std::this_thread::sleep_for(kPollInterval);
    }
  }

  void hold(bool held) override { held_ = held; }

  void withdraw() override {
    for (const Assignment& one : waiting_) finished_.push_back({one.fixture.index, std::nullopt});
    waiting_.clear();
  }

  // The connection ends, and so does the match there. Its record stays for the next run.
  void interrupt() override {
    withdraw();
    interrupted_ = true;
    for (const auto& [index, job] : jobs_) job.child->end(kJobGrace);
  }

  std::vector<std::string> take_notes() override {
    if (std::string error = events_->take_error(); !error.empty()) note_once(error);
    return std::exchange(notes_, {});
  }

 private:
  struct Host {
    HostSlots slots;
    int running = 0;
    Clock::time_point pause_until;  // after it could not be reached
  };
  struct Job {
    Assignment assignment;
    std::string name;
    Host* host = nullptr;
    std::shared_ptr<process::Child> child;
  };

  static int free_of(const Host& host) {
    return Clock::now() >= host.pause_until ? host.slots.slots - host.running : 0;
  }

  Host* find_host(const std::string& name) {
    const auto found =
        std::ranges::find(hosts_, name, [](const Host& host) { return host.slots.name; });
    return found == hosts_.end() ? nullptr : &*found;
  }

  // The host with the most free slots; null: none.
  Host* free_host() {
    Host* best = nullptr;
    for (Host& host : hosts_) {
      if (free_of(host) > (best == nullptr ? 0 : free_of(*best))) best = &host;
    }
    return best;
  }

  Result<void> start_waiting() {
    while (!held_ && !waiting_.empty()) {
      Host* host = free_host();
      if (host == nullptr) return {};
      const Assignment next = waiting_.front();
      waiting_.pop_front();
      TRY(start_job(next, *host));
    }
    return {};
  }

  Result<void> start_job(const Assignment& assignment, Host& host) {
    const std::string name = job_name(assignment.fixture.index, assignment.number);
    TRY(write_job(assignment, name));
    TRY(base::write_file_durably(folder_ / record_file(name), host.slots.name));

    TRY_INIT(auto child, host_.start(play_plan(assignment, name, host),
                                     [events = events_](std::string_view line) {
                                       if (line.starts_with(kEventLine)) events->add(line);
                                     }));
    ++host.running;
    jobs_.insert_or_assign(assignment.fixture.index,
                           Job{assignment, name, &host, std::move(child)});
    return {};
  }

  // hosts/JOB: what the match needs but the objects.
  Result<void> write_job(const Assignment& assignment, const std::string& name) const {
    const fs::path job = folder_ / kHostsFolder / name;
    std::error_code code;
    fs::remove_all(job, code);
    TRY(base::create_folders(job));
    TRY(base::write_file(job / kPlanFile, "schema = 1\n\n" + format_config(plan_there(config_))));
    TRY(base::write_file(job / kScheduleFile, format_fixture(assignment.fixture)));
    return base::write_file(job / "run.sh", host_script(assignment.fixture.index, assignment.number,
                                                        needed(assignment)));
  }

  process::CommandPlan play_plan(const Assignment& assignment, const std::string& name,
                                 const Host& host) const {
    const Execution& execution = config_.execution;
    const std::string shell =
        execution.remote_shell.empty() ? kRemoteShell : execution.remote_shell;
    const std::string root =
        execution.remote_folder.empty() ? kRemoteFolder : execution.remote_folder;

    process::CommandPlan plan;
    plan.name = fmt::format("match {} on {}", assignment.fixture.index, host.slots.name);
    plan.folder = folder_;
    plan.log = folder_ / kHostsFolder / (name + ".log");
    plan.argv = {"sh",
                 "-c",
                 play_script(),
                 "play",
                 name,
                 token_,
                 with_host(shell, host.slots.name),
                 root,
                 unfinished_label()};
    for (const HostObject& object : needed(assignment)) plan.argv.push_back(object.hash);
    return plan;
  }

  // The program and the two teams.
  std::vector<HostObject> needed(const Assignment& assignment) const {
    std::vector<HostObject> result;
    for (const HostObject& object : objects_) {
      const int team = team_index(config_.competition, object.name);
      const bool plays = team == assignment.fixture.left || team == assignment.fixture.right;
      if (object.name.empty() || plays) result.push_back(object);
    }
    return result;
  }

  Result<void> collect() {
    for (auto at = jobs_.begin(); at != jobs_.end();) {
      Job& job = at->second;
      if (!job.child->status().gone) {
        ++at;
        continue;
      }
      --job.host->running;
      const Job ended = std::move(job);
      at = jobs_.erase(at);
      TRY(end_job(ended));
    }
    return {};
  }

  Result<void> end_job(const Job& job) {
    const Fixture& fixture = job.assignment.fixture;
    std::error_code code;
    fs::remove_all(folder_ / kHostsFolder / job.name, code);

    if (auto outcome = read_work_result(folder_, fixture, job.assignment.number)) {
      for (const fs::path& file :
           {record_file(job.name), fs::path(kHostsFolder) / (job.name + ".log")}) {
        fs::remove(folder_ / file, code);
      }
      finished_.push_back({fixture.index, std::move(outcome)});
      return {};
    }
    if (interrupted_) {
      finished_.push_back({fixture.index, std::nullopt});
      return {};
    }

    const auto exit = job.child->status().exit;
    const std::string why = reason_of(job, exit.value_or(process::ProcessExit{}));
    const bool host_failed = !exit || exit->by_signal || exit->number != kNoResult;
    if (host_failed) {
      job.host->pause_until = Clock::now() + kHostPause;
      note_once(fmt::format("host {}: {}; trying again every {} s", job.host->slots.name, why,
                            kHostPause.count()));
    } else if (++fruitless_[fixture.index] >= kMaxFruitless) {
      return Error{fmt::format("match {} cannot be played on {}: {}", fixture.index,
                               job.host->slots.name, why)};
    }
    waiting_.push_front(job.assignment);
    return {};
  }

  // The last line that the script or the program there has printed.
  static std::string reason_of(const Job& job, const process::ProcessExit& exit) {
    constexpr std::string_view kMessage = "cls: ";
    const std::vector<std::string> lines = job.child->last_lines(1);
    if (lines.empty() || exit.by_signal) return "connection: " + to_text(exit);
    const std::string& line = lines.front();
    return line.starts_with(kMessage) ? line.substr(kMessage.size()) : line;
  }

  void note_once(const std::string& text) {
    if (text == last_note_) return;
    last_note_ = text;
    notes_.push_back(text);
  }

  const TournamentConfig& config_;
  fs::path folder_;
  process::ProcessHost host_;
  std::vector<HostObject> objects_;
  std::string token_;
  std::shared_ptr<EventLines> events_;
  std::vector<Host> hosts_;  // constant in number: jobs point to them
  std::map<int, Job> jobs_;  // by number of the match
  std::deque<Assignment> waiting_;
  std::map<int, int> fruitless_;  // attempts without a result on a host that was reached
  std::vector<FinishedMatch> finished_;
  std::vector<std::string> notes_;
  std::string last_note_;
  bool interrupted_ = false;
  bool held_ = false;
};

// Stores program and teams by their hashes.
Result<std::vector<HostObject>> pack_objects(const TournamentConfig& config, const fs::path& folder,
                                             const fs::path& program, process::ProcessHost& host) {
  std::vector<HostObject> objects = {{"", ""}};
  process::CommandPlan plan;
  plan.name = "packing of teams";
  plan.folder = folder;
  plan.argv = {"sh", "-c", kPackScript, "pack", program.string()};
  for (const TeamEntry& team : config.competition.teams) {
    if (!has_folder(team)) continue;
    TRY_INIT(const auto endpoint, match::parse_endpoint(team.endpoint));
    objects.push_back({team.name, ""});
    plan.argv.push_back((config.execution.folder / endpoint.path).string());
  }

  constexpr std::string_view kObject = "object ";
  std::vector<std::string> hashes;
  std::string last_message = "it takes too long";
  TRY_INIT(const auto child, host.start(plan, [&](std::string_view line) {
    if (line.starts_with(kObject)) {
      hashes.emplace_back(line.substr(kObject.size()));
    } else {
      last_message = line;
    }
  }));
  if (!child->wait_gone(kPackTimeout)) {
    child->end(std::chrono::milliseconds(0));
    child->wait_gone(kJobGrace);
  }

  const auto status = child->status();
  const bool good =
      status.gone && status.exit && !status.exit->by_signal && status.exit->number == 0;
  if (!good || hashes.size() != objects.size()) {
    return Error{fmt::format("the teams cannot be packed for other hosts: {}", last_message)};
  }
  for (std::size_t i = 0; i < objects.size(); ++i) objects[i].hash = hashes[i];
  return objects;
}

}  // namespace

Result<std::unique_ptr<MatchExecutor>> hosts_executor(const TournamentConfig& config,
                                                      const fs::path& folder,
                                                      const fs::path& program) {
  const fs::path whole = fs::absolute(folder).lexically_normal();
  TRY(base::create_folders(whole / kHostsFolder));
  TRY_INIT(auto host, process::ProcessHost::create());
  TRY_INIT(auto token, token_of(whole));
  TRY_INIT(auto objects, pack_objects(config, whole, program, host));
  return std::unique_ptr<MatchExecutor>(std::make_unique<HostsExecutor>(
      config, whole, std::move(host), std::move(objects), std::move(token)));
}

}  // namespace cls::tournament
