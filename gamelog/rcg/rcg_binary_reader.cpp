// Reads binary logs: each record is a kind and a body of fixed or stated size.
#include "gamelog/rcg/format_readers.h"

#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "base/index.h"
#include "gamelog/rcg/binary_format.h"
#include "soccer/math.h"
#include "soccer/messages/parameter_message.h"

namespace cls::gamelog {
namespace {

using namespace rcg_binary;

constexpr std::size_t kFixedRecord = 2052;  // every record of version 1
constexpr std::size_t kDrawSize = 74;
constexpr std::size_t kTeamSize = 18;
constexpr std::size_t kObjectSize = 12;
constexpr std::size_t kPlayerSize = 64;
constexpr std::size_t kMaxMessage = 8192;

// Rounds to the precision of text logs; adding 0.0 removes the negative zero.
double length_of(double value) { return soccer::math::quantize(value, 1e-4) + 0.0; }
double degrees_of(double radians) {
  return soccer::math::quantize(soccer::math::to_degrees(radians), 1e-3) + 0.0;
}

soccer::Vec2 read_point(const char* at) {
  return {length_of(read_real(at)), length_of(read_real(at + 4))};
}

// Bytes after the NUL are undefined; an absent team has an empty name and an undefined score.
TeamFrame read_team(const char* at) {
  TeamFrame team;
  team.name.assign(at, std::find(at, at + kNameSize, '\0'));
  if (!team.name.empty()) team.score = read_int16(at + kNameSize);
  return team;
}

void read_short_player(const char* at, PlayerFrame& player) {
  player = PlayerFrame{};
  player.state = static_cast<std::uint16_t>(read_int16(at));
  player.body = read_int16(at + 6);
  player.position = {read_int16(at + 8) / kShortScale, read_int16(at + 10) / kShortScale};
  player.view_width = 0.0;
}

// The order of counters differs from text logs.
void read_long_player(const char* at, PlayerFrame& player) {
  player = PlayerFrame{};

  player.state = static_cast<std::uint16_t>(read_int16(at));
  player.type = std::clamp(read_int16(at + 2), -1, kMaxPlayerType);
  player.position = read_point(at + 4);
  player.velocity = read_point(at + 12);
  player.body = degrees_of(read_real(at + 20));
  player.neck = degrees_of(read_real(at + 24));
  player.view_width = degrees_of(read_real(at + 28));
  player.high_quality = read_int16(at + 32) != 0;

  player.stamina = read_real(at + 36);
  player.effort = read_real(at + 40);
  player.recovery = read_real(at + 44);
  player.capacity = -1.0;

  CommandCounts& counts = player.counts;
  const char* counter = at + 48;
  for (int* count : {&counts.kick, &counts.dash, &counts.turn, &counts.say, &counts.turn_neck,
                     &counts.catches, &counts.move, &counts.change_view}) {
    *count = read_int16(counter);
    counter += 2;
  }
}

class BinaryReader {
 public:
  BinaryReader(base::InputBuffer& input, RecordBuilder& builder)
      : input_(input), builder_(builder), version_(builder.record().version) {}

  void read_all() {
    while (read_record()) {
    }

    if (teams_ != builder_.record().final_teams()) builder_.add_teams(last_time(), teams_);
    if (has_parameters_) write_parameter_lines();
  }

 private:
  bool read_record() {
    const std::string_view start = input_.take(kKindSize);
    if (start.empty()) return false;
    if (start.size() < kKindSize) return fail(kTruncated);
    if (!builder_.has_room()) return fail(kTooManyRecords);

    const int kind = read_int16(start.data());
    return version_ == RcgVersion::kV1 ? read_fixed(kind) : read_packed(kind);
  }

  bool read_fixed(int kind) {
    const std::string_view body = input_.take(kFixedRecord - kKindSize);
    if (body.size() < kFixedRecord - kKindSize) return fail(kTruncated);

    if (kind == kShow) {
      read_short_show(body);
    } else if (kind == kMessage) {
      const char* text = body.data() + 2;
      add_message(read_int16(body.data()),
                  {text, std::find(text, body.data() + body.size(), '\0')});
    } else if (kind < kNothing || kind > kBlank) {
      return fail("unknown record kind " + std::to_string(kind));
    }

    return true;
  }

  bool read_packed(int kind) {
    if (kind == kMessage) return read_message();

    const std::size_t size = body_size(kind);
    if (size == kUnknownSize) return fail("unknown record kind " + std::to_string(kind));

    const std::string_view body = input_.take(size);
    if (body.size() < size) return fail(kTruncated);

    switch (kind) {
      case kShow:
        version_ == RcgVersion::kV2 ? read_short_show(body) : read_long_show(body);
        break;
      case kMode:
        set_mode(read_int8(body.data()));
        break;
      case kTeams:
        teams_ = {read_team(body.data()), read_team(body.data() + kTeamSize)};
        break;
      case kType:
        read_type(body);
        break;
      case kServerParam:
        read_server_params(body, builder_.record().server);
        has_parameters_ = true;
        break;
      case kPlayerParam:
        read_player_params(body, builder_.record().player);
        break;
      default:
        break;
    }

    return true;
  }

