// Life of a cls team on its own thread.
#include "match/sides/network_agents.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "match/sides/pace.h"

namespace cls::match {
namespace {

using base::Result;
using std::chrono::milliseconds;
using Clock = std::chrono::steady_clock;

constexpr milliseconds kLimitPollInterval{5};
constexpr std::chrono::milliseconds kConnectTimeout{100};

}  // namespace

Result<std::unique_ptr<NetworkAgents>> NetworkAgents::create(AgentParts parts,
                                                             NetworkSettings settings) {
  TRY_INIT(auto clients, soccer::UdpClients::create(settings.server_host, settings.server_port));
  std::unique_ptr<NetworkAgents> agents(new NetworkAgents(std::move(parts), std::move(settings)));
  agents->clients_ = std::move(clients);

  proxy::DriverOptions driver;
  driver.leave_at_time_over = agents->settings_.leave_at_time_over;
  driver.coach_port = agents->settings_.coach_port;
  driver.trainer_port = agents->settings_.trainer_port;
  driver.wrap = agents->settings_.wrap;
  driver.before_decisions = [side = agents.get()] { side->before_decisions(); };
  agents->driver_ = std::make_unique<proxy::TeamDriver>(agents->team(), *agents->clients_, driver);
  return agents;
}

NetworkAgents::~NetworkAgents() {
  stop();
  worker().wait();
}

// A Playmaker that takes long to start must not make the players on the pitch wait for it.
bool NetworkAgents::prepared() {
  return std::ranges::all_of(playmaker_processes(), [](const PlaymakerProcess* started) {
    return started->answers(kConnectTimeout);
  });
}

std::optional<MatchEnd> NetworkAgents::join(const ServerStatus& /*server*/,
                                            const std::vector<std::string>& /*others*/) {
  if (stage_ != Stage::kIdle) return std::nullopt;
  stage_ = Stage::kJoining;
  worker().start([this] { live(); });
  return std::nullopt;
}

std::string NetworkAgents::waiting_for() const {
  return stage_ == Stage::kJoining ? fmt::format("{} could not join the match", who())
                                   : no_answer();
}

// A team that cannot join has not called its Playmaker yet.
std::string NetworkAgents::timeout_hint() const {
  return stage_ == Stage::kJoining ? std::string() : AgentSide::timeout_hint();
}

void NetworkAgents::stop() {
  if (stop_.exchange(true)) return;
  gate_.open();
  cancel();
}

// With the lock.
bool NetworkAgents::has_finished() const {
  if (!settings_.leave_at_time_over) return stage_ == Stage::kOver && !end_;
  return snapshot_.progress.match.mode == soccer::PlayMode::kTimeOver;
}

std::optional<SeenMatch> NetworkAgents::seen() const {
  const std::lock_guard lock(mutex_);
  return SeenMatch{.progress = snapshot_.progress,
                   .ball = snapshot_.ball,
                   .mode = mode_,
                   .finished = has_finished(),
                   .at_cycle_limit = reached_limit_};
}

TurnTimes NetworkAgents::turn_times() const {
  const std::lock_guard lock(mutex_);
  return snapshot_.turns;
}

std::optional<MatchEnd> NetworkAgents::agent_failure(const MatchMoment& /*moment*/) {
  const std::lock_guard lock(mutex_);
  return end_;
}

std::vector<std::string> NetworkAgents::take_warnings() {
  const std::lock_guard lock(mutex_);
  return std::exchange(warnings_, {});
}

// A server that has ended stops responding. Any other failure came before.
std::optional<MatchEnd> NetworkAgents::final_failure(const MatchMoment& moment) {
  const auto end = agent_failure(moment);
  if (!end || end->reason == EndReason::kServerFailed) return std::nullopt;
  return failure(moment);
}

void NetworkAgents::fail(MatchEnd end) {
  const std::lock_guard lock(mutex_);
  if (!end_ && !stop_) end_ = std::move(end);
}

void NetworkAgents::live() {
  if (join_server() && register_agents()) play();
  if (near_limit_) wait_for_cycle_limit();
  end_listening();
  team().leave();
  stage_ = Stage::kOver;
}

bool NetworkAgents::join_server() {
  const auto connected = driver_->connect([this] { return !stop_.load(); });
  if (!connected) {
    fail({.reason = EndReason::kRefused, .message = connected.error().message});
    return false;
  }

  mode_ = team().synchronous() ? MatchMode::kSynch : MatchMode::kRealtime;
  if (settings_.right_playmaker && team().side() == soccer::Side::kRight) {
    replace_playmaker(settings_.right_playmaker());
  }

  stage_ = Stage::kHandshake;
  return true;
}

bool NetworkAgents::register_agents() {
  if (auto end = shake_hands()) {
    fail(*std::move(end));
    return false;
  }
  if (settings_.on_ready && !stop_) settings_.on_ready(team());
  stage_ = Stage::kPlaying;
  return !stop_.load();
}

void NetworkAgents::play() {
  const proxy::DriveResult end = driver_->run([this] { return keep_playing(); });
  update_snapshot();
  const bool over = team().world().game.mode == soccer::PlayMode::kTimeOver;
  const bool unheard = end == proxy::DriveResult::kPlayersUnheard;
  if (!unheard && end != proxy::DriveResult::kServerUnresponsive) return;
  if (over && !settings_.leave_at_time_over) return;

  const char* problem = unheard ? "sends nothing to the players any more: another client may have "
                                  "taken them over by (reconnect)"
                                : "stopped responding";
  fail({.reason = EndReason::kServerFailed,
        .message = fmt::format("{}: the soccer server {}", who(), problem)});
}

void NetworkAgents::begin_play() { playing_ = true; }

void NetworkAgents::end_play() {
  playing_ = false;
  gate_.open();
}

void NetworkAgents::before_decisions() {
  end_listening();
  if (stop_) return;

  holds_turns_ = holds_turns_ || (settings_.hold_turns && has_kicked_off());
  if (holds_turns_) {
    update_snapshot();
    gate_.wait();
  }
  throttle();
  begin_listening(team().world().game.time.cycle);
}

// All sides hear of the kick-off in the same cycle. If they began to wait in different ones, a side
// would wait for its turn, and the server and the other side for that side.
bool NetworkAgents::has_kicked_off() const {
  return std::ranges::any_of(team().players(), [](const auto& player) {
    return player->world().game.mode != soccer::PlayMode::kBeforeKickOff;
  });
}

// Waits until the next cycle is due.
void NetworkAgents::throttle() {
  if (!settings_.speed || !playing_ || !team().synchronous()) return;
  if (turns_++ == 0) first_turn_ = Clock::now();
  keep_pace(first_turn_, turns_, team().world().server().simulator_step, *settings_.speed,
            [this] { return stop_.load(); });
}

// All players have sent their commands of the last cycle before the limit.
bool NetworkAgents::near_cycle_limit() const {
  const std::optional<int>& limit = settings_.cycle_limit;
  if (!limit || team().outstanding() > 0) return false;

  return std::ranges::all_of(team().players(), [&](const auto& player) {
    const int time = player->world().game.time.cycle;
    return time >= *limit ||
           (time == *limit - 1 && player->timer().due_at() == proxy::Instant::max());
  });
}

// Sees the last cycle begin without taking part in it: a server that waits for its clients makes no
// further step. It would continue without a team that had left.
void NetworkAgents::wait_for_cycle_limit() {
  while (!stop_) {
    clients_->wait_until(Clock::now() + kLimitPollInterval);
    for (const auto& player : team().players()) {
      player->perceive();
      if (player->world().game.time.cycle >= *settings_.cycle_limit) reached_limit_ = true;
    }
  }
}

void NetworkAgents::update_snapshot() {
  const player::WorldModel& world = std::as_const(*this).team().world();
  const player::GameState& game = world.game;
  const bool left = team().side() != soccer::Side::kRight;

  const std::lock_guard lock(mutex_);
  MatchProgress& progress = snapshot_.progress.match;
  // The referee's last message may come before the senses of its cycle, or instead of them.
  progress.cycle = std::max(game.time.cycle, game.mode_start.cycle);
  progress.mode = game.mode;
  progress.left_score = left ? game.our_score : game.their_score;
  progress.right_score = left ? game.their_score : game.our_score;

  std::int64_t& steps = snapshot_.progress.steps;
  for (const auto& player : team().players()) {
    steps = std::max(steps, player->statistics().decisions);
  }
  if (const proxy::CoachAgent* coach = team().coach()) {
    steps = std::max(steps, coach->statistics().decisions);
  }

  snapshot_.ball.reset();
  if (world.ball.position_valid()) {
    snapshot_.ball = left ? world.ball.position : -world.ball.position;
  }
  snapshot_.turns = AgentSide::turn_times();
  for (std::string& line : team().take_warnings()) warnings_.push_back(std::move(line));
}

bool NetworkAgents::keep_playing() {
  near_limit_ = near_cycle_limit();
  update_snapshot();
  const int cycle = team().world().game.time.cycle;
  if (auto end = end_by_missed_decisions(team().missed_decisions(), who(), cycle, options())) {
    fail(*std::move(end));
    return false;
  }
  return !stop_ && !near_limit_;
}

void NetworkAgents::leave() { stop(); }

void NetworkAgents::terminate() {
  if (stage_ != Stage::kIdle) worker().wait_for(kTerminateGrace + kKillMargin);
  for (const auto* started : playmaker_processes()) started->child().end(kTerminateGrace);
  worker().wait();  // the result is read next: what the thread writes may not be read meanwhile
}

}  // namespace cls::match
