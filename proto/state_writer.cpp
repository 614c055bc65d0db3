// The wire format of State, WorldModel and the messages they have many of. Self, Ball and the
// others, of which a State has one, are left to the generated code.
#include "proto/state_writer.h"

#include <google/protobuf/io/coded_stream.h>
#include <google/protobuf/wire_format_lite.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cstring>
#include <limits>
#include <string>
#include <type_traits>

namespace cls::proto {
namespace {

using google::protobuf::MessageLite;
using google::protobuf::io::CodedOutputStream;
using WireFormat = google::protobuf::internal::WireFormatLite;
using protos::InterceptInfo;
using protos::InterceptTable;
using protos::Player;
using protos::RpcVector2D;
using protos::State;
using protos::WorldModel;
using PlayerList = google::protobuf::RepeatedPtrField<Player>;
using PlayerMap = google::protobuf::Map<google::protobuf::int32, Player>;

// The most bytes of a message with its own tag and length; without bound for a world model, whose
// players are counted one by one.
constexpr std::size_t kMaxVector = 24;
constexpr std::size_t kMaxPlayer = 512;
constexpr std::size_t kMaxPlan = 128;
constexpr std::size_t kMaxEntryHead = 24;  // of a dictionary: what surrounds the value
constexpr std::size_t kMaxNumbers = 1024;  // of a world model, its intercept table and the State
constexpr std::size_t kUnbounded = std::numeric_limits<std::size_t>::max();

/// The place of the next byte. A value of this type stays in a register: pass copies.
class Wire {
 public:
  explicit Wire(std::uint8_t* at) : at_(at) {}

  /// The bytes written since `start`.
  std::size_t size_from(Wire start) const { return static_cast<std::size_t>(at_ - start.at_); }

  // Fields with the value 0 are left out, as the wire format has it.
  template <int field>
  void number(float value) {
    fixed<field, WireFormat::WIRETYPE_FIXED32>(value);
  }
  template <int field>
  void number(double value) {
    fixed<field, WireFormat::WIRETYPE_FIXED64>(value);
  }
  template <int field>
  void number(std::int32_t value) {
    if (value == 0) return;
    tag<field, WireFormat::WIRETYPE_VARINT>();
    varint(static_cast<std::uint64_t>(std::int64_t{value}));
  }
  template <int field>
  void flag(bool value) {
    number<field>(std::int32_t{value});
  }

  template <int field>
  void text(const std::string& value) {
    if (value.empty()) return;
    tag<field, WireFormat::WIRETYPE_LENGTH_DELIMITED>();
    varint(value.size());
    std::memcpy(at_, value.data(), value.size());
    at_ += value.size();
  }

  template <int field>
  void vector(const RpcVector2D& value) {
    const Wire start = *this;
    tag<field, WireFormat::WIRETYPE_LENGTH_DELIMITED>();
    std::uint8_t* const length = at_++;
    number<RpcVector2D::kXFieldNumber>(value.x());
    number<RpcVector2D::kYFieldNumber>(value.y());
    number<RpcVector2D::kDistFieldNumber>(value.dist());
    number<RpcVector2D::kAngleFieldNumber>(value.angle());
    *length = static_cast<std::uint8_t>(at_ - length - 1);
    assert(size_from(start) <= kMaxVector);
  }
  /// Left out where the message that it is a part of has none.
  template <int field>
  void vector(bool is_there, const RpcVector2D& value) {
    if (is_there) vector<field>(value);
  }

  /// By the generated code, after value.ByteSizeLong().
  template <int field>
  void message(const MessageLite& value) {
    tag<field, WireFormat::WIRETYPE_LENGTH_DELIMITED>();
    varint(static_cast<std::size_t>(value.GetCachedSize()));
    at_ = value.SerializeWithCachedSizesToArray(at_);
  }

  /// A message that `write_content`, a function from Wire to Wire, writes, of at most `most` bytes.
  /// Its length comes first and is known last: most have one of `length_size` bytes. Returns the
  /// content.
  template <int field, std::size_t most, std::size_t length_size = 2, typename WriteContent>
  std::string_view nested(WriteContent write_content) {
    const Wire start = *this;
    tag<field, WireFormat::WIRETYPE_LENGTH_DELIMITED>();
    const Wire expected(at_ + length_size);
    const std::size_t size = write_content(expected).size_from(expected);

    std::uint8_t* const content = at_ + CodedOutputStream::VarintSize64(size);
    if (content != expected.at_) std::memmove(content, expected.at_, size);
    varint(size);
    at_ = content + size;
    assert(size_from(start) <= most);
    return {reinterpret_cast<const char*>(content), size};
  }

