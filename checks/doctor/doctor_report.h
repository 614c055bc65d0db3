// Report of `cls doctor`.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cls::checks {

enum class DoctorStatus {
  kOk,
  kMissing,      ///< not installed; `hint` says how to install it
  kTaken,        ///< port in use
  kWrong,        ///< present, but unusable
  kUnreachable,  ///< no listener, refused or timeout
};

std::string_view name(DoctorStatus status);

/// One item of the report.
struct DoctorCheck {
  std::string name;  ///< "rcssserver", "UDP port 6000"
  DoctorStatus status = DoctorStatus::kOk;
  std::string found = {};    ///< what was observed, one line
  std::string version = {};  ///< empty: none
  std::string path = {};     ///< empty: not a file
  std::string purpose = {};  ///< what it is needed for
  std::string hint = {};     ///< what to do about it; empty if ok
  bool needed = false;       ///< required for playing, or requested by the user
};

struct DoctorReport {
  std::vector<DoctorCheck> checks;

  /// All required items are ok.
  bool healthy() const;
  /// A required item is unreachable.
  bool unreachable() const;
};

/// `"schema": "cls.doctor/1"`, with a trailing newline.
std::string to_json(const DoctorReport& report);

/// "apt-get install PACKAGES", with sudo unless the user is root.
std::string install_command(std::string_view packages);

}  // namespace cls::checks
