// `cls tournament watch DIR`: the page for spectators.
#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <atomic>
#include <cctype>
#include <chrono>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "base/system/socket_address.h"
#include "base/text/json.h"
#include "cli/support/commands.h"
#include "cli/support/interrupt.h"
#include "cli/support/print_error.h"
#include "cli/terminal/json_stdout.h"
#include "cli/tournament/tournament_session.h"
#include "match/terms/endpoint.h"
#include "tournament/config/config.h"
#include "tournament/site/tournament_site.h"
#include "tournament/store/folder.h"
#include "viewer/live/http_server.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;
namespace tournament = tournament;
using std::chrono::milliseconds;

constexpr const char* kTournamentWatchDescription =
    "serve a page for spectators of a tournament: schedule, live, tables, replays\n"
    "\n"
    "  cls tournament watch cup                        http://127.0.0.1:8080/, for a\n"
    "                                                  reverse proxy on this host\n"
    "  cls tournament watch cup --listen 0.0.0.0       for everyone in the network\n"
    "  cls tournament watch cup --delay 30             30 s behind the matches\n"
    "  cls tournament watch cup --path /cup/ --host-name cup.example.org\n"
    "\n"
    "Everyone who reaches the address may read the page; no address of it changes\n"
    "anything. It runs beside 'cls tournament run', until Ctrl-C. docs/security.md\n"
    "says what it shows.";

