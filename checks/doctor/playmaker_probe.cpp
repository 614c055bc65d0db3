// Runs a few steps of `cls check playmaker` and summarizes them in one line.
#include "checks/doctor/playmaker_probe.h"

#include <fmt/format.h>
#include <array>

#include <filesystem>
#include <optional>
#include <string>
#include <utility>

#include "checks/playmaker/playmaker_check.h"
#include "process/ports.h"
#include "process/scratch_folder.h"

namespace cls::checks {
namespace {

namespace fs = std::filesystem;

constexpr const char* kReach = "reach";
constexpr std::array kProbedSteps = {kReach,           "register_identity", "register_language",
                                     "all_parameters", "init_message",      "player_actions",
                                     "planner"};

DoctorCheck unreachable(DoctorCheck check, std::string found) {
  check.status = DoctorStatus::kUnreachable;
  check.found = std::move(found);
  check.hint = "start it first, or let cls start it: 'run:COMMAND --port {port}'";
  return check;
}

// Why a connection is impossible; empty if it may be possible.
std::string no_connection(const match::Endpoint& endpoint, std::chrono::milliseconds limit) {
  if (endpoint.kind == match::Endpoint::Kind::kUnixSocket) {
    std::error_code code;
    const fs::file_status status = fs::status(endpoint.path, code);
    if (!fs::exists(status)) return fmt::format("{}: no such file", endpoint.path);
    return fs::is_socket(status) ? "" : fmt::format("{}: not a socket", endpoint.path);
  }

  if (endpoint.kind != match::Endpoint::Kind::kAddress) return {};

  const int port = endpoint.port + (endpoint.port_step ? 1 : 0);
  const auto longest = static_cast<int>(limit.count());
  if (process::tcp_answers(endpoint.host, port, longest)) return {};
  return fmt::format("{}:{}: connection refused", endpoint.host, port);
}

}  // namespace

DoctorCheck probe_playmaker(const match::Endpoint& endpoint, std::chrono::milliseconds limit,
                            const std::atomic<int>& stop) {
  DoctorCheck check;
  check.name = "playmaker";
  check.purpose = fmt::format("the side {}", endpoint.text);
  check.needed = true;
  if (std::string why = no_connection(endpoint, limit); !why.empty()) {
    return unreachable(std::move(check), std::move(why));
  }

  PlaymakerCheckOptions options;
  std::optional<process::ScratchFolder> scratch;
  if (endpoint.kind == match::Endpoint::Kind::kRun) {
    auto created = process::ScratchFolder::create();
    if (!created) return unreachable(std::move(check), created.error().message);
    options.folder = scratch.emplace(*std::move(created)).path();
  }

  options.endpoint = endpoint;
  options.start_timeout = limit;
  options.deadline = limit;
  options.only.assign(kProbedSteps.begin(), kProbedSteps.end());

  std::string found = endpoint.text + ":";
  CheckStep failed;
  std::atomic<int> enough{0};
  const auto on_step = [&](const CheckStep& step) {
    if (stop.load() != 0) enough = 1;
    if (enough != 0) return;
    if (step.result == StepResult::kFail) {
      failed = step;
      enough = 1;
    } else if (step.name == kReach || step.name == "register_language" ||
               step.name == "player_actions") {
      found += fmt::format(" {};", step.evidence);
    } else if (step.name == "planner") {
      found += step.result == StepResult::kPass ? " implements GetBestPlannerAction"
                                                : " does not implement GetBestPlannerAction";
    }
  };

  const auto report = check_playmaker(options, on_step, enough);
  if (!report) return unreachable(std::move(check), report.error().message);
  // Skipped if the program exited before it was reached.
  const CheckStep& reach = report->steps.front();
  if (reach.result != StepResult::kPass) {
    return unreachable(std::move(check), fmt::format("{}: {}", endpoint.text, reach.evidence));
  }

  if (failed.name.empty()) {
    check.found = std::move(found);
    return check;
  }

  check.status = DoctorStatus::kWrong;
  check.found = fmt::format("{}: {}: {}", endpoint.text, failed.name, failed.evidence);
  check.hint = fmt::format("{} All steps: cls check playmaker {}", failed.why, endpoint.text);
  return check;
}

}  // namespace cls::checks
