// Creates small worlds.
#include "tests/simulator/senses/scene.h"

#include "soccer/math.h"

namespace cls::simulator {

World empty_pitch(const soccer::ServerParams& params) {
  World world = make_world(*make_rules(params, soccer::PlayerParams{}, 1), 1);
  world.mode = PlayMode::kPlayOn;
  for (const Side side : {Side::kLeft, Side::kRight}) {
    world.team(side).connected = true;
    world.team(side).name = side == Side::kLeft ? "LeftTeam" : "RightTeam";
  }
  return world;
}

Player& place(World& world, Side side, int unum, Vec2 position, double body_degrees, int version) {
  Player& player = world.player(side, unum);
  player.joined = true;
  player.enabled = true;
  player.state = state::kStand;
  player.client_version = version;
  player.view.synchronous = version >= 18;
  player.position = position;
  player.body = player.pending_body = soccer::math::to_radians(body_degrees);
  return player;
}

std::string see_text(const World& world, const Player& observer, std::uint64_t seed) {
  RandomStream noise(seed, "test");
  soccer::See message;
  see(VisionModel(world.params()), world, observer.slot(), noise, message);
  std::string text;
  soccer::format(message, text);
  return text;
}

std::string see_part(const std::string& see, const std::string& name) {
  const std::size_t begin = see.find("(" + name);
  if (begin == std::string::npos) return "";
  const std::size_t name_end = begin + 1 + name.size();
  return see.substr(begin, see.find(')', name_end) + 1 - begin);
}

}  // namespace cls::simulator
