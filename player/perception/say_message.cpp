// Codec of say messages: values quantized to grids and packed into one number in base 74.
#include "player/perception/say_message.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <tuple>

namespace cls::player {
namespace {

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
  /// Of `count` codes from `low` on, messages have those from `least` to `most`.
  void integer(int& value, int low, int count, int least, int most) {
    const bool fits = value >= least && value <= most;
    ok_ &= fits;
    push(fits ? value - low : 0, count);
  }
  void integer(int& value, int low, int count) { integer(value, low, count, low, low + count - 1); }
  /// Sign and magnitude of a speed component, six bits.
  void speed(double& value, double max) {
    const int size = rounded(std::min(std::fabs(value), max) * kMaxSpeedStep / max, kMaxSpeedStep);
    push(size + (std::signbit(value) ? kSpeedSign : 0), 2 * kSpeedSign);
  }
  /// False for a value that the grid holds only changed.
  void require(bool holds) { ok_ &= holds; }
  bool ok() const { return ok_; }

  void finish(std::size_t digits, std::string& out) {
    std::uint64_t value = 0;
    for (std::size_t i = fields_.size(); i-- > 0;) {
      value = value * static_cast<std::uint64_t>(fields_[i].count) +
              static_cast<std::uint64_t>(fields_[i].index);
    }
    const std::size_t start = out.size();
    out.append(digits, kDigits[0]);
    for (std::size_t i = out.size(); i-- > start; value /= kBase) out[i] = kDigits[value % kBase];
    fields_.clear();
  }

 private:
  struct Field {
    int index = 0;
    int count = 1;
  };
  void push(int index, int count) { fields_.push_back({index, count}); }

  base::FixedList<Field, 12> fields_;
  bool ok_ = true;
};

class Decoder {
 public:
  void start(std::string_view digits) {
    value_ = 0;
    for (const char c : digits) {
      const std::size_t digit = kDigits.find(c);
      ok_ &= digit != std::string_view::npos;
      value_ = value_ * kBase + digit;
    }
  }
  void field(double& value, const Grid& grid) { value = grid.low + grid.step * pop(grid.count); }
  void integer(int& value, int low, int count, int least, int most) {
    value = low + pop(count);
    ok_ &= value >= least && value <= most;
  }
  void integer(int& value, int low, int count) { value = low + pop(count); }
  void speed(double& value, double max) {
    const int bits = pop(2 * kSpeedSign);
    const double size = bits % kSpeedSign * max / kMaxSpeedStep;
    value = bits >= kSpeedSign ? -size : size;
  }
  /// Values that were said are on the grid.
  void require(bool /*holds*/) {}
  bool ok() const { return ok_; }

 private:
  int pop(int count) {
    const auto modulus = static_cast<std::uint64_t>(count);
    const int index = static_cast<int>(value_ % modulus);
    value_ /= modulus;
    return index;
  }

  std::uint64_t value_ = 0;
  bool ok_ = true;
};

Grid grid_x(double step, int count) { return {-52.5, step, count}; }
Grid grid_y(double step, int count) { return {-34.0, step, count}; }
Grid angles(int count) { return {-180.0, 360.0 / count, count}; }
constexpr Grid kFraction{0.0, 1.0 / 73.0, 74};

constexpr int kNumbers = 2 * soccer::kPlayersPerTeam;

// Fields that several messages have, or that need more than a line.

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
void goalie(Code& code, SayGoalie& goalie, double min_x) {
  constexpr double kGrid = 0.05;
  code.require(goalie.position.x >= min_x && goalie.position.x <= min_x + 15.9 + kGrid &&
               std::fabs(goalie.position.y) <= 19.9 + kGrid);

  code.field(goalie.body, angles(360));
  code.field(goalie.position.y, {-20.0, 0.1, 400});
  code.field(goalie.position.x, {min_x, 0.1, 160});
}

template <typename Code>
void player(Code& code, SaidPlayer& player, double step, int columns, int rows) {
  code.field(player.position.y, grid_y(step, rows));
  code.field(player.position.x, grid_x(step, columns));
  code.integer(player.number, 1, kNumbers);
}

template <std::size_t kCount, typename Code>
void players(Code& code, base::FixedList<SaidPlayer, 3>& players) {
  code.require(players.size() == kCount);
  while (players.size() < kCount) players.push_back({});

  for (std::size_t i = kCount; i-- > 0;) player(code, players[i], 0.63, 168, 109);
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
  code.integer(player.unum, 1, soccer::kPlayersPerTeam);
}

template <typename Code>
void dribble(Code& code, SayDribble& dribble) {
  dribble.count = std::clamp(dribble.count, 1, 10);
  code.integer(dribble.count, 1, 10);
  code.field(dribble.target.y, grid_y(0.5, 136));
  code.field(dribble.target.x, grid_x(0.5, 211));
}

/// Characters that hold one number: `fields(code, message, max_speed)` visits what is packed into
/// it, for the encoder and for the decoder.
template <typename Fields>
struct Group {
  std::size_t digits = 0;
  Fields fields;
};
template <typename Fields>
Group(std::size_t digits, Fields fields) -> Group<Fields>;

template <typename Message, typename... Fields>
struct Format {
  char header = '\0';
  std::tuple<Group<Fields>...> groups;

