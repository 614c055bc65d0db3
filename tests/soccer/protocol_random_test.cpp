// Random messages round-trip; random bytes crash no parser.
#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <limits>
#include <random>
#include <string>
#include <tuple>
#include <vector>

#include "soccer/commands/coach_command.h"
#include "soccer/commands/connection_request.h"
#include "soccer/commands/player_command.h"
#include "soccer/messages/full_state.h"
#include "soccer/messages/global_view.h"
#include "soccer/messages/hear.h"
#include "soccer/messages/parameter_message.h"
#include "soccer/messages/see.h"
#include "soccer/messages/sense_body.h"
#include "soccer/messages/server_reply.h"
#include "soccer/messages/values.h"
#include "soccer/pitch.h"
#include "tests/soccer/transcript.h"
#include "tests/support/files.h"

namespace cls::soccer {
namespace {

class Dice {
 public:
  int integer(int low, int high) {
    return low + static_cast<int>(engine_() % static_cast<std::uint64_t>(high - low + 1));
  }
  bool flip() { return integer(0, 1) == 1; }
  double number() {
    return flip() ? integer(-2000, 2000) * 0.1 : integer(-1000000, 1000000) * 1e-7;
  }
  Side side() { return flip() ? Side::kLeft : Side::kRight; }
  int unum() { return integer(1, 11); }
  Vec2 vector() { return {number(), number()}; }
  TeamName team() { return TeamName(text("ABCxyz_-+./<=>?@019", 1, 15)); }
  std::string said() { return text("abcXYZ019 ().+*/?<>_-", 1, 20); }

  std::string text(std::string_view characters, int shortest, int longest) {
    std::string result;
    for (int i = integer(shortest, longest); i > 0; --i) {
      result +=
          characters[static_cast<std::size_t>(integer(0, static_cast<int>(characters.size()) - 1))];
    }
    return result;
  }

