// Values by type of field, and damage of serialized messages.
#include "tests/proxy/playmaker/random_message.h"

#include <google/protobuf/descriptor.h>

#include <array>
#include <limits>
#include <type_traits>

#include "proto/field_access.h"

namespace cls::tests {
namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;

constexpr int kMaxDepth = 4;

// A field that holds itself, `depth` times: lengths of up to 127 bytes per level would not nest
// far, so these are the start tags of an unknown group.
std::string nested_groups(std::size_t depth) { return std::string(depth, '\x7b'); }

}  // namespace

std::size_t RandomMessages::below(std::size_t end) {
  state_ = state_ * 6364136223846793005ULL + 1442695040888963407ULL;
  return static_cast<std::size_t>((state_ >> 33) % end);
}

double RandomMessages::number() {
  using Limits = std::numeric_limits<double>;
  using Floats = std::numeric_limits<float>;
  constexpr std::array kExtremes = {Limits::quiet_NaN(),
                                    Limits::infinity(),
                                    -Limits::infinity(),
                                    static_cast<double>(Floats::max()),
                                    static_cast<double>(Floats::lowest()),
                                    static_cast<double>(Floats::denorm_min()),
                                    0.0,
                                    -0.0,
                                    1e9,
                                    -1e9,
                                    180.0,
                                    -180.0,
                                    360.0};

  if (one_in(4)) return kExtremes[below(kExtremes.size())];
  constexpr std::array kScales = {1.0, 10.0, 60.0, 200.0, 1e6};
  const double unit = static_cast<double>(below(1 << 20)) / (1 << 19) - 1.0;
  return unit * kScales[below(kScales.size())];
}

std::int64_t RandomMessages::integer() {
  constexpr std::array<std::int64_t, 8> kExtremes = {0,
                                                     -1,
                                                     12,
                                                     13,
                                                     std::numeric_limits<std::int32_t>::max(),
                                                     std::numeric_limits<std::int32_t>::min(),
                                                     std::numeric_limits<std::int64_t>::max(),
                                                     std::numeric_limits<std::int64_t>::min()};
  if (one_in(4)) return kExtremes[below(kExtremes.size())];
  return static_cast<std::int64_t>(below(24)) - 1;
}

std::string RandomMessages::text() {
  constexpr std::array<std::string_view, 9> kTexts = {
      "", "a", "(say)", "\"", "\x1b[2J", "\xff\xfe", "\xc2\x9b", "4-3-3", "x y\nz"};
  if (one_in(200)) return std::string(100'000, 'x');
  return std::string(kTexts[below(kTexts.size())]);
}

// Sets a field, or adds an element. Maps are repeated entries.
void RandomMessages::put(Message& message, const FieldDescriptor& field, int depth) {
  if (field.message_type() != nullptr) {
    const google::protobuf::Reflection& to = *message.GetReflection();
    return fill(field.is_repeated() ? *to.AddMessage(&message, &field)
                                    : *to.MutableMessage(&message, &field),
                depth + 1);
  }

  proto::with_access(field, [&](auto access) {
    using Value = typename decltype(access)::Value;
    if constexpr (std::is_same_v<Value, std::string>) {
      access.put(message, field, text());
    } else if constexpr (std::is_same_v<Value, bool>) {
      access.put(message, field, one_in(2));
    } else if constexpr (std::is_floating_point_v<Value>) {
      access.put(message, field, static_cast<Value>(number()));
    } else {
      access.put(message, field, static_cast<Value>(integer()));
    }
  });
}

void RandomMessages::fill(Message& message, int depth) {
  const google::protobuf::Descriptor& type = *message.GetDescriptor();
  for (int i = 0; i < type.oneof_decl_count(); ++i) {
    const google::protobuf::OneofDescriptor& choice = *type.oneof_decl(i);
    if (one_in(20)) continue;
    const auto member = static_cast<int>(below(static_cast<std::size_t>(choice.field_count())));
    put(message, *choice.field(member), depth);
  }

  for (int i = 0; i < type.field_count(); ++i) {
    const FieldDescriptor& field = *type.field(i);
    if (field.real_containing_oneof() != nullptr) continue;
    if (field.is_repeated()) {
      const std::size_t count = depth > kMaxDepth ? 0 : below(4);
      for (std::size_t k = 0; k < count; ++k) put(message, field, depth);
    } else if (!one_in(4) && depth <= kMaxDepth) {
      put(message, field, depth);
    }
  }
}

std::string RandomMessages::damaged(std::string bytes) {
  switch (below(6)) {
    case 0:
      return bytes.substr(0, below(bytes.size() + 1));
    case 1:
      for (std::size_t i = below(8) + 1; i > 0 && !bytes.empty(); --i) {
        bytes[below(bytes.size())] = static_cast<char>(below(256));
      }
      return bytes;
    case 2:
      return bytes + nested_groups(below(20'000));

    case 3: {
      std::string noise;
      for (std::size_t i = below(64); i > 0; --i) noise += static_cast<char>(below(256));
      return noise;
    }
    case 4: {
      const std::size_t limit = one_in(20) ? 2'000'000 : 200'000;
      std::string repeated;
      for (int i = 0; i < 100'000 && repeated.size() < limit; ++i) repeated += bytes;
      return repeated;
    }

    default:
      return bytes + std::string("\x82\x80\x01\x05later", 9);  // a field of a later interface
  }
}

std::string RandomMessages::reply(const Message& prototype) {
  const std::unique_ptr<Message> message(prototype.New());
  fill(*message);
  std::string bytes = message->SerializePartialAsString();
  return one_in(5) ? damaged(std::move(bytes)) : bytes;
}

}  // namespace cls::tests
