// The routes of the page for spectators, and what they need of the tournament's folder.
#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <string_view>

#include "base/result.h"
#include "viewer/live/http_server.h"

namespace cls::tournament {

struct SpectatorOptions {
  /// What happens on the pitch is shown this much later.
  std::chrono::milliseconds delay{0};
  /// Memory for pages of replays. Readers may hold some more while they receive one.
  std::size_t max_replay_bytes = std::size_t{64} << 20;
};

/// Reads a tournament's folder, and writes nothing there. A thread of its own reads plan, results
/// and running matches once a second, when all are over while pages are asked for; requests get
/// what it has read.
/// Paths are "", "now", "match/INDEX/" and "match/INDEX/live" of matches that are played now or
/// have a log; no part of a path becomes a file name.
class SpectatorSite {
 public:
  /// The error says why the folder holds no tournament.
  static base::Result<std::unique_ptr<SpectatorSite>> open(const std::filesystem::path& folder,
                                                           const SpectatorOptions& options = {});
  ~SpectatorSite();
  SpectatorSite(const SpectatorSite&) = delete;
  SpectatorSite& operator=(const SpectatorSite&) = delete;

  /// Never waits for the folder.
  viewer::HttpReply reply(std::string_view path, std::string_view query);

 private:
  struct State;
  explicit SpectatorSite(std::unique_ptr<State> state);

  std::unique_ptr<State> state_;
};

}  // namespace cls::tournament
