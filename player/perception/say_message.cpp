// Codec of say messages: values quantized to grids and packed into one number in base 74.
#include "player/perception/say_message.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "soccer/side.h"

namespace cls::player {
namespace {

using soccer::Vec2;

constexpr std::string_view kDigits =
    "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ ().+-*/?<>_0123456789";
constexpr std::uint64_t kBase = kDigits.size();
static_assert(kBase == 74);

constexpr int kMaxSpeedStep = 31;
constexpr int kSpeedSign = kMaxSpeedStep + 1;  // added to the step of a negative speed

/// Quantization grid: low, low + step, ... low + (count - 1) step.
struct Grid {
  double low = 0.0;
  double step = 1.0;
  int count = 1;
};

/// The nearest integer from 0 to `last`; 0 for NaN, which Playmakers may send.
int rounded(double value, int last) {
  return std::isnan(value) ? 0 : static_cast<int>(std::rint(std::clamp(value, 0.0, 1.0 * last)));
}

/// Encoder; encoder and decoder visit the fields of a group from the least significant.
class Encoder {
 public:
  void field(double& value, const Grid& grid) {
    push(rounded((value - grid.low) / grid.step, grid.count - 1), grid.count);
  }
  void integer(int& value, int low, int count) {
    const bool fits = value >= low && value < low + count;
    ok_ &= fits;
    push(fits ? value - low : 0, count);
  }
  /// Sign and magnitude of a speed component, six bits.
  void speed(double& value, double max) {
    const int size = rounded(std::min(std::fabs(value), max) * kMaxSpeedStep / max, kMaxSpeedStep);
    push(size + (std::signbit(value) ? kSpeedSign : 0), 2 * kSpeedSign);
  }
  void fail() { ok_ = false; }
  bool ok() const { return ok_; }

  void finish(int digits, std::string& out) {
    std::uint64_t value = 0;
    for (std::size_t i = fields_.size(); i-- > 0;) {
      value = value * static_cast<std::uint64_t>(fields_[i].count) +
              static_cast<std::uint64_t>(fields_[i].index);
    }
    const std::size_t start = out.size();
    out.append(static_cast<std::size_t>(digits), kDigits[0]);
    for (std::size_t i = out.size(); i-- > start; value /= kBase) out[i] = kDigits[value % kBase];
    fields_.clear();
  }

 private:
  struct Field {
    int index = 0;
    int count = 1;
  };
  void push(int index, int count) { fields_.push_back({index, count}); }

  FixedList<Field, 12> fields_;
  bool ok_ = true;
};

class Decoder {
 public:
  bool start(std::string_view digits) {
    value_ = 0;
    for (const char c : digits) {
      const std::size_t digit = kDigits.find(c);
      if (digit == std::string_view::npos) return false;
      value_ = value_ * kBase + digit;
    }
    return true;
  }
  void field(double& value, const Grid& grid) { value = grid.low + grid.step * pop(grid.count); }
  void integer(int& value, int low, int count) { value = low + pop(count); }
  void speed(double& value, double max) {
    const int bits = pop(2 * kSpeedSign);
    const double size = bits % kSpeedSign * max / kMaxSpeedStep;
    value = bits >= kSpeedSign ? -size : size;
  }

 private:
  int pop(int count) {
    const auto modulus = static_cast<std::uint64_t>(count);
    const int index = static_cast<int>(value_ % modulus);
    value_ /= modulus;
    return index;
  }

