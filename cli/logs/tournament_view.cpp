// Waits while the server's thread serves the site.
#include "cli/logs/tournament_view.h"

#include <fmt/format.h>

#include <chrono>
#include <thread>

#include "cli/support/browser.h"
#include "cli/support/interrupt.h"
#include "cli/support/print_error.h"
#include "cli/terminal/exit_code.h"
#include "tournament/site/tournament_site.h"
#include "tournament/store/folder.h"

namespace cls::cli {
namespace {

namespace fs = std::filesystem;

constexpr std::chrono::milliseconds kTournamentPollInterval{200};

// Without a running `cls tournament run`, too.
bool is_over(const fs::path& folder) {
  const auto state = tournament::read_tournament(folder);
  return !state || state->running.empty();
}

}  // namespace

int serve_tournament(const fs::path& folder, const LiveViewOptions& options,
                     const std::function<void(const std::string& url)>& on_start) {
  // Without a terminal the page of a tournament that is over would end before anyone sees it.
  const auto earliest_end = end_of_linger(options.linger_s);
  if (is_over(folder) && earliest_end <= std::chrono::steady_clock::now()) {
    return print_error(
        kUsage, fmt::format("{0}: no match is played now; --linger SECONDS serves the list of its "
                            "matches, cls tournament report {0} --format html --out FILE writes it",
                            folder.string()));
  }

  const std::atomic<int>& signal = watch_interrupts();
  const auto site = tournament::TournamentSite::open(fs::canonical(folder),
                                                     {.reader = tournament::Reader::kOrganizer});
  if (!site) return print_error(kBadData, site.error().message);
  const auto server = viewer::HttpServer::start(
      options.address,
      [&site](std::string_view path, std::string_view query) {
        return (*site)->reply(path, query);
      },
      access_for(options));
  if (!server) return print_error(kTryAgain, server.error().message);

  on_start((*server)->url());
  std::unique_ptr<process::ScratchFolder> link;
  if (options.open_browser) link = open_privately((*server)->single_use_url());

  while (signal.load() == 0 && !is_over(folder))
    std::this_thread::sleep_for(10 * kTournamentPollInterval);
  const auto end = end_of_linger(options.linger_s);
  while (signal.load() == 0 && std::chrono::steady_clock::now() < end) {
    std::this_thread::sleep_for(kTournamentPollInterval);
  }

  return kOk;
}

}  // namespace cls::cli
