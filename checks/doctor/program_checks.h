// `cls doctor`: external programs for matches, Playmakers and clusters.
#pragma once

#include <filesystem>
#include <functional>

#include "checks/doctor/doctor_report.h"
#include "checks/doctor/program_run.h"

namespace cls::checks {

/// A program run and the evaluation of its output.
struct ProgramCheck {
  ProgramRun question;
  std::function<DoctorCheck(const ProgramOutput&)> evaluate;
};

/// rcssserver writes configuration files even with --help: `scratch` is their folder.
ProgramCheck soccer_server_program(const std::filesystem::path& scratch);
/// Python with the packages of a Playmaker.
ProgramCheck python();
/// Node.js with the packages of a Playmaker, as found from the working folder.
ProgramCheck node();
/// The compiler of proto/playmaker.proto for Python and C++.
ProgramCheck protobuf_compiler();
ProgramCheck slurm();

}  // namespace cls::checks
