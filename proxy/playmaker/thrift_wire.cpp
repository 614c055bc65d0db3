// Writing and reading by reflection.
#include "proxy/playmaker/thrift_wire.h"

#include <google/protobuf/descriptor.h>

#include <algorithm>
#include <bit>
#include <utility>
#include <vector>

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

// Of one value; of a repeated field the type of its elements.
Type value_type(const FieldDescriptor& field) {
  switch (field.cpp_type()) {
    case FieldDescriptor::CPPTYPE_BOOL:
      return kBool;
    case FieldDescriptor::CPPTYPE_FLOAT:
    case FieldDescriptor::CPPTYPE_DOUBLE:
      return kDouble;
    case FieldDescriptor::CPPTYPE_INT64:
    case FieldDescriptor::CPPTYPE_UINT64:
      return kI64;
    case FieldDescriptor::CPPTYPE_STRING:
      return kString;
    case FieldDescriptor::CPPTYPE_MESSAGE:
      return kStruct;
    case FieldDescriptor::CPPTYPE_INT32:
    case FieldDescriptor::CPPTYPE_UINT32:
    case FieldDescriptor::CPPTYPE_ENUM:
      break;
  }
  return kI32;
}

Type field_type(const FieldDescriptor& field) {
  if (field.is_map()) return kMap;
  return field.is_repeated() ? kList : value_type(field);
}

// ---- Writing ----

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
  void i32(std::int32_t value) { number(static_cast<std::uint32_t>(value)); }
  void text(std::string_view value) {
    i32(static_cast<std::int32_t>(value.size()));
    out_ += value;
  }
  void field(Type type, int id) {
    byte(type);
    number(static_cast<std::uint16_t>(id));
  }
  void structure(const Message& message);

 private:
  void value(const Message& message, const FieldDescriptor& field, int index);
  void list(const Message& message, const FieldDescriptor& field);
  void map(const Message& message, const FieldDescriptor& field);

  std::string& out_;
};

// `index` of a repeated field; -1: the field itself.
void Writer::value(const Message& message, const FieldDescriptor& field, int index) {
  const Reflection& of = *message.GetReflection();
  const bool one = index < 0;
  switch (field.cpp_type()) {
    case FieldDescriptor::CPPTYPE_BOOL:
      return byte(one ? of.GetBool(message, &field) : of.GetRepeatedBool(message, &field, index));
    case FieldDescriptor::CPPTYPE_FLOAT: {
      const float number32 =
          one ? of.GetFloat(message, &field) : of.GetRepeatedFloat(message, &field, index);
      return number(std::bit_cast<std::uint64_t>(static_cast<double>(number32)));
    }
    case FieldDescriptor::CPPTYPE_DOUBLE:
      return number(std::bit_cast<std::uint64_t>(
          one ? of.GetDouble(message, &field) : of.GetRepeatedDouble(message, &field, index)));
    case FieldDescriptor::CPPTYPE_INT64:
      return number(static_cast<std::uint64_t>(one ? of.GetInt64(message, &field)
                                                   : of.GetRepeatedInt64(message, &field, index)));
    case FieldDescriptor::CPPTYPE_UINT64:
      return number(one ? of.GetUInt64(message, &field)
                        : of.GetRepeatedUInt64(message, &field, index));
    case FieldDescriptor::CPPTYPE_UINT32:
      return number(one ? of.GetUInt32(message, &field)
                        : of.GetRepeatedUInt32(message, &field, index));
    case FieldDescriptor::CPPTYPE_INT32:
      return i32(one ? of.GetInt32(message, &field) : of.GetRepeatedInt32(message, &field, index));
    case FieldDescriptor::CPPTYPE_ENUM:
      return i32(one ? of.GetEnumValue(message, &field)
                     : of.GetRepeatedEnumValue(message, &field, index));
    case FieldDescriptor::CPPTYPE_STRING:
      return text(one ? of.GetString(message, &field)
                      : of.GetRepeatedString(message, &field, index));
    case FieldDescriptor::CPPTYPE_MESSAGE:
      return structure(one ? of.GetMessage(message, &field)
                           : of.GetRepeatedMessage(message, &field, index));
  }
}

