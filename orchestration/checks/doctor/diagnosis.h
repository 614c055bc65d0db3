// What `cls doctor` finds, as plain data.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace cls::orchestration::checks {

enum class Health {
  kOk,
  kMissing,      ///< not here; `remedy` gets it
  kTaken,        ///< a port that somebody has
  kWrong,        ///< here, but not as it should be
  kUnreachable,  ///< nobody there, refused, or no answer in time
};

std::string_view name(Health health);

/// One thing that was looked at.
struct Symptom {
  std::string name;  ///< "rcssserver", "UDP port 6000"
  Health health = Health::kOk;
  std::string found;    ///< what was seen, one line
  std::string version;  ///< where it has one
  std::string path;     ///< where it is a file
  std::string purpose;  ///< what it is for
  std::string remedy;   ///< what to type or do; empty when nothing is wrong
  bool needed = false;  ///< without it cls cannot play, or the user asked for it
};

struct Diagnosis {
  std::vector<Symptom> symptoms;

  /// Everything that is needed is in order.
  bool healthy() const;
  /// Something that is needed cannot be reached.
  bool unreachable() const;
};

/// `"schema": "cls.doctor/1"`, with a line feed at its end.
std::string to_json(const Diagnosis& diagnosis);

/// "apt-get install PACKAGES", by sudo for those who are not root.
std::string install_command(std::string_view packages);

}  // namespace cls::orchestration::checks
