// Writing and reading by reflection.
#include "proxy/playmaker/thrift_wire.h"

#include <google/protobuf/descriptor.h>

#include <algorithm>
#include <array>
#include <bit>
#include <initializer_list>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/index.h"
#include "proto/field_access.h"

namespace cls::proxy {
namespace {

using google::protobuf::FieldDescriptor;
using google::protobuf::Message;
using google::protobuf::Reflection;

enum Type : std::uint8_t {
  kStop = 0,
  kBool = 2,
  kByte = 3,
  kDouble = 4,
  kI16 = 6,
  kI32 = 8,
  kI64 = 10,
  kString = 11,
  kStruct = 12,
  kMap = 13,
  kSet = 14,
  kList = 15,
};

constexpr std::uint32_t kVersion = 0x80010000;
constexpr std::uint32_t kVersionMask = 0xffff0000;
constexpr std::uint32_t kCall = 1;
constexpr std::uint32_t kReply = 2;
constexpr std::uint32_t kException = 3;
constexpr int kMaxDepth = 64;

// By FieldDescriptor::CppType: int32, int64, uint32, uint64, double, float, bool, enum, string and
// message, from 1.
constexpr std::array<Type, FieldDescriptor::MAX_CPPTYPE + 1> kValueTypes = {
    kStop, kI32, kI64, kI32, kI64, kDouble, kDouble, kBool, kI32, kString, kStruct};

// Of one value; of a repeated field the type of its elements.
Type value_type(const FieldDescriptor& field) { return kValueTypes[base::index(field.cpp_type())]; }

Type field_type(const FieldDescriptor& field) {
  if (field.is_map()) return kMap;
  return field.is_repeated() ? kList : value_type(field);
}

class Writer {
 public:
  explicit Writer(std::string& out) : out_(out) {}

  void byte(std::uint8_t value) { out_ += static_cast<char>(value); }
  template <typename Unsigned>
  void number(Unsigned value) {
    for (int shift = static_cast<int>(sizeof value) * 8 - 8; shift >= 0; shift -= 8) {
      byte(static_cast<std::uint8_t>(value >> shift));
    }
  }
  template <typename Value>
  void scalar(const Value& value);
  void field(Type type, int id) {
    byte(type);
    number(static_cast<std::uint16_t>(id));
  }
  void structure(const Message& message);

 private:
  void value(const Message& message, const FieldDescriptor& field, int index = 0);
  void list(const Message& message, const FieldDescriptor& field);
  void map(const Message& message, const FieldDescriptor& field);

  std::string& out_;
};

template <typename Value>
void Writer::scalar(const Value& value) {
  if constexpr (std::is_same_v<Value, bool>) {
    byte(value);
  } else if constexpr (std::is_integral_v<Value>) {
    number(static_cast<std::make_unsigned_t<Value>>(value));
  } else if constexpr (std::is_floating_point_v<Value>) {
    number(std::bit_cast<std::uint64_t>(static_cast<double>(value)));
  } else {
    number(static_cast<std::uint32_t>(value.size()));
    out_ += value;
  }
}

// `index`: of the element, in a repeated field.
void Writer::value(const Message& message, const FieldDescriptor& field, int index) {
  if (value_type(field) == kStruct) {
    const Reflection& of = *message.GetReflection();
    return structure(field.is_repeated() ? of.GetRepeatedMessage(message, &field, index)
                                         : of.GetMessage(message, &field));
  }
  proto::with_access(field, [&](auto access) { scalar(access.get(message, field, index)); });
}

void Writer::list(const Message& message, const FieldDescriptor& field) {
  const int size = message.GetReflection()->FieldSize(message, &field);
  byte(value_type(field));
  scalar(size);
  for (int i = 0; i < size; ++i) value(message, field, i);
}

// By key: protobuf has no order, and a Playmaker may take the first of equal ones.
void Writer::map(const Message& message, const FieldDescriptor& field) {
  const Reflection& of = *message.GetReflection();
  const FieldDescriptor& key = *field.message_type()->map_key();
  const FieldDescriptor& mapped = *field.message_type()->map_value();

  std::vector<const Message*> entries;
  for (int i = 0; i < of.FieldSize(message, &field); ++i) {
    entries.push_back(&of.GetRepeatedMessage(message, &field, i));
  }
  std::ranges::sort(entries, {}, [&key](const Message* entry) {
    return entry->GetReflection()->GetInt32(*entry, &key);
  });

  byte(value_type(key));
  byte(value_type(mapped));
  number(static_cast<std::uint32_t>(entries.size()));
  for (const Message* entry : entries) {
    value(*entry, key);
    value(*entry, mapped);
  }
}

void Writer::structure(const Message& message) {
  const auto* type = message.GetDescriptor();
  for (int i = 0; i < type->field_count(); ++i) {
    const FieldDescriptor& one = *type->field(i);
    if (one.containing_oneof() != nullptr && !message.GetReflection()->HasField(message, &one)) {
      continue;
    }
    field(field_type(one), one.number());
    if (one.is_map()) {
      map(message, one);
    } else if (one.is_repeated()) {
      list(message, one);
    } else {
      value(message, one);
    }
  }

  byte(kStop);
}

// Every function returns false when it fails; then `missing` says whether more bytes may help.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : rest_(bytes) {}

