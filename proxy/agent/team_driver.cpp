// Waiting for messages of the server and replies of the Playmaker concurrently.
#include "proxy/agent/team_driver.h"

#include <algorithm>
#include <memory>
#include <utility>

#include "base/system/standstill.h"
#include "soccer/protocol/reply_code.h"

namespace cls::proxy {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

constexpr milliseconds kPollInterval{50};
constexpr milliseconds kProbeInterval{100};
// A server without a coach port does not reply.
constexpr milliseconds kCoachTimeout{3000};
constexpr milliseconds kCoachRetry{200};
// While replies are outstanding: waiting time for one source before polling the other.
constexpr std::chrono::microseconds kReplyTimeout{300};

// True when a server replies at the port. No soccer server knows the command (hello), so each
// replies with an error and does nothing else. A closed port fails immediately. `keep_waiting` is
// asked after each request without a reply. Messages of players who have joined wait meanwhile.
bool server_replies(const soccer::UdpClients& clients, int port, steady_clock::time_point deadline,
                    const ShouldContinue& keep_waiting) {
  const std::unique_ptr<soccer::UdpClients> alone = clients.beside();
  const std::unique_ptr<soccer::Channel> probe = alone ? alone->connect(port) : nullptr;
  std::string reply;
  while (probe != nullptr && steady_clock::now() < deadline && probe->send("(hello)")) {
    const auto next = std::min(deadline, steady_clock::now() + kProbeInterval);
    while (steady_clock::now() < next && alone->wait_until(next)) {
      if (probe->receive(reply)) return true;
    }
    if (!keep_waiting()) break;
  }
  return false;
}

// True when a coach was refused because the server does not know its team.
bool lacks_team(const std::string& error) {
  return error.ends_with(soccer::name(soccer::ErrorCode::kNoSuchTeam));
}

}  // namespace

bool wait_for_server(soccer::UdpClients& clients, const ShouldContinue& should_continue) {
  while (should_continue()) {
    const auto next = steady_clock::now() + kProbeInterval;
    if (server_replies(clients, 0, next, should_continue)) return true;
    // A closed port fails immediately: wait for the rest of the interval.
    while (should_continue() && steady_clock::now() < next) clients.wait_until(next);
  }
  return false;
}

base::Result<void> TeamDriver::connect(const ShouldContinue& should_continue) {
  const auto connected = connect_all(should_continue);
  if (connected && !team_.synchronous()) clients_.read_on_thread();
  return connected;
}

base::Result<void> TeamDriver::connect_all(const ShouldContinue& should_continue) {
  const auto serve = [&] {
    clients_.wait_until(steady_clock::now() + kPollInterval);
    return should_continue();
  };
  const auto open = [this] {
    auto channel = clients_.connect();
    return options_.wrap && channel != nullptr ? options_.wrap(std::move(channel))
                                               : std::move(channel);
  };
  TRY(team_.connect(open, serve));

  if (options_.coach_port != 0) {
    const auto connected = connect_coach(serve);
    if (!connected && team_.players().empty()) return connected;
    if (!connected) team_.warn_once(connected.error().message + ": the team plays without a coach");
  }

  if (options_.trainer_port == 0) return {};
  return team_.connect_coach(
      soccer::CoachRole::kTrainer, [this] { return clients_.connect(options_.trainer_port); },
      serve);
}

base::Result<void> TeamDriver::connect_coach(const Serve& serve) {
  const auto deadline = steady_clock::now() + kCoachTimeout;
  if (!server_replies(clients_, options_.coach_port, deadline, serve)) {
    return base::Error{"no soccer server accepts coaches at port " +
                       std::to_string(options_.coach_port)};
  }
  const auto open = [this] { return clients_.connect(options_.coach_port); };
  const auto connect = [&] {
    return team_.connect_coach(soccer::CoachRole::kOnlineCoach, open, serve);
  };

  base::Result<void> connected = connect();
  // A coach with a host of its own may come before the first player of its team.
  while (!connected && team_.players().empty() && lacks_team(connected.error().message)) {
    clients_.wait_until(steady_clock::now() + kCoachRetry);
    if (!serve()) break;
    connected = connect();
  }
  return connected;
}

bool TeamDriver::time_over() const {
  return team_.world().game.mode == soccer::PlayMode::kTimeOver;
}

std::optional<DriveResult> TeamDriver::end_of_run(Instant now, Instant last_message) const {
  if (options_.leave_at_time_over && time_over()) return DriveResult::kTimeOver;
  const milliseconds patience = time_over() ? options_.timeout_after_end : options_.server_timeout;
  if (now - last_message <= patience) return std::nullopt;
  const CoachAgent* coach = team_.coach();
  const bool coach_hears =
      coach != nullptr && now - coach->server().channel->received_at() < patience;
  return coach_hears ? DriveResult::kPlayersUnheard : DriveResult::kServerUnresponsive;
}

DriveResult TeamDriver::run(const ShouldContinue& should_continue) {
  auto last_message = steady_clock::now();
  DriveResult end = DriveResult::kStopped;
  base::StandstillWatch watch;
  while (should_continue()) {
    if (options_.before_decisions && team_.begins_turn(steady_clock::now())) {
      options_.before_decisions();
      last_message = steady_clock::now();
    }

    const auto now = steady_clock::now();
    if (watch.check(now) > steady_clock::duration::zero()) last_message = now;
    const bool begun = team_.begin_decisions(now) > 0;
    last_message = std::max(last_message, team_.heard_at());
    if (team_.outstanding() > 0) {
      const bool received = clients_.wait_until(now);
      // More messages may make more decisions due, which should be requested first.
      team_.handle_reply(received && begun ? std::chrono::microseconds(0) : kReplyTimeout);
      continue;
    }

    if (const auto reason = end_of_run(now, last_message)) {
      end = *reason;
      break;
    }
    clients_.wait_until(std::min(team_.next_due(), now + kPollInterval));
  }
  while (team_.outstanding() > 0) team_.handle_reply(kPollInterval);
  return end;
}

}  // namespace cls::proxy
