// The bytes of values in a channel.
#include "soccer/messages/values.h"

#include <cassert>
#include <cstring>
#include <type_traits>

namespace cls::soccer {
namespace {

// Texts have a digit after the name.
constexpr std::string_view kSeeValues = "(see =";
constexpr std::string_view kSenseValues = "(sense_body =";

template <typename Value>
void append_bytes(const Value* values, std::size_t count, std::string& out) {
  static_assert(std::is_trivially_copyable_v<Value>);
  out.append(reinterpret_cast<const char*>(values), count * sizeof(Value));
}

template <typename Value>
void take_bytes(std::string_view& bytes, Value* values, std::size_t count) {
  static_assert(std::is_trivially_copyable_v<Value>);
  assert(bytes.size() >= count * sizeof(Value));
  if (count > 0) std::memcpy(values, bytes.data(), count * sizeof(Value));
  bytes.remove_prefix(count * sizeof(Value));
}

}  // namespace

void write_values(const See& see, std::string& out) {
  out += kSeeValues;
  append_bytes(&see.time, 1, out);
  append_bytes(see.objects.data(), see.objects.size(), out);
}

void write_values(const SenseBody& sense, std::string& out) {
  out += kSenseValues;
  append_bytes(&sense, 1, out);
}

bool read_values(std::string_view message, See& out) {
  if (!message.starts_with(kSeeValues)) return false;
  message.remove_prefix(kSeeValues.size());
  take_bytes(message, &out.time, 1);
  out.objects.resize(message.size() / sizeof(Observation));
  take_bytes(message, out.objects.data(), out.objects.size());
  return true;
}

bool read_values(std::string_view message, SenseBody& out) {
  if (!message.starts_with(kSenseValues)) return false;
  message.remove_prefix(kSenseValues.size());
  take_bytes(message, &out, 1);
  return true;
}

}  // namespace cls::soccer
