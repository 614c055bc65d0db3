// Sending parameters and types.
#include "simulator/sessions/greeting.h"

#include <fstream>
#include <iterator>
#include <string>

#include "soccer/messages/parameter_message.h"

namespace cls::simulator {

void send_parameters(const World& world, Connection& client) {
  std::string text;
  const auto send = [&](const auto& params) {
    text.clear();
    soccer::format(params, client.version, text);
    client.send(text);
  };
  send(world.rules->server);
  send(world.rules->player);
  for (const soccer::PlayerType& type : world.rules->types) send(type);
}

void send_changed_types(const World& world, Side side, Connection& client) {
  for (const Player& player : world.players) {
    if (player.type == 0) continue;
    soccer::PlayerTypeChange change{player.unum, std::nullopt};
    if (player.side == side) change.type = player.type;
    client.reply(change);
  }
}

void send_coach_file(const World& world, Connection& coach) {
  constexpr int kFirstVersion = 11;
  constexpr std::size_t kLongest = 8192 - 16;
  const std::string& name = world.params().coach_msg_file;
  if (name.empty() || coach.version < kFirstVersion) return;
  std::ifstream file(name, std::ios::binary);
  soccer::CoachInclude include;
  include.text.assign(std::istreambuf_iterator<char>(file), {});
  if (!include.text.empty() && include.text.size() < kLongest) coach.reply(include);
}

}  // namespace cls::simulator
