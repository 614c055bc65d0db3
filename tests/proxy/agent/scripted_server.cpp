// Scripted messages of a soccer server.
#include "tests/proxy/agent/scripted_server.h"

#include <gtest/gtest.h>

#include <utility>

#include "base/index.h"
#include "soccer/commands/connection_request.h"
#include "soccer/memory_channel.h"
#include "soccer/messages/parameter_message.h"

namespace cls::tests {
namespace {

// see message of a player at about (-25, 0), recorded before a kick-off.
constexpr const char* kSight =
    " ((f c) 24.5 0 0 0) ((f c t) 42.1 -54) ((f c b) 42.1 54) ((f r t) 84.8 -23)"
    " ((f r b) 84.8 23) ((f g r b) 77.5 5) ((g r) 77.5 0) ((f g r t) 77.5 -5) ((f p r b) 64.1 18)"
    " ((f p r c) 61 0) ((f p r t) 64.1 -18) ((f t 0) 46.1 -57) ((f b 0) 46.1 57) ((b) 24.5 0 0 0)"
    " ((p \"them\" 7) 30 10) ((p \"us\" 9) 11 -20) ((p) 45 5) ((l r) 77.5 90))";

bool is_known(const std::string& init, int newest) {
  soccer::GameRequest request;
  if (soccer::parse(init, request)) return false;
  const auto* player = std::get_if<soccer::PlayerInit>(&request);
  return player != nullptr && player->version <= newest;
}

}  // namespace

std::unique_ptr<soccer::Channel> ScriptedServer::open() {
  auto [client, server] = soccer::make_memory_channel();
  clients_.push_back(std::move(server));
  said_.emplace_back();
  return std::move(client);
}

void ScriptedServer::admit(proxy::Team& team) {
  EXPECT_TRUE(team.connect([this] { return open(); },
                           [this] {
                             serve();
                             return true;
                           }));
  const proxy::RpcStatus introduced = team.register_agents();
  EXPECT_TRUE(introduced.ok()) << introduced.message;
  for (int unum = 1; unum <= 11; ++unum) take(unum);
}

void ScriptedServer::serve() {
  for (std::size_t i = 0; i < clients_.size(); ++i) {
    std::string message;
    while (clients_[i]->receive(message)) {
      if (!message.starts_with("(init ")) {
        said_[i].push_back(message);
      } else if (!refusal.empty()) {
        clients_[i]->send(refusal);
      } else if (!is_known(message, version)) {
        clients_[i]->send("(error no_more_player_or_goalie_or_illegal_client_version)");
      } else {
        accept(*clients_[i], only_unum != 0 ? only_unum : static_cast<int>(i) + 1);
      }
    }
  }
}

void ScriptedServer::accept(soccer::Channel& client, int unum) {
  client.send("(init l " + std::to_string(unum) + " before_kick_off)");
  std::string text;
  soccer::ServerParams server;
  server.synch_mode = synchronous;
  soccer::format(server, version, text);
  client.send(text);
  soccer::PlayerParams player;
  player.player_types = player_types;
  text.clear();
  soccer::format(player, version, text);
  client.send(text);
  soccer::PlayerType type = soccer::default_player_type(server);

  for (type.id = 0; type.id < player_types; ++type.id) {
    text.clear();
    soccer::format(type, version, text);
    client.send(text);
  }

  client.send("(ok synch_see)");
}

void ScriptedServer::send_cycle(int cycle, bool think) {
  const std::string t = std::to_string(cycle);
  for (const auto& client : clients_) {
    if (cycle == 1) client->send("(hear 0 referee kick_off_l)");
    client->send("(sense_body " + t +
                 " (view_mode high normal) (stamina 8000 1 130600) (speed 0 0) (head_angle 0)"
                 " (kick 0) (dash 0) (turn 0) (say 0) (turn_neck 0) (catch 0) (move 0)"
                 " (change_view 0) (change_focus 0) (arm (movable 0) (expires 0) (target 0 0)"
                 " (count 0)) (focus (target none) (count 0)) (tackle (expires 0) (count 0))"
                 " (collision none) (foul (charged 0) (card none)) (focus_point 0 0))");
    client->send("(see " + t + kSight);
    if (think) client->send("(think)");
  }
}

std::vector<std::string> ScriptedServer::take(int unum) {
  serve();
  return std::exchange(said_.at(base::index(unum - 1)), {});
}

}  // namespace cls::tests
