// The round, in the order in which it is told.
#include "orchestration/checks/doctor/doctor.h"

#include <array>
#include <cstddef>
#include <filesystem>
#include <utility>
#include <vector>

#include "orchestration/checks/doctor/machine.h"
#include "orchestration/checks/doctor/playmaker_probe.h"
#include "orchestration/checks/doctor/programs.h"
#include "orchestration/checks/doctor/server_probe.h"
#include "orchestration/checks/scratch_folder.h"
#include "orchestration/process/process_host.h"

namespace cls::orchestration::checks {
namespace {

struct StockPort {
  int number;
  const char* role;
};
constexpr std::array<StockPort, 3> kStockPorts = {
    StockPort{6000, "players"}, StockPort{6001, "trainers"}, StockPort{6002, "coaches"}};

std::vector<Symptom> ask_all(const DoctorOptions& options, const std::atomic<int>& stop) {
  Symptom starting;
  starting.name = "processes";
  starting.purpose = "servers, run: and team: sides";
  starting.needed = true;
  const ScratchFolder scratch;
  auto host = process::ProcessHost::create();
  if (!host || scratch.path().empty()) {
    starting.health = Health::kWrong;
    starting.found = host ? "no folder for their files can be created" : host.error().message;
    starting.remedy = host ? "make room where TMPDIR points to" : "raise the limit: ulimit -u";
    return {starting};
  }
  const std::vector<ProgramExamination> examinations = {
      soccer_server_program(scratch.path()), python(), node(), protobuf_compiler(), slurm()};
  std::vector<ProgramQuestion> questions = {{"/bin/sh", {"-c", "exit 0"}, {}, {}}};
  for (const ProgramExamination& each : examinations) questions.push_back(each.question);
  const auto answers = ask_programs(*host, questions, options.limit, stop);
  starting.found = "can be started and ended";
  if (!answers.front().ended_well()) {
    starting.health = Health::kWrong;
    starting.found = "/bin/sh could not be started, or did not end";
    starting.remedy = "see what the machine is busy with, and its limits: ulimit -a";
  }
  std::vector<Symptom> symptoms = {starting};
  for (std::size_t i = 0; i < examinations.size(); ++i) {
    symptoms.push_back(examinations[i].judge(answers[i + 1]));
  }
  return symptoms;
}

}  // namespace

Diagnosis examine(const DoctorOptions& options,
                  const std::function<void(const Symptom&)>& on_symptom,
                  const std::atomic<int>& stop) {
  Diagnosis diagnosis;
  const auto tell = [&](Symptom symptom) {
    diagnosis.symptoms.push_back(std::move(symptom));
    on_symptom(diagnosis.symptoms.back());
  };
  tell(own_program());
  tell(processors());
  tell(memory());
  tell(working_folder(std::filesystem::current_path()));
  for (const StockPort& port : kStockPorts) tell(udp_port(port.number, port.role));
  for (Symptom& symptom : ask_all(options, stop)) tell(std::move(symptom));
  if (options.server && stop.load() == 0) {
    tell(probe_server(*options.server, options.own_program, options.limit, stop));
  }
  if (options.playmaker && stop.load() == 0) {
    tell(probe_playmaker(*options.playmaker, options.limit, stop));
  }
  return diagnosis;
}

}  // namespace cls::orchestration::checks
