// Appends the bytes in reverse, so that the end of the buffer is the start of the string.
#include "base/io/flat_buffer.h"

#include <algorithm>
#include <cassert>

namespace cls::base {
namespace {

constexpr std::size_t kReference = 4;
constexpr std::size_t kVtableEntry = 2;

}  // namespace

void FlatBuffer::align(std::size_t alignment, std::size_t bytes) {
  while ((reversed_.size() + bytes) % alignment != 0) reversed_ += '\0';
}

void FlatBuffer::put(std::int64_t value, std::size_t bytes) {
  align(bytes, 0);
  for (std::size_t i = bytes; i-- > 0;) {
    reversed_ += static_cast<char>(static_cast<std::uint64_t>(value) >> (8 * i) & 0xFF);
  }
}

// A reference counts from itself to what it refers to.
void FlatBuffer::put_reference(Place place) {
  align(kReference, 0);
  assert(place != 0 && place <= size());
  put(static_cast<std::int64_t>(reversed_.size() + kReference - place), kReference);
}

FlatBuffer::Place FlatBuffer::add_text(std::string_view text) {
  align(kReference, text.size() + 1);
  reversed_ += '\0';
  reversed_.append(text.rbegin(), text.rend());
  put(static_cast<std::int64_t>(text.size()), kReference);
  return size();
}

FlatBuffer::Place FlatBuffer::add_vector(const std::vector<Place>& places) {
  align(kReference, 0);
  for (auto place = places.rbegin(); place != places.rend(); ++place) put_reference(*place);
  put(static_cast<std::int64_t>(places.size()), kReference);
  return size();
}

FlatBuffer::Place FlatBuffer::add_structs(std::size_t count,
                                          const std::vector<std::int64_t>& values) {
  align(alignment_, 0);
  for (auto value = values.rbegin(); value != values.rend(); ++value) put(*value, sizeof *value);
  put(static_cast<std::int64_t>(count), kReference);
  return size();
}

void FlatBuffer::begin_table() {
  fields_.clear();
  table_end_ = size();
}

void FlatBuffer::add_number(std::size_t slot, std::int64_t value, std::size_t bytes) {
  put(value, bytes);
  fields_.resize(std::max(fields_.size(), slot + 1));
  fields_[slot] = size();
}

void FlatBuffer::add_place(std::size_t slot, Place place) {
  put_reference(place);
  fields_.resize(std::max(fields_.size(), slot + 1));
  fields_[slot] = size();
}

// The table begins with the distance to its vtable, which stands before it.
FlatBuffer::Place FlatBuffer::end_table() {
  put(0, kReference);
  const Place table = size();
  for (auto field = fields_.rbegin(); field != fields_.rend(); ++field) {
    put(*field == 0 ? 0 : static_cast<std::int64_t>(table - *field), kVtableEntry);
  }
  put(static_cast<std::int64_t>(table - table_end_), kVtableEntry);
  put(static_cast<std::int64_t>((fields_.size() + 2) * kVtableEntry), kVtableEntry);

  const Place distance = size() - table;
  for (std::size_t i = 0; i < kReference; ++i) {
    reversed_[table - 1 - i] = static_cast<char>(distance >> (8 * i) & 0xFF);
  }
  return table;
}

std::string FlatBuffer::finish(Place root) {
  align(alignment_, kReference);
  put_reference(root);
  return {reversed_.rbegin(), reversed_.rend()};
}

}  // namespace cls::base
