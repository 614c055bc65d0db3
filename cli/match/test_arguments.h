// The arguments of `cls test`, and what it does besides playing scenarios.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/support/ci_reports.h"
#include "match/terms/match_options.h"

namespace cls::cli {

struct TestArguments {
  match::TlsFileNames tls;
  std::vector<std::string> scenarios;
  std::string filter;
  std::string shard;
  int jobs = 0;
  std::optional<std::uint64_t> seed;
  std::string against;
  std::string folder = "runs/test";
  std::string export_folder;
  std::string replay;
  std::string side;
  std::optional<int> at;
  std::optional<int> player;
  bool json = false;
  std::optional<double> start_timeout_s;
  bool list = false;
  std::string sandbox = "true";
  bool sandbox_playmakers = false;
  bool accept_golden = false;
  bool quiet = false;
  bool force = false;
  bool strict = false;
  CiReports reports;
};

/// Seconds that Playmakers get to start: of the option, else of cls.toml; none: the default.
std::optional<double> start_timeout(const TestArguments& arguments);

/// `cls test --replay FILE ENDPOINT`: compares the replies of a Playmaker with a recording. Prints
/// the differences; returns the exit code.
int replay_recording(const TestArguments& arguments);

/// `cls test --export DIR`: writes copies of the shipped scenarios as templates; edited ones are
/// the user's. Returns the exit code.
int export_scenarios(const TestArguments& arguments);

}  // namespace cls::cli
