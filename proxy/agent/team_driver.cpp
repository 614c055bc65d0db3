// Waiting for two things at once: messages of the server and answers of the Playmaker.
#include "proxy/agent/team_driver.h"

#include <algorithm>
#include <memory>

namespace cls::proxy {
namespace {

using std::chrono::milliseconds;
using std::chrono::steady_clock;

constexpr milliseconds kLook{50};
constexpr milliseconds kProbePause{100};
// A server that has no door for coaches does not say so.
constexpr milliseconds kCoachWait{3000};
// While answers are outstanding, how long one of both is waited for before the other gets its turn.
constexpr std::chrono::microseconds kTurn{300};

// Whether something speaks at the server's door. No soccer server knows the word, so each answers
// it with an error and nothing else. A closed port is known at once.
bool answers(soccer::UdpClients& clients, int port, steady_clock::time_point until) {
  const std::unique_ptr<soccer::Channel> probe = clients.connect(port);
  std::string answer;
  while (probe != nullptr && steady_clock::now() < until && probe->send("(hello)")) {
    const auto next = std::min(until, steady_clock::now() + kProbePause);
    while (steady_clock::now() < next && clients.wait_until(next)) {
      if (probe->receive(answer)) return true;
    }
  }
  return false;
}

}  // namespace

bool wait_for_server(soccer::UdpClients& clients, const GoOn& go_on) {
  while (go_on()) {
    const auto next = steady_clock::now() + kProbePause;
    if (answers(clients, 0, next)) return true;
    // A closed port is known at once: the next try still comes after the pause.
    while (go_on() && steady_clock::now() < next) clients.wait_until(next);
  }
  return false;
}

base::Result<void> TeamDriver::connect(const GoOn& go_on) {
  const auto connected = connect_all(go_on);
  if (connected && !team_.synchronous()) clients_.read_on_thread();
  return connected;
}

base::Result<void> TeamDriver::connect_all(const GoOn& go_on) {
  const auto serve = [&] {
    clients_.wait_until(steady_clock::now() + kLook);
    return go_on();
  };
  if (auto done = team_.connect([this] { return clients_.connect(); }, serve); !done) return done;
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
  const auto until = steady_clock::now() + kCoachWait;
  if (!answers(clients_, options_.coach_port, until)) {
    return base::Error{"nobody lets coaches in at port " + std::to_string(options_.coach_port)};
  }
  const auto open = [this] { return clients_.connect(options_.coach_port); };
  return team_.connect_coach(soccer::CoachRole::kOnlineCoach, open, serve);
}

bool TeamDriver::time_over() const {
  return team_.world().game.mode == soccer::PlayMode::kTimeOver;
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
