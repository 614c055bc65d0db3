// Putting a subject together and taking the steps.
#include "orchestration/checks/playmaker_check.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "orchestration/checks/scratch_folder.h"
#include "orchestration/playmaker_link.h"
#include "orchestration/playmaker_program.h"
#include "proxy/grpc_playmaker.h"

namespace cls::orchestration {
namespace {

/// Whatever the subject needs to live; the subject is destroyed first.
struct Surroundings {
  ScratchFolder folder;
  std::unique_ptr<mock_server::Server> mock;
  std::optional<ProcessHost> host;
  std::unique_ptr<PlaymakerProgram> program;
};

soccer::Result<void> connect_mock(const Endpoint& endpoint, Surroundings& around,
                                  PlaymakerSubject& subject) {
  auto server = start_mock(endpoint);
  if (!server) return server.error();
  around.mock = *std::move(server);
  subject.connect = [&around, name = endpoint.text] {
    return proxy::make_grpc_playmaker(around.mock->in_process_channel(), name);
  };
  return {};
}

soccer::Result<void> start_program(const Endpoint& endpoint, Surroundings& around,
                                   PlaymakerSubject& subject) {
  if (around.folder.path().empty()) return soccer::Error{"no folder for its log can be created"};
  auto host = ProcessHost::create();
  if (!host) return host.error();
  around.host.emplace(*std::move(host));
  auto program = PlaymakerProgram::start(
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

soccer::Result<void> prepare(const PlaymakerCheckOptions& options, Surroundings& around,
                             PlaymakerSubject& subject) {
  subject.start_timeout = options.start_timeout;
  subject.deadline = options.deadline;
  subject.calls = options.calls;
  subject.latency_limit = options.latency_limit;
  subject.pid = [] { return std::optional<int>(); };
  proxy::GrpcTarget target = target_of(options.endpoint);
  if (options.endpoint.kind == Endpoint::Kind::kMock) {
    if (auto connected = connect_mock(options.endpoint, around, subject); !connected) {
      return connected;
    }
  } else {
    if (options.endpoint.kind == Endpoint::Kind::kRun) {
      if (auto started = start_program(options.endpoint, around, subject); !started) {
        return started;
      }
      target = {};
      target.host = subject.host;
      target.port = subject.port;
    } else if (options.endpoint.kind == Endpoint::Kind::kAddress && !target.port_step) {
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

// Why it is of no use to go on; empty if it is.
std::string hopeless(const Surroundings& around, const CheckReport& report,
                     const std::atomic<int>& stop) {
  if (stop != 0) return "interrupted";
  if (around.program != nullptr && around.program->ended()) {
    std::string why = "the program has ended";
    const auto lines = around.program->child().last_lines(1);
    if (!lines.empty()) why += "; its last words: " + lines.front();
    return why;
  }
  const bool unreachable =
      !report.steps.empty() && report.steps.front().result == StepResult::kFail;
  return unreachable ? "the Playmaker was not reached" : "";
}

}  // namespace

soccer::Result<CheckReport> check_playmaker(const PlaymakerCheckOptions& options,
                                            const OnStep& on_step, const std::atomic<int>& stop) {
  Surroundings around;
  PlaymakerSubject subject;
  if (const auto prepared = prepare(options, around, subject); !prepared) return prepared.error();
  CheckReport report;
  report.schema = "cls.check/1";
  report.command = "cls check playmaker";
  report.subject = options.endpoint.text;
  for (const PlaymakerStep& step : steps_to_take(options.only)) {
    CheckStep& taken = report.steps.emplace_back();
    taken.name = step.name;
    taken.why = step.why;
    const std::string why_not = hopeless(around, report, stop);
    take(taken, [&] { return why_not.empty() ? step.run(subject) : skip(why_not); });
    if (taken.result == StepResult::kFail && around.program != nullptr) {
      taken.evidence += around.program->port_hint();
    }
    on_step(taken);
  }
  return report;
}

}  // namespace cls::orchestration
