// A program of a team that sends what only others may send, and prints the replies.
#include <chrono>
#include <cstdio>
#include <string>

#include "soccer/udp_channel.h"
#include "tests/fakes/flags.h"

namespace {

using namespace cls;
using std::chrono::milliseconds;
using std::chrono::steady_clock;

/// Prints the first reply within 5 s.
bool print_reply(soccer::UdpClients& clients, soccer::Channel& server) {
  const auto until = steady_clock::now() + std::chrono::seconds(5);
  std::string message;
  while (steady_clock::now() < until) {
    clients.wait_until(until);
    if (!server.receive(message)) continue;
    std::printf("reply %s\n", message.c_str());
    return true;
  }
  std::printf("no reply\n");
  return false;
}

}  // namespace

// --port N --first TEXT [--then TEXT [--times N]]: sends the second text each 20 ms, 50 times.
int main(int argc, char** argv) {
  const fakes::Flags flags(argc, argv);
  auto clients = soccer::UdpClients::create("127.0.0.1", flags.number("port", 6000));
  if (!clients) return 1;
  const auto server = (*clients)->connect();
  server->send(flags.text("first"));
  const bool replied = print_reply(**clients, *server);
  std::fflush(stdout);
  std::string message;
  for (int i = 0; replied && flags.has("then") && i < flags.number("times", 50); ++i) {
    server->send(flags.text("then"));
    const auto next = steady_clock::now() + milliseconds(20);
    while ((*clients)->wait_until(next)) {
      while (server->receive(message)) {
      }
    }
  }
  return 0;
}
