// Compares every sensed value with a recorded match of rcssserver.
#include <gtest/gtest.h>

#include <map>

#include "base/text/number_text.h"
#include "simulator/senses/body_sense.h"
#include "simulator/senses/vision.h"
#include "soccer/pitch.h"
#include "soccer/protocol/message_kind.h"
#include "tests/simulator/senses/recorded_world.h"
#include "tests/support/files.h"
#include "tests/support/transcript.h"

namespace cls::simulator {
namespace {

using soccer::Observation;
using soccer::ObservedDetail;
using soccer::ObservedKind;

std::string text(double value) {
  std::string out;
  base::append_g(value, out);
  return out;
}

/// Counts comparisons. A different value is "at a border" if a world with the same rounded log
/// values produces it, otherwise wrong.
struct Tally {
  int equal = 0;
  int border = 0;
  std::map<std::string, int> wrong;
  std::string first_wrong;

  void add(const std::string& what, bool is_equal, bool is_border, const std::string& where) {
    if (is_equal) {
      ++equal;
    } else if (is_border) {
      ++border;
    } else {
      if (wrong.empty()) first_wrong = what + " in " + where;
      ++wrong[what];
    }
  }
};

bool same_name(const Observation& recorded, const Observation& computed) {
  if (recorded.kind != computed.kind) return false;
  switch (recorded.kind) {
    case ObservedKind::kLandmark:
    case ObservedKind::kLine:
      return recorded.index == computed.index;
    case ObservedKind::kPlayer:
      return recorded.team == computed.team &&
             (recorded.unum == 0 || recorded.unum == computed.unum);
    default:
      return true;
  }
}

bool same_names(const soccer::See& recorded, const soccer::See& computed) {
  if (recorded.objects.size() != computed.objects.size()) return false;
  for (std::size_t i = 0; i < recorded.objects.size(); ++i) {
    if (!same_name(recorded.objects[i], computed.objects[i])) return false;
  }
  return true;
}

struct Field {
  std::string name;
  bool (*equal)(const Observation& recorded, const Observation& computed);
};

const std::vector<Field>& fields_of(ObservedDetail detail) {
  static const std::vector<Field> all = {
      {"direction", [](const auto& a, const auto& b) { return a.direction == b.direction; }},
      {"distance",
       [](const auto& a, const auto& b) { return text(a.distance) == text(b.distance); }},
      {"mark", [](const auto& a, const auto& b) { return a.mark == b.mark; }},
      {"goalie", [](const auto& a, const auto& b) { return a.unum == 0 || a.goalie == b.goalie; }},
      {"distance change",
       [](const auto& a, const auto& b) {
         return text(a.distance_change) == text(b.distance_change);
       }},
      {"direction change",
       [](const auto& a, const auto& b) {
         return text(a.direction_change) == text(b.direction_change);
       }},
      {"body", [](const auto& a, const auto& b) { return a.body == b.body; }},
      {"head", [](const auto& a, const auto& b) { return a.head == b.head; }},
  };

  static const std::vector<Field> position(all.begin(), all.begin() + 4);
  static const std::vector<Field> motion(all.begin(), all.begin() + 6);
  if (detail == ObservedDetail::kPose) return all;

  return detail == ObservedDetail::kMotion ? motion : position;
}

/// Details that are always and never sent at these distances (docs/spec/simulation-model.md 7.6).
void compare_detail(const Observation& recorded, Tally& tally, const std::string& where) {
  if (recorded.kind != ObservedKind::kLandmark && recorded.kind != ObservedKind::kBall &&
      recorded.kind != ObservedKind::kPlayer) {
    tally.add("detail", recorded.detail == ObservedDetail::kPosition, false, where);
    return;
  }
  const ObservedDetail most =
      recorded.kind == ObservedKind::kPlayer ? ObservedDetail::kPose : ObservedDetail::kMotion;
  if (recorded.distance <= 20.0) tally.add("detail", recorded.detail == most, false, where);
  if (recorded.distance >= 40.0) {
    tally.add("detail", recorded.detail == ObservedDetail::kPosition, false, where);
  }
}

class Comparison {
 public:
  /// Compares one see or sense_body of the player in `slot` with the world at its time.
  void compare(const World& world, Slot slot, std::string_view message) {
    worlds_.assign(1, world);
    where_ = std::string(message.substr(0, 40));
    if (soccer::message_kind(message) == soccer::MessageKind::kSee) {
      compare_see(slot, message);
    } else {
      compare_sense_body(slot, message);
    }
  }

  const Tally& tally() const { return tally_; }

 private:
  static constexpr std::size_t kMaxWorlds = 400;

  /// World 0 is the recorded one, the others are rounded to it.
  const World& world(std::size_t i) {
    while (worlds_.size() <= i) worlds_.push_back(jittered(worlds_.front(), random_));
    return worlds_[i];
  }

  soccer::See seen(std::size_t i, Slot slot) {
    soccer::See see_message;
    see(vision_, world(i), slot, random_, see_message);
    return see_message;
  }

  void compare_see(Slot slot, std::string_view message) {
    soccer::See recorded;
    ASSERT_TRUE(soccer::parse(message, recorded)) << message;

    std::size_t names = 0;
    while (names < kMaxWorlds && !same_names(recorded, seen(names, slot))) ++names;
    tally_.add("objects", names == 0, names < kMaxWorlds, where_);

    if (names == kMaxWorlds) return;
    const soccer::See computed = seen(names, slot);
    for (std::size_t i = 0; i < recorded.objects.size(); ++i) {
      compare_detail(recorded.objects[i], tally_, where_);
      for (const Field& field : fields_of(recorded.objects[i].detail)) {
        const bool equal = field.equal(recorded.objects[i], computed.objects[i]);
        const bool border = !equal && some_world_sees(recorded, i, field, slot);
        tally_.add(field.name, equal, border, where_ + " object " + std::to_string(i));
      }
    }
  }

