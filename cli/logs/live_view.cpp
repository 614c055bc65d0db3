// Waits while threads of the viewer do the work.
#include "cli/logs/live_view.h"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <thread>
#include <utility>

#include "base/system/host.h"
#include "cli/support/browser.h"
#include "cli/terminal/terminal.h"
#include "viewer/live/live_site.h"

namespace cls::cli {
namespace {

using std::chrono::steady_clock;

constexpr std::chrono::milliseconds kViewPollInterval{50};
/// Time for connected readers to get the end of the match.
constexpr std::chrono::seconds kDrainTime{3};

bool has_terminal() { return ::isatty(STDIN_FILENO) == 1 && stderr_is_terminal(); }

}  // namespace

steady_clock::time_point end_of_linger(const std::optional<double>& linger_s) {
  if (!linger_s && has_terminal()) return steady_clock::time_point::max();
  const std::chrono::duration<double> linger(linger_s.value_or(0.0));
  return steady_clock::now() + std::chrono::duration_cast<steady_clock::duration>(linger);
}

void add_linger_option(Command& command, std::optional<double>& linger_s) {
  command
      .option("--linger", linger_s,
              "seconds that the page of a running match stays after the match "
              "(default: until Ctrl-C in a terminal, else 0)")
      .of_group(kOutputGroup)
      .from(0);
}

void add_host_name_option(Command& command, std::vector<std::string>& names) {
  command
      .option("--host-name", names,
              "names, A,B,..., under which browsers reach the page of a running match, such as\n"
              "those of tunnels, besides addresses and the name of this host")
      .placeholder("NAME")
      .split_at(',')
      .of_group(kOutputGroup);
}

viewer::HttpAccess access_for(const LiveViewOptions& options) {
  viewer::HttpAccess access;
  access.names = options.host_names;
  return access;
}

std::string tunnel_hint(const std::string& url) {
  const char* connection = std::getenv("SSH_CONNECTION");
  if (connection == nullptr || *connection == '\0') return "";

  const std::size_t port = url.find(':', url.find("//")) + 1;
  const std::string number = url.substr(port, url.find('/', port) - port);
  const std::string host = base::host_name();
  return fmt::format("ssh -L {0}:127.0.0.1:{0} {1}", number, host.empty() ? "HOST" : host);
}

base::Result<std::unique_ptr<LiveView>> LiveView::start(FollowedMatch match,
                                                        const LiveViewOptions& options) {
  std::unique_ptr<LiveView> view(new LiveView(options.linger_s));
  view->match_ =
      std::make_unique<viewer::LiveMatch>(std::move(match.input), std::move(match.text_log));
  TRY_INIT(auto server,
           viewer::HttpServer::start(
               options.address,
               viewer::live_site(match.title, options.settings, view->match_->feed(), match.folder),
               access_for(options)));

  view->server_ = std::move(server);
  if (options.open_browser) view->link_ = open_privately(view->server_->single_use_url());
  return view;
}

void LiveView::serve(const std::atomic<int>& signal) {
  while (!match_->over() && signal.load() == 0) std::this_thread::sleep_for(kViewPollInterval);
  if (signal.load() != 0) return;

  const auto end = end_of_linger(linger_s_);
  if (end == steady_clock::time_point::max()) {
    fmt::print(stderr, "cls: the match is over; Ctrl-C ends its page\n");
  }

  while (steady_clock::now() < end && signal.load() == 0) {
    std::this_thread::sleep_for(kViewPollInterval);
  }

  drain(signal);
}

void LiveView::drain(const std::atomic<int>& signal) const {
  const auto end = steady_clock::now() + kDrainTime;
  while (server_->streams() > 0 && steady_clock::now() < end && signal.load() == 0) {
    std::this_thread::sleep_for(kViewPollInterval);
  }
}

}  // namespace cls::cli
