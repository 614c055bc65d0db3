// Life of a match: start, join, handshake, cycles, end.
#include "orchestration/match/match.h"

#include <fmt/format.h>

#include <algorithm>
#include <thread>
#include <utility>

#include "orchestration/match/match_fault.h"
#include "orchestration/match/options/server_settings.h"

namespace cls::orchestration::match {
namespace {

using soccer::Side;
using std::chrono::milliseconds;

constexpr milliseconds kPollInterval{20};
constexpr milliseconds kThrottleInterval{50};
// A signal to a group of processes reaches all of them within this time.
constexpr milliseconds kSignalSpread{100};
// The match reports a reply that it has waited for this long.
constexpr std::chrono::seconds kSlowReply{3};

double seconds_between(MatchLimits::Clock::time_point from, MatchLimits::Clock::time_point to) {
  return std::chrono::duration<double>(to - from).count();
}

}  // namespace

Match::Match(const MatchOptions& options, std::unique_ptr<Server> server,
             std::vector<std::unique_ptr<MatchSide>> sides, std::uint64_t seed,
             const std::atomic<int>& stop_signal)
    : options_(options),
      seed_(seed),
      limits_(options, stop_signal),
      server_(std::move(server)),
      sides_(std::move(sides)),
      speed_(options_, sides_, server_->lockstep()) {}

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

void Match::end_by_side(const MatchSide& side, MatchEnd end) {
  if (!is_trainer(side)) end.fault = side.identity().side;
  end_unless_interrupted(std::move(end));
}

// Over UDP the server may continue without a side whose Playmaker hangs: that is a stall, too.
std::optional<EndReason> Match::exceeded_limit() const {
  if (const auto limit = limits_.exceeded()) return limit;
  if (!playing_ || options_.no_deadline) return std::nullopt;
  const std::chrono::duration<double> stall_limit(options_.stall_after_s);
  if (sides_awaited_for(sides_, stall_limit).empty()) return std::nullopt;
  return EndReason::kStalled;
}

void Match::end_by_stall() {
  // Those that kept the match waiting for most of the limit. In lockstep the match knows which side
  // it waits for; over UDP each side plays on its own.
  auto awaited =
      sides_awaited_for(sides_, std::chrono::duration<double>(options_.stall_after_s / 2));
  if (awaited.empty() && awaited_.side != nullptr) awaited.push_back(awaited_.side);
  MatchEnd end{EndReason::kStalled, limits_.describe(EndReason::kStalled), {}, {}, false};
  if (!awaited.empty()) {
    end.message = stall_message(awaited, moment().cycle, end.message);
  } else if (!server_->lockstep()) {
    const bool external = std::any_of(sides_.begin(), sides_.end(),
                                      [](const auto& side) { return side->is_external(); });
    end.message += fmt::format("; no Playmaker is awaited: the soccer server{} has stopped",
                               external ? " or an external team" : "");
  }
  if (awaited.size() == 1) blame(*awaited.front(), moment(), end);
  this->end(std::move(end));
}

void Match::end_by_limit(EndReason limit) {
  if (limit == EndReason::kStalled) return end_by_stall();
  MatchEnd end{limit, limits_.describe(limit), {}, {}, false};
  if (limit == EndReason::kRefused && awaited_.what) {
    const std::string hint = awaited_.side == nullptr ? "" : awaited_.side->timeout_hint();
    end.message = fmt::format("{} within the start limit of {} s{}", awaited_.what(),
                              options_.start_timeout_s, hint);
    // A side over UDP that has not called its Playmaker yet may wait for the server.
    const bool blamed = awaited_.side != nullptr &&
                        (server_->lockstep() || awaited_.side->awaited_reply().has_value());
    if (blamed) blame(*awaited_.side, moment(), end);
    if (!end.failure && awaited_.child != nullptr) end.failure = failure_of(*awaited_.child);
  }
  this->end(std::move(end));
}

// Says who is awaited before the stall limit ends the match.
void Match::warn_of_slow_reply() {
  if (options_.no_deadline) return;
  for (std::size_t i = 0; i < sides_.size(); ++i) {
    const auto call = sides_[i]->awaited_reply();
    if (!call || call->waited < kSlowReply || std::exchange(warned_of_slow_reply_[i], true)) {
      continue;
    }
    warn(fmt::format("{}: no reply to {} for {} s at cycle {}", sides_[i]->identity().name,
                     describe(*call), kSlowReply.count(), moment().cycle));
  }
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
  if (auto failure = server_->failure(playing_)) {
    if (failure->reason == EndReason::kLate) blame_unresponsive(sides_, *failure);
    end_unless_interrupted(*std::move(failure));
  }
  for (const auto& side : sides_) {
    if (ended() || (is_over() && !server_->lockstep())) break;
    auto failure = side->failure(moment());
    if (failure) end_by_side(*side, *std::move(failure));
  }
  if (ended()) return;
  if (playing_) warn_of_slow_reply();
  if (const auto limit = exceeded_limit()) end_by_limit(*limit);
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

void Match::warn_of_deadline() {
  const bool has_agents = options_.left.has_playmaker() || options_.right.has_playmaker();
  const auto deadline = decision_deadline(options_);
  const bool synch = !server_->lockstep() && mode_of(options_) == MatchMode::kSynch;
  if (!has_agents || !synch || !deadline) return;
  if (*deadline <= kServerWait) return;
  warn(
      fmt::format("--rpc-deadline {} ms: a soccer server in synchronous mode continues "
                  "without a reply after {} ms",
                  deadline->count(), kServerWait.count()));
}

// A Playmaker that takes long to start must not make the players on the pitch wait for it.
void Match::prepare_sides() {
  if (server_->lockstep()) return;
  for (const auto& side : sides_) {
    if (ended() || side->prepared()) continue;
    observer_->on_phase(fmt::format("waiting for {}", side->who()));
    wait_for(*side, [&] { return side->prepared(); });
  }
}

void Match::start_server() {
  if (ended()) return;
  if (!server_->lockstep()) observer_->on_phase("waiting for the soccer server");
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
    observer_->on_notice(fmt::format("monitors may attach at {}", monitor));
  }
}

void Match::join_sides() {
  std::vector<std::string> joined;
  for (const auto& side : sides_) {
    if (ended()) return;
    observer_->on_phase(fmt::format("{} joins", side->identity().name));
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

void Match::shake_hands() {
  for (const auto& side : sides_) {
    if (ended()) return;
    side->begin_handshake();
    if (!side->handshake_done()) {
      observer_->on_phase(fmt::format("waiting for {}", side->who()));
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

void Match::observe() {
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
  observer_->on_cycle(now.match);
  if (const auto line = speed_.estimate(now.match, steps_, Clock::now() - play_began_)) {
    observer_->on_notice(*line);
  }
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
  const auto external = std::find_if(sides_.begin(), sides_.end(),
                                     [](const auto& side) { return side->is_external(); });
  if (external == sides_.end()) return;
  const auto deadline = reply_timeout(options_);
  const Clock::time_point begin = Clock::now();
  awaited_ = {{}, external->get(), nullptr};
  while (!server_->turn_done(kPollInterval)) {
    check();
    if (ended()) return;
    if (!deadline || Clock::now() < begin + *deadline) continue;
    awaited_ = {};
    if (++missed_by_external_ <= options_.max_missed) return;
    end({EndReason::kLate,
         fmt::format("{}: not all players sent (done) in {} cycles in a row, up to cycle {}",
                     (*external)->who(), missed_by_external_, moment().cycle),
         {},
         (*external)->identity().side,
         false});
    return;
  }
  awaited_ = {};
  missed_by_external_ = 0;
}

void Match::take_turn() {
  const MatchView view = this->view();
  for (MatchHooks* hooks : hooks_) hooks->before_decisions(view);
  if (!hooks_.empty()) limits_.begin_cycle();
  const Clock::time_point begin = Clock::now();
  for (const auto& side : sides_) {
    if (side->takes_turns()) side->begin_turn(view.progress.cycle);
  }
  if (server_->lockstep()) {
    for (const auto& side : sides_) side->take_turn();
    wait_for_decisions();
    wait_for_external_clients();
    limits_.begin_cycle();  // every reply is in: the stall limit must not expire after this
    speed_.add_turns(Clock::now() - begin);
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

void Match::play_cycles() {
  if (!server_->lockstep()) observer_->on_phase("playing");
  const Clock::time_point start = Clock::now();
  stepped_at_ = play_began_ = start;
  limits_.begin_cycle();
  while (!ended() && !is_over()) {
    const Clock::time_point free = Clock::now();
    throttle(start);
    if (server_->lockstep()) limits_.begin_cycle();
    const Clock::time_point begin = Clock::now();
    server_->step();
    observe();
    const Clock::time_point stepped = Clock::now();
    times_.server += seconds_between(begin, stepped);
    if (server_->lockstep()) speed_.add_step(begin - free, stepped - begin);
    const bool turn = turn_is_due();
    if (turn) take_turn();
    times_.sides += seconds_between(stepped, Clock::now());
    check();
    report_warnings();
    if (!turn) continue;
    const MatchView after = view();
    for (MatchHooks* hooks : hooks_) {
      if (!hooks->after_cycle(after)) end({});
    }
  }
  played_ = Clock::now() - start;
  times_.play = std::chrono::duration<double>(played_).count();
  for (const auto& side : sides_) {
    if (ended()) break;
    if (auto failure = side->final_failure(moment())) end_by_side(*side, *std::move(failure));
  }
}

// ---- warnings and result

void Match::warn(std::string line) {
  observer_->on_warning(line);
  warnings_.push_back(std::move(line));
}

void Match::report_warnings() {
  for (const auto& side : sides_) {
    for (const std::string& line : side->take_warnings()) {
      warn(fmt::format("{}: {}", side->identity().name, line));
    }
  }
  report_disconnects();
}

// Agents that leave because the match has ended are no news.
void Match::report_disconnects() {
  if (!playing_ || server_->lockstep() || is_over() || ended()) return;
  for (const ReportedConnections& team : server_->status().teams) {
    std::size_t& reported = reported_disconnects_[team.name];
    const std::vector<int> left(team.disconnected.begin() + static_cast<std::ptrdiff_t>(reported),
                                team.disconnected.end());
    reported = team.disconnected.size();
    if (left.empty()) continue;
    warn(fmt::format("player{} {} of {} left the match at cycle {}", left.size() == 1 ? "" : "s",
                     fmt::join(left, ", "), team.name, moment().cycle));
  }
}

void Match::finish() {
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
      warn(fmt::format("{}: {}", side->identity().name, line));
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

void Match::make_result() {
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
    observer_->on_warning(result_.warnings[i]);
  }
  const double seconds =
      server_->lockstep() ? times_.play : seconds_between(first_cycle_, last_cycle_);
  if (seconds > 0.0) result_.cycles_per_second = result_.cycles / seconds;
  result_.speed = speed_.result(played_, result_);
}

void Match::play(MatchObserver& observer) {
  observer_ = &observer;
  warn_of_deadline();
  prepare_sides();
  start_server();
  join_sides();
  shake_hands();
  report_warnings();
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
    play_cycles();
  }
  finish();
  make_result();
}

}  // namespace cls::orchestration::match