  std::uint64_t value_ = 0;
};

Grid grid_x(double step, int count) { return {-52.5, step, count}; }
Grid grid_y(double step, int count) { return {-34.0, step, count}; }
Grid angles(int count) { return {-180.0, 360.0 / count, count}; }
constexpr Grid kFraction{0.0, 1.0 / 73.0, 74};

// Groups: fields packed into one number.

template <typename Code>
void ball_position(Code& code, Vec2& position) {
  code.field(position.y, grid_y(68.0 / 511.0, 512));
  code.field(position.x, grid_x(105.0 / 1023.0, 1024));
}

template <typename Code>
void ball(Code& code, SayBall& ball, double max_speed) {
  code.speed(ball.velocity.y, max_speed);
  code.speed(ball.velocity.x, max_speed);
  ball_position(code, ball.position);
}

template <typename Code>
void receiver(Code& code, SayPass& pass) {
  code.integer(pass.receiver, 0, 16);
  ball_position(code, pass.point);
}

template <typename Code>
void goalie(Code& code, SayGoalie& goalie, double min_x) {
  code.field(goalie.body, angles(360));
  code.field(goalie.position.y, {-20.0, 0.1, 400});
  code.field(goalie.position.x, {min_x, 0.1, 160});
}

template <typename Code>
void player(Code& code, SaidPlayer& player, double step, int columns, int rows) {
  code.field(player.position.y, grid_y(step, rows));
  code.field(player.position.x, grid_x(step, columns));
  code.integer(player.number, 1, 22);
}

template <typename Code>
void ball_and_goalie(Code& code, SayBallGoalie& both, double max_speed) {
  const Grid speeds{-max_speed, 2.0 * max_speed / 63.0, 63};
  goalie(code, both.goalie, 36.5);
  code.field(both.ball.velocity.y, speeds);
  code.field(both.ball.velocity.x, speeds);
  code.field(both.ball.position.y, grid_y(0.1, 680));
  code.field(both.ball.position.x, grid_x(0.1, 1050));
}

template <typename Code>
void self(Code& code, SaySelf& self) {
  code.field(self.stamina_fraction, {0.0, 0.1, 11});
  code.field(self.body, angles(60));
  code.field(self.position.y, grid_y(0.4, 171));
  code.field(self.position.x, grid_x(0.4, 264));
}

template <typename Code, typename Player>
void numbered(Code& code, Player& player) {
  code.field(player.body, angles(180));
  code.field(player.position.y, grid_y(0.7, 98));
  code.field(player.position.x, grid_x(0.7, 151));
  code.integer(player.unum, 1, 11);
}

template <typename Code>
void player_with_body(Code& code, SayBallPlayer& message) {
  code.field(message.body, angles(180));
  player(code, message.player, 1.0, 106, 69);
}

template <typename Code>
void request(Code& code, SayPassRequest& request) {
  code.field(request.point.y, grid_y(68.0 / 511.0, 512));
  code.field(request.point.x, {-52.0, 104.0 / 511.0, 512});
}

template <typename Code>
void dribble(Code& code, SayDribble& dribble) {
  code.integer(dribble.count, 1, 10);
  code.field(dribble.target.y, grid_y(0.5, 136));
  code.field(dribble.target.x, grid_x(0.5, 211));
}

/// Characters that follow a header; npos for an unknown header.
std::size_t length_of(char header) {
  switch (header) {
    case 'w':
      return 0;
    case 'o':
    case 'd':
    case 's':
    case 'r':
    case 'c':
    case 'F':
      return 1;
    case 'i':
      return 2;
    case 'h':
    case 'D':
    case 'P':
      return 3;
    case 'g':
    case 'S':
    case 'T':
    case 'O':
      return 4;
    case 'b':
      return 5;
    case 'Q':
      return 6;
    case 'e':
      return 7;
    case 'p':
    case 'G':
    case 'R':
    case 'B':
      return 9;
    default:
      return std::string_view::npos;
  }
}

/// Parses one message from the characters after the header; their number is checked before.
class Parser {
 public:
  Parser(std::string_view digits, const soccer::ServerParams& server)
      : digits_(digits), speed_(server.ball_speed_max) {}

  std::optional<SayMessage> message(char header) {
    switch (header) {
      case 'b':
        return parse_fields<SayBall>([this](auto& m) { ball(code_, m, speed_); });
      case 'p':
        return pass();
      case 'i':
        return intercept();
      case 'g':
        return parse_fields<SayGoalie>([this](auto& m) { goalie(code_, m, 37.0); });
      case 'e':
        return parse_fields<SayGoalieAndPlayer>([this](auto& m) {
          player(code_, m.player, 0.555, 191, 124);
          goalie(code_, m.goalie, 37.0);
        });
      case 'o':
        return line<SayOffsideLine>(10.0);
      case 'd':
        return line<SayDefenseLine>(-52.0);
      case 'w':
        return SayWaitRequest{};
      case 'F':
        return parse_fields<SaySetplay>([this](auto& m) { code_.integer(m.wait_cycles, 0, 74); });
      default:
        return message_continued(header);
    }
  }

