// The options of one match.
#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/result.h"
#include "match/terms/endpoint.h"
#include "match/terms/server_choice.h"
#include "match/terms/side_limits.h"
#include "process/command_plan.h"
#include "proxy/agent/debug_options.h"
#include "proxy/agent/on_late.h"
#include "proxy/playmaker/batch_mode.h"
#include "soccer/parameters/player_params.h"
#include "soccer/parameters/server_params.h"
#include "soccer/per_side.h"
#include "soccer/protocol/protocol_version.h"

namespace cls::analysis {
struct Book;
}
namespace cls::simulator {
struct MatchConfig;
}
namespace cls::player {
class FormationSet;
}
namespace cls::saved {
class SavedMatch;
}

namespace cls::match {

/// Parameters of the embedded server for `cls match`: those of rcssserver, but a level match ends
/// after normal time (server::nr_extra_halfs 0, server::penalty_shoot_outs off).
soccer::ServerParams match_server_params();

/// Names of PEM files for tls:HOST:PORT; empty: not used.
struct TlsFileNames {
  std::string authorities;
  std::string certificate;
  std::string key;
  std::string server_name;  ///< expected in the Playmaker's certificate
};

/// What separates the programs of `team:` sides from the rest of this host (docs/security.md).
enum class Sandbox {
  kOff,
  kFiles,       ///< they use their own files only
  kOn,          ///< and have namespaces of their own, where this host can make them
  kNamespaces,  ///< the match needs them
};

std::string_view name(Sandbox sandbox);
base::Result<Sandbox> parse_sandbox(std::string_view text);

/// Defaults are those of `cls match`. option_table.h has a row for each member that users set.
struct MatchOptions {
  Endpoint left;
  Endpoint right;
  soccer::PerSide<std::string> names;  ///< empty: from the endpoint
  bool own_names = false;              ///< external teams may play under other names
  bool rated = false;                  ///< policies trained with the full state are refused

  std::optional<std::uint64_t> seed;  ///< none: random, reported
  std::optional<int> cycles;          ///< end of the match in game time; with a book see below
  std::optional<int> adjudicate;      ///< lead that ends the match
  std::string book;                   ///< file of situations that are played instead of a match
  int situations = 8;                 ///< of the book
  std::shared_ptr<const analysis::Book> loaded_book;  ///< see load_book()
  soccer::ServerParams server = match_server_params();
  soccer::PlayerParams player;

  ServerChoice server_choice;
  std::optional<MatchMode> mode;    ///< none: see mode_of()
  bool coach = true;                ///< each cls team connects an online coach
  std::optional<Endpoint> trainer;  ///< whose Playmaker handles GetTrainerActions
  /// Processor cores of the programs and agents of a side, see pin_sides(); empty: all.
  soccer::PerSide<std::vector<int>> cpus;
  Sandbox sandbox = Sandbox::kOn;   ///< of `team:` sides
  bool sandbox_playmakers = false;  ///< programs of `run:` sides too have namespaces of their own
  bool bind_clients = true;         ///< players and coaches of a side come from its own programs
  process::ResourceLimits limits;   ///< of each process that a `run:` or `team:` side starts
  SideLimits side_limits;           ///< of all processes of a side in a sandbox

  bool pin = false;  ///< pin_sides() chooses the cores
  TlsFileNames tls;

  /// Home positions of cls agents; null: the built-in formations.
  soccer::PerSide<std::shared_ptr<const player::FormationSet>> formations;
  std::string formation;                         ///< the folder of those of both sides
  soccer::PerSide<std::string> side_formations;  ///< the folders of those of one side

