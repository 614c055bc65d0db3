// A Playmaker that plays the mock's simple team until it does the wrong thing that its flags name.
#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <memory>
#include <string>
#include <thread>

#include "mock-server/behaviour.h"
#include "mock-server/server.h"

namespace {

using cls::mock_server::Behaviour;

/// `--NAME VALUE` pairs.
class Flags {
 public:
  Flags(int argc, char** argv) {
    for (int i = 1; i + 1 < argc; i += 2) values_[argv[i]] = argv[i + 1];
  }
  bool has(const std::string& name) const { return values_.count("--" + name) != 0; }
  int number(const std::string& name, int otherwise = 0) const {
    const auto found = values_.find("--" + name);
    return found == values_.end() ? otherwise : std::atoi(found->second.c_str());
  }

 private:
  std::map<std::string, std::string> values_;
};

/// Plays well until the cycle of its fault.
class FaultyTeam : public Behaviour {
 public:
  FaultyTeam(std::unique_ptr<Behaviour> team, const Flags& flags)
      : team_(std::move(team)), flags_(flags) {}

  void decide(const protos::State& state, protos::PlayerActions& actions) const override {
    const int cycle = state.world_model().cycle();
    if (reached("exit-at-cycle", cycle)) {
      std::fprintf(stderr, "out of ideas\n");
      std::_Exit(flags_.number("code", 3));
    }
    if (reached("signal-at-cycle", cycle)) ::raise(flags_.number("signal", SIGSEGV));
    if (reached("hang-at-cycle", cycle)) std::this_thread::sleep_for(std::chrono::hours(1));
    team_->decide(state, actions);
  }

 private:
  bool reached(const std::string& fault, int cycle) const {
    return flags_.has(fault) && cycle >= flags_.number(fault);
  }

  std::unique_ptr<Behaviour> team_;
  const Flags& flags_;
};

void leave_grandchild() {
  const pid_t child = ::fork();
  if (child == 0) {
    ::setsid();
    if (::fork() != 0) ::_exit(0);
    ::signal(SIGTERM, SIG_IGN);
    while (true) ::pause();
  }
  ::waitpid(child, nullptr, 0);
}

// Accepts connections and never says a word.
void listen_silently(int port) {
  const int fd = ::socket(AF_INET, SOCK_STREAM, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  ::bind(fd, reinterpret_cast<sockaddr*>(&address), sizeof address);
  ::listen(fd, 16);
}

[[noreturn]] void hang() {
  while (true) ::pause();
}

}  // namespace

int main(int argc, char** argv) {
  const Flags flags(argc, argv);
  if (flags.has("ignore-term")) ::signal(SIGTERM, SIG_IGN);
  if (flags.has("grandchild")) leave_grandchild();
  if (flags.has("exit-at-start")) {
    std::fprintf(stderr, "cannot load the formation\n");
    return flags.number("exit-at-start");
  }
  if (flags.has("never-listen")) hang();
  if (flags.has("silent")) {
    listen_silently(flags.number("port"));
    hang();
  }
  std::this_thread::sleep_for(std::chrono::milliseconds(flags.number("late-start-ms")));
  auto team = cls::mock_server::make_behaviour("");
  if (!team) return 1;
  auto server = cls::mock_server::Server::start(
      std::make_unique<FaultyTeam>(std::move(*team), flags), "127.0.0.1",
      flags.number("port") + flags.number("port-offset"));
  if (!server) {
    std::fprintf(stderr, "%s\n", server.error().message.c_str());
    return 1;
  }
  while (flags.has("flood")) std::printf("thinking about the ball, and thinking, and thinking\n");
  hang();
}
