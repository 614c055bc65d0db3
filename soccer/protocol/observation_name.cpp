// Landmark names by a hash table; player names.
#include "soccer/protocol/observation_name.h"

#include <array>
#include <cassert>
#include <cstring>

#include "soccer/pitch.h"
#include "soccer/side.h"

namespace cls::soccer {
namespace {

constexpr std::size_t kMaxNameSize = 8;  // "f r t 20"

// A landmark name fits into 64 bits; a see message has up to 55 of them.
class LandmarkNames {
 public:
  LandmarkNames() {
    for (std::size_t i = 0; i < kLandmarks.size(); ++i) {
      assert(kLandmarks[i].name.size() <= kMaxNameSize);
      const std::uint64_t key = key_of(kLandmarks[i].name);
      std::size_t slot = slot_of(key);
      while (keys_[slot] != 0) slot = (slot + 1) % kSlots;

      keys_[slot] = key;
      indices_[slot] = static_cast<std::uint8_t>(i);
    }
  }

  bool find(std::string_view name, std::uint8_t& index) const {
    if (name.empty() || name.size() > kMaxNameSize) return false;

    const std::uint64_t key = key_of(name);
    for (std::size_t slot = slot_of(key); keys_[slot] != 0; slot = (slot + 1) % kSlots) {
      if (keys_[slot] != key) continue;
      index = indices_[slot];
      return true;
    }

    return false;
  }

 private:
  static constexpr std::size_t kSlots = 256;

  static std::uint64_t key_of(std::string_view name) {
    std::uint64_t key = 0;
    std::memcpy(&key, name.data(), name.size());
    return key;
  }
  static std::size_t slot_of(std::uint64_t key) {
    return static_cast<std::size_t>((key * 0x9E3779B97F4A7C15u) >> 56);
  }

  std::array<std::uint64_t, kSlots> keys_{};
  std::array<std::uint8_t, kSlots> indices_{};
};

}  // namespace

bool read_landmark(Scanner& in, std::uint8_t& index) {
  static const LandmarkNames names;
  const std::string_view rest = in.rest().substr(0, kMaxNameSize + 1);
  const std::string_view name = rest.substr(0, rest.find(')'));
  return names.find(name, index) ? in.literal(name) : in.fail("a landmark");
}

bool read_team(Scanner& in, TeamName& team) {
  if (!in.literal("\"")) return false;

  const std::string_view rest = in.rest();
  const std::size_t size = rest.substr(0, TeamName::kMaxSize + 1).find('"');
  if (size == std::string_view::npos || size == 0) return in.fail("a team name");

  team = TeamName(rest.substr(0, size));
  return in.literal(rest.substr(0, size + 1));
}

bool read_player(Scanner& in, TeamName& team, int& unum, bool& goalie) {
  if (!(read_team(in, team) && in.literal(" ") && in.integer(unum, 1, kPlayersPerTeam))) {
    return false;
  }

  goalie = in.optional(" goalie");
  return true;
}

void append_player(const TeamName& team, int unum, bool goalie, TextWriter& out) {
  append(out, '"', team.view(), "\" ", unum);
  if (goalie) out.append(" goalie");
}

void append_player(const TeamName& team, int unum, bool goalie, std::string& out) {
  TextWriter writer(out);
  append_player(team, unum, goalie, writer);
}

}  // namespace cls::soccer
