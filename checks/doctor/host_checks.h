// `cls doctor`: the host, without running other programs.
#pragma once

#include <filesystem>

#include "checks/doctor/doctor_report.h"

namespace cls::checks {

/// Version and path of cls.
DoctorCheck program_file();
/// Usable processor cores.
DoctorCheck processors();
DoctorCheck loopback();
/// Memory, from a file in the format of /proc/meminfo.
DoctorCheck memory(const std::filesystem::path& meminfo = "/proc/meminfo");
/// What separates the programs of external teams from this host, and from each other.
DoctorCheck sandbox();
/// Whether match folders can be written below this folder.
DoctorCheck working_folder(const std::filesystem::path& folder);
/// Whether the UDP port is free, otherwise its owner. `role`: its users, such as "players".
DoctorCheck udp_port(int port, const std::string& role);

}  // namespace cls::checks
