// A soccer server that works until the fault named by its flags. Takes the options of rcssserver
// after its flags, and prints rcssserver's status lines.
#include <atomic>
#include <cstdio>
#include <memory>
#include <string>

#include "base/io/byte_sink.h"
#include "match/terms/match_options.h"
#include "simulator/server/udp_server.h"
#include "soccer/side.h"
#include "tests/fakes/flags.h"

namespace {

using namespace cls;

std::atomic<bool> stop{false};

match::MatchOptions options_of(const fakes::Flags& flags) {
  match::MatchOptions options;
  options.server = soccer::ServerParams();
  for (const std::string& word : flags.rest()) {
    const auto applied = apply_setting(options, word);
    if (applied) continue;
    std::fprintf(stderr, "fake_server: %s\n", applied.error().message.c_str());
    std::exit(97);
  }
  return options;
}

std::unique_ptr<simulator::UdpServer> open(const fakes::Flags& flags) {
  const match::MatchOptions options = options_of(flags);
  simulator::UdpConfig config;
  config.match.server = options.server;
  config.match.player = options.player;
  config.match.seed = 7;
  if (flags.has("until-cycle")) config.match.cycle_limit = flags.number("until-cycle");
  config.port = options.server.port + flags.number("port-offset");
  config.trainer_port = options.server.coach_port;
  config.coach_port = options.server.olcoach_port;
  auto server = simulator::UdpServer::open(std::move(config));
  if (!server) {
    std::fprintf(stderr, "fake_server: %s\n", server.error().message.c_str());
    std::exit(1);
  }
  return std::move(*server);
}

void print_joined(const simulator::UdpServer& server, const simulator::UdpServerEvent& notice) {
  if (notice.kind != simulator::UdpServerEvent::Kind::kConnected) return;
  if (!simulator::is_player(notice.client)) return;
  const auto name = server.world().team(soccer::side_of_slot(notice.client)).name.view();
  std::printf("A new (v%d) player (%.*s %d) connected.\n", notice.version,
              static_cast<int>(name.size()), name.data(), soccer::unum_of_slot(notice.client));
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  ::signal(SIGXFSZ, SIG_IGN);  // a file that is too large is a failed write
  const fakes::Flags flags(argc, argv);
  fakes::misbehave_at_start(flags);
  std::printf("rcssserver-19.0.0\n\nSimulator Random Seed: 1234\n");
  std::fflush(stdout);

  if (flags.has("exit-at-start")) {
    std::fprintf(stderr, "Error: the stadium is closed\n");
    return flags.number("exit-at-start");
  }

  if (flags.has("never-open")) fakes::hang();
  if (flags.has("silent")) {
    fakes::open_silently(SOCK_DGRAM, options_of(flags).server.port);
    fakes::hang();
  }
  auto game = base::FileSink::create("match.rcg");
  auto text = base::FileSink::create("match.rcl");
  if (!game || !text) return 1;
  auto server = open(flags);
  server->record({game->get(), text->get()});
  server->on_event([&](const simulator::UdpServerEvent& notice) { print_joined(*server, notice); });
  std::printf("Hit CTRL-C to exit\n");
  std::fflush(stdout);
  for (int i = 0; flags.has("flood") && i < 200'000; ++i) std::printf("the grass grows\n");

  if (!flags.has("ignore-term")) ::signal(SIGTERM, [](int) { stop = true; });
  server->run(stop);
  static_cast<void>((*game)->close());
  static_cast<void>((*text)->close());
  if (flags.has("signal")) fakes::die_of(flags.number("signal"));
  if (flags.has("then-hang")) fakes::hang();
  if (flags.has("give-up")) std::printf("Waiting too long for clients! Exiting\n");
  if (!flags.has("until-cycle")) std::printf("Game Over. Exiting...\n");
  return flags.number("code");
}