  std::filesystem::path record_rpc;  ///< file for all requests and replies; empty: none
  bool record_world_models = false;  ///< what agents estimate, for the decision debugger
  bool record_choices = false;       ///< with the ball, for programs that learn them
  std::optional<int> save_at;        ///< game time at which `save_file` is written
  std::filesystem::path save_file;
  std::filesystem::path resume;                      ///< file of the match to continue
  std::shared_ptr<const saved::SavedMatch> resumed;  ///< what it holds; see resume_from()
  /// With `resumed`: of the random draws after the saved step; none: those of the match.
  std::optional<std::uint64_t> branch_seed;
  std::filesystem::path folder;  ///< empty: ./runs/<UTC>-<left>-vs-<right>
  bool replace = false;          ///< existing `folder` and `record_rpc` become NAME.old

  proxy::DebugOptions debug;  ///< for soccerwindow2

  int protocol = soccer::kDefaultProtocolVersion;  ///< of cls agents, 14 to 19
  std::optional<int> rpc_deadline_ms;  ///< none: depends on the mode, see decision_deadline()
  bool no_deadline = false;
  proxy::OnLate on_late = proxy::OnLate::kHold;
  proxy::BatchMode batch = proxy::BatchMode::kAuto;  ///< one call per team and cycle
  int max_missed = 20;                               ///< missed decisions of one player in a row
  double start_timeout_s = 20.0;       ///< until both teams have joined and registered
  double reconnect_within_s = 3.0;     ///< for a lost Playmaker to come back: proxy::DecisionLimits
  double stall_after_s = 10.0;         ///< without a new cycle
  std::optional<double> time_limit_s;  ///< for the whole match

  std::optional<int> monitor_port;  ///< where monitors connect on loopback; 0: a free one
  std::optional<double> speed;      ///< limit in multiples of real time; none: no limit
  bool step = false;                ///< hooks may hold the match: MatchHooks::before_decisions

  std::vector<std::string> command_line;  ///< for manifest.json
};

/// The endpoint of a side; the trainer, which there must be, for the neutral one.
const Endpoint& endpoint_of(const MatchOptions& options, soccer::Side side);

/// True if a side has a Playmaker, and if a side is an external team.
bool has_agents(const MatchOptions& options);
bool has_external_team(const MatchOptions& options);

/// Sets a parameter from `server::NAME=VALUE` or `player::NAME=VALUE`.
base::Result<void> apply_setting(MatchOptions& options, std::string_view setting);

/// Gives each side half of the processor cores that this process may use. An error if there is only
/// one.
base::Result<void> pin_sides(MatchOptions& options);

/// The server parameters of the match: those of the options, and server::coach_w_referee for a
/// trainer, unless server::coach is on.
soccer::ServerParams server_params(const MatchOptions& options);

/// The mode of the options; by default lockstep, or synch with an external server or team.
MatchMode mode_of(const MatchOptions& options);

/// Default deadline of a decision in real time, where a cycle lasts 100 ms.
inline constexpr std::chrono::milliseconds kRealtimeDeadline{70};

/// Deadline of a Playmaker's decision; nothing: none. By default 10 s in lockstep, 1 s in synch
/// mode (rcssserver continues after 1.25 s), kRealtimeDeadline in real time.
std::optional<std::chrono::milliseconds> decision_deadline(const MatchOptions& options);

/// A match limit and the deadline of a call never expire together: the call gets this much more.
inline constexpr std::chrono::milliseconds kMatchLimitMargin{1000};

/// Timeout of a decision's calls: the decision deadline, unless the stall limit is as short. Then
/// the stall limit alone decides.
std::optional<std::chrono::milliseconds> reply_timeout(const MatchOptions& options);

/// Cycles of each situation of a book.
inline constexpr int kDefaultSituationCycles = 50;
int situation_cycles(const MatchOptions& options);

/// Reads the book of the options, if they name one. The error names file and line.
base::Result<void> load_book(MatchOptions& options);

/// The configuration of the embedded server.
simulator::MatchConfig server_config(const MatchOptions& options, std::uint64_t seed);

/// Every invalid combination of values, one line each; empty: valid. The ranges of single values
/// are those of option_table.h.
std::vector<std::string> validate_options(const MatchOptions& options);

}  // namespace cls::match
