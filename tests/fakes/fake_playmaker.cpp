// A Playmaker with the mock's simple team until the fault named by its flags.
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "mock-server/script/named_behaviors.h"
#include "mock-server/server.h"
#include "tests/fakes/flags.h"

namespace {

using cls::fakes::Flags;
using cls::mock_server::Behavior;

/// Works until the cycle of its fault.
class FaultyTeam : public Behavior {
 public:
  FaultyTeam(std::unique_ptr<Behavior> team, const Flags& flags)
      : team_(std::move(team)), flags_(flags) {}

  void decide(const protos::State& state, protos::PlayerActions& actions) const override {
    const int cycle = state.world_model().cycle();
    if (reached("exit-at-cycle", cycle)) {
      std::fprintf(stderr, "out of ideas\n");
      std::_Exit(flags_.number("code", 3));
    }
    if (reached("signal-at-cycle", cycle)) cls::fakes::die_of(flags_.number("signal", SIGSEGV));
    if (reached("hang-at-cycle", cycle)) {
      std::fprintf(stderr, "lost in thought\n");
      std::this_thread::sleep_for(std::chrono::hours(1));
    }
    if (flags_.has("leak-kb")) take(flags_.number("leak-kb"));
    if (flags_.has("grow-at-call") && ++calls_ == flags_.number("grow-at-call")) take(40 << 10);
    team_->decide(state, actions);
  }

 private:
  // Takes memory, and uses it, for as long as the program runs.
  static void take(int kilobytes) {
    static std::mutex mutex;
    static std::deque<std::string> taken;
    const std::scoped_lock lock(mutex);
    taken.emplace_back(static_cast<std::size_t>(kilobytes) << 10, 'x');
  }

  bool reached(const std::string& fault, int cycle) const {
    return flags_.has(fault) && cycle >= flags_.number(fault);
  }

  std::unique_ptr<Behavior> team_;
  const Flags& flags_;
  mutable std::atomic<int> calls_ = 0;
};

}  // namespace

int main(int argc, char** argv) {
  const Flags flags(argc, argv);
  cls::fakes::misbehave_at_start(flags);
  if (flags.has("exit-at-start")) {
    std::fprintf(stderr, "cannot load the formation\n");
    return flags.number("exit-at-start");
  }

  if (flags.has("never-listen")) cls::fakes::hang();
  if (flags.has("silent")) {
    cls::fakes::open_silently(SOCK_STREAM, flags.number("port"));
    cls::fakes::hang();
  }

  std::this_thread::sleep_for(std::chrono::milliseconds(flags.number("late-start-ms")));
  auto team = cls::mock_server::make_behavior("simple");
  if (!team) return 1;
  auto server = cls::mock_server::Server::start(
      std::make_unique<FaultyTeam>(std::move(*team), flags), "127.0.0.1",
      flags.number("port") + flags.number("port-offset"));
  if (!server) {
    std::fprintf(stderr, "%s\n", server.error().message.c_str());
    return 1;
  }
  while (flags.has("flood")) std::printf("thinking about the ball, and thinking, and thinking\n");
  cls::fakes::hang();
}
