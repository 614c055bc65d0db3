// Watching and ending a match over UDP.
#include "orchestration/match/network_match.h"

#include <fmt/format.h>

#include <algorithm>
#include <thread>
#include <utility>

#include "orchestration/match/result/match_folder.h"
#include "orchestration/match/sides/playmaker_program.h"

namespace cls::orchestration::match {
namespace {

using base::Result;
using std::chrono::milliseconds;
using Clock = DeadlineWatch::Clock;

constexpr milliseconds kLook{10};
constexpr milliseconds kSignalsTogether{100};
// An interrupted match has 5 s in all.
constexpr milliseconds kServerGrace{1500};
constexpr milliseconds kProgramGrace{1000};
constexpr milliseconds kKillMargin{300};
constexpr milliseconds kServerEndsItself{10'000};
// A team may hear of the end of the match, and leave, before we do.
constexpr milliseconds kEndBecomesKnown{2000};
constexpr int kCyclesUntilEndIsKnown = 15;
// For how long a server in synchronous mode waits for its clients' (done).
constexpr milliseconds kServerWaits{1250};

}  // namespace

NetworkMatch::NetworkMatch(const MatchOptions& options, std::uint64_t seed,
                           const std::atomic<int>& stop_signal, process::ProcessHost& host,
                           std::filesystem::path folder)
    : options_(options),
      seed_(seed),
      host_(host),
      folder_(std::move(folder)),
      watch_(options, stop_signal),
      log_(folder_ / kGameLogFile) {}

Result<std::unique_ptr<NetworkMatch>> NetworkMatch::create(const MatchOptions& options,
                                                           const TeamNames& names,
                                                           std::uint64_t seed,
                                                           const std::atomic<int>& stop_signal,
                                                           process::ProcessHost& host,
                                                           const std::filesystem::path& folder) {
  std::unique_ptr<NetworkMatch> match(new NetworkMatch(options, seed, stop_signal, host, folder));
  auto plan = plan_network_match(options, names, seed, folder);
  if (!plan) return plan.error();
  match->plan_ = std::move(*plan);
  match->sides_.resize(options.trainer ? 3 : 2);
  for (std::size_t i = 0; i < match->sides_.size(); ++i) {
    Side& side = match->sides_[i];
    side.name = i == 1 ? names.right : names.left;
    side.name_is_asked_for =
        !options.own_names && !(i == 1 ? options.right_name : options.left_name).empty();
    side.endpoint = match->endpoint_of(i).text;
  }
  return match;
}

void NetworkMatch::end(EndReason reason, std::string message, const process::Child* failed) {
  if (ended()) return;
  end_ = MatchEnd{reason, std::move(message), std::nullopt};
  if (failed != nullptr) end_->failure = failure_of(*failed);
}

void NetworkMatch::warn(MatchObserver& observer, std::string line) {
  observer.on_warning(line);
  warnings_.push_back(std::move(line));
}

bool NetworkMatch::match_is_over() const {
  if (output_.news().game_over || log_.moment().mode == soccer::PlayMode::kTimeOver) return true;
  if (options_.cycles && log_.moment().time >= *options_.cycles) return true;
  return std::any_of(sides_.begin(), sides_.end(), [](const Side& side) {
    return side.own && side.own->moment().progress.mode == soccer::PlayMode::kTimeOver;
  });
}

bool NetworkMatch::cycle_limit_reached() const {
  if (!options_.cycles) return false;
  return log_.moment().time >= *options_.cycles ||
         std::any_of(sides_.begin(), sides_.end(),
                     [](const Side& side) { return side.own && side.own->reached_cycle_limit(); });
}

void NetworkMatch::check_server() {
  if (ended() || server_ == nullptr || !process::has_ended(server_->status())) return;
  log_.look();
  if (match_is_over() || watch_.interrupted_within(kSignalsTogether)) return;
  const std::string exit = to_text(server_->status().exit.value_or(process::ProcessExit{}));
  const ServerNews news = output_.news();
  if (news.gave_up) {
    end(EndReason::kLate,
        fmt::format("the soccer server gave up at cycle {}: clients did not answer for too long",
                    log_.moment().time),
        server_.get());
  } else if (playing_) {
    end(EndReason::kServerFailed,
        fmt::format("the soccer server ended at cycle {}: {}", log_.moment().time, exit),
        server_.get());
  } else {
    const std::string why = news.complaint.empty() ? "" : fmt::format(" ({})", news.complaint);
    end(EndReason::kRefused,
        fmt::format("the soccer server ended before the match: {}{}", exit, why), server_.get());
  }
}

void NetworkMatch::end_by_death(const Side& side, const process::Child& child, int cycle) {
  if (ended() || watch_.interrupted_within(kSignalsTogether)) return;
  if (side_of(side) != soccer::Side::kNeutral) fault_ = side_of(side);
  const std::string exit = to_text(child.status().exit.value_or(process::ProcessExit{}));
  const std::string when = playing_ ? fmt::format("at cycle {}", cycle) : "before the match";
  end(playing_ ? EndReason::kCrashed : EndReason::kRefused,
      fmt::format("{} ({}): the process of {} ended {}: {}{}", side.name, side.endpoint,
                  child.plan().name, when, exit, name_hint(side)),
      &child);
}

void NetworkMatch::check_foreign(Side& side) {
  const process::Child* dead = side.foreign->dead_agent();
  if (dead == nullptr) return;
  if (!side.departure) side.departure = Departure{dead, cycle_now(), Clock::now()};
  const bool may_be_the_end = playing_ && Clock::now() - side.departure->at < kEndBecomesKnown;
  if (may_be_the_end && !left_before_the_end(side)) return;
  end_by_death(side, *side.departure->agent, side.departure->cycle);
}

bool NetworkMatch::left_before_the_end(const Side& side) const {
  return side.departure && cycle_now() > side.departure->cycle + kCyclesUntilEndIsKnown;
}

void NetworkMatch::check_side(Side& side) {
  if (ended() || match_is_over()) return;
  if (side.foreign) return check_foreign(side);
  if (!side.own) return;
  const PlaymakerProgram* program = side.own->side().program();
  const auto own_end = side.own->end();
  // Calls to a dead process fail faster than its end is known.
  if (program != nullptr && own_end) program->child().wait_exit(milliseconds(500));
  if (program != nullptr && program->ended()) end_by_death(side, program->child(), cycle_now());
  if (own_end && !ended()) {
    if (side_of(side) != soccer::Side::kNeutral) fault_ = side_of(side);
    end(own_end->reason, own_end->message, program == nullptr ? nullptr : &program->child());
  }
}

void NetworkMatch::check() {
  if (ended()) return;
  check_server();
  for (Side& side : sides_) check_side(side);
  const auto limit = watch_.exceeded();
  if (!limit || ended()) return;
  const bool waited = *limit == EndReason::kRefused && waiting_for_;
  end(*limit, waited ? fmt::format("{} within the start limit of {} s{}", waiting_for_(),
                                   options_.start_timeout_s, name_hint(sides_[1]))
                     : describe_limit(*limit, options_));
}

bool NetworkMatch::wait_until(const std::function<bool()>& reached,
                              std::function<std::string()> what) {
  waiting_for_ = std::move(what);
  while (!ended() && !reached()) {
    std::this_thread::sleep_for(kLook);
    check();
  }
  waiting_for_ = {};
  return !ended();
}

int NetworkMatch::cycle_now() const {
  int cycle = log_.moment().time;
  for (const Side& side : sides_) {
    if (side.own) cycle = std::max(cycle, side.own->moment().progress.cycle);
  }
  return cycle;
}

// How long a match that goes well may seem to stand. Players see every cycle; logs leave out those
// before a kick-off, in which the clock stands.
std::chrono::milliseconds NetworkMatch::silent_time() const {
  if (sides_[0].own || sides_[1].own) return kLook;
  const soccer::ServerParams& server = options_.server;
  const milliseconds cycle(server.simulator_step * server.slow_down_factor);
  return cycle * (server.kick_off_wait + 1);
}

void NetworkMatch::look(MatchObserver& observer) {
  log_.look();
  std::int64_t seen = log_.moment().shows;
  MatchProgress progress = {log_.moment().time, 0, log_.moment().left_score,
                            log_.moment().right_score, log_.moment().mode};
  for (const Side& side : sides_) {
    if (!side.own) continue;
    const OwnTeam::Moment moment = side.own->moment();
    seen = std::max(seen, moment.cycles_seen);
    if (moment.progress.cycle >= progress.cycle) progress = moment.progress;
  }
  if (seen > cycles_seen_) {
    cycles_seen_ = seen;
    seen_at_ = Clock::now();
  }
  if (Clock::now() - seen_at_ < silent_time()) watch_.cycle_begins();
  if (progress.cycle > 0) {
    last_cycle_ = Clock::now();
    if (first_cycle_ == Clock::time_point{}) first_cycle_ = last_cycle_;
  }
  progress.last_cycle = options_.cycles.value_or(options_.server.normal_time_cycles());
  observer.on_cycle(progress);
}

void NetworkMatch::tell_news(MatchObserver& observer) {
  for (Side& side : sides_) {
    if (!side.own) continue;
    for (const std::string& line : side.own->take_warnings()) {
      warn(observer, fmt::format("{}: {}", side.own->side().name(), line));
    }
  }
  if (match_is_over()) return;
  std::size_t departures = 0;
  for (const AnnouncedTeam& team : output_.news().teams) {
    for (const int unum : team.departed) {
      if (departures++ < departures_told_) continue;
      ++departures_told_;
      warn(observer,
           fmt::format("player {} of {} left the match at cycle {}", unum, team.name, cycle_now()));
    }
  }
}

void NetworkMatch::play_cycles(MatchObserver& observer) {
  if (ended()) return;
  observer.on_phase("playing");
  playing_ = true;
  seen_at_ = Clock::now();
  watch_.cycle_begins();
  while (!ended()) {
    look(observer);
    check();
    tell_news(observer);
    if (match_is_over() || cycle_limit_reached()) finish_play();
    if (!ended()) std::this_thread::sleep_for(kLook);
  }
}

void NetworkMatch::finish_play() {
  for (const Side& side : sides_) {
    if (!left_before_the_end(side)) continue;
    end_by_death(side, *side.departure->agent, side.departure->cycle);
  }
  end(EndReason::kFinished, "");
}

void NetworkMatch::end_server() {
  if (server_ == nullptr) return;
  // A team that reached the cycle limit has left the server waiting: it makes no step more.
  const bool ends_itself = end_->reason == EndReason::kFinished && !cycle_limit_reached();
  const auto until = Clock::now() + kServerEndsItself;
  while (ends_itself && !server_->wait_exit(kLook) && Clock::now() < until) {
    if (watch_.signal() != 0) break;
  }
  server_->end(kServerGrace);
  // Nobody may leave before it: it would go on without them.
  if (cycle_limit_reached()) server_->wait_gone(kServerGrace + kKillMargin);
}

void NetworkMatch::finish() {
  end_server();
  for (Side& side : sides_) {
    if (side.own) side.own->stop();
    if (side.foreign) side.foreign->call_kill_script();
  }
  for (Side& side : sides_) {
    if (side.foreign) side.foreign->end(kProgramGrace);
    if (!side.own) continue;
    if (side.own->stage() != OwnTeam::Stage::kIdle) {
      side.own->wait_over(kProgramGrace + kKillMargin);
    }
    const PlaymakerProgram* program = side.own->side().program();
    if (program != nullptr) program->child().end(kProgramGrace);
  }
  await_gone();
}

void NetworkMatch::await_gone() {
  if (server_ != nullptr) {
    server_->wait_gone(kServerGrace + kKillMargin);
    processes_.push_back(result_of(*server_));
  }
  for (Side& side : sides_) {
    if (side.foreign) {
      side.foreign->wait_gone(kProgramGrace + kKillMargin);
      for (ProcessResult& result : side.foreign->results()) processes_.push_back(std::move(result));
    } else if (side.own && side.own->side().program() != nullptr) {
      const process::Child& child = side.own->side().program()->child();
      child.wait_gone(kProgramGrace + kKillMargin);
      processes_.push_back(result_of(child));
    }
  }
}

void NetworkMatch::warn_of_deadline(MatchObserver& observer) {
  const bool ours = sides_[0].own || sides_[1].own;
  const auto deadline = decision_deadline(options_);
  if (!ours || mode_of(options_) != MatchMode::kSynch || !deadline) return;
  if (*deadline <= kServerWaits) return;
  warn(observer, fmt::format("--rpc-deadline {} ms: a soccer server in synchronous mode goes on "
                             "without an answer after {} ms",
                             deadline->count(), kServerWaits.count()));
}

void NetworkMatch::play(MatchObserver& observer) {
  if (const std::string taken = taken_port(plan_); !taken.empty()) {
    try_again_ = true;
    end(EndReason::kRefused, taken);
  } else {
    start_sides();
    warn_of_deadline(observer);
    wait_for_playmakers(observer);
    start_server(observer);
    join(0, observer);
    join(1, observer);
    if (sides_.size() > 2) join(2, observer);
    introduce(observer);
    play_cycles(observer);
  }
  finish();
}

}  // namespace cls::orchestration::match