 private:
  std::optional<SayMessage> message_continued(char header) {
    switch (header) {
      case 'h':
        return parse_fields<SayPassRequest>([this](auto& m) { request(code_, m); });
      case 's':
        return fraction<SayStamina>();
      case 'r':
        return fraction<SayRecovery>();
      case 'c':
        return fraction<SayCapacity>();
      case 'D':
        return parse_fields<SayDribble>([this](auto& m) { dribble(code_, m); });
      case 'G':
        return parse_fields<SayBallGoalie>([this](auto& m) { ball_and_goalie(code_, m, speed_); });
      case 'P':
      case 'Q':
      case 'R':
        return players();
      case 'S':
        return parse_fields<SaySelf>([this](auto& m) { self(code_, m); });
      case 'T':
        return parse_fields<SayTeammate>([this](auto& m) { numbered(code_, m); });
      case 'O':
        return parse_fields<SayOpponent>([this](auto& m) { numbered(code_, m); });
      case 'B':
        return ball_player();
      default:
        return std::nullopt;
    }
  }

  template <typename Message, typename Fields>
  std::optional<SayMessage> parse_fields(Fields fields) {
    Message message;
    if (!code_.start(digits_)) return std::nullopt;
    fields(message);
    return message;
  }

  template <typename Line>
  std::optional<SayMessage> line(double low) {
    return parse_fields<Line>([&](auto& m) { code_.field(m.x, {low, 42.0 / 73.0, 74}); });
  }

  template <typename Fraction>
  std::optional<SayMessage> fraction() {
    return parse_fields<Fraction>([this](auto& m) { code_.field(m.fraction, kFraction); });
  }

  std::optional<SayMessage> intercept() {
    SayIntercept message;
    if (!code_.start(digits_)) return std::nullopt;
    code_.integer(message.cycles, 0, 74);
    code_.integer(message.number, 0, 74);
    if (message.number < 1 || message.number > 22) return std::nullopt;
    return message;
  }

  std::optional<SayMessage> pass() {
    SayPass message;
    if (!code_.start(digits_.substr(0, 4))) return std::nullopt;
    receiver(code_, message);
    if (!code_.start(digits_.substr(4))) return std::nullopt;
    ball(code_, message.ball, speed_);
    if (message.receiver < 1 || message.receiver > soccer::kPlayersPerTeam) return std::nullopt;
    return message;
  }

  std::optional<SayMessage> players() {
    SayPlayers message;
    if (!code_.start(digits_)) return std::nullopt;
    std::array<SaidPlayer, 3> reversed;
    const std::size_t count = digits_.size() / 3;
    for (std::size_t i = 0; i < count; ++i) player(code_, reversed[i], 0.63, 168, 109);
    for (std::size_t i = count; i-- > 0;) message.players.push_back(reversed[i]);
    return message;
  }

  std::optional<SayMessage> ball_player() {
    SayBallPlayer message;
    if (!code_.start(digits_.substr(0, 5))) return std::nullopt;
    ball(code_, message.ball, speed_);
    if (!code_.start(digits_.substr(5))) return std::nullopt;
    player_with_body(code_, message);
    return message;
  }

  std::string_view digits_;
  double speed_;
  Decoder code_;
};

/// Formats one message including its header.
class Formatter {
 public:
  Formatter(const soccer::ServerParams& server, std::string& out)
      : speed_(server.ball_speed_max), out_(out) {}

  bool ok() const { return code_.ok(); }