 private:
  std::mt19937_64 engine_{20261120};
};

template <typename Message, typename Write>
void expect_round_trip(const Message& message, Write write) {
  std::string text;
  write(message, text);
  Message again;
  const base::Result<void> done = parse(text, again);
  ASSERT_TRUE(done) << done.error().message << "\n" << text;
  std::string text_again;
  write(again, text_again);
  ASSERT_EQ(text_again, text);
}

SenseBody random_sense(Dice& dice) {
  SenseBody sense;
  sense.time = dice.integer(0, 100000);
  sense.quality = dice.flip() ? ViewQuality::kHigh : ViewQuality::kLow;
  sense.width = static_cast<ViewWidth>(dice.integer(0, 2));
  sense.stamina = dice.number();
  sense.effort = dice.number();
  sense.capacity = dice.number();
  sense.speed = dice.number();
  sense.speed_direction = dice.integer(-180, 180);
  sense.head_angle = dice.integer(-90, 90);
  sense.counts = {dice.integer(0, 9), dice.integer(0, 99), 3, 4, 5, 6, 7, 8, dice.integer(0, 9999)};
  sense.arm = {dice.integer(0, 9), 2, dice.number(), dice.integer(-180, 180), 5};

  if (dice.flip()) {
    sense.attention_side = dice.side();
    sense.attention_unum = dice.unum();
  }

  sense.attention_count = dice.integer(0, 99);
  sense.tackle_expires_in = dice.integer(0, 10);
  sense.collided_with_ball = dice.flip();
  sense.collided_with_player = dice.flip();
  sense.collided_with_post = dice.flip();
  sense.foul_charged = dice.integer(0, 5);
  sense.card = static_cast<Card>(dice.integer(0, 2));
  sense.focus_distance = dice.number();
  sense.focus_direction = dice.number();
  return sense;
}

Observation random_player(Dice& dice) {
  Observation object;
  object.kind = ObservedKind::kPlayer;
  object.detail = static_cast<ObservedDetail>(dice.integer(0, 1));
  if (dice.integer(0, 3) == 0) return object;
  object.team = dice.team();

  if (dice.flip()) {
    object.unum = static_cast<std::uint8_t>(dice.unum());
    object.goalie = dice.flip();
    if (object.detail == ObservedDetail::kPosition) object.detail = ObservedDetail::kPose;
  }

  if (object.detail == ObservedDetail::kDirection) return object;
  object.pointing = dice.flip();
  object.mark = static_cast<ActionMark>(dice.integer(0, 2));
  return object;
}

Observation random_object(Dice& dice) {
  Observation object;
  object.kind = static_cast<ObservedKind>(dice.integer(0, 7));

  if (object.kind == ObservedKind::kPlayer) {
    object = random_player(dice);
  } else {
    object.detail = static_cast<ObservedDetail>(dice.integer(0, 2));
  }

  if (object.kind == ObservedKind::kLandmark) {
    object.index = static_cast<std::uint8_t>(dice.integer(0, kLandmarkCount - 1));
  }

  if (object.kind == ObservedKind::kLine) {
    object.index = static_cast<std::uint8_t>(dice.integer(0, kPitchLineCount - 1));
  }
  for (std::int16_t* angle :
       {&object.direction, &object.body, &object.head, &object.point_direction}) {
    *angle = static_cast<std::int16_t>(dice.integer(-180, 180));
  }
  object.distance = dice.number();
  object.distance_change = dice.number();
  object.direction_change = dice.number();
  return object;
}

FullState random_full_state(Dice& dice) {
  FullState state;
  state.time = dice.integer(0, 6000);
  state.mode = static_cast<PlayMode>(dice.integer(1, kPlayModeCount - 1));

  if (dice.integer(0, 4) == 0) {
    state.mode = for_side(PlayMode::kFreeKickLeft, dice.side());
    state.ball_caught = true;
  }

  state.counts = {1, 2, 3, 4, 5, 6, 7, 8, 9};
  state.arm = {1, 2, dice.number(), 4, 5};
  state.ball_position = dice.vector();
  state.ball_velocity = dice.vector();

  for (int i = dice.integer(0, kPlayersOnPitch); i > 0; --i) {
    FullStatePlayer player;
    player.side = dice.side();
    player.unum = dice.unum();
    player.goalie = dice.flip();
    player.type = dice.integer(0, 17);
    player.position = dice.vector();
    player.velocity = dice.vector();
    player.body = dice.number();
    player.pointing = dice.flip();
    player.point_distance = dice.number();
    player.focus_distance = dice.number();
    player.stamina = dice.number();
    player.mark = static_cast<ActionMark>(dice.integer(0, 3));
    player.card = static_cast<Card>(dice.integer(0, 2));
    state.players.push_back(player);
  }

  return state;
}

GlobalView random_view(Dice& dice) {
  GlobalView view;
  view.is_look_reply = dice.flip();
  view.ball_position = dice.vector();

  for (int i = dice.integer(0, kPlayersOnPitch); i > 0; --i) {
    GlobalViewPlayer player;
    player.team = dice.team();
    player.unum = dice.unum();
    player.goalie = dice.flip();
    player.position = dice.vector();
    player.velocity = dice.vector();
    player.body = dice.integer(-180, 180);
    player.pointing = dice.flip();
    player.point_direction = dice.integer(-180, 180);
    player.mark = static_cast<ActionMark>(dice.integer(0, 3));
    player.card = static_cast<Card>(dice.integer(0, 2));
    view.players.push_back(player);
  }

  return view;
}

Hear random_hear(Dice& dice, Recipient& recipient) {
  using Sender = Hear::Sender;
  Hear hear;
  hear.time = dice.integer(0, 6000);
  hear.sender = static_cast<Sender>(dice.integer(0, 7));
  recipient = Recipient::kPlayer;
  if (hear.sender == Sender::kPlayer) recipient = Recipient::kTrainer;

  hear.team = dice.team();
  hear.unum = dice.unum();
  hear.direction = dice.integer(-180, 180);
  hear.partial =
      dice.flip() && (hear.sender == Sender::kTeammate || hear.sender == Sender::kOpponent);
  hear.text = dice.said();
  return hear;
}

TEST(ProtocolRandom, MessagesRoundTrip) {
  Dice dice;

  for (int i = 0; i < 5000; ++i) {
    const int version = dice.integer(14, 19);
    const auto versioned = [&](const auto& message, std::string& out) {
      format(message, version, out);
    };
    const auto plain = [](const auto& message, std::string& out) { format(message, out); };
    See see;
    see.time = dice.integer(0, 6000);
    for (int k = dice.integer(0, 81); k > 0; --k) see.objects.push_back(random_object(dice));
    Recipient recipient;
    const Hear hear = random_hear(dice, recipient);
    expect_round_trip(random_sense(dice), versioned);
    expect_round_trip(see, plain);
    expect_round_trip(random_full_state(dice), versioned);
    expect_round_trip(random_view(dice), plain);
    expect_round_trip(hear,
                      [&](const Hear& one, std::string& out) { format(one, recipient, out); });
    if (HasFatalFailure()) return;
  }
}

// Bits, because -0 and 0 are equal.
std::uint64_t bits(double value) { return std::bit_cast<std::uint64_t>(value); }

auto fields(const Observation& object) {
  return std::tuple(object.kind, object.detail, object.index, object.unum, object.goalie,
                    object.pointing, object.mark, object.direction, object.body, object.head,
                    object.point_direction, object.team.view(), bits(object.distance),
                    bits(object.distance_change), bits(object.direction_change));
}

auto fields(const CommandCounts& counts) {
  return std::tuple(counts.kick, counts.dash, counts.turn, counts.say, counts.turn_neck,
                    counts.catches, counts.move, counts.change_view, counts.change_focus);
}

auto fields(const ArmState& arm) {
  return std::tuple(arm.movable_in, arm.expires_in, bits(arm.target_distance), arm.target_direction,
                    arm.count);
}

auto fields(const SenseBody& sense) {
  return std::tuple(sense.time, sense.quality, sense.width, bits(sense.stamina), bits(sense.effort),
                    bits(sense.capacity), bits(sense.speed), sense.speed_direction,
                    sense.head_angle, fields(sense.counts), fields(sense.arm), sense.attention_side,
                    sense.attention_unum, sense.attention_count, sense.tackle_expires_in,
                    sense.tackle_count, sense.collided_with_ball, sense.collided_with_player,
                    sense.collided_with_post, sense.foul_charged, sense.card, sense.has_focus_point,
                    bits(sense.focus_distance), bits(sense.focus_direction));
}

// What passes a channel as values.
template <typename Message>
Message through_bytes(const Message& message) {
  std::string bytes;
  write_values(message, bytes);
  Message read;
  EXPECT_TRUE(read_values(bytes, read));
  return read;
}

// Of any form: the text of some has another one or does not parse.
See any_see(Dice& dice) {
  See see;
  see.time = dice.integer(0, 6000);
  for (int k = dice.integer(0, 81); k > 0; --k) {
    Observation object = random_object(dice);
    if (dice.integer(0, 500) == 0) object.pointing = true;
    if (dice.integer(0, 500) == 0) object.detail = static_cast<ObservedDetail>(dice.integer(0, 3));
    if (dice.integer(0, 50) == 0) object.mark = static_cast<ActionMark>(dice.integer(0, 3));
    if (dice.integer(0, 9) == 0) object.goalie = true;
    if (dice.flip()) object.distance = dice.number() * dice.number();
    if (dice.flip()) object.direction_change = dice.number() * dice.number();
    see.objects.push_back(object);
  }
  return see;
}

TEST(ProtocolRandom, ValuesOfSeeAreThoseOfItsText) {
  Dice dice;
  int sent = 0;
  for (int i = 0; i < 5000; ++i) {
    const See see = any_see(dice);
    std::string text;
    format(see, text);
    See from_text;
    const bool parsed = parse(text, from_text).ok();

    See values = see;
    if (!make_as_sent(values)) {  // goes as text, which is the same
      std::string again;
      format(values, again);
      ASSERT_EQ(again, text);
      continue;
    }
    ASSERT_TRUE(parsed) << text;
    ++sent;
    values = through_bytes(values);
    ASSERT_EQ(values.time, from_text.time);
    ASSERT_EQ(values.objects.size(), from_text.objects.size());
    for (std::size_t k = 0; k < values.objects.size(); ++k) {
      ASSERT_EQ(fields(values.objects[k]), fields(from_text.objects[k])) << k << ": " << text;
    }
  }
  EXPECT_GT(sent, 2000);
  EXPECT_LT(sent, 5000);
}

TEST(ProtocolRandom, ValuesOfSenseBodyAreThoseOfItsText) {
  Dice dice;
  for (int i = 0; i < 20000; ++i) {
    const int version = dice.integer(8, 19);
    SenseBody sense = random_sense(dice);
    if (dice.flip()) sense.stamina = dice.number() * dice.number();
    if (dice.flip()) sense.attention_unum = dice.unum();
    if (dice.integer(0, 9) == 0) sense.arm.target_direction = std::numeric_limits<int>::min();
    std::string text;
    format(sense, version, text);
    SenseBody from_text;
    const bool parsed = parse(text, from_text).ok();

    SenseBody values = sense;
    const bool made = make_as_sent(values, version);
    ASSERT_EQ(made, parsed) << text;
    if (!made) continue;
    ASSERT_EQ(fields(through_bytes(values)), fields(from_text)) << text;
  }
}

TEST(ProtocolRandom, TextIsNotReadAsValues) {
  See see;
  SenseBody sense;
  EXPECT_FALSE(read_values("(see 0)", see));
  EXPECT_FALSE(read_values("(see 0 ((b) 1 2))", see));
  EXPECT_FALSE(read_values("(sense_body 0 (view_mode high normal)", sense));
}

PlayerCommand random_command(Dice& dice) {
  const Dash dash{dice.number(), dice.number()};
  const TeamReference team{static_cast<TeamReference::Kind>(dice.integer(0, 4)),
                           "T" + dice.text("abc_-09", 0, 30)};

  switch (dice.integer(0, 17)) {
    case 0:
      return Turn{dice.number()};
    case 1:
      return dash;
    case 2:
      return LegDash{dash, dice.flip() ? std::optional(dash) : std::nullopt};
    case 3:
      return LegDash{std::nullopt, dash};
    case 4:
      return Kick{dice.number(), dice.number()};
    case 5:
      return Tackle{dice.number(), dice.flip()};
    case 6:
      return Move{dice.number(), dice.number()};
    case 7:
      return ChangeView{static_cast<ViewWidth>(dice.integer(0, 2)),
                        dice.flip() ? std::optional(ViewQuality::kLow) : std::nullopt};
    case 8:
      return Say{dice.said()};
    case 9:
      return PointTo{dice.number(), dice.number()};
    case 10:
      return AttentionTo{team, dice.integer(-5, 15)};
    case 11:
      return Ear{dice.flip(), dice.flip() ? std::optional(team) : std::nullopt,
                 dice.flip() ? std::optional(EarMode::kPartial) : std::nullopt};
    case 12:
      return Clang{dice.integer(0, 9), dice.integer(0, 9)};
    case 13:
      return ChangeFocus{dice.number(), dice.number()};
    case 14:
      return Compression{dice.integer(-3, 12)};
    case 15:
      return Catch{dice.number()};
    case 16:
      return TurnNeck{dice.number()};
    default:
      return Done{};
  }
}

TEST(ProtocolRandom, CommandListsRoundTrip) {
  Dice dice;

  for (int i = 0; i < 20000; ++i) {
    std::string text;
    const int count = dice.integer(1, 8);
    for (int k = 0; k < count; ++k) ASSERT_TRUE(format(random_command(dice), text));
    std::vector<PlayerCommand> commands;
    ASSERT_FALSE(parse_player_commands(text, commands)) << text;
    ASSERT_EQ(commands.size(), static_cast<std::size_t>(count)) << text;
    std::string again;
    for (const PlayerCommand& command : commands) ASSERT_TRUE(format(command, again));
    ASSERT_EQ(again, text);
  }
}

// All parsers return for any bytes, and accepted messages can be formatted.
class AllParsers {
 public:
  void feed(const std::string& text) {
    commands_.clear();
    parse_player_commands(text, commands_);
    for (const PlayerCommand& command : commands_) ASSERT_TRUE(format(command, out_)) << text;

    for (const CoachRole role : {CoachRole::kOnlineCoach, CoachRole::kTrainer}) {
      if (!parse(text, role, coach_)) (void)format(coach_, out_);
    }
    if (!parse(text, game_)) std::visit([&](const auto& one) { format(one, out_); }, game_);
    if (!parse(text, coach_init_)) format(coach_init_, out_);
    if (!parse(text, trainer_init_)) format(trainer_init_, out_);

    if (parse(text, sense_)) format(sense_, 18, out_);
    if (parse(text, see_)) format(see_, out_);
    if (parse(text, hear_)) format(hear_, Recipient::kPlayer, out_);
    if (parse(text, full_)) format(full_, 18, out_);
    if (parse(text, view_)) format(view_, out_);
    if (parse(text, reply_)) format(reply_, out_);
    if (parse(text, params_)) format(params_, 18, out_);
    if (parse(text, type_)) format(type_, 18, out_);
    out_.clear();
  }

