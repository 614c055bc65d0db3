// Life of a match: start, join, handshake, cycles, end.
#include "orchestration/match/match.h"

#include <fmt/format.h>

#include <algorithm>
#include <thread>
#include <utility>

namespace cls::orchestration::match {
namespace {

using soccer::Side;
using std::chrono::milliseconds;

constexpr milliseconds kPollInterval{20};
constexpr milliseconds kThrottleInterval{50};
// A signal to a group of processes reaches all of them within this time.
constexpr milliseconds kSignalSpread{100};
// For how long a server in synch mode waits for the (done) of its clients.
constexpr milliseconds kServerWait{1250};

double seconds_between(MatchLimits::Clock::time_point from, MatchLimits::Clock::time_point to) {
  return std::chrono::duration<double>(to - from).count();
}

bool is_trainer(const MatchSide& side) { return side.identity().side == Side::kNeutral; }

}  // namespace

Match::Match(const MatchOptions& options, std::unique_ptr<Server> server,
             std::vector<std::unique_ptr<MatchSide>> sides, std::uint64_t seed,
             const std::atomic<int>& stop_signal)
    : options_(options),
      seed_(seed),
      limits_(options, stop_signal),
      server_(std::move(server)),
      sides_(std::move(sides)) {}

void Match::add_hooks(MatchHooks& hooks) {
  hooks_.push_back(&hooks);
  for (const auto& side : sides_) {
    if (is_trainer(*side)) continue;
    SideListener* listener = hooks.listener(side->identity().side);
    if (listener != nullptr) side->listen(*listener);
  }
}

// ---- ends

void Match::end(MatchEnd end) {
  if (!ended()) end_ = std::move(end);
}

// A signal that ends cls may have ended the process that failed, too.
void Match::end_unless_interrupted(MatchEnd end) {
  if (limits_.interrupted_within(kSignalSpread)) return;
  this->end(std::move(end));
  if (server_->lockstep()) cancel_calls();
}

void Match::end_by_limit(EndReason limit) {
  MatchEnd end{limit, limits_.describe(limit), {}, {}, false};
  const bool is_fault = limit == EndReason::kRefused || limit == EndReason::kStalled;
  if (is_fault && awaited_.what) {
    const bool blamed = server_->lockstep() && awaited_.side != nullptr;
    if (limit == EndReason::kRefused) {
      const std::string hint = awaited_.side == nullptr ? "" : awaited_.side->timeout_hint();
      end.message = fmt::format("{} within the start limit of {} s{}", awaited_.what(),
                                options_.start_timeout_s, hint);
    } else if (blamed) {
      end.message = fmt::format("{}: {}", awaited_.side->who(), end.message);
    }
    if (blamed && !is_trainer(*awaited_.side)) end.fault = awaited_.side->identity().side;
    if (awaited_.child != nullptr) end.failure = failure_of(*awaited_.child);
  }
  this->end(std::move(end));
}

void Match::cancel_calls() {
  for (const auto& side : sides_) side->cancel();
}

bool Match::at_cycle_limit() const {
  return options_.cycles && (server_->progress().match.cycle >= *options_.cycles ||
                             std::any_of(sides_.begin(), sides_.end(),
                                         [](const auto& side) { return side->at_cycle_limit(); }));
}

bool Match::is_over() const {
  return server_->finished() || (!server_->lockstep() && at_cycle_limit()) ||
         std::any_of(sides_.begin(), sides_.end(),
                     [](const auto& side) { return side->finished(); });
}

void Match::check() {
  if (ended()) return;
  if (auto failure = server_->failure(playing_)) end_unless_interrupted(*std::move(failure));
  for (const auto& side : sides_) {
    if (ended() || (is_over() && !server_->lockstep())) break;
    auto failure = side->failure(moment());
    if (!failure) continue;
    if (!is_trainer(*side)) failure->fault = side->identity().side;
    end_unless_interrupted(*std::move(failure));
  }
  if (ended()) return;
  if (const auto limit = limits_.exceeded()) end_by_limit(*limit);
}

bool Match::wait_for(const MatchSide& side, const std::function<bool()>& reached) {
  awaited_ = {[&side] { return side.waiting_for(); }, &side, side.awaited_process()};
  while (!ended() && !reached()) {
    if (!playing_) server_->wait_for_clients();
    awaited_.child = side.awaited_process();
    check();
  }
  awaited_ = {};
  return !ended();
}

// ---- start

void Match::warn_of_deadline(MatchObserver& observer) {
  const bool has_agents = options_.left.has_playmaker() || options_.right.has_playmaker();
  const auto deadline = decision_deadline(options_);
  const bool synch = !server_->lockstep() && mode_of(options_) == MatchMode::kSynch;
  if (!has_agents || !synch || !deadline) return;
  if (*deadline <= kServerWait) return;
  warn(observer, fmt::format("--rpc-deadline {} ms: a soccer server in synchronous mode continues "
                             "without a reply after {} ms",
                             deadline->count(), kServerWait.count()));
}

// A Playmaker that takes long to start must not make the players on the pitch wait for it.
void Match::prepare_sides(MatchObserver& observer) {
  if (server_->lockstep()) return;
  for (const auto& side : sides_) {
    if (ended() || side->prepared()) continue;
    observer.on_phase(fmt::format("waiting for {}", side->who()));
    wait_for(*side, [&] { return side->prepared(); });
  }
}

void Match::start_server(MatchObserver& observer) {
  if (ended()) return;
  if (!server_->lockstep()) observer.on_phase("waiting for the soccer server");
  awaited_ = {[this] { return server_->waiting_for(); }, nullptr, nullptr};
  auto failure = server_->start([this] {
    awaited_.child = server_->child();
    check();
    return !ended();
  });
  awaited_ = {};
  if (failure) end(*std::move(failure));
  const std::string monitor = server_->monitor_address();
  if (!ended() && !monitor.empty()) {
    observer.on_notice(fmt::format("monitors may attach at {}", monitor));
  }
}

void Match::join_sides(MatchObserver& observer) {
  std::vector<std::string> joined;
  for (const auto& side : sides_) {
    if (ended()) return;
    observer.on_phase(fmt::format("{} joins", side->identity().name));
    wait_for(*side, [&] {
      if (auto failure = side->join(server_->status(), joined)) {
        if (server_->lockstep() && !is_trainer(*side)) failure->fault = side->identity().side;
        end(*std::move(failure));
      }
      return side->joined();
    });
    joined.push_back(side->team_name());
  }
  // A side alone waits for its Playmaker with a limit of its own.
  if (sides_.size() == 1) limits_.begin_cycle();
}

void Match::shake_hands(MatchObserver& observer) {
  for (const auto& side : sides_) {
    if (ended()) return;
    side->begin_handshake();
    if (!side->handshake_done()) {
      observer.on_phase(fmt::format("waiting for {}", side->who()));
      wait_for(*side, [&] { return side->handshake_done(); });
    }
    check();
  }
}

// ---- cycles

SourceProgress Match::progress() const {
  SourceProgress latest = server_->progress();
  for (const auto& side : sides_) {
    const auto seen = side->progress();
    if (!seen) continue;
    latest.steps = std::max(latest.steps, seen->steps);
    if (seen->match.cycle >= latest.match.cycle) latest.match = seen->match;
  }
  const int whole = options_.server.normal_time_cycles();
  latest.match.last_cycle = whole;
  if (options_.cycles) {
    latest.match.last_cycle = whole > 0 ? std::min(whole, *options_.cycles) : *options_.cycles;
  }
  return latest;
}

void Match::observe(MatchObserver& observer) {
  const SourceProgress now = progress();
  if (now.steps > steps_) {
    steps_ = now.steps;
    stepped_at_ = Clock::now();
  }
  if (server_->lockstep() || Clock::now() - stepped_at_ < server_->quiet_time()) {
    limits_.begin_cycle();
  }
  if (now.match.cycle > 0 || server_->lockstep()) {
    last_cycle_ = Clock::now();
    if (first_cycle_ == Clock::time_point{}) first_cycle_ = last_cycle_;
  }
  observer.on_cycle(now.match);
}

MatchView Match::view() const {
  MatchView view;
  view.progress = progress().match;
  view.world = server_->world();
  if (view.world != nullptr) {
    view.stoppage = view.world->clock.stoppage;
    view.ball = view.world->ball.position;
  }
  for (const auto& side : sides_) {
    if (!view.ball) view.ball = side->ball();
  }
  return view;
}

bool Match::turn_is_due() const {
  bool due = server_->lockstep();
  for (const auto& side : sides_) {
    if (!side->takes_turns()) continue;
    if (!side->at_turn()) return false;
    due = true;
  }
  return due;
}

void Match::wait_for_decisions() {
  for (const auto& side : sides_) wait_for(*side, [&] { return side->turn_done(); });
  if (!ended()) return;
  cancel_calls();
  for (const auto& side : sides_) {
    while (!side->turn_done()) {
    }
  }
}

// External clients in lockstep have as long as a Playmaker, and may miss as many cycles.
void Match::wait_for_external_clients() {
  if (ended()) return;
  const auto deadline = decision_deadline(options_);
  const Clock::time_point begin = Clock::now();
  while (!server_->turn_done(kPollInterval)) {
    check();
    if (ended()) return;
    if (!deadline || Clock::now() < begin + *deadline) continue;
    if (++missed_by_external_ <= options_.max_missed) return;
    const auto external = std::find_if(sides_.begin(), sides_.end(),
                                       [](const auto& side) { return !side->takes_turns(); });
    end({EndReason::kLate,
         fmt::format("{}: not all players sent (done) in {} cycles in a row, up to cycle {}",
                     (*external)->who(), missed_by_external_, moment().cycle),
         {},
         (*external)->identity().side,
         false});
    return;
  }
  missed_by_external_ = 0;
}

void Match::take_turn() {
  const MatchView view = this->view();
  for (MatchHooks* hooks : hooks_) hooks->before_decisions(view);
  if (!hooks_.empty()) limits_.begin_cycle();
  for (const auto& side : sides_) {
    if (side->takes_turns()) side->begin_turn(view.progress.cycle);
  }
  if (server_->lockstep()) {
    wait_for_decisions();
    wait_for_external_clients();
  }
  for (const auto& side : sides_) side->end_turn();
}

// In lockstep; over UDP the agents do this. In slices, so that a signal is noticed.
void Match::throttle(Clock::time_point start) const {
  if (!options_.speed || !server_->lockstep()) return;
  const std::chrono::duration<double, std::milli> step(options_.server.simulator_step /
                                                       *options_.speed);
  const auto due =
      start + std::chrono::duration_cast<Clock::duration>(step * static_cast<double>(steps_));
  for (auto now = Clock::now(); now < due && limits_.signal() == 0; now = Clock::now()) {
    std::this_thread::sleep_until(std::min(due, now + kThrottleInterval));
  }
}

void Match::play_cycles(MatchObserver& observer) {
  if (!server_->lockstep()) observer.on_phase("playing");
  const Clock::time_point start = Clock::now();
  stepped_at_ = start;
  limits_.begin_cycle();
  while (!ended() && !is_over()) {
    throttle(start);
    if (server_->lockstep()) limits_.begin_cycle();
    const Clock::time_point begin = Clock::now();
    server_->step();
    observe(observer);
    const Clock::time_point stepped = Clock::now();
    times_.server += seconds_between(begin, stepped);
    const bool turn = turn_is_due();
    if (turn) take_turn();
    times_.sides += seconds_between(stepped, Clock::now());
    check();
    report_warnings(observer);
    if (!turn) continue;
    const MatchView after = view();
    for (MatchHooks* hooks : hooks_) {
      if (!hooks->after_cycle(after)) end({});
    }
  }
  times_.play = seconds_between(start, Clock::now());
  for (const auto& side : sides_) {
    if (auto failure = side->final_failure(moment())) {
      failure->fault = side->identity().side;
      if (!ended()) end_unless_interrupted(*std::move(failure));
    }
  }
}

// ---- warnings and result

void Match::warn(MatchObserver& observer, std::string line) {
  observer.on_warning(line);
  warnings_.push_back(std::move(line));
}

void Match::report_warnings(MatchObserver& observer) {
  for (const auto& side : sides_) {
    for (const std::string& line : side->take_warnings()) {
      warn(observer, fmt::format("{}: {}", side->identity().name, line));
    }
  }
  report_disconnects(observer);
}

void Match::report_disconnects(MatchObserver& observer) {
  if (!playing_ || server_->lockstep() || is_over()) return;
  std::size_t count = 0;
  for (const ReportedConnections& team : server_->status().teams) {
    for (const int unum : team.disconnected) {
      if (count++ < reported_disconnects_) continue;
      ++reported_disconnects_;
      warn(observer, fmt::format("player {} of {} left the match at cycle {}", unum, team.name,
                                 moment().cycle));
    }
  }
}

void Match::finish(MatchObserver& observer) {
  end({});
  auto state = Server::FinalState::kRunning;
  if (end_->reason == EndReason::kFinished && is_over()) state = Server::FinalState::kOver;
  // The server makes no further step while it waits for a team at the cycle limit or at its turn.
  const bool held_at_turn = state == Server::FinalState::kRunning && !server_->lockstep() &&
                            std::any_of(sides_.begin(), sides_.end(),
                                        [](const auto& side) { return side->takes_turns(); });
  if (at_cycle_limit() || held_at_turn) state = Server::FinalState::kHeld;
  if (!held_at_turn) {
    for (const auto& side : sides_) side->end_play();
  }
  server_->finish(state, limits_.signal());
  for (const auto& side : sides_) side->leave();
  for (const auto& side : sides_) side->terminate();
  for (const auto& side : sides_) {
    for (const std::string& line : side->failed_expectations()) {
      warn(observer, fmt::format("{}: {}", side->identity().name, line));
    }
  }
  processes_ = server_->wait_gone();
  for (const auto& side : sides_) {
    for (ProcessResult& process : side->wait_gone()) processes_.push_back(std::move(process));
  }
}

std::vector<AgentProgress> Match::agent_progress() const {
  std::vector<AgentProgress> all;
  for (const auto& side : sides_) {
    if (const auto seen = side->progress()) all.push_back({side->identity().name, *seen});
  }
  return all;
}

void Match::make_result(MatchObserver& observer) {
  result_.mode = name(server_->lockstep() ? MatchMode::kLockstep : mode_of(options_));
  for (const auto& side : sides_) {
    TeamResult team = side->result();
    const auto missed = [](const PlayerResult& player) {
      return player.missed > 0 || player.reconnects > 0;
    };
    if (std::any_of(team.players.begin(), team.players.end(), missed) ||
        (team.coach && team.coach->missed > 0)) {
      result_.deterministic = false;
    }
    // On a server that cls did not start, its operator has chosen the mode.
    const bool chosen = options_.server_choice.kind == ServerChoice::Kind::kAddress;
    if (const auto mode = side->mode(); mode && chosen) result_.mode = name(*mode);
    if (is_trainer(*side)) {
      result_.trainer = team.coach;
    } else {
      (side->identity().side == Side::kLeft ? result_.left : result_.right) = std::move(team);
    }
  }
  result_.end_reason = end_->reason;
  result_.message = end_->message;
  result_.failure = end_->failure;
  result_.fault = end_->fault;
  result_.try_again = end_->try_again;
  result_.signal = limits_.signal();
  result_.seed = seed_;
  result_.server_kind = options_.server_choice.text;
  result_.processes = std::move(processes_);
  result_.warnings = warnings_;
  server_->add_result(result_, agent_progress());
  for (std::size_t i = warnings_.size(); i < result_.warnings.size(); ++i) {
    observer.on_warning(result_.warnings[i]);
  }
  const double seconds =
      server_->lockstep() ? times_.play : seconds_between(first_cycle_, last_cycle_);
  if (seconds > 0.0) result_.cycles_per_second = result_.cycles / seconds;
}

void Match::play(MatchObserver& observer) {
  warn_of_deadline(observer);
  prepare_sides(observer);
  start_server(observer);
  join_sides(observer);
  shake_hands(observer);
  report_warnings(observer);
  playing_ = !ended();
  if (playing_) {
    std::vector<Server::Arrange> changes;
    for (MatchHooks* hooks : hooks_) {
      changes.push_back([hooks](simulator::World& world, simulator::Events& events) {
        hooks->arrange(world, events);
      });
    }
    for (const auto& side : sides_) side->begin_play();
    server_->begin_play(changes);
    play_cycles(observer);
  }
  finish(observer);
  make_result(observer);
}

}  // namespace cls::orchestration::match