void Writer::list(const Message& message, const FieldDescriptor& field) {
  const int size = message.GetReflection()->FieldSize(message, &field);
  byte(value_type(field));
  i32(size);
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
  std::sort(entries.begin(), entries.end(), [&](const Message* a, const Message* b) {
    return a->GetReflection()->GetInt32(*a, &key) < b->GetReflection()->GetInt32(*b, &key);
  });
  byte(value_type(key));
  byte(value_type(mapped));
  i32(static_cast<std::int32_t>(entries.size()));
  for (const Message* entry : entries) {
    value(*entry, key, -1);
    value(*entry, mapped, -1);
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
      value(message, one, -1);
    }
  }
  byte(kStop);
}

// ---- Reading ----

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
  bool field(std::uint8_t& type, std::uint16_t& id) {
    return number(type) && (type == kStop || number(id));
  }
  bool skip(std::uint8_t type, int depth);
  bool structure(Message& message, int depth);

 private:
  static constexpr std::uint32_t kMaxText = 1U << 24;

  bool skip_elements(std::uint32_t count, std::uint8_t type, int depth);
  bool real_value(Message& message, const FieldDescriptor& field, bool repeated);
  bool value(Message& message, const FieldDescriptor& field, bool repeated, int depth);
  bool list(Message& message, const FieldDescriptor& field, int depth);
  bool map(Message& message, const FieldDescriptor& field, int depth);
  bool field_value(Message& message, const FieldDescriptor& field, int depth);

  std::string_view rest_;
  bool missing_ = false;
};

bool Reader::skip_elements(std::uint32_t count, std::uint8_t type, int depth) {
  for (std::uint32_t i = 0; i < count; ++i) {
    if (!skip(type, depth)) return false;
  }
  return true;
}

bool Reader::skip(std::uint8_t type, int depth) {
  if (depth > kMaxDepth) return false;
  std::string_view ignored;
  std::uint8_t first = 0;
  std::uint8_t second = 0;
  std::uint16_t id = 0;
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
      while (field(first, id)) {
        if (first == kStop) return true;
        if (!skip(first, depth + 1)) return false;
      }
      return false;
    case kList:
    case kSet:
      return number(first) && number(count) && skip_elements(count, first, depth + 1);
    case kMap:
      if (!number(first) || !number(second) || !number(count)) return false;
      for (std::uint32_t i = 0; i < count; ++i) {
        if (!skip(first, depth + 1) || !skip(second, depth + 1)) return false;
      }
      return true;
    default:
      return false;
  }
}

bool Reader::real_value(Message& message, const FieldDescriptor& field, bool repeated) {
  const Reflection& of = *message.GetReflection();
  std::uint64_t bits = 0;
  if (!number(bits)) return false;
  const auto read = std::bit_cast<double>(bits);
  if (field.cpp_type() == FieldDescriptor::CPPTYPE_DOUBLE) {
    repeated ? of.AddDouble(&message, &field, read) : of.SetDouble(&message, &field, read);
  } else {
    const auto narrow = static_cast<float>(read);
    repeated ? of.AddFloat(&message, &field, narrow) : of.SetFloat(&message, &field, narrow);
  }
  return true;
}

bool Reader::value(Message& message, const FieldDescriptor& field, bool repeated, int depth) {
  const Reflection& of = *message.GetReflection();
  std::uint8_t flag = 0;
  std::uint32_t word = 0;
  std::uint64_t large = 0;
  std::string_view quoted;
  switch (field.cpp_type()) {
    case FieldDescriptor::CPPTYPE_BOOL:
      if (!number(flag)) return false;
      repeated ? of.AddBool(&message, &field, flag != 0) : of.SetBool(&message, &field, flag != 0);
      return true;
    case FieldDescriptor::CPPTYPE_FLOAT:
    case FieldDescriptor::CPPTYPE_DOUBLE:
      return real_value(message, field, repeated);
    case FieldDescriptor::CPPTYPE_INT64:
    case FieldDescriptor::CPPTYPE_UINT64: {
      if (!number(large)) return false;
      if (field.cpp_type() == FieldDescriptor::CPPTYPE_UINT64) {
        repeated ? of.AddUInt64(&message, &field, large) : of.SetUInt64(&message, &field, large);
      } else {
        const auto read = static_cast<std::int64_t>(large);
        repeated ? of.AddInt64(&message, &field, read) : of.SetInt64(&message, &field, read);
      }
      return true;
    }
    case FieldDescriptor::CPPTYPE_UINT32:
      if (!number(word)) return false;
      repeated ? of.AddUInt32(&message, &field, word) : of.SetUInt32(&message, &field, word);
      return true;
    case FieldDescriptor::CPPTYPE_INT32:
    case FieldDescriptor::CPPTYPE_ENUM: {
      if (!number(word)) return false;
      const auto read = static_cast<std::int32_t>(word);
      if (field.cpp_type() == FieldDescriptor::CPPTYPE_ENUM) {
        repeated ? of.AddEnumValue(&message, &field, read)
                 : of.SetEnumValue(&message, &field, read);
      } else {
        repeated ? of.AddInt32(&message, &field, read) : of.SetInt32(&message, &field, read);
      }
      return true;
    }
    case FieldDescriptor::CPPTYPE_STRING:
      if (!text(quoted)) return false;
      repeated ? of.AddString(&message, &field, std::string(quoted))
               : of.SetString(&message, &field, std::string(quoted));
      return true;
    case FieldDescriptor::CPPTYPE_MESSAGE:
      return structure(
          repeated ? *of.AddMessage(&message, &field) : *of.MutableMessage(&message, &field),
          depth + 1);
  }
  return false;
}

