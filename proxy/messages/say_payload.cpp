// One case per member of Say.
#include "proxy/messages/say_payload.h"

#include <algorithm>
#include <initializer_list>

#include "proxy/messages/state_message.h"

namespace cls::proxy {
namespace {

template <typename Message>
player::SayBall ball(const Message& m) {
  return {vec(m.ball_position()), vec(m.ball_velocity())};
}

template <typename Message>
player::SayGoalie goalie(const Message& m) {
  return {vec(m.goalie_position()), m.goalie_body_direction()};
}

double fraction(double value, double min, double max) {
  return max > min ? std::clamp((value - min) / (max - min), 0.0, 1.0) : 0.0;
}

player::SayPlayers players(std::initializer_list<player::SaidPlayer> list) {
  player::SayPlayers said;
  for (const player::SaidPlayer& player : list) said.players.push_back(player);
  return said;
}

player::SayIntercept intercept(const protos::InterceptMessage& m) {
  const bool known = m.uniform_number() >= 1 && m.uniform_number() <= soccer::kPlayersPerTeam;
  const int first = m.our() ? 0 : soccer::kPlayersPerTeam;
  return {known ? first + m.uniform_number() : 0, m.cycle()};
}

/// Members about the ball, the goalie and several players.
std::optional<player::SayMessage> message_of_objects(const protos::Say& say) {
  using Say = protos::Say;
  switch (say.message_case()) {
    case Say::kBallMessage:
      return ball(say.ball_message());
    case Say::kPassMessage: {
      const auto& m = say.pass_message();
      return player::SayPass{m.receiver_uniform_number(), vec(m.receiver_point()), ball(m)};
    }

    case Say::kGoalieMessage:
      return goalie(say.goalie_message());
    case Say::kGoalieAndPlayerMessage: {
      const auto& m = say.goalie_and_player_message();
      return player::SayGoalieAndPlayer{goalie(m),
                                        {m.player_uniform_number(), vec(m.player_position())}};
    }
    case Say::kBallGoalieMessage: {
      const auto& m = say.ball_goalie_message();
      return player::SayBallGoalie{ball(m), goalie(m)};
    }

    case Say::kOnePlayerMessage: {
      const auto& m = say.one_player_message();
      return players({{m.uniform_number(), vec(m.position())}});
    }
    case Say::kTwoPlayerMessage: {
      const auto& m = say.two_player_message();
      return players({{m.first_uniform_number(), vec(m.first_position())},
                      {m.second_uniform_number(), vec(m.second_position())}});
    }
    case Say::kThreePlayerMessage: {
      const auto& m = say.three_player_message();
      return players({{m.first_uniform_number(), vec(m.first_position())},
                      {m.second_uniform_number(), vec(m.second_position())},
                      {m.third_uniform_number(), vec(m.third_position())}});
    }

    case Say::kBallPlayerMessage: {
      const auto& m = say.ball_player_message();
      return player::SayBallPlayer{
          ball(m), {m.uniform_number(), vec(m.player_position())}, m.body_direction()};
    }
    default:
      return std::nullopt;
  }
}

}  // namespace

std::optional<player::SayMessage> say_message_of(const protos::Say& say,
                                                 const soccer::ServerParams& server) {
  using Say = protos::Say;
  switch (say.message_case()) {
    case Say::kInterceptMessage:
      return intercept(say.intercept_message());
    case Say::kOffsideLineMessage:
      return player::SayOffsideLine{say.offside_line_message().offside_line_x()};
    case Say::kDefenseLineMessage:
      return player::SayDefenseLine{say.defense_line_message().defense_line_x()};
    case Say::kWaitRequestMessage:
      return player::SayWaitRequest{};
    case Say::kSetplayMessage:
      return player::SaySetplay{say.setplay_message().wait_step()};
    case Say::kPassRequestMessage:
      return player::SayPassRequest{vec(say.pass_request_message().target_point())};

    case Say::kSelfMessage: {
      const auto& m = say.self_message();
      return player::SaySelf{vec(m.self_position()), m.self_body_direction(),
                             fraction(m.self_stamina(), 0.0, server.stamina_max)};
    }
    case Say::kTeammateMessage: {
      const auto& m = say.teammate_message();
      return player::SayTeammate{m.uniform_number(), vec(m.position()), m.body_direction()};
    }
    case Say::kOpponentMessage: {
      const auto& m = say.opponent_message();
      return player::SayOpponent{m.uniform_number(), vec(m.position()), m.body_direction()};
    }

    case Say::kStaminaMessage:
      return player::SayStamina{fraction(say.stamina_message().stamina(), 0.0, server.stamina_max)};
    case Say::kRecoveryMessage:
      return player::SayRecovery{
          fraction(say.recovery_message().recovery(), server.recover_min, server.recover_init)};
    case Say::kStaminaCapacityMessage:
      return player::SayCapacity{fraction(say.stamina_capacity_message().stamina_capacity(), 0.0,
                                          server.stamina_capacity)};

    case Say::kDribbleMessage:
      return player::SayDribble{vec(say.dribble_message().target_point()),
                                say.dribble_message().queue_count()};
    default:
      return message_of_objects(say);
  }
}

}  // namespace cls::proxy
