// The life of a team on its own thread.
#include "orchestration/match/sides/own_team.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace cls::orchestration::match {

using base::Result;

namespace {

constexpr std::chrono::milliseconds kLook{5};

}  // namespace

Result<std::unique_ptr<OwnTeam>> OwnTeam::create(std::unique_ptr<MatchSide> side,
                                                 const std::string& server_host,
                                                 const ServerPorts& ports,
                                                 const MatchOptions& options,
                                                 std::optional<int> cycle_limit) {
  std::unique_ptr<OwnTeam> team(new OwnTeam(std::move(side), options, cycle_limit));
  auto clients = soccer::UdpClients::create(server_host, ports.player);
  if (!clients) return clients.error();
  team->clients_ = std::move(*clients);
  proxy::DriverOptions settings;
  if (team->side_->is_trainer()) {
    settings.trainer_port = ports.trainer;
  } else if (options.coach) {
    settings.coach_port = ports.coach;
  }
  team->driver_ =
      std::make_unique<proxy::TeamDriver>(team->side_->team(), *team->clients_, settings);
  return team;
}

OwnTeam::~OwnTeam() {
  stop();
  while (!wait_over(std::chrono::milliseconds(1000))) {
  }
}

std::string OwnTeam::who() const {
  return fmt::format("{} ({})", side_->name(), side_->endpoint().text);
}

void OwnTeam::start() {
  stage_ = Stage::kJoining;
  side_->worker().start([this] { live(); });
}

void OwnTeam::stop() {
  if (stop_.exchange(true)) return;
  side_->playmaker().cancel();
}

OwnTeam::Moment OwnTeam::moment() const {
  const std::lock_guard lock(mutex_);
  return moment_;
}

std::optional<MatchEnd> OwnTeam::end() const {
  const std::lock_guard lock(mutex_);
  return end_;
}

std::vector<std::string> OwnTeam::take_warnings() {
  const std::lock_guard lock(mutex_);
  return std::exchange(warnings_, {});
}

void OwnTeam::fail(EndReason reason, std::string message) {
  const std::lock_guard lock(mutex_);
  if (!end_ && !stop_) end_ = MatchEnd{reason, std::move(message), std::nullopt};
}

void OwnTeam::live() {
  if (join() && introduce()) play();
  if (limit_near_) await_last_cycle();
  side_->team().leave();
  stage_ = Stage::kOver;
}

// Sees the last cycle begin without taking part in it: a server that waits for everybody makes no
// step more. A team that left would let it go on.
void OwnTeam::await_last_cycle() {
  while (!stop_) {
    clients_->wait_until(std::chrono::steady_clock::now() + kLook);
    for (const auto& player : side_->team().players()) {
      player->perceive();
      if (player->world().game.time.cycle >= *cycle_limit_) reached_limit_ = true;
    }
  }
}

bool OwnTeam::join() {
  const auto connected = driver_->connect([this] { return !stop_.load(); });
  if (!connected) fail(EndReason::kRefused, connected.error().message);
  if (!connected) return false;
  mode_ = side_->team().synchronous() ? MatchMode::kSynch : MatchMode::kRealtime;
  stage_ = Stage::kIntroducing;
  return true;
}

bool OwnTeam::introduce() {
  const proxy::RpcStatus status = side_->team().introduce();
  if (status.ok()) {
    stage_ = Stage::kPlaying;
    return !stop_.load();
  }
  const bool garbled = status.outcome == proxy::RpcOutcome::kProtocolError;
  fail(garbled ? EndReason::kProtocolError : EndReason::kRefused,
       fmt::format("{}: {}", who(), status.message));
  return false;
}

void OwnTeam::play() {
  switch (driver_->run([this] { return look_and_go_on(); })) {
    case proxy::DriveEnd::kServerSilent:
      fail(EndReason::kServerFailed, fmt::format("{}: the soccer server fell silent", who()));
      break;
    case proxy::DriveEnd::kTimeOver:
      look_and_go_on();  // the last moment
      break;
    case proxy::DriveEnd::kStopped:
      break;
  }
}

// All have done what they wanted in the last cycle before the limit.
bool OwnTeam::cycle_limit_near() const {
  const proxy::Team& team = side_->team();
  if (!cycle_limit_ || team.outstanding() > 0) return false;
  const auto& players = team.players();
  return std::all_of(players.begin(), players.end(), [this](const auto& player) {
    const int time = player->world().game.time.cycle;
    return time >= *cycle_limit_ ||
           (time == *cycle_limit_ - 1 && player->timer().due_at() == proxy::Instant::max());
  });
}

bool OwnTeam::look_and_go_on() {
  const proxy::Team& team = side_->team();
  const proxy::GameState& game = team.world().game;
  const bool left = team.side() != soccer::Side::kRight;
  limit_near_ = cycle_limit_near();
  const std::lock_guard lock(mutex_);
  MatchProgress& progress = moment_.progress;
  // The referee's last word may come before the senses of its cycle, or instead of them.
  progress.cycle = std::max(game.time.cycle, game.mode_start.cycle);
  progress.mode = game.mode;
  progress.left_score = left ? game.our_score : game.their_score;
  progress.right_score = left ? game.their_score : game.our_score;
  for (const auto& player : team.players()) {
    moment_.cycles_seen = std::max(moment_.cycles_seen, player->statistics().decisions);
  }
  if (const proxy::CoachAgent* coach = team.coach()) {
    moment_.cycles_seen = std::max(moment_.cycles_seen, coach->statistics().decisions);
  }
  for (std::string& line : side_->team().take_warnings()) warnings_.push_back(std::move(line));
  if (auto end = end_by_missing_answers(team.missing_answers(), who(), game.time.cycle, options_)) {
    if (!end_ && !stop_) end_ = std::move(end);
    return false;
  }
  return !stop_ && !limit_near_;
}

}  // namespace cls::orchestration::match
