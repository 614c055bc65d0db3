// Plays short matches in sequence in one process and prints its resources after each.
#include <malloc.h>
#include <unistd.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <string>

#include "match/run_match.h"
#include "process/guard.h"

namespace {

namespace fs = std::filesystem;
using namespace cls::match;

/// Allocated memory of all arenas; resident memory would include fragmentation.
long kilobytes_in_use() {
  const auto info = ::mallinfo2();
  return static_cast<long>((info.uordblks + info.hblkhd) / 1024);
}

long entries_of(const char* folder) {
  return static_cast<long>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

Endpoint side(const std::string& text) {
  const auto parsed = parse_endpoint(text);
  if (parsed) return *parsed;
  std::fprintf(stderr, "%s\n", parsed.error().message.c_str());
  std::exit(2);
}

/// Every second match over UDP with an external server and team, the others in lockstep with a
/// `run:` Playmaker.
MatchOptions options_of(int index, char** words) {
  MatchOptions options;
  options.left = side("mock:hold");
  options.seed = static_cast<std::uint64_t>(index + 1);
  options.cycles = 10;
  options.server.kick_off_wait = 2;
  // Independent of the load of the host.
  options.start_timeout_s = 300;
  options.stall_after_s = 300;
  options.folder = fs::path(words[0]) / std::to_string(index);
  if (index % 2 == 0) {
    options.right = side(words[1]);
    return options;
  }
  options.right = side(words[2]);
  options.server_choice = *parse_server(words[3]);
  return options;
}

}  // namespace

// FOLDER RUN-SIDE TEAM-SIDE SERVER COUNT
int main(int argc, char** argv) {
  const auto guard = cls::process::Guard::start(argc, argv);
  if (!guard || argc != 6) return 2;
  const std::atomic<int> no_signal{0};
  const int count = std::atoi(argv[5]);

  for (int i = 0; i < count; ++i) {
    MatchObserver no_observer;
    const MatchOptions options = options_of(i, argv + 1);
    const auto result = run_match(options, no_observer, no_signal);
    if (!result || !result->valid()) {
      std::fprintf(stderr, "match %d: %s\n", i,
                   result ? result->message.c_str() : result.error().message.c_str());
      return 1;
    }
    // Logs of many matches need disk space; the test checks only open files of the process.
    fs::remove_all(options.folder);
    std::printf("%ld %ld %ld\n", kilobytes_in_use(), entries_of("/proc/self/fd"),
                entries_of("/proc/self/task"));
    std::fflush(stdout);
  }

  return 0;
}