  std::string_view rest() const { return rest_; }
  bool missing() const { return missing_; }

  bool bytes(std::size_t size, std::string_view& out) {
    if (rest_.size() < size) {
      missing_ = true;
      return false;
    }
    out = rest_.substr(0, size);
    rest_.remove_prefix(size);
    return true;
  }
  template <typename Unsigned>
  bool number(Unsigned& out) {
    std::string_view raw;
    if (!bytes(sizeof out, raw)) return false;
    out = 0;
    for (const char c : raw) {
      out = static_cast<Unsigned>((static_cast<std::uint64_t>(out) << 8) |
                                  static_cast<unsigned char>(c));
    }
    return true;
  }
  bool text(std::string_view& out) {
    std::uint32_t size = 0;
    return number(size) && size <= kMaxText && bytes(size, out);
  }
  template <typename Value>
  bool scalar(Value& out);

  // Reads a struct; `use` reads the value of a field of this type and number.
  template <typename Use>
  bool fields(Use use) {
    std::uint8_t type = 0;
    std::uint16_t id = 0;
    while (number(type)) {
      if (type == kStop) return true;
      if (!number(id) || !use(type, id)) return false;
    }
    return false;
  }
  bool skip(std::uint8_t type, int depth);
  bool structure(Message& message, int depth);

 private:
  static constexpr std::uint32_t kMaxText = 1U << 24;

  bool skip_elements(std::uint32_t count, std::initializer_list<std::uint8_t> types, int depth);
  bool value(Message& message, const FieldDescriptor& field, int depth);
  bool list(Message& message, const FieldDescriptor& field, int depth);
  bool map(Message& message, const FieldDescriptor& field, int depth);
  bool field_value(Message& message, const FieldDescriptor& field, int depth);