  /// The key of an entry of a dictionary, which is written even if it is 0.
  void key(std::int32_t value) {
    tag<1, WireFormat::WIRETYPE_VARINT>();
    varint(static_cast<std::uint64_t>(std::int64_t{value}));
  }

 private:
  template <int field, WireFormat::WireType type>
  void tag() {
    constexpr std::uint32_t kTag = WireFormat::MakeTag(field, type);
    static_assert(kTag < 1U << 14);
    if constexpr (kTag < 0x80) {
      *at_++ = static_cast<std::uint8_t>(kTag);
    } else {
      *at_++ = static_cast<std::uint8_t>(kTag | 0x80);
      *at_++ = static_cast<std::uint8_t>(kTag >> 7);
    }
  }

  void varint(std::uint64_t value) {
    while (value >= 0x80) {
      *at_++ = static_cast<std::uint8_t>(value | 0x80);
      value >>= 7;
    }
    *at_++ = static_cast<std::uint8_t>(value);
  }

  template <int field, WireFormat::WireType type, typename Number>
  void fixed(Number value) {
    using Bits = std::conditional_t<sizeof(Number) == 4, std::uint32_t, std::uint64_t>;
    if (std::bit_cast<Bits>(value) == 0) return;  // -0 is written
    tag<field, type>();
    std::memcpy(at_, &value, sizeof value);  // little-endian, as the wire
    at_ += sizeof value;
  }

