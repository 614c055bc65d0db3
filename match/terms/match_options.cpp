// Validation of match options, all in one place.
#include "match/terms/match_options.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>
#include <variant>

#include "analysis/situations/book_file.h"
#include "base/system/host.h"
#include "base/text/enum_names.h"
#include "match/terms/match_settings.h"
#include "mock-server/mock.h"
#include "mock-server/script/named_behaviors.h"
#include "simulator/server/lockstep_server.h"
#include "soccer/parameters/match_parameters.h"

namespace cls::match {

using base::Error;
using base::Result;

namespace {

constexpr auto kSandboxes = base::enum_names<Sandbox>("false", "files", "true", "namespaces");

}  // namespace

std::string_view name(Sandbox sandbox) { return kSandboxes.name(sandbox); }

Result<Sandbox> parse_sandbox(std::string_view text) {
  if (const auto sandbox = kSandboxes.parse(text)) return *sandbox;
  return Error{
      fmt::format("--sandbox '{}': must be {}", text, fmt::join(kSandboxes.texts, " or "))};
}

soccer::ServerParams match_server_params() { return soccer::match_server_params(); }

const Endpoint& endpoint_of(const MatchOptions& options, soccer::Side side) {
  if (side == soccer::Side::kNeutral) return *options.trainer;
  return side == soccer::Side::kLeft ? options.left : options.right;
}

bool has_agents(const MatchOptions& options) {
  return options.left.has_playmaker() || options.right.has_playmaker();
}

bool has_external_team(const MatchOptions& options) {
  return !options.left.has_playmaker() || !options.right.has_playmaker();
}

Result<void> apply_setting(MatchOptions& options, std::string_view setting) {
  return soccer::apply_setting(options.server, options.player, setting);
}

soccer::ServerParams server_params(const MatchOptions& options) {
  soccer::ServerParams params = options.server;
  if (options.trainer && !params.coach) params.coach_w_referee = true;
  return params;
}

MatchMode mode_of(const MatchOptions& options) {
  if (options.mode) return *options.mode;
  const bool embedded = options.server_choice.kind == ServerChoice::Kind::kEmbedded;
  if (embedded && !options.book.empty()) return MatchMode::kLockstep;
  return embedded && !has_external_team(options) ? MatchMode::kLockstep : MatchMode::kSynch;
}

std::optional<std::chrono::milliseconds> decision_deadline(const MatchOptions& options) {
  if (options.no_deadline) return std::nullopt;
  if (options.rpc_deadline_ms) return std::chrono::milliseconds(*options.rpc_deadline_ms);

  const MatchMode mode = mode_of(options);
  if (mode == MatchMode::kRealtime) return kRealtimeDeadline;
  return std::chrono::milliseconds(mode == MatchMode::kSynch ? 1000 : 10'000);
}

std::optional<std::chrono::milliseconds> reply_timeout(const MatchOptions& options) {
  const auto deadline = decision_deadline(options);
  const std::chrono::duration<double> stall_limit(options.stall_after_s);
  if (!deadline || *deadline < stall_limit) return deadline;
  return std::chrono::ceil<std::chrono::milliseconds>(stall_limit) + kMatchLimitMargin;
}

Result<void> pin_sides(MatchOptions& options) {
  auto [left, right] = base::split_in_half(base::allowed_cores());
  if (left.empty()) return Error{"--pin: only one processor core is available"};
  options.cpus = {std::move(left), std::move(right)};
  return {};
}

int situation_cycles(const MatchOptions& options) {
  return options.cycles.value_or(kDefaultSituationCycles);
}

Result<void> load_book(MatchOptions& options) {
  if (options.book.empty()) return {};
  TRY_INIT(auto book, analysis::read_book(options.book));
  options.loaded_book = std::make_shared<const analysis::Book>(std::move(book));
  return {};
}

simulator::MatchConfig server_config(const MatchOptions& options, std::uint64_t seed) {
  simulator::MatchConfig config;
  config.server = server_params(options);
  config.server.auto_mode = true;
  // Players must not notice how logs are stored: compressed logs hold the bytes of plain ones.
  config.server.game_log_compression = config.server.text_log_compression = 0;
  config.player = options.player;
  config.seed = seed;
  if (options.book.empty()) config.cycle_limit = options.cycles;
  config.decisive_lead = options.adjudicate;

  if (options.loaded_book != nullptr) {
    config.types = analysis::log_of(*options.loaded_book, seed, options.situations).types;
    config.player.player_types = static_cast<int>(config.types.size());
  }
  return config;
}

namespace {

/// Collects the errors of options.
class Errors {
 public:
  void require(bool holds, std::string message) {
    if (!holds) all_.push_back(std::move(message));
  }
  template <typename Value>
  void require(const Result<Value>& result) {
    if (!result) all_.push_back(result.error().message);
  }
  std::vector<std::string> take() { return std::move(all_); }

 private:
  std::vector<std::string> all_;
};

template <typename Params>
bool same(const Params& one, const Params& other, const soccer::ParameterTable<Params>& table) {
  return std::ranges::all_of(table, [&](const auto& row) {
    return std::visit([&](auto member) { return one.*member == other.*member; }, row.member);
  });
}

// Combinations of servers, modes and sides.
void check_server_and_mode(const MatchOptions& options, Errors& errors) {
  const bool embedded = options.server_choice.kind == ServerChoice::Kind::kEmbedded;
  const bool lockstep = mode_of(options) == MatchMode::kLockstep;
  const std::string& server = options.server_choice.text;

  errors.require(!lockstep || embedded,
                 "--mode lockstep needs the embedded server; use synch or realtime");

  const bool running = options.server_choice.kind == ServerChoice::Kind::kAddress;
  const bool stock = same(options.server, match_server_params(), soccer::server_param_table()) &&
                     same(options.player, soccer::PlayerParams(), soccer::player_param_table());
  errors.require(
      !running || stock,
      fmt::format("the server at {} has settings of its own: no --set, no --half-time", server));

  for (const Endpoint* side : {&options.left, &options.right}) {
    errors.require(!lockstep || side->has_playmaker() || !options.book.empty(),
                   fmt::format("--mode lockstep does not support side '{}'; use synch or realtime",
                               side->text));
    errors.require(!running || side->has_playmaker(),
                   fmt::format("side '{}' requires a server started by cls; the server at {} does "
                               "not report which players connect",
                               side->text, server));
  }
}

// Other servers, and teams over a network, take the end of a match from the referee.
void check_adjudication(const MatchOptions& options, Errors& errors) {
  if (!options.adjudicate) return;
  const bool embedded = options.server_choice.kind == ServerChoice::Kind::kEmbedded;
  errors.require(embedded && mode_of(options) == MatchMode::kLockstep,
                 "--adjudicate needs the embedded server in lockstep: other servers play on");
  errors.require(options.book.empty(), "--adjudicate: situations of a book end with a goal");
}

// Matches in which situations of a book can be played exactly.
void check_book(const MatchOptions& options, Errors& errors) {
  if (options.book.empty()) return;
  const bool embedded = options.server_choice.kind == ServerChoice::Kind::kEmbedded;
  errors.require(embedded && mode_of(options) == MatchMode::kLockstep,
                 "--book needs the embedded server in lockstep: a trainer of another server sets "
                 "neither stamina nor the state of the referee, so situations would not be exact");
  errors.require(!options.save_at && options.resumed == nullptr,
                 "--book: a match with situations can be neither saved nor resumed");
  errors.require(!options.trainer, "--book: a match with situations has no trainer");
  errors.require(!options.server.coach || options.server.coach_w_referee,
                 "--book needs a referee: no server::coach");

  const int half = options.server.half_time_cycles();
  const std::int64_t steps =
      std::int64_t{options.situations} * (situation_cycles(options) + analysis::kMaxWarmUp);
  errors.require(
      half <= 0 || steps < half,
      fmt::format("--situations {} of {} cycles are longer than a half of {} cycles; use "
                  "fewer",
                  options.situations, situation_cycles(options), half));
}

// Servers and modes that can hold a match, show it to monitors, and record its calls.
void check_hooks(const MatchOptions& options, Errors& errors) {
  const MatchMode mode = mode_of(options);
  const bool agents = has_agents(options);
  const bool embedded = options.server_choice.kind == ServerChoice::Kind::kEmbedded;

  errors.require(agents || options.record_rpc.empty(),
                 "--record-rpc needs a side with a Playmaker");
  errors.require(agents || !options.record_world_models,
                 "--record-world-models needs a side with a Playmaker");
  errors.require(agents || !options.record_choices,
                 "--record-choices needs a side with a Playmaker");

  const bool built_in = options.formations.left == nullptr && options.formations.right == nullptr &&
                        options.left.planner_file.empty() && options.right.planner_file.empty();
  const bool repeatable = mode == MatchMode::kLockstep && embedded && !options.trainer &&
                          !has_external_team(options) && built_in;
  errors.require(repeatable || (!options.save_at && options.resumed == nullptr),
                 "--save-at and --resume need the embedded server in lockstep, two sides with a "
                 "Playmaker, the built-in formations and planner, and no trainer");

  errors.require(!options.speed || (mode != MatchMode::kRealtime && agents),
                 "--speed needs --mode lockstep or synch and a side with a Playmaker; in real time "
                 "the server sets the speed");
  errors.require(!options.step || (mode != MatchMode::kRealtime && agents && embedded),
                 "--step and --at need the embedded server, --mode lockstep or synch, and a side "
                 "with a Playmaker; other servers do not wait");
  errors.require(
      !options.monitor_port || options.server_choice.kind != ServerChoice::Kind::kAddress,
      fmt::format("--monitor-port: monitors connect to the server at {} itself",
                  options.server_choice.text));
}

void check_playmakers(const MatchOptions& options, Errors& errors) {
  std::vector<const Endpoint*> sides = {&options.left, &options.right};
  if (options.trainer) {
    errors.require(
        options.trainer->has_playmaker(),
        fmt::format("--trainer '{}': an external team has its own", options.trainer->text));
    errors.require(
        options.trainer->kind != Endpoint::Kind::kMixed,
        fmt::format("--trainer '{}': a trainer has one Playmaker", options.trainer->text));
    errors.require(
        options.trainer->planner_file.empty(),
        fmt::format("--trainer '{}': a trainer does not use the planner", options.trainer->text));
    errors.require(options.trainer->policy_file.empty(),
                   fmt::format("--trainer '{}': a trainer has no policy", options.trainer->text));
    sides.push_back(&*options.trainer);
  }

  for (const Endpoint* side : {&options.left, &options.right}) {
    for (const Endpoint& part : side->parts) sides.push_back(&part);
  }
  for (const Endpoint* side : sides) {
    if (side->kind != Endpoint::Kind::kMock || side->script != nullptr) continue;
    if (mock_server::is_script_name(side->behavior)) continue;
    errors.require(mock_server::make_behavior(side->behavior));
  }
}

}  // namespace

std::vector<std::string> validate_options(const MatchOptions& options) {
  Errors errors;
  for (const std::string& name : {options.names.left, options.names.right}) {
    if (!name.empty()) errors.require(check_team_name(name));
  }

  check_server_and_mode(options, errors);
  const std::string length = length_problem(options.server, options.cycles, "give --cycles");
  errors.require(length.empty(), length);
  check_hooks(options, errors);
  check_adjudication(options, errors);
  check_book(options, errors);
  for (std::string& line : log_setting_errors(options)) errors.require(false, std::move(line));
  check_playmakers(options, errors);
  errors.require(simulator::LockstepServer::create(server_config(options, 0)));
  return errors.take();
}

}  // namespace cls::match
