// `cls doctor`: this machine, without asking any other program.
#pragma once

#include <filesystem>

#include "orchestration/checks/doctor/diagnosis.h"

namespace cls::orchestration::checks {

/// Which cls this is.
Symptom own_program();
/// Processors that may be used.
Symptom processors();
/// Working memory, from a file in the form of /proc/meminfo.
Symptom memory(const std::filesystem::path& meminfo = "/proc/meminfo");
/// Can matches be written below this folder?
Symptom working_folder(const std::filesystem::path& folder);
/// Is the UDP port free, and who has it if not? `role` says who uses it: "players".
Symptom udp_port(int port, const std::string& role);

}  // namespace cls::orchestration::checks
