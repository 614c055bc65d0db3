// Driving a match over UDP.
#include "simulator/server/udp_server.h"

#include <algorithm>
#include <thread>
#include <utility>

#include "simulator/server/udp_network.h"

namespace cls::simulator {
namespace {

using WallClock = std::chrono::steady_clock;

/// Everybody has had a turn at once; only who sends on and on is cut short.
constexpr std::chrono::milliseconds kLastLook{1};

}  // namespace

base::Result<std::unique_ptr<UdpServer>> UdpServer::open(UdpConfig config) {
  auto match = MatchServer::create(config.match);
  if (!match) return match.error();
  std::unique_ptr<UdpServer> server(new UdpServer(std::move(config), std::move(*match)));
  const UdpConfig& asked = server->config_;
  const std::pair<Door, int> doors[] = {{Door::kGame, asked.port},
                                        {Door::kOfflineCoach, asked.trainer_port},
                                        {Door::kOnlineCoach, asked.coach_port}};
  for (const auto& [door, port] : doors) {
    const auto opened = server->network_->open(door, asked.address, port);
    if (!opened) return opened.error();
  }
  return server;
}

UdpServer::UdpServer(UdpConfig config, std::unique_ptr<MatchServer> match)
    : config_(std::move(config)),
      match_(std::move(match)),
      network_(std::make_unique<UdpNetwork>(*match_)) {}

// Sessions own sockets that belong to the network's context: they go first.
UdpServer::~UdpServer() { match_->disconnect_all(); }

int UdpServer::port(Door door) const { return network_->port(door); }

std::int64_t UdpServer::missed_cycles() const { return missed_cycles_; }

const World& UdpServer::world() const { return match_->world(); }

UdpEnd UdpServer::run(const std::atomic<bool>& stop) {
  const UdpEnd end = world().params().synch_mode ? run_synchronous(stop) : run_in_real_time(stop);
  network_->flush();
  match_->finish();
  return end;
}

bool UdpServer::is_over() const {
  if (!match_->finished()) return false;
  if (world().mode != PlayMode::kTimeOver) return true;
  return world().params().auto_mode && (match_->connected() == 0 || world().auto_mode.ended);
}

UdpEnd UdpServer::run_synchronous(const std::atomic<bool>& stop) {
  while (!stop.load()) {
    if (!run_cycle(stop)) return UdpEnd::kUnanswered;
    if (is_over()) return UdpEnd::kFinished;
  }
  return UdpEnd::kStopped;
}

bool UdpServer::run_cycle(const std::atomic<bool>& stop) {
  make_step();
  match_->sense();
  const bool started = world().clock.time > 0;
  if (!started) {
    network_->receive_until(WallClock::now() + config_.pause_before_start, [] { return false; });
  }
  const bool coaches_are_late = match_->coaches_are_late();
  match_->think_players();
  if (!coaches_are_late) match_->think_coaches();
  bool missed = !wait_for_answers(stop, [this] { return !match_->awaits_anybody(); });
  tell_connections();
  match_->execute_players();
  if (coaches_are_late) {
    match_->think_coaches();
    const auto coaches_are_done = [this] { return !match_->awaits_coaches(); };
    missed = !wait_for_answers(stop, coaches_are_done) || missed;
  }
  match_->execute_coaches();
  tell_connections();
  if (missed) {
    ++missed_cycles_;
    if (started) ++missed_in_a_row_;
    if (started) tell(UdpNotice::Kind::kMissedCycle, kNobody);
  } else {
    missed_in_a_row_ = 0;
  }
  return missed_in_a_row_ <= config_.max_missed;
}

// In slices, so that a wish to stop is noticed.
bool UdpServer::wait_for_answers(const std::atomic<bool>& stop,
                                 const std::function<bool()>& enough) {
  constexpr std::chrono::milliseconds kLook{20};
  const auto deadline = WallClock::now() + config_.max_wait;
  do {
    network_->receive_until(std::min(deadline, WallClock::now() + kLook), enough);
  } while (!enough() && !stop.load() && WallClock::now() < deadline);
  return enough();
}

UdpEnd UdpServer::run_in_real_time(const std::atomic<bool>& stop) {
  const soccer::ServerParams& params = world().params();
  const int step_ms = params.simulator_step * params.slow_down_factor;
  const std::chrono::milliseconds step(step_ms);
  StepClock clock(step, WallClock::now() + step);
  while (!stop.load()) {
    receive_until(clock.due(), step_ms, stop);
    clock.made(WallClock::now());
    make_step();
    match_->sense();
    lateness_ = clock.lateness();
    if (is_over()) return UdpEnd::kFinished;
  }
  return UdpEnd::kStopped;
}

// One look at the sockets every recv_step, and one right before the step, which is short: a flood
// must not make the step late.
void UdpServer::receive_until(StepClock::Time next_step, int step_ms,
                              const std::atomic<bool>& stop) {
  const soccer::ServerParams& params = world().params();
  const std::chrono::milliseconds tick(params.recv_step);
  for (auto due = next_step - std::chrono::milliseconds(step_ms) + tick; !stop.load();
       due = std::min(due + tick, next_step)) {
    network_->flush();
    std::this_thread::sleep_until(due);
    const bool last = due >= next_step;
    network_->poll(WallClock::now() + (last ? kLastLook : tick / 2));
    execute();
    if (last) return;
    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(next_step - due);
    match_->see((step_ms - static_cast<int>(left.count())) / params.slow_down_factor);
  }
}

void UdpServer::make_step() {
  match_->step();
  if (look_) look_(world());
}

void UdpServer::execute() {
  tell_connections();
  match_->execute();
  tell_connections();
}

// Looked at before and after the commands of a cycle, when the lost ones go.
void UdpServer::tell_connections() {
  for (std::size_t i = 0; i < told_.size(); ++i) {
    const auto client = static_cast<ClientId>(i);
    const Connection*& told = told_[i];
    const Connection* now = match_->connection(client);
    if (now == told) continue;
    if (now == nullptr) tell(UdpNotice::Kind::kDisconnected, client);
    if (now != nullptr) tell(UdpNotice::Kind::kConnected, client, now->version);
    told = now;
  }
}

}  // namespace cls::simulator
