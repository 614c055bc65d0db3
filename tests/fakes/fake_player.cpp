// One agent of an external team: joins and turns every cycle until its fault.
#include <chrono>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "soccer/udp_channel.h"
#include "tests/fakes/flags.h"

namespace {

using namespace cls;
using std::chrono::steady_clock;

/// Plays until the server has sent nothing for 5 s.
int play(const fakes::Flags& flags, soccer::UdpClients& clients, soccer::Channel& server) {
  std::string message;
  int now = 0;
  while (clients.wait_until(steady_clock::now() + std::chrono::seconds(5))) {
    while (server.receive(message)) {
      int time = 0;
      if (message.starts_with("(error")) std::printf("%s\n", message.c_str());
      if (std::sscanf(message.c_str(), "(sense_body %d", &time) == 1) {
        now = time;
        if (flags.has("exit-at-cycle") && time >= flags.number("exit-at-cycle")) {
          std::fprintf(stderr, "lost my boots\n");
          std::_Exit(flags.number("code", 4));
        }
        if (flags.has("hang-at-cycle") && time >= flags.number("hang-at-cycle")) fakes::hang();
      }
      const bool misses = flags.has("miss-cycle") && now == flags.number("miss-cycle");
      if (message == "(think)" && !misses) server.send("(turn 10)(done)");
    }
  }
  std::printf("server down\n");
  return 0;
}

}  // namespace

// --port N --name TEAM [--goalie 1] and faults.
int main(int argc, char** argv) {
  const fakes::Flags flags(argc, argv);
  fakes::misbehave_at_start(flags);
  if (flags.has("exit-at-start")) {
    std::fprintf(stderr, "cannot read formation.conf\n");
    return flags.number("exit-at-start");
  }
  if (flags.has("never-join")) fakes::hang();
  auto clients = soccer::UdpClients::create("127.0.0.1", flags.number("port", 6000));
  if (!clients) return 1;
  for (int i = 0; flags.has("flood") && i < 20'000; ++i) std::printf("the grass grows\n");
  std::vector<std::unique_ptr<soccer::Channel>> players;
  for (int i = 0; i < flags.number("players", 1); ++i) {
    players.push_back((*clients)->connect());
    players.back()->send("(init " + flags.text("name") + " (version 18)" +
                         (flags.has("goalie") ? " (goalie)" : "") + ")");
  }
  return play(flags, **clients, *players.front());
}
