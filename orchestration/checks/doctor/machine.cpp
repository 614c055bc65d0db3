// Asking the operating system.
#include "orchestration/checks/doctor/machine.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdint>
#include <fstream>
#include <map>
#include <string>
#include <system_error>

#include "base/system/host.h"
#include "base/system/version.h"
#include "orchestration/process/ports.h"

namespace cls::orchestration::checks {
namespace {

namespace fs = std::filesystem;

// A whole match in lockstep writes about 10 MB, its programs' logs 10 MB each at most.
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

Symptom own_program() {
  Symptom symptom;
  symptom.name = "cls";
  symptom.purpose = "this program";
  symptom.version = base::kVersion;
  std::error_code code;
  symptom.path = fs::read_symlink("/proc/self/exe", code).string();
  symptom.found = fmt::format("{}, wire {}, {}", base::kVersion, base::kWireVersion, symptom.path);
  return symptom;
}

Symptom processors() {
  Symptom symptom;
  symptom.name = "processors";
  symptom.purpose = "matches at once; --pin needs two";
  symptom.found = fmt::format("{} to use, of {}; {} physical cores; load {:.1f}",
                              base::allowed_processors().size(), ::sysconf(_SC_NPROCESSORS_ONLN),
                              base::usable_cores(), base::load_average());
  return symptom;
}

Symptom memory(const fs::path& meminfo) {
  Symptom symptom;
  symptom.name = "memory";
  symptom.purpose = "a match of two mocks takes about 0.1 GB";
  const auto lines = memory_lines(meminfo);
  const auto total = lines.find("MemTotal:");
  const auto available = lines.find("MemAvailable:");
  if (total == lines.end() || available == lines.end()) {
    symptom.found = fmt::format("unknown: {} does not tell", meminfo.string());
    return symptom;
  }
  symptom.found =
      fmt::format("{} of {} free", gigabytes(available->second), gigabytes(total->second));
  return symptom;
}

Symptom working_folder(const fs::path& folder) {
  Symptom symptom;
  symptom.name = "folder";
  symptom.purpose = "match folders are made in ./runs";
  symptom.needed = true;
  symptom.path = folder.string();
  std::error_code code;
  const fs::path runs = folder / "runs";
  const fs::path written = fs::exists(runs, code) ? runs : folder;
  if (::access(written.c_str(), W_OK | X_OK) != 0) {
    symptom.health = Health::kWrong;
    symptom.found = fmt::format("{}: {}", written.string(),
                                std::error_code(errno, std::generic_category()).message());
    symptom.remedy = "go to a folder that you may write, or name one: --dir DIR";
    return symptom;
  }
  const fs::space_info space = fs::space(written, code);
  const double available = code ? 0.0 : static_cast<double>(space.available);
  symptom.found = fmt::format("{}, {} free", written.string(), gigabytes(available));
  if (!code && space.available < kRoomForMatches) {
    symptom.health = Health::kWrong;
    symptom.remedy = "make room, or name another folder: --dir DIR";
  }
  return symptom;
}

Symptom udp_port(int port, const std::string& role) {
  Symptom symptom;
  symptom.name = fmt::format("UDP port {}", port);
  symptom.purpose =
      fmt::format("{} of a server at its stock ports, which some team:DIR need", role);
  symptom.found = "free";
  if (process::port_is_free(process::Protocol::kUdp, port)) return symptom;
  symptom.health = Health::kTaken;
  symptom.found = process::port_taken_text(process::Protocol::kUdp, port);
  symptom.remedy = "end that process; other sides and servers get free ports from cls";
  return symptom;
}

}  // namespace cls::orchestration::checks
