// Serves the page of a match that is played now, for `cls watch` and `cls match --watch`.
#pragma once

#include <atomic>
#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "cli/command/command.h"
#include "process/scratch_folder.h"
#include "viewer/live/http_server.h"
#include "viewer/live/live_match.h"
#include "viewer/page/page.h"

namespace cls::cli {

/// A match that is played now.
struct FollowedMatch {
  std::unique_ptr<viewer::LiveInput> input;
  std::filesystem::path text_log;  ///< of the same match; may not exist
  std::string title;               ///< what the page is called until the teams are known
  std::filesystem::path folder;    ///< with the drawings of the Playmakers; empty: none
};

struct LiveViewOptions {
  viewer::HttpAddress address;
  viewer::PageSettings settings;
  std::vector<std::string> host_names;  ///< under which browsers reach the page, of tunnels
  bool open_browser = false;
  /// Seconds that the page stays after the match; none: until a signal if a terminal is attached,
  /// so that no script waits for Ctrl-C.
  std::optional<double> linger_s;
};

/// A match and the server of its page. Reads the match only.
class LiveView {
 public:
  static base::Result<std::unique_ptr<LiveView>> start(FollowedMatch match,
                                                       const LiveViewOptions& options);

  std::string url() const { return server_->url(); }

  /// Waits until the match is over and its page has been there as long as the options say, or
  /// until a signal. Readers that are connected get the end of the match in any case.
  void serve(const std::atomic<int>& signal);

 private:
  explicit LiveView(std::optional<double> linger_s) : linger_s_(linger_s) {}
  void drain(const std::atomic<int>& signal) const;

  std::optional<double> linger_s_;
  std::unique_ptr<viewer::LiveMatch> match_;
  std::unique_ptr<viewer::HttpServer> server_;
  std::unique_ptr<process::ScratchFolder> link_;  ///< that the browser has opened; null: none
};

/// When a page that is over ends; never if a terminal is attached and `linger_s` does not say.
std::chrono::steady_clock::time_point end_of_linger(const std::optional<double>& linger_s);

/// `--linger SECONDS`
void add_linger_option(Command& command, std::optional<double>& linger_s);

/// `--host-name NAME,...`
void add_host_name_option(Command& command, std::vector<std::string>& names);

/// The access of a page that only those read who know its address.
viewer::HttpAccess access_for(const LiveViewOptions& options);

/// The line for a user on another host, "ssh -L ..."; empty without an ssh connection.
std::string tunnel_hint(const std::string& url);

}  // namespace cls::cli
