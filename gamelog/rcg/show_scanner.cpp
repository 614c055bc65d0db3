// Parses a show line in one pass, straight into the columns.
#include "gamelog/rcg/show_scanner.h"

#include <cstring>
#include <limits>

#include "base/text/number_scan.h"

namespace cls::gamelog {
namespace {

constexpr float kNoNumber = std::numeric_limits<float>::quiet_NaN();

class ShowScanner {
 public:
  ShowScanner(std::string_view line, PlayerColumns& players, std::size_t first_entry)
      : start_(line.data()),
        end_(line.data() + line.size()),
        at_(line.data()),
        players_(players),
        first_entry_(first_entry) {}

  bool scan_header(std::int32_t& time) {
    return literal("(show ") && integer(time) && (time >= 0 || fail("negative time"));
  }

  // Logs recorded by monitors have `(pm 3)` and `(tm ...)` here.
  bool skip_monitor_parts() {
    skip_spaces();
    while (*at_ == '(' && (at_[1] == 'p' || at_[1] == 't')) {
      const void* closing = std::memchr(at_, ')', static_cast<std::size_t>(end_ - at_));
      if (closing == nullptr) return fail("expected ')'");
      at_ = static_cast<const char*>(closing) + 1;
      skip_spaces();
    }

    return true;
  }

  bool scan_ball(Point& position, Point& velocity) {
    return literal("((b)") && point(position) && point(velocity);
  }

  // Only version 7 has one.
  bool scan_height(float& height, bool has_height) {
    height = 0.0F;
    skip_spaces();
    if (has_height && *at_ != ')' && !number(height)) return false;
    return literal(")");
  }

  bool scan_players() {
    std::uint32_t seen = 0;
    skip_spaces();

    while (*at_ == '(') {
      if (!player(seen)) return false;
      skip_spaces();
    }

    for (std::size_t slot = 0; slot < kSlots; ++slot) {
      if ((seen >> slot & 1) == 0) clear_player(players_, first_entry_ + slot);
    }

    return true;
  }

  bool scan_end() {
    return literal(")") && (skip_spaces(), at_ == end_ || fail("expected the end"));
  }

  /// The cause of a failed scan; otherwise the first number that is out of range; otherwise empty.
  LineError error() const {
    if (error_.empty()) return {};
    return {static_cast<std::size_t>(error_at_ - start_), error_};
  }

 private:
  bool fail(std::string_view message) {
    error_ = message;
    error_at_ = at_;
    return false;
  }

  void skip_spaces() {
    while (*at_ == ' ') ++at_;
  }

  template <std::size_t kSize>
  bool starts_with(const char (&text)[kSize]) const {
    return std::memcmp(at_, text, kSize - 1) == 0;
  }

  template <std::size_t kSize>
  bool literal(const char (&text)[kSize]) {
    if (!starts_with(text)) return fail("expected another keyword or bracket");
    at_ += kSize - 1;
    return true;
  }

  bool number(float& value) {
    skip_spaces();
    if (base::scan_number(at_, value)) return true;

    const char* start = at_;
    if (!base::scan_number_out_of_range(at_, value)) return fail("expected a number");

    if (error_.empty()) {
      error_ = "number out of range";
      error_at_ = start;
    }

    return true;
  }

  bool integer(std::int32_t& value) {
    skip_spaces();
    return base::scan_integer(at_, value) || fail("expected an integer");
  }

  bool point(Point& value) { return number(value.x) && number(value.y); }

  bool side_and_unum(int& slot) {
    const char side = *at_;
    if (side != 'l' && side != 'r') return fail("expected 'l' or 'r'");

    ++at_;
    std::int32_t unum = 0;
    if (!integer(unum)) return false;
    if (!soccer::is_unum(unum)) return fail("expected a number from 1 to 11");

    slot = soccer::slot_of(side == 'l' ? soccer::Side::kLeft : soccer::Side::kRight, unum);
    return literal(")");
  }

  bool state(std::uint32_t& value) {
    skip_spaces();
    if (*at_ != '0') return fail("expected a state");
    ++at_;

    value = 0;
    if (*at_ != 'x') return true;
    const char* first = ++at_;

    for (;; ++at_) {
      const auto c = static_cast<unsigned char>(*at_);
      if (c >= '0' && c <= '9') {
        value = value << 4 | static_cast<std::uint32_t>(c - '0');
      } else if (c >= 'a' && c <= 'f') {
        value = value << 4 | static_cast<std::uint32_t>(c - 'a' + 10);
      } else {
        break;
      }
    }

    return (at_ > first && at_ - first <= 8) || fail("expected a state");
  }