  std::string_view rest_;
  bool missing_ = false;
};

template <typename Value>
bool Reader::scalar(Value& out) {
  if constexpr (std::is_same_v<Value, std::string>) {
    std::string_view read;
    if (!text(read)) return false;
    out = read;
  } else if constexpr (std::is_floating_point_v<Value>) {
    std::uint64_t bits = 0;
    if (!number(bits)) return false;
    out = static_cast<Value>(std::bit_cast<double>(bits));
  } else if constexpr (std::is_same_v<Value, bool>) {
    std::uint8_t read = 0;
    if (!number(read)) return false;
    out = read != 0;
  } else {
    std::make_unsigned_t<Value> read = 0;
    if (!number(read)) return false;
    out = static_cast<Value>(read);
  }

  return true;
}

// Elements of these types, one after the other.
bool Reader::skip_elements(std::uint32_t count, std::initializer_list<std::uint8_t> types,
                           int depth) {
  for (std::uint32_t i = 0; i < count; ++i) {
    for (const std::uint8_t type : types) {
      if (!skip(type, depth)) return false;
    }
  }
  return true;
}

bool Reader::skip(std::uint8_t type, int depth) {
  if (depth > kMaxDepth) return false;
  std::string_view ignored;
  std::uint8_t first = 0;
  std::uint8_t second = 0;
  std::uint32_t count = 0;

  switch (type) {
    case kBool:
    case kByte:
      return bytes(1, ignored);
    case kI16:
      return bytes(2, ignored);
    case kI32:
      return bytes(4, ignored);
    case kI64:
    case kDouble:
      return bytes(8, ignored);
    case kString:
      return text(ignored);
    case kStruct:
      return fields([&](std::uint8_t field, int /*id*/) { return skip(field, depth + 1); });
    case kList:
    case kSet:
      return number(first) && number(count) && skip_elements(count, {first}, depth + 1);
    case kMap:
      return number(first) && number(second) && number(count) &&
             skip_elements(count, {first, second}, depth + 1);
    default:
      return false;
  }
}

// Sets the field, or adds an element to a repeated one.
bool Reader::value(Message& message, const FieldDescriptor& field, int depth) {
  if (value_type(field) == kStruct) {
    const Reflection& of = *message.GetReflection();
    return structure(field.is_repeated() ? *of.AddMessage(&message, &field)
                                         : *of.MutableMessage(&message, &field),
                     depth + 1);
  }

  return proto::with_access(field, [&](auto access) {
    typename decltype(access)::Value read{};
    if (!scalar(read)) return false;
    access.put(message, field, std::move(read));
    return true;
  });
}

bool Reader::list(Message& message, const FieldDescriptor& field, int depth) {
  std::uint8_t type = 0;
  std::uint32_t count = 0;
  if (!number(type) || !number(count)) return false;
  if (type != value_type(field)) return skip_elements(count, {type}, depth + 1);
  for (std::uint32_t i = 0; i < count; ++i) {
    if (!value(message, field, depth)) return false;
  }
  return true;
}

bool Reader::map(Message& message, const FieldDescriptor& field, int depth) {
  std::uint8_t key = 0;
  std::uint8_t mapped = 0;
  std::uint32_t count = 0;
  if (!number(key) || !number(mapped) || !number(count)) return false;

  const FieldDescriptor& key_field = *field.message_type()->map_key();
  const FieldDescriptor& mapped_field = *field.message_type()->map_value();
  const bool known = key == value_type(key_field) && mapped == value_type(mapped_field);
  if (!known) return skip_elements(count, {key, mapped}, depth + 1);

  for (std::uint32_t i = 0; i < count; ++i) {
    Message& entry = *message.GetReflection()->AddMessage(&message, &field);
    if (!value(entry, key_field, depth) || !value(entry, mapped_field, depth)) return false;
  }
  return true;
}

bool Reader::field_value(Message& message, const FieldDescriptor& field, int depth) {
  if (field.is_map()) return map(message, field, depth);
  return field.is_repeated() ? list(message, field, depth) : value(message, field, depth);
}

bool Reader::structure(Message& message, int depth) {
  if (depth > kMaxDepth) return false;
  return fields([&](std::uint8_t type, int id) {
    const FieldDescriptor* known = message.GetDescriptor()->FindFieldByNumber(id);
    const bool fits = known != nullptr && field_type(*known) == type;
    return fits ? field_value(message, *known, depth) : skip(type, depth + 1);
  });
}

// The header of a message, in the strict form or in that of old writers.
bool read_header(Reader& in, std::uint32_t& kind, std::int32_t& sequence, bool& valid) {
  std::uint32_t first = 0;
  std::string_view method;
  valid = true;
  if (!in.number(first)) return false;

  if ((first & kVersionMask) == kVersion) {
    kind = first & 0xff;
    if (!in.text(method)) return false;
  } else {
    constexpr std::uint32_t kMaxName = 256;
    valid = first <= kMaxName;
    std::uint8_t type = 0;
    if (!valid || !in.bytes(first, method) || !in.number(type)) return false;
    kind = type;
  }
  return in.scalar(sequence);
}

// Thrift's TApplicationException: text and type.
bool read_exception(Reader& in, ThriftReply& reply) {
  return in.fields([&](std::uint8_t type, int id) {
    if (id == 1 && type == kString) return in.scalar(reply.error);
    if (id == 2 && type == kI32) return in.scalar(reply.exception_type);
    return in.skip(type, 0);
  });
}

// The struct of a result: field 0 is what the method returned.
bool read_result(Reader& in, Message& message) {
  return in.fields([&](std::uint8_t type, int id) {
    return id == 0 && type == kStruct ? in.structure(message, 0) : in.skip(type, 0);
  });
}

}  // namespace

void append_thrift_call(std::string_view method, std::int32_t sequence, const Message& request,
                        std::string& out) {
  Writer writer(out);
  writer.number(kVersion | kCall);
  writer.scalar(method);
  writer.scalar(sequence);
  writer.field(kStruct, 1);
  writer.structure(request);
  writer.byte(kStop);
}

ThriftReply read_thrift_reply(std::string_view bytes, Message& message) {
  ThriftReply reply;
  Reader in(bytes);
  std::uint32_t kind = 0;
  bool valid = true;
  bool complete = read_header(in, kind, reply.sequence, valid);

  const bool is_reply = complete && (kind == kReply || kind == kException);
  if (is_reply) {
    message.Clear();
    complete = kind == kException ? read_exception(in, reply) : read_result(in, message);
  }
  if (!complete && in.missing() && valid) return reply;

  if (!complete || !is_reply) {
    reply.kind = ThriftReply::Kind::kInvalid;
    reply.error = "not a reply in Thrift's binary protocol";
    return reply;
  }
  reply.kind = kind == kException ? ThriftReply::Kind::kException : ThriftReply::Kind::kReply;
  reply.size = bytes.size() - in.rest().size();
  return reply;
}

}  // namespace cls::proxy
