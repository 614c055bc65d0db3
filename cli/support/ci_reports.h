// Reports for CI systems: JUnit file and GitHub Actions annotations.
#pragma once

#include <string>

#include "cli/support/exit_code.h"

namespace CLI {
class App;
}

namespace cls::cli {

struct CiReports {
  std::string junit;    ///< file; empty: none
  bool github = false;  ///< annotations; always on in GitHub Actions
};

/// --junit FILE and --github.
void add_ci_options(CLI::App& command, CiReports& reports);

/// Writes the requested reports; prints an error. Returns kOk or kCannotCreate.
ExitCode write_ci_reports(const CiReports& reports, const std::string& junit,
                          const std::string& annotations);

}  // namespace cls::cli