  bool player(std::uint32_t& seen) {
    int slot = 0;
    if (!literal("((") || !side_and_unum(slot)) return false;
    if ((seen >> slot & 1) != 0) return fail("duplicate player");

    seen |= std::uint32_t{1} << slot;
    const std::size_t entry = first_entry_ + static_cast<std::size_t>(slot);
    return body(entry) && view(entry) && stamina(entry) && attention(entry) && counters(entry) &&
           literal(")");
  }

  bool body(std::size_t entry) {
    std::int32_t type = 0;
    skip_spaces();
    const bool unknown_type = *at_ == '-';
    if (unknown_type) ++at_;
    if (!integer(type)) return false;
    if (type > kMaxPlayerType) return fail("player type above 255");

    players_.type[entry] = static_cast<std::int16_t>(unknown_type ? -type : type);
    if (!(state(players_.state[entry]) && point(players_.position[entry]) &&
          point(players_.velocity[entry]) && number(players_.body[entry]) &&
          number(players_.neck[entry]))) {
      return false;
    }

    skip_spaces();
    Point& arm = players_.pointing_at[entry];

    if (*at_ == '(') {
      arm = {kNoNumber, kNoNumber};
      return true;
    }

    return point(arm) && (skip_spaces(), true);
  }

  bool view(std::size_t entry) {
    if (!literal("(v ")) return false;
    if (*at_ != 'h' && *at_ != 'l') return fail("expected 'h' or 'l'");
    players_.high_quality[entry] = *at_ == 'h' ? 1 : 0;
    ++at_;

    if (!(number(players_.view_width[entry]) && literal(")"))) return false;
    skip_spaces();
    if (starts_with("(fp ")) {
      at_ += 4;
      if (!(point(players_.focus[entry]) && literal(")"))) return false;
      skip_spaces();
    } else {
      players_.focus[entry] = {0.0F, 0.0F};
    }

    return true;
  }

  bool stamina(std::size_t entry) {
    if (!(literal("(s ") && number(players_.stamina[entry]) && number(players_.effort[entry]) &&
          number(players_.recovery[entry]))) {
      return false;
    }

    skip_spaces();
    players_.capacity[entry] = -1.0F;
    if (*at_ != ')' && !number(players_.capacity[entry])) return false;
    return literal(")") && (skip_spaces(), true);
  }

  bool attention(std::size_t entry) {
    players_.attention[entry] = -1;
    if (!starts_with("(f")) return true;
    at_ += 2;
    skip_spaces();  // rcgverconv writes no space
    int slot = 0;
    if (!side_and_unum(slot)) return false;

    players_.attention[entry] = static_cast<std::int8_t>(slot);
    skip_spaces();
    return true;
  }

  bool counters(std::size_t entry) {
    if (!literal("(c ")) return false;
    Counters& counters = players_.counters[entry];
    constexpr std::size_t kInAllVersions = kCounterCount - 1;

    for (std::size_t i = 0; i < kInAllVersions; ++i) {
      if (!integer(counters[i])) return false;
    }

    skip_spaces();
    counters[kInAllVersions] = 0;
    if (*at_ != ')' && !integer(counters[kInAllVersions])) return false;
    return literal(")");
  }

  const char* start_;
  const char* end_;
  const char* at_;
  PlayerColumns& players_;
  std::size_t first_entry_;
  std::string_view error_;
  const char* error_at_ = nullptr;
};

}  // namespace

bool read_show(std::string_view line, RecordBuilder& builder, LineError& error) {
  MatchRecord& record = builder.record();
  const std::size_t index = record.frames();
  ShowScanner scanner(line, record.players, index * kSlots);
  std::int32_t time = 0;

  if (!scanner.scan_header(time)) {
    error = scanner.error();
    return false;
  }

  builder.begin_frame(time);
  if (scanner.skip_monitor_parts() &&
      scanner.scan_ball(record.ball_position[index], record.ball_velocity[index]) &&
      scanner.scan_height(record.ball_height[index], record.has_ball_height) &&
      scanner.scan_players() && scanner.scan_end()) {
    error = scanner.error();
    return true;
  }

  builder.drop_frame();
  error = scanner.error();
  return false;
}

}  // namespace cls::gamelog
