// Runs the checks in the order of the report.
#include "checks/doctor/doctor.h"

#include <array>
#include <cstddef>
#include <filesystem>
#include <system_error>
#include <utility>
#include <vector>

#include "checks/checked_program.h"
#include "checks/doctor/host_checks.h"
#include "checks/doctor/playmaker_probe.h"
#include "checks/doctor/program_checks.h"
#include "checks/doctor/server_probe.h"
#include "process/process_host.h"
#include "process/scratch_folder.h"

namespace cls::checks {
namespace {

struct StockPort {
  int number;
  const char* role;
};
constexpr std::array<StockPort, 3> kStockPorts = {
    StockPort{6000, "players"}, StockPort{6001, "trainers"}, StockPort{6002, "coaches"}};

std::vector<DoctorCheck> ask_all(const DoctorOptions& options, const std::atomic<int>& stop) {
  DoctorCheck starting;
  starting.name = "processes";
  starting.purpose = "servers, run: and team: sides";
  starting.needed = true;

  const auto scratch = process::ScratchFolder::create();
  auto host = process::ProcessHost::create();
  if (!host || !scratch) {
    starting.status = DoctorStatus::kWrong;
    starting.found = host ? scratch.error().message : host.error().message;
    starting.hint = host ? "free space in TMPDIR" : "raise the limit: ulimit -u";
    return {starting};
  }

  const std::vector<ProgramCheck> examinations = {soccer_server_program(scratch->path()), python(),
                                                  node(), protobuf_compiler(), slurm()};
  std::vector<ProgramRun> questions = {{"/bin/sh", {"-c", "exit 0"}, {}, {}}};
  for (const ProgramCheck& each : examinations) questions.push_back(each.question);
  const auto answers = run_programs(*host, questions, options.limit, stop);

  starting.found = "can be started and stopped";
  if (!answers.front().ended_well()) {
    starting.status = DoctorStatus::kWrong;
    starting.found = "/bin/sh could not be started or did not exit";
    starting.hint = "check the load of the host and its limits: ulimit -a";
  }

  std::vector<DoctorCheck> checks = {starting};
  for (std::size_t i = 0; i < examinations.size(); ++i) {
    checks.push_back(examinations[i].evaluate(answers[i + 1]));
  }
  return checks;
}

}  // namespace

DoctorReport examine(const DoctorOptions& options,
                     const std::function<void(const DoctorCheck&)>& on_check,
                     const std::atomic<int>& stop) {
  DoctorReport report;

  const auto add_check = [&](DoctorCheck check) {
    report.checks.push_back(std::move(check));
    on_check(report.checks.back());
  };

  add_check(program_file());
  add_check(processors());
  add_check(memory());
  add_check(sandbox());
  add_check(loopback());
  std::error_code gone;
  add_check(working_folder(std::filesystem::current_path(gone)));
  for (const StockPort& port : kStockPorts) add_check(udp_port(port.number, port.role));
  for (DoctorCheck& check : ask_all(options, stop)) add_check(std::move(check));

  if (options.server && stop.load() == 0) {
    add_check(probe_server(*options.server, options.own_program, options.limit, stop));
  }
  if (options.playmaker && stop.load() == 0) {
    add_check(probe_playmaker(*options.playmaker, options.limit, stop));
  }

  return report;
}

}  // namespace cls::checks
