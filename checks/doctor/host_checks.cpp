// Checks of the host: cls itself, processor cores, memory, disk, ports.
#include "checks/doctor/host_checks.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <fstream>
#include <map>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "base/system/control_group.h"
#include "base/system/host.h"
#include "base/system/own_program.h"
#include "base/system/parallel.h"
#include "base/system/version.h"
#include "process/confinement.h"
#include "process/landlock.h"
#include "process/namespaces.h"
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
  const auto program = base::own_program();
  const std::string path = program ? program->string() : "";
  return {.name = "cls",
          .found = fmt::format("{}, wire {}, {}", base::kVersion, base::kWireVersion, path),
          .version = std::string(base::kVersion),
          .path = path,
          .purpose = "this program"};
}

DoctorCheck processors() {
  const auto quota = base::processor_quota();
  DoctorCheck check = {
      .name = "processors",
      .found = fmt::format("{} usable of {}; {}{} physical cores; load {:.1f}",
                           base::default_jobs(), ::sysconf(_SC_NPROCESSORS_ONLN),
                           quota ? fmt::format("quota of the control group {}; ", *quota) : "",
                           base::allowed_cores().size(), base::load_average()),
      .purpose = "parallel matches; --pin requires two"};
  if (const std::string busy = base::busy_host(); !busy.empty()) {
    check.hint = busy + ": measurements of times mean nothing now";
  }
  return check;
}

DoctorCheck loopback() {
  const std::string problem = process::loopback_problem(true);
  const std::size_t remedy = problem.find("; ");
  return {.name = "loopback",
          .status = problem.empty() ? DoctorStatus::kOk : DoctorStatus::kWrong,
          .found = problem.empty() ? "127.0.0.1" : problem.substr(0, remedy),
          .purpose = "programs of a match, which connect to 127.0.0.1",
          .hint = problem.empty() ? "" : problem.substr(remedy + 2),
          .needed = true};
}

DoctorCheck memory(const fs::path& meminfo) {
  const auto lines = memory_lines(meminfo);
  const auto total = lines.find("MemTotal:");
  const auto available = lines.find("MemAvailable:");
  const bool known = total != lines.end() && available != lines.end();

  return {.name = "memory",
          .found = known ? fmt::format("{} of {} free", gigabytes(available->second),
                                       gigabytes(total->second))
                         : fmt::format("unknown: not in {}", meminfo.string()),
          .purpose = "a match of two mocks takes about 0.1 GB"};
}

DoctorCheck sandbox() {
  DoctorCheck check = {.name = "sandbox", .purpose = "team:DIR sides; levels in docs/security.md"};
  const int landlock = process::landlock_version();
  std::vector<std::string> parts;
  if (landlock > 0) parts.push_back(fmt::format("files (Landlock {})", landlock));
  if (process::can_confine()) parts.emplace_back("processes (seccomp)");
  const std::string& missing = process::missing_namespaces();
  if (missing.empty()) parts.emplace_back("namespaces");
  check.found = parts.empty() ? "none" : fmt::format("{}", fmt::join(parts, ", "));
  if (missing.empty()) return check;

  check.status = DoctorStatus::kMissing;
  check.found += "; no namespaces: " + missing;
  check.hint = landlock > 0 ? "without namespaces teams share the network and shared memory"
                            : "run teams of others as another user or in a container";
  return check;
}

DoctorCheck working_folder(const fs::path& folder) {
  DoctorCheck check = {.name = "folder",
                       .path = folder.string(),
                       .purpose = "match folders in ./runs",
                       .needed = true};
  const auto wrong = [&check](std::string found, std::string hint) {
    check.status = DoctorStatus::kWrong;
    check.found = std::move(found);
    check.hint = std::move(hint);
    return check;
  };
  if (folder.empty()) return wrong("it does not exist any more", "change to a folder that exists");

  std::error_code code;
  const fs::path runs = folder / "runs";
  const fs::path written = fs::exists(runs, code) ? runs : folder;
  if (::access(written.c_str(), W_OK | X_OK) != 0) {
    const std::error_code denied(errno, std::generic_category());
    return wrong(fmt::format("{}: {}", written.string(), denied.message()),
                 "change to a writable folder, or use --dir DIR");
  }

  const fs::space_info space = fs::space(written, code);
  const double available = code ? 0.0 : static_cast<double>(space.available);
  check.found = fmt::format("{}, {} free", written.string(), gigabytes(available));
  const bool full = !code && space.available < kRoomForMatches;
  return full ? wrong(check.found, "free disk space, or use --dir DIR") : check;
}

DoctorCheck udp_port(int port, const std::string& role) {
  const bool free = process::port_is_free(process::Protocol::kUdp, port);
  return {.name = fmt::format("UDP port {}", port),
          .status = free ? DoctorStatus::kOk : DoctorStatus::kTaken,
          .found = free ? "free" : process::port_taken_text(process::Protocol::kUdp, port),
          .purpose =
              fmt::format("{} of a server at its default ports, which some team:DIR require", role),
          .hint = free ? "" : "stop that process; other sides and servers use free ports"};
}

}  // namespace cls::checks
