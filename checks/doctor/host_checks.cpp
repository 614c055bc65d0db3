// Checks of the host: cls itself, processor cores, memory, disk, ports.
#include "checks/doctor/host_checks.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdint>
#include <fstream>
#include <map>
#include <string>
#include <system_error>

#include "base/system/host.h"
#include "base/system/own_program.h"
#include "base/system/version.h"
#include "process/ports.h"

namespace cls::checks {
namespace {

namespace fs = std::filesystem;

// A full lockstep match writes about 10 MB, and each program log at most 10 MB.
constexpr std::uintmax_t kRoomForMatches = 200u << 20;

std::string gigabytes(double bytes) { return fmt::format("{:.1f} GB", bytes / 1e9); }

// Lines "MemTotal:       24105000 kB", in bytes.
std::map<std::string, double> memory_lines(const fs::path& path) {
  std::map<std::string, double> lines;
  std::ifstream file(path);
  std::string name;
  for (double kilobytes = 0; file >> name >> kilobytes;) {
    lines[name] = kilobytes * 1024.0;
    std::getline(file, name);
  }
  return lines;
}

}  // namespace

DoctorCheck program_file() {
  DoctorCheck check;
  check.name = "cls";
  check.purpose = "this program";
  check.version = base::kVersion;
  if (const auto program = base::own_program()) check.path = program->string();
  check.found = fmt::format("{}, wire {}, {}", base::kVersion, base::kWireVersion, check.path);
  return check;
}

DoctorCheck processors() {
  DoctorCheck check;
  check.name = "processors";
  check.purpose = "parallel matches; --pin requires two";
  check.found = fmt::format("{} usable of {}; {} physical cores; load {:.1f}",
                            base::allowed_processors().size(), ::sysconf(_SC_NPROCESSORS_ONLN),
                            base::usable_cores(), base::load_average());
  return check;
}

DoctorCheck memory(const fs::path& meminfo) {
  DoctorCheck check;
  check.name = "memory";
  check.purpose = "a match of two mocks takes about 0.1 GB";

  const auto lines = memory_lines(meminfo);
  const auto total = lines.find("MemTotal:");
  const auto available = lines.find("MemAvailable:");
  if (total == lines.end() || available == lines.end()) {
    check.found = fmt::format("unknown: not in {}", meminfo.string());
    return check;
  }

  check.found =
      fmt::format("{} of {} free", gigabytes(available->second), gigabytes(total->second));
  return check;
}

DoctorCheck working_folder(const fs::path& folder) {
  DoctorCheck check;
  check.name = "folder";
  check.purpose = "match folders in ./runs";
  check.needed = true;
  check.path = folder.string();

  if (folder.empty()) {
    check.status = DoctorStatus::kWrong;
    check.found = "it does not exist any more";
    check.hint = "change to a folder that exists";
    return check;
  }

  std::error_code code;
  const fs::path runs = folder / "runs";
  const fs::path written = fs::exists(runs, code) ? runs : folder;
  if (::access(written.c_str(), W_OK | X_OK) != 0) {
    check.status = DoctorStatus::kWrong;
    check.found = fmt::format("{}: {}", written.string(),
                              std::error_code(errno, std::generic_category()).message());
    check.hint = "change to a writable folder, or use --dir DIR";
    return check;
  }

  const fs::space_info space = fs::space(written, code);
  const double available = code ? 0.0 : static_cast<double>(space.available);
  check.found = fmt::format("{}, {} free", written.string(), gigabytes(available));
  if (!code && space.available < kRoomForMatches) {
    check.status = DoctorStatus::kWrong;
    check.hint = "free disk space, or use --dir DIR";
  }

  return check;
}

DoctorCheck udp_port(int port, const std::string& role) {
  DoctorCheck check;
  check.name = fmt::format("UDP port {}", port);
  check.purpose =
      fmt::format("{} of a server at its default ports, which some team:DIR require", role);
  check.found = "free";

  if (process::port_is_free(process::Protocol::kUdp, port)) return check;

  check.status = DoctorStatus::kTaken;
  check.found = process::port_taken_text(process::Protocol::kUdp, port);
  check.hint = "stop that process; other sides and servers use free ports";
  return check;
}

}  // namespace cls::checks