  static constexpr std::size_t kUnknownSize = static_cast<std::size_t>(-1);

  std::size_t body_size(int kind) const {
    // By kind; the size of a message is in its record.
    constexpr std::array<std::size_t, 10> kSecond = {0,
                                                     kShortShowSize,
                                                     kUnknownSize,
                                                     kDrawSize,
                                                     0,
                                                     kUnknownSize,
                                                     kUnknownSize,
                                                     kUnknownSize,
                                                     kUnknownSize,
                                                     kUnknownSize};
    constexpr std::array<std::size_t, 10> kThird = {
        0, kLongShowSize, kUnknownSize,    kDrawSize,        0,
        1, 2 * kTeamSize, kPlayerTypeSize, kServerParamSize, kPlayerParamSize};
    if (kind < kNothing || kind > kPlayerParam) return kUnknownSize;
    return (version_ == RcgVersion::kV3 ? kThird : kSecond)[base::index(kind)];
  }

  bool read_message() {
    const std::string head = std::string(input_.take(4));
    if (head.size() < 4) return fail(kTruncated);

    const std::size_t size = base::index(std::max(read_int16(head.data() + 2), 0));
    if (size > kMaxMessage) return fail("message longer than 8192 bytes");

    std::string_view text = input_.take(size);
    if (text.size() < size) return fail(kTruncated);

    while (text.ends_with('\0')) text.remove_suffix(1);
    add_message(read_int16(head.data()), std::string(text));
    return true;
  }

  // Binary messages have no time: the previous frame's is used.
  void add_message(int board, std::string text) { builder_.add_message(last_time(), board, text); }

  void read_short_show(std::string_view body) {
    const char* at = body.data();
    set_mode(read_int8(at));
    teams_ = {read_team(at + 2), read_team(at + 20)};

    const char* objects = at + 38;
    frame_.ball_position = {read_int16(objects + 8) / kShortScale,
                            read_int16(objects + 10) / kShortScale};

    for (std::size_t slot = 0; slot < kSlots; ++slot) {
      read_short_player(objects + (slot + 1) * kObjectSize, frame_.players[slot]);
    }

    append(read_int16(at + 314));
  }

  void read_long_show(std::string_view body) {
    const char* at = body.data();
    frame_.ball_position = read_point(at);
    frame_.ball_velocity = read_point(at + 8);

    for (std::size_t slot = 0; slot < kSlots; ++slot) {
      read_long_player(at + 16 + slot * kPlayerSize, frame_.players[slot]);
    }

    append(read_int16(at + 1424));
  }

  // Times above 32767 overflow the sixteen bits.
  void append(int time) {
    if (time < 0) {
      fail("negative time");
      return;
    }

    frame_.time = time;
    frame_.teams = teams_;
    builder_.append_frame(frame_);
  }

  void set_mode(int id) {
    if (id > 0 && id < soccer::kPlayModeCount) frame_.mode = static_cast<soccer::PlayMode>(id);
  }

  void read_type(std::string_view body) {
    soccer::PlayerType type;
    read_player_type(body, type);
    builder_.set_player_type(type);
  }

  void write_parameter_lines() {
    const auto write = [this](const auto& parameters) {
      std::string line;
      soccer::format(parameters, soccer::kAllVersions, line);
      builder_.add_parameter_line(std::move(line));
    };

    write(builder_.record().server);
    write(builder_.record().player);
    for (const soccer::PlayerType& type : builder_.record().types) write(type);
  }

  static int read_int8(const char* at) { return static_cast<signed char>(*at); }

  int last_time() const {
    const MatchRecord& record = builder_.record();
    return record.time.empty() ? 0 : record.time.back();
  }

  // Returns false: the next record cannot be found.
  bool fail(std::string message) {
    builder_.add_error(input_, std::move(message));
    return false;
  }

  base::InputBuffer& input_;
  RecordBuilder& builder_;
  RcgVersion version_;
  Frame frame_;
  TeamFrames teams_;
  bool has_parameters_ = false;
};

}  // namespace

bool looks_like_version_1(std::string_view start) {
  if (start.size() < 3 || start[0] != '\0' || start[1] < 0 || start[1] > kBlank) return false;
  return start[1] != kShow || (start[2] >= 0 && start[2] < soccer::kPlayModeCount);
}

void read_rcg_binary(base::InputBuffer& input, RecordBuilder& builder) {
  BinaryReader(input, builder).read_all();
}

}  // namespace cls::gamelog
