// Waiting for two things at once: messages of the server and answers of the Playmaker.
#include "proxy/team_driver.h"

#include <algorithm>
#include <memory>

namespace cls::proxy {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

constexpr milliseconds kLook{50};
constexpr milliseconds kProbePause{100};
// While answers are outstanding, how long one of both is waited for before the other gets its turn.
constexpr std::chrono::microseconds kTurn{300};

}  // namespace

bool wait_for_server(soccer::UdpClients& clients, const GoOn& go_on) {
  std::string answer;
  while (go_on()) {
    const std::unique_ptr<soccer::Channel> probe = clients.connect();
    // No soccer server knows this word, so each answers it with an error and nothing else.
    if (probe != nullptr) probe->send("(hello)");
    const auto next = steady_clock::now() + kProbePause;
    while (probe != nullptr && steady_clock::now() < next && clients.wait_until(next)) {
      if (probe->receive(answer)) return true;
    }
    // A closed port is known at once: the next try still comes after the pause.
    while (go_on() && steady_clock::now() < next) clients.wait_until(next);
  }
  return false;
}

soccer::Result<void> TeamDriver::connect(const GoOn& go_on) {
  const auto serve = [&] {
    clients_.wait_until(steady_clock::now() + kLook);
    return go_on();
  };
  const auto connected = team_.connect([this] { return clients_.connect(); }, serve);
  const auto& players = team_.players();
  if (!players.empty() && !players.front()->timer().synchronous()) clients_.read_on_thread();
  return connected;
}

bool TeamDriver::time_over() const {
  const auto& players = team_.players();
  return std::any_of(players.begin(), players.end(), [](const auto& player) {
    return player->world().game.mode == soccer::PlayMode::kTimeOver;
  });
}

void TeamDriver::finish_answers() {
  while (team_.outstanding() > 0) team_.take_reply(kLook);
}

DriveEnd TeamDriver::run(const GoOn& go_on) {
  auto last_message = steady_clock::now();
  DriveEnd end = DriveEnd::kStopped;
  while (go_on()) {
    const auto now = steady_clock::now();
    const bool asked = team_.ask(now) > 0;
    if (team_.outstanding() > 0) {
      const bool news = clients_.wait_until(now);
      if (news) last_message = now;
      // More messages may make more decisions due, which should be on their way first.
      team_.take_reply(news && asked ? std::chrono::microseconds(0) : kTurn);
      continue;
    }
    if (options_.leave_at_time_over && time_over()) {
      end = DriveEnd::kTimeOver;
      break;
    }
    if (clients_.wait_until(std::min(team_.next_due(), now + kLook))) {
      last_message = steady_clock::now();
    } else if (steady_clock::now() - last_message > options_.silence) {
      end = DriveEnd::kServerSilent;
      break;
    }
  }
  finish_answers();
  return end;
}

}  // namespace cls::proxy