  std::uint8_t* at_;
};

Wire write_player(const Player& player, Wire out) {
  out.vector<Player::kPositionFieldNumber>(player.has_position(), player.position());
  out.vector<Player::kSeenPositionFieldNumber>(player.has_seen_position(), player.seen_position());
  out.vector<Player::kHeardPositionFieldNumber>(player.has_heard_position(),
                                                player.heard_position());
  out.vector<Player::kVelocityFieldNumber>(player.has_velocity(), player.velocity());
  out.vector<Player::kSeenVelocityFieldNumber>(player.has_seen_velocity(), player.seen_velocity());

  out.number<Player::kPosCountFieldNumber>(player.pos_count());
  out.number<Player::kSeenPosCountFieldNumber>(player.seen_pos_count());
  out.number<Player::kHeardPosCountFieldNumber>(player.heard_pos_count());
  out.number<Player::kVelCountFieldNumber>(player.vel_count());
  out.number<Player::kSeenVelCountFieldNumber>(player.seen_vel_count());
  out.number<Player::kGhostCountFieldNumber>(player.ghost_count());

  out.number<Player::kDistFromSelfFieldNumber>(player.dist_from_self());
  out.number<Player::kAngleFromSelfFieldNumber>(player.angle_from_self());
  out.number<Player::kIdFieldNumber>(player.id());
  out.number<Player::kSideFieldNumber>(player.side());
  out.number<Player::kUniformNumberFieldNumber>(player.uniform_number());
  out.number<Player::kUniformNumberCountFieldNumber>(player.uniform_number_count());
  out.flag<Player::kIsGoalieFieldNumber>(player.is_goalie());

  out.number<Player::kBodyDirectionFieldNumber>(player.body_direction());
  out.number<Player::kBodyDirectionCountFieldNumber>(player.body_direction_count());
  out.number<Player::kFaceDirectionFieldNumber>(player.face_direction());
  out.number<Player::kFaceDirectionCountFieldNumber>(player.face_direction_count());
  out.number<Player::kPointToDirectionFieldNumber>(player.point_to_direction());
  out.number<Player::kPointToDirectionCountFieldNumber>(player.point_to_direction_count());

  out.flag<Player::kIsKickingFieldNumber>(player.is_kicking());
  out.number<Player::kDistFromBallFieldNumber>(player.dist_from_ball());
  out.number<Player::kAngleFromBallFieldNumber>(player.angle_from_ball());
  out.number<Player::kBallReachStepsFieldNumber>(player.ball_reach_steps());
  out.flag<Player::kIsTacklingFieldNumber>(player.is_tackling());
  out.number<Player::kTypeIdFieldNumber>(player.type_id());
  out.vector<Player::kInertiaFinalPointFieldNumber>(player.has_inertia_final_point(),
                                                    player.inertia_final_point());
  out.number<Player::kBodyCountFieldNumber>(player.body_count());
  return out;
}

Wire write_plan(const InterceptInfo& plan, Wire out) {
  out.number<InterceptInfo::kActionTypeFieldNumber>(plan.action_type());
  out.number<InterceptInfo::kTurnStepsFieldNumber>(plan.turn_steps());
  out.number<InterceptInfo::kTurnAngleFieldNumber>(plan.turn_angle());
  out.number<InterceptInfo::kDashStepsFieldNumber>(plan.dash_steps());
  out.number<InterceptInfo::kDashPowerFieldNumber>(plan.dash_power());
  out.number<InterceptInfo::kDashDirFieldNumber>(plan.dash_dir());
  out.vector<InterceptInfo::kFinalSelfPositionFieldNumber>(plan.has_final_self_position(),
                                                           plan.final_self_position());
  out.number<InterceptInfo::kFinalBallDistFieldNumber>(plan.final_ball_dist());
  out.number<InterceptInfo::kFinalStaminaFieldNumber>(plan.final_stamina());
  out.number<InterceptInfo::kValueFieldNumber>(plan.value());
  return out;
}

Wire write_intercept(const InterceptTable& table, Wire out) {
  out.number<InterceptTable::kSelfReachStepsFieldNumber>(table.self_reach_steps());
  out.number<InterceptTable::kFirstTeammateReachStepsFieldNumber>(
      table.first_teammate_reach_steps());
  out.number<InterceptTable::kSecondTeammateReachStepsFieldNumber>(
      table.second_teammate_reach_steps());
  out.number<InterceptTable::kFirstOpponentReachStepsFieldNumber>(
      table.first_opponent_reach_steps());
  out.number<InterceptTable::kSecondOpponentReachStepsFieldNumber>(
      table.second_opponent_reach_steps());

  out.number<InterceptTable::kFirstTeammateIdFieldNumber>(table.first_teammate_id());
  out.number<InterceptTable::kSecondTeammateIdFieldNumber>(table.second_teammate_id());
  out.number<InterceptTable::kFirstOpponentIdFieldNumber>(table.first_opponent_id());
  out.number<InterceptTable::kSecondOpponentIdFieldNumber>(table.second_opponent_id());

  for (const InterceptInfo& plan : table.self_intercept_info()) {
    out.nested<InterceptTable::kSelfInterceptInfoFieldNumber, kMaxPlan, 1>(
        [&](Wire content) { return write_plan(plan, content); });
  }
  return out;
}

/// The written players of a list by uniform number; the first of each.
class WrittenPlayers {
 public:
  void add(const Player& player, std::string_view bytes) {
    if (player.uniform_number() < 1 || player.uniform_number() > kMaxNumber) return;
    std::string_view& first = first_[static_cast<std::size_t>(player.uniform_number())];
    if (first.data() == nullptr) first = bytes;
  }

  /// Whether the entry of a dictionary with this key and player says nothing new.
  bool contain(int key, std::string_view player) const {
    if (key < 1 || key > kMaxNumber) return false;
    const std::string_view first = first_[static_cast<std::size_t>(key)];
    return first.data() != nullptr && first == player;
  }

