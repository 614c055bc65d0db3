// What CI systems are handed: a JUnit report, annotations of GitHub Actions.
#pragma once

#include <string>

#include "cli/support/exit_code.h"

namespace CLI {
class App;
}

namespace cls::cli {

struct CiReports {
  std::string junit;    ///< file; empty: none
  bool github = false;  ///< asked for; in GitHub Actions they come by themselves
};

/// --junit FILE and --github.
void add_ci_options(CLI::App& command, CiReports& reports);

/// Writes what is wanted; an error is told. kDone or kCannotCreate.
ExitCode hand_out(const CiReports& reports, const std::string& junit,
                  const std::string& annotations);

}  // namespace cls::cli
