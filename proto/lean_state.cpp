// Dropping entries from the bytes of a State, and adding them to a parsed one.
#include "proto/lean_state.h"

#include <google/protobuf/io/coded_stream.h>
#include <google/protobuf/wire_format_lite.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "proto/sorted_maps.h"

namespace cls::proto {
namespace {

using google::protobuf::io::CodedInputStream;
using google::protobuf::io::CodedOutputStream;
using WireFormat = google::protobuf::internal::WireFormatLite;
using PlayerList = google::protobuf::RepeatedPtrField<protos::Player>;
using PlayerMap = google::protobuf::Map<google::protobuf::int32, protos::Player>;

constexpr int kMaxNumber = 11;  // uniform numbers

/// One field of a message: where its bytes are.
struct Field {
  int number = 0;
  std::string_view whole;    ///< with tag and length
  std::string_view content;  ///< of a message or string
  std::uint64_t integer = 0;
};

/// The fields of a serialized message, one by one.
class Fields {
 public:
  explicit Fields(std::string_view bytes)
      : bytes_(bytes),
        in_(reinterpret_cast<const std::uint8_t*>(bytes.data()), static_cast<int>(bytes.size())) {}

  bool next(Field& field) {
    const auto begin = position();
    const std::uint32_t tag = in_.ReadTag();
    if (tag == 0) return false;
    field.number = WireFormat::GetTagFieldNumber(tag);
    field.content = {};
    if (WireFormat::GetTagWireType(tag) == WireFormat::WIRETYPE_LENGTH_DELIMITED) {
      std::uint32_t size = 0;
      if (!in_.ReadVarint32(&size)) return false;
      field.content = bytes_.substr(position(), size);
      if (!in_.Skip(static_cast<int>(size))) return false;
    } else if (WireFormat::GetTagWireType(tag) == WireFormat::WIRETYPE_VARINT) {
      if (!in_.ReadVarint64(&field.integer)) return false;
    } else if (!WireFormat::SkipField(&in_, tag)) {
      return false;
    }
    field.whole = bytes_.substr(begin, position() - begin);
    return true;
  }

 private:
  std::size_t position() const { return static_cast<std::size_t>(in_.CurrentPosition()); }

  std::string_view bytes_;
  CodedInputStream in_;
};

/// The serialized players of a list by number; the first of each.
class ListedPlayers {
 public:
  void add(const protos::Player& player, std::string_view bytes) {
    const int number = player.uniform_number();
    if (number < 1 || number > kMaxNumber) return;
    std::string_view& first = players_[static_cast<std::size_t>(number)];
    if (first.data() == nullptr) first = bytes;
  }

  /// Whether an entry of the dictionary says nothing new.
  bool contain(std::string_view entry) const {
    Fields fields(entry);
    Field field;
    std::uint64_t key = 0;
    std::string_view player;
    while (fields.next(field)) {
      if (field.number == 1) key = field.integer;
      if (field.number == 2) player = field.content;
    }
    return key >= 1 && key <= kMaxNumber && players_[key].data() != nullptr &&
           players_[key] == player;
  }

 private:
  std::array<std::string_view, kMaxNumber + 1> players_{};
};

// The fields of the world model that remain, appended to `bytes`.
void write_lean_world(const protos::WorldModel& world, std::string_view whole, std::string& bytes) {
  ListedPlayers ours;
  ListedPlayers theirs;
  int teammates = 0;
  int opponents = 0;
  Fields fields(whole);
  Field field;
  while (fields.next(field)) {  // the lists come before the dictionaries
    if (field.number == protos::WorldModel::kTeammatesFieldNumber) {
      ours.add(world.teammates(teammates++), field.content);
    } else if (field.number == protos::WorldModel::kOpponentsFieldNumber) {
      theirs.add(world.opponents(opponents++), field.content);
    } else if ((field.number == protos::WorldModel::kOurPlayersDictFieldNumber &&
                ours.contain(field.content)) ||
               (field.number == protos::WorldModel::kTheirPlayersDictFieldNumber &&
                theirs.contain(field.content))) {
      continue;
    }
    bytes.append(field.whole);
  }
}

void append_varint(std::size_t value, std::string& bytes) {
  std::array<std::uint8_t, 10> varint{};
  const auto* end = CodedOutputStream::WriteVarint64ToArray(value, varint.data());
  bytes.append(reinterpret_cast<const char*>(varint.data()),
               static_cast<std::size_t>(end - varint.data()));
}

void add_missing(const PlayerList& players, PlayerMap& dictionary) {
  for (const protos::Player& player : players) {
    if (player.uniform_number() < 1 || dictionary.contains(player.uniform_number())) continue;
    dictionary[player.uniform_number()] = player;
  }
}

}  // namespace

void write_lean(const protos::State& state, std::string& whole, std::string& bytes) {
  write_with_sorted_maps(state, whole);
  bytes.clear();
  Fields fields(whole);
  Field field;
  while (fields.next(field)) {
    if (field.number != protos::State::kWorldModelFieldNumber) {
      bytes.append(field.whole);
      continue;
    }
    // Tag, new length, and what remains, whose length is known last.
    const std::size_t begin = bytes.size();
    write_lean_world(state.world_model(), field.content, bytes);
    std::string head(1, field.whole.front());
    append_varint(bytes.size() - begin, head);
    bytes.insert(begin, head);
  }
}

void complete(protos::State& state) {
  if (!state.has_world_model()) return;
  protos::WorldModel& world = *state.mutable_world_model();
  add_missing(world.teammates(), *world.mutable_our_players_dict());
  add_missing(world.opponents(), *world.mutable_their_players_dict());
}

}  // namespace cls::proto
