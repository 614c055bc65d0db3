// Options and output of CI reports.
#include "cli/support/ci_reports.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdlib>
#include <string_view>

#include "base/io/whole_file.h"

namespace cls::cli {
namespace {

bool runs_in_github_actions() {
  const char* actions = std::getenv("GITHUB_ACTIONS");
  return actions != nullptr && std::string_view(actions) == "true";
}

}  // namespace

void add_ci_options(CLI::App& command, CiReports& reports) {
  command.add_option("--junit", reports.junit, "write a JUnit report to FILE")->type_name("FILE");
  command.add_flag("--github", reports.github,
                   "print annotations on stderr (default in GitHub Actions: on)");
}

ExitCode write_ci_reports(const CiReports& reports, const std::string& junit,
                          const std::string& annotations) {
  if (reports.github || runs_in_github_actions()) fmt::print(stderr, "{}", annotations);
  if (reports.junit.empty()) return kOk;
  const auto written = base::write_file(reports.junit, junit);
  if (written) return kOk;
  fmt::print(stderr, "cls: {}\n", written.error().message);
  return kCannotCreate;
}

}  // namespace cls::cli