  void operator()(SayBall m) {
    header('b');
    ball(code_, m, speed_);
    code_.finish(5, out_);
  }
  void operator()(SayPass m) {
    header('p');
    if (m.receiver < 1 || m.receiver > soccer::kPlayersPerTeam) code_.fail();
    receiver(code_, m);
    code_.finish(4, out_);
    ball(code_, m.ball, speed_);
    code_.finish(5, out_);
  }
  void operator()(SayIntercept m) {
    header('i');
    if (m.number < 1 || m.number > 22) code_.fail();
    code_.integer(m.cycles, 0, 74);
    code_.integer(m.number, 0, 74);
    code_.finish(2, out_);
  }
  void operator()(SayGoalie m) {
    header('g');
    check(m, 37.0);
    goalie(code_, m, 37.0);
    code_.finish(4, out_);
  }
  void operator()(SayGoalieAndPlayer m) {
    header('e');
    check(m.goalie, 37.0);
    player(code_, m.player, 0.555, 191, 124);
    goalie(code_, m.goalie, 37.0);
    code_.finish(7, out_);
  }
  void operator()(SayOffsideLine m) {
    if (m.x < 10.0) code_.fail();
    one('o', m.x, {10.0, 42.0 / 73.0, 74});
  }
  void operator()(SayDefenseLine m) {
    if (m.x > -10.0) code_.fail();
    one('d', m.x, {-52.0, 42.0 / 73.0, 74});
  }
  void operator()(SayWaitRequest) { header('w'); }
  void operator()(SaySetplay m) {
    header('F');
    code_.integer(m.wait_cycles, 0, 74);
    code_.finish(1, out_);
  }
  void operator()(SayPassRequest m) {
    header('h');
    request(code_, m);
    code_.finish(3, out_);
  }
  void operator()(SayStamina m) { one('s', m.fraction, kFraction); }
  void operator()(SayRecovery m) { one('r', m.fraction, kFraction); }
  void operator()(SayCapacity m) { one('c', m.fraction, kFraction); }
  void operator()(SayDribble m) {
    header('D');
    m.count = std::clamp(m.count, 1, 10);
    dribble(code_, m);
    code_.finish(3, out_);
  }
  void operator()(SayBallGoalie m) {
    header('G');
    check(m.goalie, 36.5);
    ball_and_goalie(code_, m, speed_);
    code_.finish(9, out_);
  }
  void operator()(SayPlayers m) {
    if (m.players.empty()) code_.fail();
    const auto count = static_cast<int>(m.players.size());
    header("PPQR"[count]);
    for (std::size_t i = m.players.size(); i-- > 0;) player(code_, m.players[i], 0.63, 168, 109);
    code_.finish(3 * count, out_);
  }
  void operator()(SaySelf m) {
    header('S');
    self(code_, m);
    code_.finish(4, out_);
  }
  void operator()(SayTeammate m) {
    header('T');
    numbered(code_, m);
    code_.finish(4, out_);
  }
  void operator()(SayOpponent m) {
    header('O');
    numbered(code_, m);
    code_.finish(4, out_);
  }
  void operator()(SayBallPlayer m) {
    header('B');
    ball(code_, m.ball, speed_);
    code_.finish(5, out_);
    player_with_body(code_, m);
    code_.finish(4, out_);
  }

 private:
  void header(char c) { out_ += c; }
  void one(char c, double value, const Grid& grid) {
    header(c);
    code_.field(value, grid);
    code_.finish(1, out_);
  }
  void check(const SayGoalie& goalie, double min_x) {
    constexpr double kGrid = 0.05;
    if (goalie.position.x < min_x || goalie.position.x > min_x + 15.9 + kGrid ||
        std::fabs(goalie.position.y) > 19.9 + kGrid) {
      code_.fail();
    }
  }

  double speed_;
  std::string& out_;
  Encoder code_;
};

}  // namespace

std::optional<SayMessage> parse_say_message(std::string_view& text,
                                            const soccer::ServerParams& server) {
  if (text.empty()) return std::nullopt;
  const std::size_t length = length_of(text[0]);
  if (length == std::string_view::npos || text.size() < 1 + length) return std::nullopt;
  auto message = Parser(text.substr(1, length), server).message(text[0]);
  if (message) text.remove_prefix(1 + length);
  return message;
}

bool append_say_message(const SayMessage& message, const soccer::ServerParams& server,
                        std::string& out) {
  const std::size_t size = out.size();
  Formatter formatter(server, out);
  std::visit(formatter, message);
  if (!formatter.ok()) out.resize(size);
  return formatter.ok();
}

}  // namespace cls::player
