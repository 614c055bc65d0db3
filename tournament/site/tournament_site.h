// The web site of a tournament: its routes, and what they need of the tournament's folder.
#pragma once

#include <chrono>
#include <filesystem>
#include <memory>
#include <string_view>

#include "base/result.h"
#include "viewer/live/http_server.h"

namespace cls::tournament {

enum class Reader {
  kOrganizer,  ///< sees all of it: states, failures, drawings of the Playmakers
  kSpectator,  ///< sees what is public (spectator_view.h)
};

struct SiteOptions {
  Reader reader = Reader::kSpectator;
  /// The delay with which play is shown.
  std::chrono::milliseconds delay{0};
  /// Memory for pages of replays. Readers may hold some more while they receive one.
  std::size_t max_replay_bytes = std::size_t{64} << 20;
};

/// Reads a tournament's folder, and writes nothing there. Paths are "", "match/INDEX/" and
/// "match/INDEX/live" of matches that are played now or have a log; no part of a path becomes a
/// file name.
///
/// Spectators have "now", too. For them a thread of its own reads plan, results and running matches
/// once a second, when all are over while pages are asked for; requests get what it has read.
/// Organizers also have "match/INDEX/drawings-left" and "-right"; their requests read the folder.
class TournamentSite {
 public:
  /// For spectators the error says why the folder holds no tournament; organizers get it as a page.
  static base::Result<std::unique_ptr<TournamentSite>> open(const std::filesystem::path& folder,
                                                            const SiteOptions& options = {});
  ~TournamentSite();
  TournamentSite(const TournamentSite&) = delete;
  TournamentSite& operator=(const TournamentSite&) = delete;

  viewer::HttpReply reply(std::string_view path, std::string_view query);

  /// How often the site has made its view of the tournament anew: once for each change.
  int views() const;

 private:
  struct State;
  explicit TournamentSite(std::unique_ptr<State> state);

  std::unique_ptr<State> state_;
};

}  // namespace cls::tournament