  constexpr std::size_t length() const {
    return std::apply([](const auto&... group) { return (std::size_t{0} + ... + group.digits); },
                      groups);
  }
};

template <typename Message, typename... Fields>
constexpr Format<Message, Fields...> format(char header, Group<Fields>... groups) {
  return {header, {groups...}};
}

// clang-format off
#define FIELDS(...) [](auto& code, auto& m, [[maybe_unused]] double max_speed) { __VA_ARGS__; }

/// Every message: its header, and how many characters hold which fields.
constexpr std::tuple kFormats{
    format<SayBall>('b', Group{5, FIELDS(ball(code, m, max_speed))}),
    format<SayPass>('p', Group{4, FIELDS(code.integer(m.receiver, 0, 16, 1, soccer::kPlayersPerTeam);
                                         ball_position(code, m.point))},
                         Group{5, FIELDS(ball(code, m.ball, max_speed))}),
    format<SayIntercept>('i', Group{2, FIELDS(code.integer(m.cycles, 0, 74);
                                              code.integer(m.number, 0, 74, 1, kNumbers))}),
    format<SayGoalie>('g', Group{4, FIELDS(goalie(code, m, 37.0))}),
    format<SayGoalieAndPlayer>('e', Group{7, FIELDS(player(code, m.player, 0.555, 191, 124);
                                                    goalie(code, m.goalie, 37.0))}),
    format<SayOffsideLine>('o', Group{1, FIELDS(code.require(m.x >= 10.0);
                                                code.field(m.x, {10.0, 42.0 / 73.0, 74}))}),
    format<SayDefenseLine>('d', Group{1, FIELDS(code.require(m.x <= -10.0);
                                                code.field(m.x, {-52.0, 42.0 / 73.0, 74}))}),
    format<SayWaitRequest>('w'),
    format<SaySetplay>('F', Group{1, FIELDS(code.integer(m.wait_cycles, 0, 74))}),
    format<SayPassRequest>('h', Group{3, FIELDS(code.field(m.point.y, grid_y(68.0 / 511.0, 512));
                                                code.field(m.point.x, {-52.0, 104.0 / 511.0, 512}))}),
    format<SayStamina>('s', Group{1, FIELDS(code.field(m.fraction, kFraction))}),
    format<SayRecovery>('r', Group{1, FIELDS(code.field(m.fraction, kFraction))}),
    format<SayCapacity>('c', Group{1, FIELDS(code.field(m.fraction, kFraction))}),
    format<SayDribble>('D', Group{3, FIELDS(dribble(code, m))}),
    format<SayBallGoalie>('G', Group{9, FIELDS(ball_and_goalie(code, m, max_speed))}),
    format<SayPlayers>('P', Group{3, FIELDS(players<1>(code, m.players))}),
    format<SayPlayers>('Q', Group{6, FIELDS(players<2>(code, m.players))}),
    format<SayPlayers>('R', Group{9, FIELDS(players<3>(code, m.players))}),
    format<SaySelf>('S', Group{4, FIELDS(self(code, m))}),
    format<SayTeammate>('T', Group{4, FIELDS(numbered(code, m))}),
    format<SayOpponent>('O', Group{4, FIELDS(numbered(code, m))}),
    format<SayBallPlayer>('B', Group{5, FIELDS(ball(code, m.ball, max_speed))},
                               Group{4, FIELDS(code.field(m.body, angles(180));
                                               player(code, m.player, 1.0, 106, 69))}),
};
#undef FIELDS
// clang-format on

/// The message if the header is that of the format and the characters are there; removes them.
template <typename Message, typename... Fields>
std::optional<SayMessage> parse_as(const Format<Message, Fields...>& format, double max_speed,
                                   std::string_view& text) {
  if (text[0] != format.header || text.size() < 1 + format.length()) return std::nullopt;

  Message message;
  Decoder code;
  std::string_view rest = text.substr(1);
  const auto parse_group = [&](const auto& group) {
    code.start(rest.substr(0, group.digits));
    group.fields(code, message, max_speed);
    rest.remove_prefix(group.digits);
  };
  std::apply([&](const auto&... group) { (parse_group(group), ...); }, format.groups);
  if (!code.ok()) return std::nullopt;

  text = rest;
  return message;
}

/// False without change where the format is not that of the message or cannot hold its values.
template <typename Message, typename... Fields>
bool append_as(const Format<Message, Fields...>& format, double max_speed, const SayMessage& said,
               std::string& out) {
  const auto* given = std::get_if<Message>(&said);
  if (given == nullptr) return false;

  Message message = *given;
  Encoder code;
  const std::size_t size = out.size();
  out += format.header;
  const auto append_group = [&](const auto& group) {
    group.fields(code, message, max_speed);
    code.finish(group.digits, out);
  };
  std::apply([&](const auto&... group) { (append_group(group), ...); }, format.groups);

  if (!code.ok()) out.resize(size);
  return code.ok();
}

}  // namespace

std::optional<SayMessage> parse_say_message(std::string_view& text,
                                            const soccer::ServerParams& server) {
  std::optional<SayMessage> message;
  if (text.empty()) return message;

  const auto parse = [&](const auto& format) {
    return (message = parse_as(format, server.ball_speed_max, text)).has_value();
  };
  std::apply([&](const auto&... format) { return (parse(format) || ...); }, kFormats);
  return message;
}

bool append_say_message(const SayMessage& message, const soccer::ServerParams& server,
                        std::string& out) {
  const auto append = [&](const auto& format) {
    return append_as(format, server.ball_speed_max, message, out);
  };
  return std::apply([&](const auto&... format) { return (append(format) || ...); }, kFormats);
}

}  // namespace cls::player
