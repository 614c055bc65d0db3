// `cls doctor`: programs of others that matches, Playmakers and clusters need.
#pragma once

#include <filesystem>
#include <functional>
#include <vector>

#include "orchestration/checks/doctor/diagnosis.h"
#include "orchestration/checks/doctor/program_question.h"

namespace cls::orchestration::checks {

/// What a program is asked, and what its answer means.
struct ProgramExamination {
  ProgramQuestion question;
  std::function<Symptom(const ProgramAnswer&)> judge;
};

// rcssserver writes configuration files when it is asked: `scratch` is where.
ProgramExamination soccer_server_program(const std::filesystem::path& scratch);
/// With the packages of a Playmaker in Python.
ProgramExamination python();
/// With the packages of a Playmaker in JavaScript, as found from the working folder.
ProgramExamination node();
/// Makes the Python modules and C++ classes of proto/playmaker.proto.
ProgramExamination protobuf_compiler();
ProgramExamination slurm();

}  // namespace cls::orchestration::checks
