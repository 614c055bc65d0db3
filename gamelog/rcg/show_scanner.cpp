// One pass over a show line, straight into the columns.
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

  bool header(std::int32_t& time) {
    return literal("(show ") && integer(time) && (time >= 0 || fail("the time is negative"));
  }

  // Monitors' own recordings have `(pm 3)` and `(tm ...)` here.
  bool skip_monitor_parts() {
    blanks();
    while (*at_ == '(' && (at_[1] == 'p' || at_[1] == 't')) {
      const void* closing = std::memchr(at_, ')', static_cast<std::size_t>(end_ - at_));
      if (closing == nullptr) return fail("expected ')'");
      at_ = static_cast<const char*>(closing) + 1;
      blanks();
    }
    return true;
  }

  bool ball(Point& position, Point& velocity) {
    return literal("((b)") && point(position) && point(velocity) && literal(")");
  }

  bool all_players() {
    std::uint32_t seen = 0;
    blanks();
    while (*at_ == '(') {
      if (!player(seen)) return false;
      blanks();
    }
    for (std::size_t slot = 0; slot < kSlots; ++slot) {
      if ((seen >> slot & 1) == 0) clear_player(players_, first_entry_ + slot);
    }
    return true;
  }

  bool end() { return literal(")") && (blanks(), at_ == end_ || fail("expected the end")); }

  LineProblem problem() const { return {static_cast<std::size_t>(problem_at_ - start_), problem_}; }

 private:
  bool fail(std::string_view what) {
    problem_ = what;
    problem_at_ = at_;
    return false;
  }

  void blanks() {
    while (*at_ == ' ') ++at_;
  }

  template <std::size_t kSize>
  bool looking_at(const char (&text)[kSize]) const {
    return std::memcmp(at_, text, kSize - 1) == 0;
  }

  template <std::size_t kSize>
  bool literal(const char (&text)[kSize]) {
    if (!looking_at(text)) return fail("expected another word or bracket");
    at_ += kSize - 1;
    return true;
  }

  bool number(float& value) {
    blanks();
    return base::scan_number(at_, value) || fail("expected a number");
  }

  bool integer(std::int32_t& value) {
    blanks();
    return base::scan_integer(at_, value) || fail("expected an integer");
  }

  bool point(Point& value) { return number(value.x) && number(value.y); }

  bool side_and_unum(int& slot) {
    const char side = *at_;
    if (side != 'l' && side != 'r') return fail("expected 'l' or 'r'");
    ++at_;
    std::int32_t unum = 0;
    if (!integer(unum)) return false;
    if (unum < 1 || unum > soccer::kPlayersPerTeam) return fail("expected a number from 1 to 11");
    slot = soccer::slot_of(side == 'l' ? soccer::Side::kLeft : soccer::Side::kRight, unum);
    return literal(")");
  }

  bool state(std::uint32_t& value) {
    blanks();
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
    if ((seen >> slot & 1) != 0) return fail("the same player twice");
    seen |= std::uint32_t{1} << slot;
    const std::size_t entry = first_entry_ + static_cast<std::size_t>(slot);
    return body(entry) && view(entry) && stamina(entry) && attention(entry) && counters(entry) &&
           literal(")");
  }

  bool body(std::size_t entry) {
    std::int32_t type = 0;
    blanks();
    const bool unknown_type = *at_ == '-';
    if (unknown_type) ++at_;
    if (!integer(type)) return false;
    if (type > kHighestType) return fail("no such player type");
    players_.type[entry] = static_cast<std::int16_t>(unknown_type ? -type : type);
    if (!(state(players_.state[entry]) && point(players_.position[entry]) &&
          point(players_.velocity[entry]) && number(players_.body[entry]) &&
          number(players_.neck[entry]))) {
      return false;
    }
    blanks();
    Point& arm = players_.pointing_at[entry];
    if (*at_ == '(') {
      arm = {kNoNumber, kNoNumber};
      return true;
    }
    return point(arm) && (blanks(), true);
  }

  bool view(std::size_t entry) {
    if (!literal("(v ")) return false;
    if (*at_ != 'h' && *at_ != 'l') return fail("expected 'h' or 'l'");
    players_.high_quality[entry] = *at_ == 'h' ? 1 : 0;
    ++at_;
    if (!(number(players_.view_width[entry]) && literal(")"))) return false;
    blanks();
    if (looking_at("(fp ")) {
      at_ += 4;
      if (!(point(players_.focus[entry]) && literal(")"))) return false;
      blanks();
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
    blanks();
    players_.capacity[entry] = -1.0F;
    if (*at_ != ')' && !number(players_.capacity[entry])) return false;
    return literal(")") && (blanks(), true);
  }

  bool attention(std::size_t entry) {
    players_.attention[entry] = -1;
    if (!looking_at("(f ")) return true;
    at_ += 3;
    int slot = 0;
    if (!side_and_unum(slot)) return false;
    players_.attention[entry] = static_cast<std::int8_t>(slot);
    blanks();
    return true;
  }

  bool counters(std::size_t entry) {
    if (!literal("(c ")) return false;
    Counters& counters = players_.counters[entry];
    constexpr std::size_t kInAllVersions = kCounterCount - 1;
    for (std::size_t i = 0; i < kInAllVersions; ++i) {
      if (!integer(counters[i])) return false;
    }
    blanks();
    counters[kInAllVersions] = 0;
    if (*at_ != ')' && !integer(counters[kInAllVersions])) return false;
    return literal(")");
  }

  const char* start_;
  const char* end_;
  const char* at_;
  PlayerColumns& players_;
  std::size_t first_entry_;
  std::string_view problem_;
  const char* problem_at_ = nullptr;
};

}  // namespace

bool read_show(std::string_view line, RecordBuilder& builder, LineProblem& problem) {
  MatchRecord& record = builder.record();
  const std::size_t index = record.frames();
  ShowScanner scanner(line, record.players, index * kSlots);
  std::int32_t time = 0;
  if (!scanner.header(time)) {
    problem = scanner.problem();
    return false;
  }
  builder.begin_frame(time);
  if (scanner.skip_monitor_parts() &&
      scanner.ball(record.ball_position[index], record.ball_velocity[index]) &&
      scanner.all_players() && scanner.end()) {
    return true;
  }
  builder.drop_frame();
  problem = scanner.problem();
  return false;
}

}  // namespace cls::gamelog
