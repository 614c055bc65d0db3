// A few steps of the check, told in one line.
#include "orchestration/checks/doctor/playmaker_probe.h"

#include <fmt/format.h>

#include <filesystem>
#include <string>
#include <utility>

#include "orchestration/checks/playmaker/playmaker_check.h"
#include "orchestration/process/ports.h"

namespace cls::orchestration::checks {
namespace {

namespace fs = std::filesystem;

constexpr const char* kReach = "reach";

Symptom unreachable(Symptom symptom, std::string found) {
  symptom.health = Health::kUnreachable;
  symptom.found = std::move(found);
  symptom.remedy = "start it first, or let cls do it: 'run:COMMAND --port {port}'";
  return symptom;
}

// Why there can be no connection; empty when there can.
std::string no_connection(const match::Endpoint& endpoint, std::chrono::milliseconds limit) {
  if (endpoint.kind == match::Endpoint::Kind::kUnixSocket) {
    std::error_code code;
    const fs::file_status status = fs::status(endpoint.path, code);
    if (!fs::exists(status)) return fmt::format("{}: no such file", endpoint.path);
    return fs::is_socket(status) ? "" : fmt::format("{} is no socket", endpoint.path);
  }
  if (endpoint.kind != match::Endpoint::Kind::kAddress) return {};
  const int port = endpoint.port + (endpoint.port_step ? 1 : 0);
  const auto longest = static_cast<int>(limit.count());
  if (process::tcp_answers(endpoint.host, port, longest)) return {};
  return fmt::format("{}:{}: nobody accepts a connection", endpoint.host, port);
}

}  // namespace

Symptom probe_playmaker(const match::Endpoint& endpoint, std::chrono::milliseconds limit,
                        const std::atomic<int>& stop) {
  Symptom symptom;
  symptom.name = "playmaker";
  symptom.purpose = fmt::format("the side {}", endpoint.text);
  symptom.needed = true;
  if (std::string why = no_connection(endpoint, limit); !why.empty()) {
    return unreachable(std::move(symptom), std::move(why));
  }
  PlaymakerCheckOptions options;
  options.endpoint = endpoint;
  options.start_timeout = limit;
  options.deadline = limit;
  options.only = {kReach,           "register_identity", "register_language",
                  "all_parameters", "init_message",      "player_actions",
                  "planner"};
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
      found += step.result == StepResult::kPass ? " knows GetBestPlannerAction"
                                                : " does not know GetBestPlannerAction";
    }
  };
  const auto report = check_playmaker(options, on_step, enough);
  if (!report) return unreachable(std::move(symptom), report.error().message);
  // Left out when the program had ended before it could be asked.
  const CheckStep& reach = report->steps.front();
  if (reach.result != StepResult::kPass) {
    return unreachable(std::move(symptom), fmt::format("{}: {}", endpoint.text, reach.evidence));
  }
  if (failed.name.empty()) {
    symptom.found = std::move(found);
    return symptom;
  }
  symptom.health = Health::kWrong;
  symptom.found = fmt::format("{}: {}: {}", endpoint.text, failed.name, failed.evidence);
  symptom.remedy = fmt::format("{} All steps: cls check playmaker {}", failed.why, endpoint.text);
  return symptom;
}

}  // namespace cls::orchestration::checks
