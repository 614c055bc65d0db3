// Putting a subject together and taking the steps.
#include "orchestration/checks/playmaker/playmaker_check.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <thread>
#include <utility>

#include "orchestration/checks/ended_program.h"
#include "orchestration/checks/scratch_folder.h"
#include "orchestration/match/sides/playmaker_link.h"
#include "orchestration/match/sides/playmaker_program.h"
#include "proxy/playmaker/grpc_playmaker.h"

namespace cls::orchestration::checks {
namespace {

constexpr std::chrono::milliseconds kLook{20};

/// Whatever the subject needs to live; the subject is destroyed first.
struct Surroundings {
  ScratchFolder folder;
  std::unique_ptr<mock_server::Server> mock;
  std::optional<process::ProcessHost> host;
  std::unique_ptr<match::PlaymakerProgram> program;
};

base::Result<void> connect_mock(const match::Endpoint& endpoint, Surroundings& around,
                                PlaymakerSubject& subject) {
  auto server = match::start_mock(endpoint);
  if (!server) return server.error();
  around.mock = *std::move(server);
  subject.connect = [&around, name = endpoint.text] {
    return proxy::make_grpc_playmaker(around.mock->in_process_channel(), name);
  };
  return {};
}

base::Result<void> start_program(const match::Endpoint& endpoint, Surroundings& around,
                                 PlaymakerSubject& subject) {
  if (around.folder.path().empty()) return base::Error{"no folder for its log can be created"};
  auto host = process::ProcessHost::create();
  if (!host) return host.error();
  around.host.emplace(*std::move(host));
  auto program = match::PlaymakerProgram::start(
      *around.host, endpoint, {0, soccer::Side::kLeft, team_name(0), 1}, around.folder.path());
  if (!program) return program.error();
  around.program = *std::move(program);
  subject.host = "localhost";
  subject.port = around.program->port();
  subject.pid = [&around]() -> std::optional<int> {
    if (around.program->ended()) return std::nullopt;
    return around.program->child().status().pid;
  };
  return {};
}

base::Result<void> prepare(const PlaymakerCheckOptions& options, Surroundings& around,
                           PlaymakerSubject& subject) {
  subject.start_timeout = options.start_timeout;
  subject.deadline = options.deadline;
  subject.calls = options.calls;
  subject.latency_limit = options.latency_limit;
  subject.pid = [] { return std::optional<int>(); };
  proxy::GrpcTarget target = match::target_of(options.endpoint);
  if (options.endpoint.kind == match::Endpoint::Kind::kMock) {
    if (auto connected = connect_mock(options.endpoint, around, subject); !connected) {
      return connected;
    }
  } else {
    if (options.endpoint.kind == match::Endpoint::Kind::kRun) {
      if (auto started = start_program(options.endpoint, around, subject); !started) {
        return started;
      }
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

std::vector<PlaymakerStep> steps_to_take(const std::vector<std::string>& only) {
  std::vector<PlaymakerStep> steps;
  for (const auto& part :
       {handshake_steps(), decision_steps(), state_steps(), load_steps(), life_steps()}) {
    std::copy_if(part.begin(), part.end(), std::back_inserter(steps), [&](const auto& step) {
      return only.empty() || std::find(only.begin(), only.end(), step.name) != only.end();
    });
  }
  return steps;
}

/// Why nothing can come of asking the Playmaker; empty while something can. Called from two
/// threads.
using Hopeless = std::function<std::string()>;

// The first step waits for the Playmaker to come up, but not when none can come any more.
Finding take_first(const PlaymakerStep& step, PlaymakerSubject& subject, const Hopeless& hopeless) {
  std::atomic<bool> taken = false;
  bool called_back = false;
  std::thread watch([&] {
    while (!taken && hopeless().empty()) std::this_thread::sleep_for(kLook);
    if (taken) return;
    called_back = true;
    subject.left().cancel();
  });
  Finding found = step.run(subject);
  taken = true;
  watch.join();
  const bool failed = found.result == StepResult::kFail;
  return called_back && failed ? fail("no answer") : found;
}

Finding take_step(const PlaymakerStep& step, PlaymakerSubject& subject, const CheckReport& report,
                  const Hopeless& hopeless) {
  if (std::string reason = hopeless(); !reason.empty()) return skip(std::move(reason));
  const bool first = report.steps.size() == 1;
  if (first) return take_first(step, subject, hopeless);
  const bool reached = report.steps.front().result != StepResult::kFail;
  return reached ? step.run(subject) : skip("the Playmaker was not reached");
}

// What may be behind a step's failure.
std::string hint(const Surroundings& around, const Hopeless& hopeless) {
  if (const std::string reason = hopeless(); !reason.empty()) return "; " + reason;
  return around.program == nullptr ? "" : around.program->port_hint();
}

}  // namespace

base::Result<CheckReport> check_playmaker(const PlaymakerCheckOptions& options,
                                          const OnStep& on_step, const std::atomic<int>& stop) {
  Surroundings around;
  PlaymakerSubject subject;
  if (const auto prepared = prepare(options, around, subject); !prepared) return prepared.error();
  const Hopeless hopeless = [&around, &stop]() -> std::string {
    if (stop != 0) return "interrupted";
    if (around.program == nullptr) return {};
    return account_of_end("the program", around.program->child());
  };
  CheckReport report;
  report.schema = "cls.check/1";
  report.command = "cls check playmaker";
  report.subject = options.endpoint.text;
  for (const PlaymakerStep& step : steps_to_take(options.only)) {
    CheckStep& taken = report.steps.emplace_back();
    taken.name = step.name;
    taken.why = step.why;
    take(taken, [&] { return take_step(step, subject, report, hopeless); });
    if (taken.result == StepResult::kFail) taken.evidence += hint(around, hopeless);
    on_step(taken);
  }
  return report;
}

}  // namespace cls::orchestration::checks
