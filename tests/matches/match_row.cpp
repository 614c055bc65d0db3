// Plays short matches in a row in one process, and prints after each what the process holds.
#include <malloc.h>
#include <unistd.h>

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <string>

#include "orchestration/match/match.h"
#include "orchestration/process/guard.h"

namespace {

namespace fs = std::filesystem;
using namespace cls::orchestration::match;

/// Memory that is handed out and not given back, of all arenas; what is resident also has holes.
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

/// Every second one over UDP with a server and a team that are programs, the others in lockstep
/// with a Playmaker that is one.
MatchOptions options_of(int index, char** words) {
  MatchOptions options;
  options.left = side("mock:hold");
  options.seed = static_cast<std::uint64_t>(index + 1);
  options.cycles = 10;
  options.server.kick_off_wait = 2;
  // How busy the machine is must not matter.
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
  const auto guard = Guard::start(argc, argv);
  if (!guard || argc != 6) return 2;
  const std::atomic<int> no_signal{0};
  const int count = std::atoi(argv[5]);
  for (int i = 0; i < count; ++i) {
    MatchObserver nobody;
    const MatchOptions options = options_of(i, argv + 1);
    const auto result = run_match(options, nobody, no_signal);
    if (!result || !result->valid()) {
      std::fprintf(stderr, "match %d: %s\n", i,
                   result ? result->message.c_str() : result.error().message.c_str());
      return 1;
    }
    // Logs of many matches need room; the processes' own files are what is looked at.
    fs::remove_all(options.folder);
    std::printf("%ld %ld %ld\n", kilobytes_in_use(), entries_of("/proc/self/fd"),
                entries_of("/proc/self/task"));
    std::fflush(stdout);
  }
  return 0;
}
