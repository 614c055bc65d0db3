// Starts children through the guard; requests to their keepers.
#include "process/process_host.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <thread>

#include "base/system/control_group.h"
#include "process/guard.h"
#include "process/namespaces.h"
#include "process/pipe.h"
#include "process/process_host_core.h"

namespace cls::process {
namespace {

using base::Error;
using base::Result;
using std::chrono::milliseconds;

// For a loaded host; the keeper usually replies in 1 ms.
constexpr milliseconds kStartTimeout{10'000};
constexpr milliseconds kUsageTimeout{500};
constexpr milliseconds kDroppedGrace{1000};
constexpr milliseconds kEndMargin{2000};
constexpr milliseconds kReadyInterval{5};

Error cannot_start(const CommandPlan& plan, const std::string& reason) {
  return Error{fmt::format("cannot start {}: {}", plan.name, reason)};
}

// The plan with absolute paths.
Result<CommandPlan> resolved(const CommandPlan& plan) {
  CommandPlan result = plan;
  std::error_code code;

  if (!plan.folder.empty()) {
    result.folder = std::filesystem::absolute(plan.folder, code);
    if (!std::filesystem::is_directory(result.folder, code)) {
      return cannot_start(plan, fmt::format("{}: no such folder", plan.folder.string()));
    }
  }

  const auto program = find_program(plan.argv.empty() ? "" : plan.argv.front());
  if (!program) return cannot_start(plan, program.error().message);
  result.argv.front() = program->string();
  return result;
}

Result<base::UniqueFd> open_log(const CommandPlan& plan) {
  if (plan.log.empty()) return base::UniqueFd();
  base::UniqueFd file(::open(plan.log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
  if (file) return file;
  return cannot_start(plan,
                      fmt::format("cannot create {}: {}", plan.log.string(), std::strerror(errno)));
}

std::string place_of(LaunchStep step, const CommandPlan& plan) {
  if (step == LaunchStep::kFolder) return plan.folder.string();
  if (step == LaunchStep::kConfinement) return "seccomp";
  if (step == LaunchStep::kNamespaces) return "namespaces";
  if (step == LaunchStep::kMounts) return "mounts in a namespace";
  return step == LaunchStep::kFiles ? "Landlock" : plan.argv.front();
}

// The order of keeper_fds().
std::vector<int> descriptors(const CommandPlan& plan, int control, int output) {
  std::vector<int> fds = {control, output};
  fds.insert(fds.end(), plan.passed.begin(), plan.passed.end());
  if (plan.namespaces == nullptr) return fds;
  fds.push_back(plan.namespaces->user_fd());
  fds.push_back(plan.namespaces->network_fd());
  return fds;
}

}  // namespace

void ChildRecord::ask(const KeeperRequest& request) {
  if (!control || !send_request(control.get(), request)) return;
  status.asked_to_end = status.asked_to_end || !status.exit;
}

Child::Child(std::shared_ptr<ProcessHostCore> core, std::shared_ptr<ChildRecord> record)
    : core_(std::move(core)), record_(std::move(record)) {}

// Who has the child is who hears its lines, and may be gone when the last ones come.
Child::~Child() {
  const std::lock_guard lock(core_->mutex);
  record_->log.stop_calls();
  record_->ask({KeeperRequest::Kind::kEnd, std::chrono::duration<double>(kDroppedGrace).count()});
}

const CommandPlan& Child::plan() const { return record_->plan; }

Child::Status Child::status() const {
  const std::lock_guard lock(core_->mutex);
  return record_->status;
}

std::vector<std::string> Child::last_lines(std::size_t count) const {
  const std::lock_guard lock(core_->mutex);
  return record_->log.last_lines(count);
}

std::string Child::log_error() const {
  const std::lock_guard lock(core_->mutex);
  if (record_->log.error() == 0) return {};
  return fmt::format("writing {} failed: {}", record_->plan.log.string(),
                     std::strerror(record_->log.error()));
}

double Child::cpu_seconds() const {
  std::unique_lock lock(core_->mutex);
  const std::uint64_t answers = record_->usage_answers;
  // A keeper that has ended cannot be asked, but its last report may wait to be read.
  if (record_->control) send_request(record_->control.get(), {KeeperRequest::Kind::kUsage});
  core_->changed.wait_for(lock, kUsageTimeout,
                          [&] { return record_->usage_answers > answers || record_->status.gone; });
  return record_->cpu_seconds;
}

double Child::delayed_seconds() const {
  const std::lock_guard lock(core_->mutex);
  return record_->delayed_seconds;
}

void Child::end(milliseconds grace, bool gently) const {
  const std::lock_guard lock(core_->mutex);
  record_->ask({gently ? KeeperRequest::Kind::kEndGently : KeeperRequest::Kind::kEnd,
                std::chrono::duration<double>(grace).count()});
}

bool Child::wait_exit(milliseconds limit) const {
  std::unique_lock lock(core_->mutex);
  return core_->changed.wait_for(
      lock, limit, [&] { return record_->status.exit.has_value() || record_->status.gone; });
}

bool Child::wait_gone(milliseconds limit) const {
  std::unique_lock lock(core_->mutex);
  return core_->changed.wait_for(lock, limit, [&] { return record_->status.gone; });
}

ProcessHost::ProcessHost(std::shared_ptr<ProcessHostCore> core) : core_(std::move(core)) {}

Result<ProcessHost> ProcessHost::create(std::size_t log_limit) {
  base::note_memory_kills();
  if (Guard::active() == nullptr) {
    const std::string& why = Guard::start_error();
    return Error{why.empty()
                     ? "this process has no guard process; Guard::start was not called in main"
                     : why};
  }

  base::UniqueFd wake_event(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK));
  if (!wake_event) return Error{fmt::format("cannot start processes: {}", std::strerror(errno))};
  return ProcessHost(std::make_shared<ProcessHostCore>(log_limit, std::move(wake_event)));
}

ProcessHost::~ProcessHost() {
  if (!core_) return;
  end_all(kDroppedGrace);
  core_->stop();
}

std::uint64_t ProcessHost::changes() const { return core_->changes.load(); }

Result<std::shared_ptr<Child>> ProcessHost::start(const CommandPlan& plan, OnLine on_line) {
  TRY_INIT(const CommandPlan complete, resolved(plan));
  TRY_INIT(auto log, open_log(plan));

  auto control = make_socket_pair();
  auto output = make_pipe();
  const Guard* guard = Guard::active();
  if (guard == nullptr) return cannot_start(plan, "the guard is gone");
  if (!control || !output) return cannot_start(plan, std::strerror(errno));
  ::fcntl(output->read.get(), F_SETFL, O_NONBLOCK);

  if (!send_packet(guard->socket(), encode(complete),
                   descriptors(plan, control->second.get(), output->write.get()))) {
    return cannot_start(
        plan, errno == EMSGSIZE ? "the command line is too long" : "the guard process was killed");
  }
  control->second.reset();
  output->write.reset();

  auto record = std::make_shared<ChildRecord>();
  record->plan = plan;
  record->control = std::move(control->first);
  record->output = std::move(output->read);
  record->log = OutputLog(std::move(log), core_->log_limit, std::move(on_line));
  auto child = std::make_shared<Child>(core_, record);
  core_->add(record);

  std::unique_lock lock(core_->mutex);
  core_->changed.wait_for(lock, kStartTimeout,
                          [&] { return record->first_report || record->status.gone; });
  if (!record->first_report) return cannot_start(plan, "no process could be made for it");

  const KeeperReport& report = *record->first_report;
  if (report.kind == KeeperReport::Kind::kStarted) return child;
  return cannot_start(
      plan, fmt::format("{}: {}", place_of(report.step, complete), std::strerror(report.number)));
}

bool ProcessHost::end_all(milliseconds grace) {
  std::unique_lock lock(core_->mutex);
  const double seconds = std::chrono::duration<double>(grace).count();
  for (const auto& record : core_->records) record->ask({KeeperRequest::Kind::kEnd, seconds});
  return core_->changed.wait_for(lock, grace + kEndMargin, [&] { return core_->records.empty(); });
}

bool has_ended(const Child::Status& status) {
  if (status.gone || !status.exit) return status.gone;
  const bool failed = status.exit->by_signal || status.exit->number != 0;
  return failed || status.living == 0;
}

Readiness wait_until_ready(const Child& child, const std::function<bool()>& ready,
                           milliseconds limit, const std::atomic<int>& stop) {
  const auto until = std::chrono::steady_clock::now() + limit;
  while (true) {
    if (ready()) return Readiness::kReady;
    if (stop.load() != 0) return Readiness::kInterrupted;
    if (has_ended(child.status())) return Readiness::kEnded;
    if (std::chrono::steady_clock::now() >= until) return Readiness::kTimedOut;
    std::this_thread::sleep_for(kReadyInterval);
  }
}

}  // namespace cls::process
