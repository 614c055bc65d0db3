// Reports for CI systems: JUnit file, annotations and summary of GitHub Actions.
#pragma once

#include <string>

#include "cli/command/command.h"
#include "cli/terminal/exit_code.h"

namespace cls::cli {

struct CiReports {
  std::string junit;    ///< file; empty: none
  bool github = false;  ///< annotations; always on in GitHub Actions
};

/// --junit FILE and --github.
void add_ci_options(Command& command, CiReports& reports);

/// The same results in each format.
struct CiTexts {
  std::string junit;
  std::string annotations;
  std::string summary = {};  ///< Markdown for the summary of a job of GitHub Actions; empty: none
};

/// Writes the requested reports; prints an error. Returns kOk or kCannotCreate.
ExitCode write_ci_reports(const CiReports& reports, const CiTexts& texts);

}  // namespace cls::cli
