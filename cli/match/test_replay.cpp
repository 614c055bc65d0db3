// `cls test --replay`: asks a Playmaker again what a recording has.
#include <fmt/format.h>

#include <atomic>
#include <cstddef>

#include "base/io/whole_file.h"
#include "cli/match/test_arguments.h"
#include "cli/support/interrupt.h"
#include "cli/support/print_error.h"
#include "cli/support/side_arguments.h"
#include "match/replay/rpc_replay.h"
#include "soccer/side.h"

namespace cls::cli {
namespace {

int resolve(const TestArguments& arguments, match::ReplayOptions& options) {
  if (arguments.scenarios.size() != 1) {
    return print_error(kUsage, "--replay FILE requires one ENDPOINT");
  }
  TRY_STEP(
      read_playmaker("--replay: ", arguments.scenarios.front(), arguments.tls, options.endpoint));

  options.file = arguments.replay;
  options.folder = arguments.folder;
  options.cycle = arguments.at;
  options.agent = arguments.player;
  if (const auto limit = start_timeout(arguments)) options.start_timeout_s = *limit;
  if (const auto absence = base::absence(options.file)) {
    return print_error(kNoInput, "{}: {}", options.file, *absence);
  }
  if (options.endpoint.starts_programs()) {
    TRY_OR(kCannotCreate, base::create_folders(options.folder));
  }

  options.side = soccer::parse_side(arguments.side);
  return kOk;
}

}  // namespace

int replay_recording(const TestArguments& arguments) {
  constexpr std::size_t kShownDifferences = 20;
  match::ReplayOptions options;
  TRY_STEP(resolve(arguments, options));

  const std::atomic<int>& signal = watch_interrupts();
  TRY_INIT_OR(kUnavailable, const auto result, match::replay_recording(options, signal));
  if (!result.file_error.empty()) return print_error(kBadData, result.file_error);

  fmt::print("{}", arguments.json ? to_json(result) : to_text(result, kShownDifferences));
  if (result.interrupted) return signal_exit_code(signal);
  return result.passed() ? kOk : kFailed;
}

}  // namespace cls::cli
