// A match without threads, sockets and files, for browsers and Node.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "analysis/situations/book.h"
#include "base/result.h"
#include "match/hooks/decision_stream.h"
#include "match/hooks/situation_play.h"
#include "mock-server/service/request_handler.h"
#include "playground/log_buffer.h"
#include "playground/setup.h"
#include "playground/viewer_stream.h"
#include "proxy/agent/team.h"
#include "proxy/playmaker/direct_playmaker.h"
#include "simulator/server/lockstep_server.h"
#include "soccer/per_side.h"

namespace cls::playground {

/// Missed decisions of one player in a row that a match accepts, as `cls match` does by default.
inline constexpr int kMaxMissed = 20;

/// Decisions of the teams that are functions; of other sides unused.
using Functions = soccer::PerSide<proxy::FallibleHandler>;

/// Plays what `cls match` plays with the same sides, names, seed, cycles, settings and situations:
/// game log and text log have the same bytes. All code runs on the caller's thread.
class Match {
 public:
  /// Both teams are connected and registered. The error names the member of the setup that is
  /// wrong, or the team and the call that failed.
  static base::Result<std::unique_ptr<Match>> create(const MatchSetup& setup,
                                                     Functions functions = {});

  /// Plays up to `steps` steps of the simulator; false once the match is over. Its logs are
  /// complete then, and later calls change nothing.
  bool play(int steps);

  /// The bytes since the last call: of the game log (rcg), of the text log (rcl), and of the stream
  /// of the viewer (docs/formats/view.md), if the setup asks for it.
  std::string take_game_log() { return game_log_.take(); }
  std::string take_text_log() { return text_log_.take(); }
  std::string take_view();
  /// The bytes since the last call of the stream of a side's decisions (docs/formats/decisions.md),
  /// if the setup asks for it.
  std::string take_decisions(soccer::Side side);

  bool over() const { return over_; }
  /// Why a team could not play on; empty: none.
  const std::string& failure() const { return failure_; }
  const simulator::World& world() const { return server_->world(); }
  /// Lines about the teams since the last call, each with the name of its team.
  std::vector<std::string> take_warnings();

 private:
  /// A team and who decides for it.
  struct TeamSide {
    std::unique_ptr<mock_server::Behavior> behavior;  ///< of a mock
    std::unique_ptr<mock_server::RequestHandler> mock;
    std::unique_ptr<proxy::Playmaker> playmaker;
    std::unique_ptr<proxy::Team> team;
    std::unique_ptr<match::DecisionStream> decisions;  ///< null: not recorded
    std::string decision_bytes;                        ///< not taken yet
  };

  explicit Match(bool with_view) : with_view_(with_view) {}

  base::Result<void> open_server(const MatchSetup& setup);
  base::Result<void> add_team(soccer::Side side, const MatchSetup& setup, const std::string& name,
                              proxy::FallibleHandler function);
  base::Result<void> connect(soccer::Side side);
  void begin_situations(const MatchSetup& setup);
  void play_step();
  bool is_over() const;
  void end_team(TeamSide& side);
  void finish();

  bool with_view_;
  ViewerStream view_;
  LogBuffer game_log_;
  LogBuffer text_log_;
  std::unique_ptr<simulator::LockstepServer> server_;
  soccer::PerSide<TeamSide> sides_;
  std::shared_ptr<const analysis::Book> book_;
  std::optional<match::SituationPlay> situations_;  ///< of the book
  std::string failure_;
  bool over_ = false;
};

}  // namespace cls::playground
