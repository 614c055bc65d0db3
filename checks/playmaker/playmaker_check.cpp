// Builds the subject and runs the steps.
#include "checks/playmaker/playmaker_check.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <thread>
#include <utility>

#include "checks/checked_program.h"
#include "match/sides/playmaker_process.h"
#include "proxy/playmaker/grpc_playmaker.h"

namespace cls::checks {
namespace {

constexpr std::chrono::milliseconds kExitPollInterval{20};

/// Resources of the subject; outlives it.
struct Environment {
  std::unique_ptr<mock_server::Server> mock;
  std::optional<process::ProcessHost> host;
  std::unique_ptr<match::PlaymakerProcess> program;
};

base::Result<void> connect_mock(const match::Endpoint& endpoint, Environment& environment,
                                PlaymakerSubject& subject) {
  TRY_INIT(environment.mock, match::start_mock(endpoint));
  subject.connect = [&environment, name = endpoint.text] {
    return proxy::make_grpc_playmaker(environment.mock->in_process_channel(), name);
  };
  return {};
}

base::Result<void> start_program(const PlaymakerCheckOptions& options, Environment& environment,
                                 PlaymakerSubject& subject) {
  TRY_INIT(auto host, process::ProcessHost::create());
  environment.host.emplace(std::move(host));

  TRY_INIT(environment.program, match::PlaymakerProcess::start(
                                    *environment.host, options.endpoint,
                                    {0, soccer::Side::kLeft, team_name(0), 1}, options.folder));

  subject.host = "localhost";
  subject.port = environment.program->port();
  subject.pid = [&environment]() -> std::optional<int> {
    if (environment.program->ended()) return std::nullopt;
    return environment.program->child().status().pid;
  };
  return {};
}

base::Result<void> prepare(const PlaymakerCheckOptions& options, Environment& environment,
                           PlaymakerSubject& subject) {
  subject.start_timeout = options.start_timeout;
  subject.deadline = options.deadline;
  subject.calls = options.calls;
  subject.latency_limit = options.latency_limit;
  subject.pid = [] { return std::optional<int>(); };

  proxy::GrpcTarget target = match::target_of(options.endpoint);
  if (options.endpoint.kind == match::Endpoint::Kind::kMock) {
    TRY(connect_mock(options.endpoint, environment, subject));
  } else {
    if (options.endpoint.kind == match::Endpoint::Kind::kRun) {
      TRY(start_program(options, environment, subject));
      target = {};
      target.host = subject.host;
      target.port = subject.port;
    } else if (options.endpoint.kind == match::Endpoint::Kind::kAddress && !target.port_step) {
      subject.host = target.host;
      subject.port = target.port;
    }
    subject.connect = [target] { return proxy::make_grpc_playmaker(target); };
  }

  for (auto& team : subject.teams) team = subject.connect();
  return {};
}

std::vector<PlaymakerStep> selected_steps(const std::vector<std::string>& only) {
  std::vector<PlaymakerStep> steps;
  for (const auto& part : {handshake_steps(), decision_steps(), state_steps(), load_steps(),
                           play_steps(), life_steps(), team_steps()}) {
    std::copy_if(part.begin(), part.end(), std::back_inserter(steps), [&](const auto& step) {
      return only.empty() || std::ranges::find(only, step.name) != only.end();
    });
  }
  return steps;
}

/// Why further calls cannot succeed; empty while they can. Called from two threads.
using FailureReason = std::function<std::string()>;

// The first step waits for the Playmaker to start, but stops when it cannot start any more.
Finding run_first_step(const PlaymakerStep& step, PlaymakerSubject& subject,
                       const FailureReason& failure_reason) {
  std::atomic<bool> done = false;
  bool cancelled = false;
  std::thread watch([&] {
    while (!done && failure_reason().empty()) std::this_thread::sleep_for(kExitPollInterval);
    if (done) return;
    cancelled = true;
    subject.left().cancel();
  });

  Finding found = step.run(subject);
  done = true;
  watch.join();

  const bool failed = found.result == StepResult::kFail;
  return cancelled && failed ? fail("no reply") : found;
}

Finding ask_step(const PlaymakerStep& step, PlaymakerSubject& subject, const CheckReport& report,
                 const FailureReason& failure_reason) {
  if (std::string reason = failure_reason(); !reason.empty()) return skip(std::move(reason));
  const bool first = report.steps.size() == 1;
  if (first) return run_first_step(step, subject, failure_reason);
  const bool reached = report.steps.front().result != StepResult::kFail;
  return reached ? step.run(subject) : skip("Playmaker unreachable");
}

// Possible cause of a failed step.
std::string hint(const Environment& environment, const FailureReason& failure_reason) {
  if (const std::string reason = failure_reason(); !reason.empty()) return "; " + reason;
  return environment.program == nullptr ? "" : environment.program->port_hint();
}

}  // namespace

base::Result<CheckReport> check_playmaker(const PlaymakerCheckOptions& options,
                                          const OnStep& on_step, const std::atomic<int>& stop) {
  Environment environment;
  PlaymakerSubject subject;
  TRY(prepare(options, environment, subject));

  const FailureReason failure_reason = [&environment, &stop]() -> std::string {
    if (stop != 0) return "interrupted";
    if (environment.program == nullptr) return {};
    return describe_exit("the program", environment.program->child());
  };

  CheckReport report{"cls.check/1", "cls check playmaker", options.endpoint.text, {}};
  for (const PlaymakerStep& step : selected_steps(options.only)) {
    CheckStep& done = run_step(report, step.name, step.why,
                               [&] { return ask_step(step, subject, report, failure_reason); });
    if (done.result == StepResult::kFail) done.evidence += hint(environment, failure_reason);
    on_step(done);
  }
  return report;
}

}  // namespace cls::checks