constexpr int kDefaultPort = 8080;
constexpr int kDefaultConnections = 800;
constexpr double kMaxDelaySeconds = 86'400.0;
constexpr double kSafeDelaySeconds = 10.0;
/// File descriptors of the process besides those of connections.
constexpr int kOwnDescriptors = 100;
constexpr milliseconds kPollInterval{100};
constexpr int kNice = 10;
/// Memory of one reader: a piece, and twice the buffer in the kernel.
constexpr std::size_t kPiece = std::size_t{32} << 10;
constexpr int kSendBuffer = 64 << 10;
constexpr milliseconds kWriteTimeout{20'000};
constexpr milliseconds kFeedInterval{50};

struct TournamentWatchArguments {
  std::string folder;
  viewer::HttpAddress address{"127.0.0.1", kDefaultPort};
  std::string path = "/";
  std::vector<std::string> host_names;
  std::optional<double> delay_s;  ///< none: see delay_of()
  int max_connections = kDefaultConnections;
  bool json = false;
};

// "/cup/" of "cup", "/cup" and "/cup/".
std::string with_slashes(std::string path) {
  if (!path.starts_with('/')) path.insert(path.begin(), '/');
  if (!path.ends_with('/')) path += '/';
  return path;
}

bool is_plain_path(const std::string& path) {
  return std::ranges::all_of(path, [](unsigned char each) {
    return std::isalnum(each) != 0 || each == '/' || each == '-' || each == '_' || each == '.';
  });
}

// Each connection takes a descriptor. Returns how many there may be.
int allowed_connections(int wanted) {
  rlimit limit{};
  if (::getrlimit(RLIMIT_NOFILE, &limit) != 0) return wanted;
  limit.rlim_cur = limit.rlim_max;
  ::setrlimit(RLIMIT_NOFILE, &limit);
  const auto most = static_cast<double>(limit.rlim_cur) - kOwnDescriptors;
  return most < wanted ? std::max(1, static_cast<int>(most)) : wanted;
}

viewer::HttpAccess access_of(const TournamentWatchArguments& arguments) {
  viewer::HttpAccess access;
  access.open = true;
  access.prefix = with_slashes(arguments.path);
  access.names = arguments.host_names;
  access.max_connections = static_cast<std::size_t>(allowed_connections(arguments.max_connections));
  access.write_timeout = kWriteTimeout;
  access.feed_interval = kFeedInterval;
  access.piece = kPiece;
  access.send_buffer = kSendBuffer;
  return access;
}

void print_address(const std::string& url, bool json) {
  if (json) {
    print_json({{"schema", "cls.watch/1"}, {"url", url}});
  } else {
    fmt::print("{}\n", url);
  }
  std::fflush(stdout);
}

// True if a team is more than the built-in mock: its program may read pages during its match.
bool has_programs(const fs::path& folder) {
  const auto config = tournament::read_plan(folder);
  return config && std::ranges::any_of(config->competition.teams, [](const auto& team) {
           const auto endpoint = match::parse_endpoint(team.endpoint);
           return !endpoint || !endpoint->is_built_in();
         });
}

// The page shows where all are, which no program on the pitch may know: without --delay it is
// behind. Warns where it is not.
milliseconds delay_of(const TournamentWatchArguments& arguments, const fs::path& folder) {
  const bool programs = has_programs(folder);
  const double delay_s = arguments.delay_s.value_or(programs ? kSafeDelaySeconds : 0.0);
  if (programs && delay_s < kSafeDelaySeconds) {
    print_error(0,
                "warning: programs of teams that reach this address can read where all players "
                "are, {} s late; --delay {} is safe",
                delay_s, kSafeDelaySeconds);
  }
  return milliseconds(static_cast<int>(delay_s * 1000.0));
}

int run_tournament_watch(const TournamentWatchArguments& arguments) {
  if (!is_plain_path(arguments.path)) {
    return print_error(kUsage, "--path '{}': letters, digits and / - _ . only", arguments.path);
  }
  if (!base::parse_ip_address(arguments.address.host, 0)) {
    return print_error(kUsage, "--listen '{}': must be an IP address of this host",
                       arguments.address.host);
  }
  const std::string remedy = fmt::format("; 'cls tournament run {}' begins one", arguments.folder);
  TRY_STEP(check_tournament(arguments.folder, remedy));
  // A running match needs the processor cores more than those who watch it.
  ::setpriority(PRIO_PROCESS, 0, kNice);

  std::error_code code;
  fs::path folder = fs::canonical(arguments.folder, code);
  if (code) folder = arguments.folder;
  tournament::SiteOptions options;
  options.delay = delay_of(arguments, folder);
  TRY_INIT_OR(kBadData, const auto site, tournament::TournamentSite::open(folder, options));

  const std::atomic<int>& signal = watch_interrupts();
  const auto server = viewer::HttpServer::start(
      arguments.address,
      [site = site.get()](std::string_view path, std::string_view query) {
        return site->reply(path, query);
      },
      access_of(arguments));
  if (!server) {
    return print_error(kTryAgain, server.error().message + "; --port 0 selects a free port");
  }

  print_address((*server)->url(), arguments.json);
  while (signal.load() == 0) std::this_thread::sleep_for(kPollInterval);
  return kOk;
}

}  // namespace

void add_tournament_watch_command(Command& app) {
  auto [command, arguments] =
      app.command("watch", kTournamentWatchDescription, run_tournament_watch);
  command.option("DIR", arguments.folder, "folder of the tournament").required();
  command.option("--listen ADDRESS", arguments.address.host,
                 "IP address of the page (default: 127.0.0.1; 0.0.0.0: all of this host)");
  command.setting("--port", arguments.address.port, "its port; 0 selects a free one")
      .range(0, 65535);

  command.setting("--path", arguments.path,
                  "first part of all addresses, for a proxy that does not remove it");

  command
      .option("--host-name", arguments.host_names,
              "names, A,B,..., under which browsers reach the page, besides addresses\n"
              "and the name of this host")
      .placeholder("NAME")
      .split_at(',');

  command
      .option(
          "--delay", arguments.delay_s,
          fmt::format("seconds by which the page is behind the matches: no program on the\n"
                      "pitch profits from it (default: {} with teams that are programs, else 0)",
                      kSafeDelaySeconds))
      .range(0, kMaxDelaySeconds);

  command
      .setting("--max-connections", arguments.max_connections,
               "how many there may be; a browser needs one or two")
      .range(1, 100000);
  command.flag("--json", arguments.json, "print the address as one JSON document")
      .of_group(kOutputGroup);
}

}  // namespace cls::cli
