// Options for CI, and where their reports go.
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
  command.add_option("--junit", reports.junit, "write a JUnit report");
  command.add_flag("--github", reports.github,
                   "annotations on stderr (on by itself in GitHub Actions)");
}

ExitCode hand_out(const CiReports& reports, const std::string& junit,
                  const std::string& annotations) {
  if (reports.github || runs_in_github_actions()) fmt::print(stderr, "{}", annotations);
  if (reports.junit.empty()) return kDone;
  const auto written = base::write_file(reports.junit, junit);
  if (written) return kDone;
  fmt::print(stderr, "cls: {}\n", written.error().message);
  return kCannotCreate;
}

}  // namespace cls::cli
