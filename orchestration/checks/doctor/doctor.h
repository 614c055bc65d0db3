// `cls doctor`: what is here, what is missing, and what gets it.
#pragma once

#include <atomic>
#include <chrono>
#include <functional>
#include <optional>
#include <string>

#include "orchestration/checks/doctor/diagnosis.h"
#include "orchestration/match/options/endpoint.h"
#include "orchestration/match/options/server_choice.h"

namespace cls::orchestration::checks {

struct DoctorOptions {
  std::optional<match::ServerChoice> server;  ///< to be tried
  std::optional<match::Endpoint> playmaker;   ///< to be tried; not a team
  std::chrono::milliseconds limit{5'000};
  std::string own_program;  ///< path of this binary, for the embedded server
};

/// Looks at machine and programs, then tries what the options name. Programs are asked all at
/// once; each, and each probe, has `limit` to answer, and nothing of them is left. `on_symptom` is
/// told each in its turn. `stop` nonzero leaves out what has not begun.
Diagnosis examine(const DoctorOptions& options,
                  const std::function<void(const Symptom&)>& on_symptom,
                  const std::atomic<int>& stop);

}  // namespace cls::orchestration::checks
