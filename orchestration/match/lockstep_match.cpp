// Playing one match in lockstep.
#include "orchestration/match/lockstep_match.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <thread>
#include <utility>

#include "orchestration/match/result/match_end.h"
#include "orchestration/match/sides/playmaker_link.h"

namespace cls::orchestration::match {
namespace {

using base::Result;
using proxy::RpcOutcome;
using Clock = std::chrono::steady_clock;

double seconds_between(Clock::time_point from, Clock::time_point to) {
  return std::chrono::duration<double>(to - from).count();
}

// Time that a signal to a whole group of processes takes to reach all of them.
constexpr std::chrono::milliseconds kSignalsTogether{100};
constexpr std::chrono::milliseconds kProgramGrace{1500};
constexpr std::chrono::milliseconds kEndBecomesKnown{500};

}  // namespace

simulator::MatchConfig server_config(const MatchOptions& options, std::uint64_t seed) {
  simulator::MatchConfig config;
  config.server = server_params(options);
  config.server.auto_mode = true;
  config.player = options.player;
  config.seed = seed;
  config.cycle_limit = options.cycles;
  return config;
}

Result<std::unique_ptr<LockstepMatch>> LockstepMatch::create(const MatchOptions& options,
                                                             const TeamNames& names,
                                                             std::uint64_t seed,
                                                             const std::atomic<int>& stop_signal,
                                                             process::ProcessHost* host,
                                                             const std::filesystem::path& folder) {
  std::unique_ptr<LockstepMatch> match(new LockstepMatch(options, seed, stop_signal));
  auto server = simulator::LockstepServer::create(server_config(options, seed));
  if (!server) return server.error();
  match->server_ = std::move(*server);
  auto left = MatchSide::create(
      options.left, {soccer::Side::kLeft, names.left, seed, folder, host, options.left_cpus},
      options);
  if (!left) return left.error();
  match->left_ = std::move(*left);
  auto right = MatchSide::create(
      options.right, {soccer::Side::kRight, names.right, seed, folder, host, options.right_cpus},
      options);
  if (!right) return right.error();
  match->right_ = std::move(*right);
  if (host != nullptr) {
    auto guests = ForeignGuests::create(options, names, *match->server_, *host, folder);
    if (!guests) return guests.error();
    match->guests_ = *std::move(guests);
  }
  if (!options.trainer) return match;
  auto trainer = MatchSide::create(
      *options.trainer, {soccer::Side::kNeutral, names.left, seed, folder, host, {}}, options);
  if (!trainer) return trainer.error();
  match->trainer_ = std::move(*trainer);
  return match;
}

std::vector<MatchSide*> LockstepMatch::sides() const {
  std::vector<MatchSide*> all = {left_.get(), right_.get()};
  if (trainer_ != nullptr) all.push_back(trainer_.get());
  return all;
}

void LockstepMatch::cancel_calls() {
  for (MatchSide* side : sides()) side->playmaker().cancel();
}

void LockstepMatch::end(EndReason reason, std::string message, const MatchSide* at_fault) {
  if (ended()) return;
  end_reason_ = reason;
  if (at_fault == left_.get()) fault_ = soccer::Side::kLeft;
  if (at_fault == right_.get()) fault_ = soccer::Side::kRight;
  message_ = std::move(message);
}

// Waits, but not beyond the limits: past one, the calls in flight are called back, so that the
// side comes to its end at once.
void LockstepMatch::wait_for(MatchSide& side) {
  constexpr std::chrono::milliseconds kLook{20};
  while (!side.worker().wait_for(kLook)) {
    check_programs();
    if (guests_ != nullptr && !playing_ && !ended()) guests_->pass_time();
    const auto limit = watch_.exceeded();
    if (!limit || ended()) continue;
    const bool at_fault = *limit == EndReason::kRefused || *limit == EndReason::kStalled;
    const std::string whose =
        at_fault ? fmt::format("{} ({}): ", side.name(), side.endpoint().text) : "";
    std::string hint;
    if (*limit == EndReason::kRefused) {
      hint =
          side.program() != nullptr ? side.program()->port_hint() : silence_hint(side.endpoint());
    }
    end(*limit, whose + describe_limit(*limit, options_) + hint, at_fault ? &side : nullptr);
    if (side.program() != nullptr && at_fault) failure_ = failure_of(side.program()->child());
    cancel_calls();
  }
}

// A Playmaker that died is told as such, with its last words, before anything is made of the calls
// that fail because of it.
void LockstepMatch::check_programs() {
  check_guests();
  for (MatchSide* side : sides()) {
    if (ended() || side->program() == nullptr || !side->program()->ended()) continue;
    // Whoever ends us may have ended the Playmaker in the same breath.
    if (watch_.interrupted_within(kSignalsTogether)) return;
    failure_ = failure_of(side->program()->child());
    const std::string when =
        playing_ ? fmt::format("at cycle {}", server_->world().clock.time) : "before it answered";
    end(playing_ ? EndReason::kCrashed : EndReason::kRefused,
        fmt::format("{} ({}): its process ended {}: {}", side->name(), side->endpoint().text, when,
                    failure_->exit),
        side);
    cancel_calls();
  }
}

void LockstepMatch::check_guests() {
  if (guests_ == nullptr || ended()) return;
  auto loss = guests_->loss();
  if (!loss || watch_.interrupted_within(kSignalsTogether)) return;
  const MatchSide& side = loss->side == soccer::Side::kLeft ? *left_ : *right_;
  failure_ = std::move(loss->failure);
  const std::string when =
      playing_ ? fmt::format("at cycle {}", server_->world().clock.time) : "before the match";
  end(playing_ ? EndReason::kCrashed : EndReason::kRefused,
      fmt::format("{} ({}): {} ({})", side.name(), side.endpoint().text, loss->what, when), &side);
}

// Foreign agents have as long as a Playmaker, and are missed as often.
void LockstepMatch::wait_for_guests() {
  constexpr std::chrono::milliseconds kLook{20};
  if (guests_ == nullptr || ended()) return;
  const auto limit = decision_deadline(options_);
  const Clock::time_point asked = Clock::now();
  while (!guests_->answered(Clock::now() + kLook)) {
    check_guests();
    if (ended() || watch_.exceeded()) return;
    if (!limit || Clock::now() < asked + *limit) continue;
    if (++cycles_without_guests_ > options_.max_missed) {
      const MatchSide& side = guests_->has(soccer::Side::kLeft) ? *left_ : *right_;
      end(EndReason::kLate,
          fmt::format("{} ({}): not all its players said (done) in {} cycles in a row, up to "
                      "cycle {}",
                      side.name(), side.endpoint().text, cycles_without_guests_,
                      server_->world().clock.time),
          &side);
    }
    return;
  }
  cycles_without_guests_ = 0;
}

void LockstepMatch::end_programs() {
  if (guests_ != nullptr) {
    guests_->end();
    processes_ = guests_->results();
  }
  for (MatchSide* side : sides()) {
    if (side->program() != nullptr) side->program()->child().end(kProgramGrace);
  }
  for (MatchSide* side : sides()) {
    if (side->program() == nullptr) continue;
    side->program()->child().wait_gone(kProgramGrace + kProgramGrace);
    processes_.push_back(result_of(side->program()->child()));
  }
}

void LockstepMatch::run_on_all(const std::function<void(MatchSide&)>& work) {
  for (MatchSide* side : sides()) {
    side->worker().start([side, &work] { work(*side); });
  }
  for (MatchSide* side : sides()) wait_for(*side);
}

void LockstepMatch::connect(MatchObserver& observer) {
  observer.on_phase("connecting the players");
  for (MatchSide* side : sides()) {
    if (!side->endpoint().has_playmaker()) {
      join_guests(*side, observer);
      continue;
    }
    const auto connected = connect(*side);
    if (!connected) end(EndReason::kServerFailed, connected.error().message);
  }
}

Result<void> LockstepMatch::connect(MatchSide& side) {
  const auto serve = [this] {
    server_->answer_requests();
    return true;
  };
  const auto open = [this](simulator::Door door) {
    return [this, door] { return server_->connect(door); };
  };
  proxy::Team& team = side.team();
  if (&side == trainer_.get()) {
    return team.connect_coach(soccer::CoachRole::kTrainer, open(simulator::Door::kOfflineCoach),
                              serve);
  }
  if (auto done = team.connect(open(simulator::Door::kGame), serve); !done) return done;
  if (!options_.coach) return {};
  return team.connect_coach(soccer::CoachRole::kOnlineCoach, open(simulator::Door::kOnlineCoach),
                            serve);
}

void LockstepMatch::join_guests(const MatchSide& side, MatchObserver& observer) {
  observer.on_phase(fmt::format("{} joins", side.name()));
  const soccer::Side which = &side == left_.get() ? soccer::Side::kLeft : soccer::Side::kRight;
  const std::string who = fmt::format("{} ({}): ", side.name(), side.endpoint().text);
  while (!ended() && !guests_->joined(which)) {
    if (const auto step = guests_->join(which); !step) {
      end(EndReason::kRefused, who + step.error().message, &side);
    }
    guests_->pass_time();
    check_guests();
    if (const auto limit = watch_.exceeded()) {
      const bool late = *limit == EndReason::kRefused;
      end(*limit,
          late ? fmt::format("{}{} within the start limit of {} s", who,
                             guests_->waiting_for(which), options_.start_timeout_s)
               : describe_limit(*limit, options_),
          late ? &side : nullptr);
    }
  }
}

void LockstepMatch::introduce(MatchObserver& observer) {
  for (MatchSide* side : sides()) {
    if (ended()) return;
    observer.on_phase(fmt::format("waiting for {} ({})", side->name(), side->endpoint().text));
    proxy::RpcStatus status;
    side->worker().start([side, &status] { status = side->team().introduce(); });
    wait_for(*side);
    check_programs();
    if (!status.ok()) {
      const bool garbled = status.outcome == RpcOutcome::kProtocolError;
      end(garbled ? EndReason::kProtocolError : EndReason::kRefused,
          fmt::format("{} ({}): {}", side->name(), side->endpoint().text, status.message), side);
    }
  }
}

void LockstepMatch::check_answers(const MatchSide& side) {
  const proxy::MissingAnswers missing = side.team().missing_answers();
  // Calls to a dead process fail faster than its end is known.
  if (side.program() != nullptr && missing.in_a_row == 1 &&
      missing.last.outcome == RpcOutcome::kUnavailable) {
    side.program()->child().wait_exit(kEndBecomesKnown);
    check_programs();
  }
  auto over =
      end_by_missing_answers(missing, fmt::format("{} ({})", side.name(), side.endpoint().text),
                             server_->world().clock.time, options_);
  if (!over || ended()) return;
  if (side.program() != nullptr) failure_ = failure_of(side.program()->child());
  end(over->reason, std::move(over->message), &side);
}

void LockstepMatch::pass_on_warnings(MatchObserver& observer) {
  for (MatchSide* side : sides()) {
    for (const std::string& line : side->team().take_warnings()) {
      warnings_.push_back(fmt::format("{}: {}", side->name(), line));
      observer.on_warning(warnings_.back());
    }
  }
}

void LockstepMatch::report_expectations(MatchObserver& observer) {
  for (MatchSide* side : sides()) {
    for (const std::string& line : side->failed_expectations()) {
      warnings_.push_back(fmt::format("{}: {}", side->name(), line));
      observer.on_warning(warnings_.back());
    }
  }
}

int LockstepMatch::last_cycle() const {
  const int whole = options_.server.normal_time_cycles();
  if (!options_.cycles) return whole;
  return whole > 0 ? std::min(whole, *options_.cycles) : *options_.cycles;
}

void LockstepMatch::report_progress(MatchObserver& observer) const {
  const simulator::World& world = server_->world();
  observer.on_cycle({world.clock.time, last_cycle(), world.team(soccer::Side::kLeft).score,
                     world.team(soccer::Side::kRight).score, world.mode});
}

void LockstepMatch::direct(MatchDirector& director) {
  directors_.push_back(&director);
  for (const auto side : {soccer::Side::kLeft, soccer::Side::kRight}) {
    proxy::RpcListener* listener = director.listener(side);
    MatchSide& listened = side == soccer::Side::kLeft ? *left_ : *right_;
    if (listener != nullptr) listened.listen(*listener);
  }
}

void LockstepMatch::arrange() {
  for (MatchDirector* director : directors_) {
    server_->arrange([director](simulator::World& world, simulator::Events& events) {
      director->arrange(world, events);
    });
  }
}

void LockstepMatch::open_to_monitors(MatchObserver& observer) {
  if (!options_.monitor_port) return;
  const auto port = server_->open_to_monitors("127.0.0.1", *options_.monitor_port);
  if (!port) return end(EndReason::kServerFailed, port.error().message);
  observer.on_notice(fmt::format("monitors may attach at 127.0.0.1:{}", *port));
}

// Waits until the next step is due, in slices, so that a signal is noticed.
void LockstepMatch::keep_pace(Clock::time_point start) const {
  if (!options_.speed) return;
  constexpr std::chrono::milliseconds kSlice{50};
  const std::chrono::duration<double, std::milli> step(options_.server.simulator_step /
                                                       *options_.speed);
  const auto due =
      start + std::chrono::duration_cast<Clock::duration>(step * static_cast<double>(steps_));
  for (auto now = Clock::now(); now < due && watch_.signal() == 0; now = Clock::now()) {
    std::this_thread::sleep_until(std::min(due, now + kSlice));
  }
}

void LockstepMatch::play_cycles(MatchObserver& observer, MatchChronicle& chronicle) {
  const Clock::time_point start = Clock::now();
  Clock::time_point now = start;
  while (!ended() && !server_->finished()) {
    keep_pace(start);
    now = Clock::now();
    watch_.cycle_begins();
    server_->run_cycle();
    ++steps_;
    chronicle.follow(server_->world());
    report_progress(observer);
    for (MatchDirector* director : directors_) director->before_decisions(server_->world());
    if (!directors_.empty()) watch_.cycle_begins();
    const Clock::time_point asked = Clock::now();
    times_.simulator += seconds_between(now, asked);
    run_on_all([](MatchSide& side) { side.team().run_cycle(); });
    wait_for_guests();
    now = Clock::now();
    times_.sides += seconds_between(asked, now);
    check_programs();
    for (const MatchSide* side : sides()) check_answers(*side);
    pass_on_warnings(observer);
    for (MatchDirector* director : directors_) {
      if (!director->after_cycle(server_->world())) end(EndReason::kFinished, "");
    }
    if (const auto limit = watch_.exceeded()) end(*limit, describe_limit(*limit, options_));
  }
  times_.play = seconds_between(start, now);
}

void LockstepMatch::leave() {
  run_on_all([](MatchSide& side) { side.team().leave(); });
}

void LockstepMatch::play(MatchObserver& observer, MatchChronicle& chronicle) {
  open_to_monitors(observer);
  if (!ended()) connect(observer);
  introduce(observer);
  pass_on_warnings(observer);
  playing_ = !ended();
  if (playing_) arrange();
  if (playing_ && guests_ != nullptr) guests_->begin();
  if (playing_) play_cycles(observer, chronicle);
  end(EndReason::kFinished, "");
  server_->finish();
  leave();
  report_expectations(observer);
  end_programs();
}

MatchResult LockstepMatch::result() const {
  const simulator::World& world = server_->world();
  MatchResult result;
  result.left = left_->result();
  result.right = right_->result();
  for (const auto side : {soccer::Side::kLeft, soccer::Side::kRight}) {
    const simulator::Team& team = world.team(side);
    TeamResult& told = side == soccer::Side::kLeft ? result.left : result.right;
    told.score = team.score;
    if (guests_ != nullptr && guests_->has(side)) {
      told.cpu_seconds = guests_->cpu_seconds(side);
      result.deterministic = false;
    }
    if (team.penalty_kicks > 0) told.penalty_score = team.penalty_goals;
    for (const PlayerResult& player : told.players) {
      if (player.missed > 0 || player.reconnects > 0) result.deterministic = false;
    }
    if (told.coach && told.coach->missed > 0) result.deterministic = false;
  }
  if (trainer_ != nullptr) result.trainer = trainer_->result().coach;
  if (result.trainer && result.trainer->missed > 0) result.deterministic = false;
  result.end_reason = end_reason_.value_or(EndReason::kFinished);
  result.message = message_;
  result.fault = fault_;
  result.failure = failure_;
  result.processes = processes_;
  result.signal = watch_.signal();
  result.cycles = world.clock.time;
  result.steps = steps_;
  result.seed = seed_;
  result.warnings = warnings_;
  if (times_.play > 0.0) result.cycles_per_second = result.cycles / times_.play;
  return result;
}

}  // namespace cls::orchestration::match
