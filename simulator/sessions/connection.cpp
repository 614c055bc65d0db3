// Sends parameters, player types and the coach message file.
#include "simulator/sessions/connection.h"

#include <fstream>
#include <iterator>
#include <string>

#include "soccer/messages/parameter_message.h"
#include "soccer/protocol/protocol_version.h"

namespace cls::simulator {

bool is_supported_version(double version) {
  return version >= soccer::kMinServedVersion && version < soccer::kMaxProtocolVersion + 1;
}

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
  constexpr std::size_t kMaxLength = 8192 - 16;
  const std::string& name = world.params().coach_msg_file;
  if (name.empty() || coach.version < kFirstVersion) return;
  std::ifstream file(name, std::ios::binary);
  soccer::CoachInclude include;
  include.text.assign(std::istreambuf_iterator<char>(file), {});
  if (!include.text.empty() && include.text.size() < kMaxLength) coach.reply(include);
}

}  // namespace cls::simulator