 private:
  static constexpr int kMaxNumber = 11;  // uniform numbers
  std::array<std::string_view, kMaxNumber + 1> first_{};
};

template <int field>
Wire write_list(const PlayerList& players, WrittenPlayers& written, Wire out) {
  for (const Player& player : players) {
    const std::string_view bytes =
        out.nested<field, kMaxPlayer>([&](Wire content) { return write_player(player, content); });
    written.add(player, bytes);
  }
  return out;
}

/// The entries of a dictionary by key.
template <typename Value>
std::vector<std::pair<int, const Value*>> sorted(
    const google::protobuf::Map<google::protobuf::int32, Value>& dictionary) {
  std::vector<std::pair<int, const Value*>> entries;
  entries.reserve(dictionary.size());
  for (const auto& [key, value] : dictionary) entries.emplace_back(key, &value);
  std::ranges::sort(entries);
  return entries;
}

/// Without the entries that `known` contains, unless it is null.
template <int field>
Wire write_dictionary(const PlayerMap& players, const WrittenPlayers* known, Wire out) {
  for (const auto& entry : sorted(players)) {
    const Wire before = out;
    bool is_known = false;
    out.nested<field, kMaxPlayer + kMaxEntryHead>([&](Wire content) {
      content.key(entry.first);
      const std::string_view player = content.nested<2, kMaxPlayer>(
          [&](Wire value) { return write_player(*entry.second, value); });
      is_known = known != nullptr && known->contain(entry.first, player);
      return content;
    });
    if (is_known) out = before;
  }
  return out;
}

Wire write_players(const WorldModel& world, StateForm form, Wire out) {
  WrittenPlayers ours;
  WrittenPlayers theirs;
  const bool lean = form == StateForm::kLean;

  out = write_list<WorldModel::kTeammatesFieldNumber>(world.teammates(), ours, out);
  out = write_list<WorldModel::kOpponentsFieldNumber>(world.opponents(), theirs, out);
  for (const Player& player : world.unknowns()) {
    out.nested<WorldModel::kUnknownsFieldNumber, kMaxPlayer>(
        [&](Wire content) { return write_player(player, content); });
  }

  out = write_dictionary<WorldModel::kOurPlayersDictFieldNumber>(world.our_players_dict(),
                                                                 lean ? &ours : nullptr, out);
  return write_dictionary<WorldModel::kTheirPlayersDictFieldNumber>(world.their_players_dict(),
                                                                    lean ? &theirs : nullptr, out);
}

Wire write_home(const WorldModel& world, Wire out) {
  for (const auto& entry : sorted(world.helios_home_positions())) {
    out.nested<WorldModel::kHeliosHomePositionsFieldNumber, kMaxVector + kMaxEntryHead, 1>(
        [&](Wire content) {
          content.key(entry.first);
          content.vector<2>(*entry.second);
          return content;
        });
  }
  return out;
}

Wire write_match(const WorldModel& world, Wire out) {
  out.number<WorldModel::kOurGoalieUniformNumberFieldNumber>(world.our_goalie_uniform_number());
  out.number<WorldModel::kTheirGoalieUniformNumberFieldNumber>(world.their_goalie_uniform_number());
  out.number<WorldModel::kOffsideLineXFieldNumber>(world.offside_line_x());
  out.number<WorldModel::kOfsideLineXCountFieldNumber>(world.ofside_line_x_count());
  out.number<WorldModel::kKickableTeammateIdFieldNumber>(world.kickable_teammate_id());
  out.number<WorldModel::kKickableOpponentIdFieldNumber>(world.kickable_opponent_id());
  out.number<WorldModel::kLastKickSideFieldNumber>(world.last_kick_side());
  out.number<WorldModel::kLastKickerUniformNumberFieldNumber>(world.last_kicker_uniform_number());

  out.number<WorldModel::kCycleFieldNumber>(world.cycle());
  out.number<WorldModel::kGameModeTypeFieldNumber>(world.game_mode_type());
  out.number<WorldModel::kLeftTeamScoreFieldNumber>(world.left_team_score());
  out.number<WorldModel::kRightTeamScoreFieldNumber>(world.right_team_score());

  out.flag<WorldModel::kIsOurSetPlayFieldNumber>(world.is_our_set_play());
  out.flag<WorldModel::kIsTheirSetPlayFieldNumber>(world.is_their_set_play());
  out.number<WorldModel::kStopedCycleFieldNumber>(world.stoped_cycle());
  out.number<WorldModel::kOurTeamScoreFieldNumber>(world.our_team_score());
  out.number<WorldModel::kTheirTeamScoreFieldNumber>(world.their_team_score());
  out.flag<WorldModel::kIsPenaltyKickModeFieldNumber>(world.is_penalty_kick_mode());
  return out;
}

Wire write_lines_and_times(const WorldModel& world, Wire out) {
  out.number<WorldModel::kOurDefenseLineXFieldNumber>(world.our_defense_line_x());
  out.number<WorldModel::kTheirDefenseLineXFieldNumber>(world.their_defense_line_x());
  out.number<WorldModel::kOurDefensePlayerLineXFieldNumber>(world.our_defense_player_line_x());
  out.number<WorldModel::kTheirDefensePlayerLineXFieldNumber>(world.their_defense_player_line_x());
  out.flag<WorldModel::kKickableTeammateExistanceFieldNumber>(world.kickable_teammate_existance());
  out.flag<WorldModel::kKickableOpponentExistanceFieldNumber>(world.kickable_opponent_existance());

  if (world.has_penalty_kick_state()) {
    out.message<WorldModel::kPenaltyKickStateFieldNumber>(world.penalty_kick_state());
  }
  out.number<WorldModel::kSeeTimeFieldNumber>(world.see_time());
  out.number<WorldModel::kTimeStoppedFieldNumber>(world.time_stopped());
  out.number<WorldModel::kSetPlayCountFieldNumber>(world.set_play_count());
  out.number<WorldModel::kGameModeSideFieldNumber>(world.game_mode_side());
  return out;
}

Wire write_world(const WorldModel& world, StateForm form, Wire out) {
  if (world.has_intercept_table()) {
    out.nested<WorldModel::kInterceptTableFieldNumber, kUnbounded>(
        [&](Wire content) { return write_intercept(world.intercept_table(), content); });
  }

  out.text<WorldModel::kOurTeamNameFieldNumber>(world.our_team_name());
  out.text<WorldModel::kTheirTeamNameFieldNumber>(world.their_team_name());
  out.number<WorldModel::kOurSideFieldNumber>(world.our_side());
  out.number<WorldModel::kLastSetPlayStartTimeFieldNumber>(world.last_set_play_start_time());
  if (world.has_self()) out.message<WorldModel::kSelfFieldNumber>(world.self());
  if (world.has_ball()) out.message<WorldModel::kBallFieldNumber>(world.ball());

  out = write_players(world, form, out);
  out = write_match(world, out);
  out = write_home(world, out);
  return write_lines_and_times(world, out);
}

/// At least the bytes of the message. Asks the generated code for the sizes of what it will write.
std::size_t capacity_for(const WorldModel& world) {
  const auto players = static_cast<std::size_t>(world.teammates_size()) +
                       static_cast<std::size_t>(world.opponents_size()) +
                       static_cast<std::size_t>(world.unknowns_size());
  const std::size_t entries = world.our_players_dict().size() + world.their_players_dict().size();
  const auto plans = static_cast<std::size_t>(world.intercept_table().self_intercept_info_size());

  const std::size_t singles = world.self().ByteSizeLong() + world.ball().ByteSizeLong() +
                              world.penalty_kick_state().ByteSizeLong();
  return kMaxNumbers + singles + world.our_team_name().size() + world.their_team_name().size() +
         players * kMaxPlayer + entries * (kMaxPlayer + kMaxEntryHead) + plans * kMaxPlan +
         world.helios_home_positions().size() * (kMaxVector + kMaxEntryHead);
}

}  // namespace

std::string_view StateWriter::write(const State& state, StateForm form) {
  const std::size_t capacity = capacity_for(state.world_model()) +
                               capacity_for(state.full_world_model()) +
                               state.register_response().ByteSizeLong();
  if (bytes_.size() < capacity) bytes_.resize(capacity);

  const Wire start(bytes_.data());
  Wire out = start;
  if (state.has_register_response()) {
    out.message<State::kRegisterResponseFieldNumber>(state.register_response());
  }
  if (state.has_world_model()) {
    out.nested<State::kWorldModelFieldNumber, kUnbounded>(
        [&](Wire content) { return write_world(state.world_model(), form, content); });
  }
  if (state.has_full_world_model()) {
    out.nested<State::kFullWorldModelFieldNumber, kUnbounded>([&](Wire content) {
      return write_world(state.full_world_model(), StateForm::kWhole, content);
    });
  }
  out.flag<State::kNeedPreprocessFieldNumber>(state.need_preprocess());

  assert(out.size_from(start) <= capacity);
  return {reinterpret_cast<const char*>(bytes_.data()), out.size_from(start)};
}

}  // namespace cls::proto