bool Reader::list(Message& message, const FieldDescriptor& field, int depth) {
  std::uint8_t type = 0;
  std::uint32_t count = 0;
  if (!number(type) || !number(count)) return false;
  if (type != value_type(field)) return skip_elements(count, type, depth + 1);
  for (std::uint32_t i = 0; i < count; ++i) {
    if (!value(message, field, true, depth)) return false;
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
  for (std::uint32_t i = 0; i < count; ++i) {
    if (!known) {
      if (!skip(key, depth + 1) || !skip(mapped, depth + 1)) return false;
      continue;
    }
    Message& entry = *message.GetReflection()->AddMessage(&message, &field);
    if (!value(entry, key_field, false, depth) || !value(entry, mapped_field, false, depth)) {
      return false;
    }
  }
  return true;
}

bool Reader::field_value(Message& message, const FieldDescriptor& field, int depth) {
  if (field.is_map()) return map(message, field, depth);
  return field.is_repeated() ? list(message, field, depth) : value(message, field, false, depth);
}

bool Reader::structure(Message& message, int depth) {
  if (depth > kMaxDepth) return false;
  std::uint8_t type = 0;
  std::uint16_t id = 0;
  while (field(type, id)) {
    if (type == kStop) return true;
    const FieldDescriptor* known = message.GetDescriptor()->FindFieldByNumber(id);
    const bool fits = known != nullptr && field_type(*known) == type;
    if (fits ? !field_value(message, *known, depth) : !skip(type, depth + 1)) return false;
  }
  return false;
}

// The header of a message, in the strict form or in that of old writers.
bool read_header(Reader& in, std::uint32_t& kind, std::int32_t& sequence, bool& valid) {
  std::uint32_t first = 0;
  std::string_view method;
  std::uint32_t number = 0;
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
  if (!in.number(number)) return false;
  sequence = static_cast<std::int32_t>(number);
  return true;
}

// Thrift's TApplicationException: text and type.
bool read_exception(Reader& in, ThriftReply& reply) {
  std::uint8_t type = 0;
  std::uint16_t id = 0;
  while (in.field(type, id)) {
    if (type == kStop) return true;
    std::string_view text;
    std::uint32_t number = 0;
    if (id == 1 && type == kString) {
      if (!in.text(text)) return false;
      reply.error = text;
    } else if (id == 2 && type == kI32) {
      if (!in.number(number)) return false;
      reply.exception_type = static_cast<std::int32_t>(number);
    } else if (!in.skip(type, 0)) {
      return false;
    }
  }
  return false;
}

// The struct of a result: field 0 is what the method returned.
bool read_result(Reader& in, Message& message) {
  std::uint8_t type = 0;
  std::uint16_t id = 0;
  while (in.field(type, id)) {
    if (type == kStop) return true;
    const bool returned = id == 0 && type == kStruct;
    if (returned ? !in.structure(message, 0) : !in.skip(type, 0)) return false;
  }
  return false;
}

}  // namespace

void append_thrift_call(std::string_view method, std::int32_t sequence, const Message& request,
                        std::string& out) {
  Writer writer(out);
  writer.number(kVersion | kCall);
  writer.text(method);
  writer.i32(sequence);
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
