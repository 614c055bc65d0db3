// A faulty server may send any numbers as its parameters. Players then play badly, but they decide
// in every cycle and send only commands that the server can read.
#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <vector>

#include "player/perception/perception.h"
#include "proxy/messages/state_message.h"
#include "soccer/parameters/parameter.h"
#include "tests/proxy/playmaker/random_message.h"
#include "tests/support/known_pitch.h"

namespace cls::proxy {
namespace {

using soccer::PlayMode;
using soccer::Vec2;
using tests::KnownPitch;
using tests::RandomMessages;

constexpr std::array kNumbers = {"0",          "1",           "-1",    "0.001", "-0.5",
                                 "7",          "-360",        "1000",  "1e-12", "1e12",
                                 "2147483647", "-2147483648", "1e300", "-1e30"};

/// CLS_FAULTY_PARAMETERS=60000 plays that many situations.
std::uint64_t wanted_situations() {
  const char* text = std::getenv("CLS_FAULTY_PARAMETERS");
  return text == nullptr ? 400 : std::strtoull(text, nullptr, 10);
}

/// Sets a random parameter to a random number that its type accepts; returns what it did.
template <typename Params>
std::string change(Params& params, const soccer::ParameterTable<Params>& table,
                   RandomMessages& random) {
  const auto& row = table[random.below(table.size())];
  const char* number = kNumbers[random.below(kNumbers.size())];
  const bool set = static_cast<bool>(soccer::set_parameter(params, table, row.name, number));
  return set ? std::string(row.name) + " = " + number + "; " : "";
}

/// As the agent takes messages of the server.
std::string change_parameters(KnownPitch& pitch, RandomMessages& random) {
  soccer::ServerParams server = pitch.world.server();
  std::vector<soccer::PlayerType> types = pitch.world.parameters->types;

  std::string what;
  for (std::size_t i = random.below(4) + 1; i > 0; --i) {
    if (random.one_in(2)) {
      what += change(server, soccer::server_param_table(), random);
    } else {
      for (soccer::PlayerType& type : types) {
        what += change(type, soccer::player_type_table(), random);
      }
    }
  }

  on_server_param(pitch.world, server);
  for (const soccer::PlayerType& type : types) on_player_type(pitch.world, type);
  return what;
}

Vec2 anywhere(RandomMessages& random) {
  return {static_cast<double>(random.below(105)) - 52.0,
          static_cast<double>(random.below(68)) - 34.0};
}

KnownPitch random_pitch(RandomMessages& random) {
  KnownPitch pitch;
  const Vec2 self = anywhere(random);
  pitch.place_self(self, static_cast<double>(random.below(360)));
  pitch.place_ball(random.one_in(3) ? anywhere(random) : self + Vec2{0.6, 0.0},
                   {static_cast<double>(random.below(5)) - 2.0, 0.5});

  for (int unum = 1; unum <= soccer::kPlayersPerTeam; ++unum) {
    const int age = static_cast<int>(random.below(12));
    if (unum != pitch.world.unum) pitch.add_teammate(unum, anywhere(random), 30.0, age);
    pitch.add_opponent(unum, anywhere(random), 200.0, age);
  }

  if (random.one_in(4)) pitch.make_goalie();
  if (random.one_in(3)) {
    constexpr std::array kModes = {PlayMode::kKickOffLeft,  PlayMode::kKickInLeft,
                                   PlayMode::kFreeKickLeft, PlayMode::kCornerKickRight,
                                   PlayMode::kGoalKickLeft, PlayMode::kGoalKickRight};
    pitch.set_mode(kModes[random.below(kModes.size())]);
  } else if (random.one_in(4)) {
    pitch.set_shoot_out(random.one_in(2) ? PlayMode::kPenaltyTakenLeft
                                         : PlayMode::kPenaltyTakenRight);
  }

  return pitch;
}

/// One of all actions, half of the time with the behavior of `mock:planner` around it.
protos::PlayerActions decision(RandomMessages& random) {
  protos::PlayerActions reply;
  if (random.one_in(2)) tests::disable_automatic_behavior(reply);
  protos::PlayerAction& action = *reply.add_actions();
  const google::protobuf::OneofDescriptor& kinds = *action.GetDescriptor()->oneof_decl(0);
  const auto kind = static_cast<int>(random.below(static_cast<std::size_t>(kinds.field_count())));
  auto& chosen = *action.GetReflection()->MutableMessage(&action, kinds.field(kind));
  if (random.one_in(3)) random.fill(chosen);
  if (action.has_helios_offensive_planner() || random.one_in(3)) {
    tests::allow_everything(*reply.add_actions()->mutable_helios_offensive_planner());
  }
  return reply;
}

TEST(FaultyParameters, LetEveryActionEndWithCommandsThatTheServerReads) {
  constexpr int kCycles = 3;
  for (std::uint64_t seed = 1; seed <= wanted_situations() && !HasFailure(); ++seed) {
    RandomMessages random(seed);
    KnownPitch pitch = random_pitch(random);
    const std::string changed = change_parameters(pitch, random);
    for (int cycle = 0; cycle < kCycles; ++cycle) {
      const protos::PlayerActions reply = decision(random);
      SCOPED_TRACE(testing::Message()
                   << "seed " << seed << ": " << changed << reply.ShortDebugString());

      protos::State state;
      fill_state(pitch.world, HomePositions{}, true, state);
      EXPECT_FALSE(state.SerializeAsString().empty());

      pitch.act(reply);
      for (const soccer::PlayerCommand& command : pitch.commands) {
        std::string text;
        EXPECT_TRUE(soccer::format(command, text)) << "command " << command.index();
      }
    }
  }
}

}  // namespace
}  // namespace cls::proxy