 private:
  std::vector<PlayerCommand> commands_;
  CoachCommand coach_;
  GameRequest game_;
  CoachInit coach_init_;
  TrainerInit trainer_init_;
  SenseBody sense_;
  See see_;
  Hear hear_;
  FullState full_;
  GlobalView view_;
  ServerReply reply_;
  ServerParams params_;
  PlayerType type_;
  std::string out_;
};

TEST(ProtocolRandom, CorruptMessagesDoNotCrash) {
  Dice dice;
  AllParsers parsers;

  for (const char* file : {"player-synch-v18.txt.gz", "scripted-clients-9.log.gz",
                           "coach-v18.txt.gz", "player-realtime-fullstate-v19.txt.gz"}) {
    int count = 0;
    for (const auto& recorded :
         tests::read_transcript(tests::fixture(std::string("protocol/") + file))) {
      if (++count > 250) break;
      std::string text = recorded.text;
      for (int round = 0; round < 6 && !text.empty(); ++round) {
        const auto at =
            static_cast<std::size_t>(dice.integer(0, static_cast<int>(text.size()) - 1));
        switch (dice.integer(0, 3)) {
          case 0:
            text[at] = static_cast<char>(dice.integer(0, 255));
            break;
          case 1:
            text.resize(at);
            break;
          case 2:
            text.erase(at, static_cast<std::size_t>(dice.integer(1, 5)));
            break;
          default:
            text.insert(at, text.substr(at, static_cast<std::size_t>(dice.integer(1, 40))));
            break;
        }
        parsers.feed(text);
        if (HasFatalFailure()) return;
      }
    }
  }
}

TEST(ProtocolRandom, LongHostileMessagesTakeLinearTime) {
  AllParsers parsers;

  for (const char* piece : {"(", ")", "(say ", "(say a", "\"", "(dash ", "9", "(turn 1)", "(p \"",
                            "((f c t) ", " ", "(move (", "(say (freeform (", "-", "e9"}) {
    std::string text;
    while (text.size() < 65536) text += piece;
    for (const char* start : {"", "(see 0 ", "(hear 0 ", "(say (", "(init ", "(server_param "}) {
      parsers.feed(start + text);
    }
  }
}

}  // namespace
}  // namespace cls::soccer
