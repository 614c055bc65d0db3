// Runs a match over UDP.
#include "simulator/server/udp_server.h"

#include <algorithm>
#include <thread>
#include <utility>

#include "simulator/server/udp_network.h"

namespace cls::simulator {
namespace {

using WallClock = std::chrono::steady_clock;

/// Time limit of the last poll before a step. One pass reads from every client; only floods exceed
/// it.
constexpr std::chrono::milliseconds kLastPollLimit{1};

}  // namespace

base::Result<std::unique_ptr<UdpServer>> UdpServer::open(UdpConfig config) {
  TRY_INIT(auto match, MatchServer::create(config.match));
  std::unique_ptr<UdpServer> server(new UdpServer(std::move(config), std::move(match)));

  const UdpConfig& options = server->config_;
  UdpNetwork& sockets = *server->network_;
  for (const auto& [network, player, coach] : options.others) {
    TRY(sockets.open_in(network, ListeningPort::kPlayers, options.address, player));
    TRY(sockets.open_in(network, ListeningPort::kOnlineCoaches, options.address, coach));
  }

  const std::pair<ListeningPort, int> ports[] = {
      {ListeningPort::kPlayers, options.port},
      {ListeningPort::kTrainers, options.trainer_port},
      {ListeningPort::kOnlineCoaches, options.coach_port}};
  for (const auto& [role, port] : ports) {
    TRY(sockets.open(role, options.address, port));
  }
  return server;
}

UdpServer::UdpServer(UdpConfig config, std::unique_ptr<MatchServer> match)
    : config_(std::move(config)), match_(std::move(match)), network_(make_udp_network(*match_)) {
  if (world().params().synch_mode) match_->answer_on_receipt();
}

// Connections own sockets registered with the network, so they are destroyed first.
UdpServer::~UdpServer() { match_->disconnect_all(); }

void UdpServer::bind_clients(RightsOf rights_of, OnIntrusion on_intrusion) {
  network_->bind_clients(std::move(rights_of), std::move(on_intrusion));
}

int UdpServer::port(ListeningPort role) const { return network_->port(role); }

std::int64_t UdpServer::missed_cycles() const { return missed_cycles_; }

const World& UdpServer::world() const { return match_->world(); }

UdpServerExit UdpServer::run(const std::atomic<bool>& stop) {
  const UdpServerExit end =
      world().params().synch_mode ? run_synchronous(stop) : run_in_real_time(stop);

  network_->flush();
  match_->finish();
  return end;
}

void UdpServer::announce_end() {
  if (world().mode == PlayMode::kTimeOver) return;
  match_->announce_end();
  network_->flush();
}

bool UdpServer::is_over() const {
  if (!match_->finished()) return false;
  if (world().mode != PlayMode::kTimeOver) return true;
  return world().params().auto_mode && (match_->connected() == 0 || world().auto_mode.ended);
}

UdpServerExit UdpServer::run_synchronous(const std::atomic<bool>& stop) {
  while (!stop.load()) {
    if (!run_cycle(stop)) return UdpServerExit::kUnresponsiveClients;
    if (is_over()) return UdpServerExit::kFinished;
  }
  return UdpServerExit::kStopped;
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
  bool missed = !wait_for_clients(stop, [this] { return !match_->awaits_any_client(); });
  report_connections();

  match_->execute_players();
  if (coaches_are_late) {
    match_->think_coaches();
    const auto coaches_are_done = [this] { return !match_->awaits_coaches(); };
    missed = !wait_for_clients(stop, coaches_are_done) || missed;
  }
  match_->execute_coaches();
  report_connections();

  if (missed && started) {
    ++missed_cycles_;
    ++missed_in_a_row_;
    report(UdpServerEvent::Kind::kMissedCycle, kNoClient);
  } else {
    missed_in_a_row_ = 0;
  }
  return missed_in_a_row_ <= config_.max_missed;
}

// Waits in short intervals to check `stop`.
bool UdpServer::wait_for_clients(const std::atomic<bool>& stop,
                                 const std::function<bool()>& enough) {
  constexpr std::chrono::milliseconds kPollInterval{20};
  const auto begin = WallClock::now();
  const auto deadline = begin + config_.max_wait;
  std::array<std::chrono::nanoseconds, 2> awaited{};
  const auto measured_enough = [&] {
    const auto now = WallClock::now();
    if (awaits_side(Side::kLeft)) awaited[0] = now - begin;
    if (awaits_side(Side::kRight)) awaited[1] = now - begin;
    return enough();
  };
  do {
    network_->receive_until(std::min(deadline, WallClock::now() + kPollInterval), measured_enough);
  } while (!enough() && !stop.load() && WallClock::now() < deadline);
  awaited_[0] += awaited[0];
  awaited_[1] += awaited[1];
  return enough();
}

bool UdpServer::awaits_side(Side side) const {
  for (int unum = 1; unum <= soccer::kPlayersPerTeam; ++unum) {
    if (match_->awaits(soccer::slot_of(side, unum))) return true;
  }
  return match_->awaits(side == Side::kLeft ? kLeftCoach : kRightCoach);
}

UdpServerExit UdpServer::run_in_real_time(const std::atomic<bool>& stop) {
  const soccer::ServerParams& params = world().params();
  const int step_ms = params.simulator_step * params.slow_down_factor;
  const std::chrono::milliseconds step(step_ms);
  StepTimer timer(step, WallClock::now() + step);

  while (!stop.load()) {
    receive_until(timer.due(), step_ms, stop);
    timer.record_step(WallClock::now());
    make_step();
    match_->sense();
    lateness_ = timer.lateness();
    if (is_over()) return UdpServerExit::kFinished;
  }
  return UdpServerExit::kStopped;
}

// Polls the sockets every recv_step, and once more for a short time right before the step: a flood
// must not delay the step.
void UdpServer::receive_until(StepTimer::Time next_step, int step_ms,
                              const std::atomic<bool>& stop) {
  const soccer::ServerParams& params = world().params();
  const std::chrono::milliseconds tick(params.recv_step);
  for (auto due = next_step - std::chrono::milliseconds(step_ms) + tick; !stop.load();
       due = std::min(due + tick, next_step)) {
    network_->flush();
    std::this_thread::sleep_until(due);

    const bool last = due >= next_step;
    network_->poll(WallClock::now() + (last ? kLastPollLimit : tick / 2));
    execute();
    if (last) return;

    const auto left = std::chrono::duration_cast<std::chrono::milliseconds>(next_step - due);
    match_->see((step_ms - static_cast<int>(left.count())) / params.slow_down_factor);
  }
}

void UdpServer::make_step() {
  match_->step();
  if (on_step_) on_step_(world());
}

void UdpServer::execute() {
  report_connections();
  match_->execute();
  report_connections();
}

// Called before and after executing commands, which removes lost connections.
void UdpServer::report_connections() {
  for (std::size_t i = 0; i < reported_.size(); ++i) {
    const auto client = static_cast<ClientId>(i);
    const Connection*& reported = reported_[i];
    const Connection* now = match_->connection(client);
    if (now == reported) continue;

    if (now == nullptr) report(UdpServerEvent::Kind::kDisconnected, client);
    if (now != nullptr) report(UdpServerEvent::Kind::kConnected, client, now->version);
    reported = now;
  }
}

}  // namespace cls::simulator