  bool some_world_sees(const soccer::See& recorded, std::size_t object, const Field& field,
                       Slot slot) {
    for (std::size_t i = 0; i < kMaxWorlds; ++i) {
      const soccer::See computed = seen(i, slot);
      if (same_names(recorded, computed) &&
          field.equal(recorded.objects[object], computed.objects[object])) {
        return true;
      }
    }
    return false;
  }

  void compare_sense_body(Slot slot, std::string_view message) {
    soccer::SenseBody recorded;
    ASSERT_TRUE(soccer::parse(message, recorded)) << message;

    const auto groups = [](const soccer::SenseBody& sense) {
      std::string out;
      soccer::format(sense, 18, out);
      return out;
    };

    // Three fields are rounded from values that the log rounds too; the other text must be equal.
    soccer::SenseBody computed = sense_body(world(0), slot);
    const soccer::SenseBody exact = computed;
    compare_rounded("speed", recorded, exact, slot, &soccer::SenseBody::speed);
    // Four decimals do not determine the direction of a player that hardly moves.
    constexpr double kSlow = 0.005;
    if (world(0).player(slot).velocity.length() >= kSlow) {
      compare_rounded("speed direction", recorded, exact, slot,
                      &soccer::SenseBody::speed_direction);
    }

    compare_rounded("head angle", recorded, exact, slot, &soccer::SenseBody::head_angle);
    computed.speed = recorded.speed;
    computed.speed_direction = recorded.speed_direction;
    computed.head_angle = recorded.head_angle;
    tally_.add("sense_body", groups(computed) == groups(recorded), false,
               groups(recorded) + " / " + groups(computed));
  }

  template <typename T>
  void compare_rounded(const std::string& name, const soccer::SenseBody& recorded,
                       const soccer::SenseBody& exact, Slot slot, T soccer::SenseBody::*field) {
    const auto same = [&](const soccer::SenseBody& computed) {
      return text(computed.*field) == text(recorded.*field);
    };
    bool border = false;
    for (std::size_t i = 1; !same(exact) && !border && i < kMaxWorlds; ++i) {
      border = same(sense_body(world(i), slot));
    }
    tally_.add(name, same(exact), border, where_);
  }

  VisionModel vision_{soccer::ServerParams{}};
  RandomStream random_{1, "jitter"};
  std::vector<World> worlds_;
  std::string where_;
  Tally tally_;
};

/// The k-th sense_body and see at a time belong to the k-th frame of that time.
Tally compare_player(const std::vector<World>& worlds, Slot slot, std::string_view transcript) {
  std::map<std::pair<int, int>, const World*> by_clock;
  for (const World& world : worlds) by_clock[{world.clock.time, world.clock.stoppage}] = &world;
  Comparison comparison;
  std::map<int, int> bodies;
  for (const tests::Spoken& spoken : tests::read_transcript(transcript)) {
    const auto kind = soccer::message_kind(spoken.message);
    const bool is_body = kind == soccer::MessageKind::kSenseBody;
    if (!spoken.by_server || (!is_body && kind != soccer::MessageKind::kSee)) continue;
    int time = 0;
    base::parse_int_prefix(spoken.message.substr(spoken.message.find(' ') + 1), time);
    if (is_body) ++bodies[time];
    const auto found = by_clock.find({time, bodies[time] - 1});
    if (found != by_clock.end()) comparison.compare(*found->second, slot, spoken.message);
  }

  return comparison.tally();
}

void expect_nothing_wrong(const Tally& tally, int least) {
  for (const auto& [what, count] : tally.wrong) ADD_FAILURE() << count << " x wrong " << what;
  EXPECT_TRUE(tally.wrong.empty()) << "first: " << tally.first_wrong;
  EXPECT_GE(tally.equal, least);
  EXPECT_LE(tally.border, tally.equal / 50);
  testing::Test::RecordProperty("equal", tally.equal);
  testing::Test::RecordProperty("border", tally.border);
}

TEST(RecordedSenses, MatchRecordedExcerpt) {
  const std::string log = tests::read_file(tests::fixture("simulator/senses.rcg.gz"));
  const std::string transcript = tests::read_file(tests::fixture("simulator/senses-l10.txt.gz"));
  expect_nothing_wrong(compare_player(recorded_worlds(unlimited_vision_rules(), log),
                                      soccer::slot_of(Side::kLeft, 10), transcript),
                       2900);
}

TEST(RecordedSenses, MatchRecordedMatch) {
  const auto log = tests::data("aligned/game.rcg.gz");
  if (!log) GTEST_SKIP() << "no data: set CLS_DATA";
  const auto worlds = recorded_worlds(unlimited_vision_rules(), tests::read_file(*log));
  for (const auto& [name, unum] :
       {std::pair{"player_l1_goalie", 1}, {"player_l4", 4}, {"player_l7", 7}, {"player_l10", 10}}) {
    SCOPED_TRACE(name);
    const auto path = tests::data("aligned/udp/" + std::string(name) + ".txt.gz");
    ASSERT_TRUE(path);
    expect_nothing_wrong(
        compare_player(worlds, soccer::slot_of(Side::kLeft, unum), tests::read_file(*path)), 50000);
  }
}

}  // namespace
}  // namespace cls::simulator
