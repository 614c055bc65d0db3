// The layout of https://arrow.apache.org/docs/format/Columnar.html: messages of metadata and body.
#include "base/io/arrow_file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <cstring>
#include <limits>

#include "base/index.h"
#include "base/io/flat_buffer.h"
#include "base/text/utf8.h"

namespace cls::base {
namespace {

static_assert(std::endian::native == std::endian::little, "values are written as they are");

using Place = FlatBuffer::Place;

constexpr std::string_view kMagic = "ARROW1";
constexpr std::size_t kAlignment = 64;                       // recommended for the arrays of a body
constexpr std::size_t kMaxBatchText = std::size_t{1} << 28;  // offsets have 32 bits
constexpr std::uint32_t kContinues = 0xFFFFFFFF;

// Numbers of the schemas Message.fbs, Schema.fbs and File.fbs.
constexpr int kMetadataV5 = 4;
constexpr int kSchemaMessage = 1;
constexpr int kRecordBatchMessage = 3;
constexpr int kListType = 16;
constexpr int kSinglePrecision = 1;
constexpr const char* kItemName = "item";
constexpr const char* kUnitKey = "unit";

constexpr int kIntType = 2;
constexpr int kFloatType = 3;

/// A type of values: its number in the schema, and the bytes of a value.
struct TypeLayout {
  int number;
  int size;
};
// By ArrowType.
constexpr std::array<TypeLayout, 7> kTypes = {
    {{6, 1}, {kIntType, 1}, {kIntType, 2}, {kIntType, 4}, {kIntType, 8}, {kFloatType, 4}, {5, 0}}};

Place add_type(FlatBuffer& buffer, ArrowType type) {
  const TypeLayout& layout = kTypes[index(type)];
  buffer.begin_table();
  if (layout.number == kIntType) {
    buffer.add_number(0, 8 * layout.size, 4);
    buffer.add_number(1, 1, 1);  // signed
  } else if (layout.number == kFloatType) {
    buffer.add_number(0, kSinglePrecision, 2);
  }
  return buffer.end_table();
}

Place add_pairs(FlatBuffer& buffer, const std::vector<std::pair<std::string, std::string>>& pairs) {
  std::vector<Place> places;
  for (const auto& pair : pairs) {
    const Place key = buffer.add_text(pair.first);
    const Place value = buffer.add_text(pair.second);
    buffer.begin_table();
    buffer.add_place(0, key);
    buffer.add_place(1, value);
    places.push_back(buffer.end_table());
  }
  return buffer.add_vector(places);
}

struct FieldParts {
  std::string name;
  int type;
  Place type_place;
  std::vector<Place> children;
  std::string unit;
};

Place add_field(FlatBuffer& buffer, const FieldParts& parts) {
  const Place name = buffer.add_text(parts.name);
  const Place children = buffer.add_vector(parts.children);
  const Place metadata = parts.unit.empty() ? 0 : add_pairs(buffer, {{kUnitKey, parts.unit}});

  buffer.begin_table();
  buffer.add_place(0, name);
  buffer.add_place(3, parts.type_place);
  buffer.add_place(5, children);
  if (metadata != 0) buffer.add_place(6, metadata);
  buffer.add_number(1, 1, 1);  // nullable
  buffer.add_number(2, parts.type, 1);
  return buffer.end_table();
}

Place add_field(FlatBuffer& buffer, const ArrowField& field) {
  const Place type = add_type(buffer, field.type);
  const int number = kTypes[index(field.type)].number;
  if (field.list == 0) return add_field(buffer, {field.name, number, type, {}, field.unit});

  const Place item = add_field(buffer, {kItemName, number, type, {}, ""});
  buffer.begin_table();
  buffer.add_number(0, static_cast<std::int64_t>(field.list), 4);
  const Place list = buffer.end_table();
  return add_field(buffer, {field.name, kListType, list, {item}, field.unit});
}

Place add_schema(FlatBuffer& buffer, const std::vector<ArrowField>& fields,
                 const std::vector<std::pair<std::string, std::string>>& metadata) {
  std::vector<Place> places;
  places.reserve(fields.size());
  for (const ArrowField& field : fields) places.push_back(add_field(buffer, field));
  const Place all = buffer.add_vector(places);
  const Place pairs = add_pairs(buffer, metadata);

  buffer.begin_table();
  buffer.add_place(1, all);
  buffer.add_place(2, pairs);
  return buffer.end_table();
}

std::string message(FlatBuffer& buffer, int kind, Place header, std::size_t body) {
  buffer.begin_table();
  buffer.add_number(3, static_cast<std::int64_t>(body), 8);
  buffer.add_place(2, header);
  buffer.add_number(0, kMetadataV5, 2);
  buffer.add_number(1, kind, 1);
  return buffer.finish(buffer.end_table());
}

template <typename T>
void append_bytes(T value, std::string& out) {
  std::array<char, sizeof value> bytes{};
  std::memcpy(bytes.data(), &value, sizeof value);
  out.append(bytes.data(), bytes.size());
}

template <typename T>
void append_whole(double number, std::string& out) {
  assert(number >= static_cast<double>(std::numeric_limits<T>::min()) &&
         number <= static_cast<double>(std::numeric_limits<T>::max()));
  append_bytes(static_cast<T>(number), out);
}

void set_bit(std::size_t index, bool value, std::string& bits) {
  if (index % 8 == 0) bits += '\0';
  if (value) bits.back() = static_cast<char>(bits.back() | 1 << index % 8);
}

void append_utf8(std::string_view text, std::string& out) {
  constexpr std::string_view kReplacement = "\xEF\xBF\xBD";
  while (!text.empty()) {
    const std::size_t length = utf8_sequence_length(text);
    out += length > 0 ? text.substr(0, length) : kReplacement;
    text.remove_prefix(length > 0 ? length : 1);
  }
}

// The arrays of a batch, and where they are.
struct Body {
  std::string bytes;
  std::vector<std::int64_t> buffers;  // offset and length of each
  std::vector<std::int64_t> nodes;    // length and null count of each

  void add_node(std::size_t length, std::size_t nulls) {
    nodes.push_back(static_cast<std::int64_t>(length));
    nodes.push_back(static_cast<std::int64_t>(nulls));
  }

  void add_buffer(std::string_view array) {
    buffers.push_back(static_cast<std::int64_t>(bytes.size()));
    buffers.push_back(static_cast<std::int64_t>(array.size()));
    bytes += array;
    bytes.resize((bytes.size() + kAlignment - 1) / kAlignment * kAlignment);
  }
};

}  // namespace

ArrowWriter::ArrowWriter(ByteSink& sink, std::vector<ArrowField> fields,
                         std::vector<std::pair<std::string, std::string>> metadata)
    : sink_(sink),
      fields_(std::move(fields)),
      metadata_(std::move(metadata)),
      columns_(fields_.size()) {
  write(kMagic);
  write(std::string_view("\0\0", 2));
  FlatBuffer buffer;
  const Place schema = add_schema(buffer, fields_, metadata_);
  write_message(message(buffer, kSchemaMessage, schema, 0), {});
}

void ArrowWriter::write(std::string_view bytes) {
  sink_.write(bytes);
  written_ += static_cast<std::int64_t>(bytes.size());
}

ArrowWriter::Block ArrowWriter::write_message(std::string_view metadata, std::string_view body) {
  constexpr std::int64_t kPrefix = 8;
  const Block block{written_, kPrefix + static_cast<std::int64_t>(metadata.size()),
                    static_cast<std::int64_t>(body.size())};
  std::string prefix;
  append_bytes(kContinues, prefix);
  append_bytes(static_cast<std::int32_t>(metadata.size()), prefix);
  write(prefix);
  write(metadata);
  write(body);
  return block;
}

void ArrowWriter::append_value(double number) {
  Column& column = columns_[column_];
  switch (fields_[column_].type) {
    case ArrowType::kBool:
      return set_bit(column.bits++, number != 0.0, column.values);
    case ArrowType::kInt8:
      return append_whole<std::int8_t>(number, column.values);
    case ArrowType::kInt16:
      return append_whole<std::int16_t>(number, column.values);
    case ArrowType::kInt32:
      return append_whole<std::int32_t>(number, column.values);
    case ArrowType::kInt64:
      return append_whole<std::int64_t>(number, column.values);
    case ArrowType::kFloat32:
      return append_bytes(static_cast<float>(number), column.values);
    case ArrowType::kText:
      assert(false && "a number in a column of texts");
  }
}

void ArrowWriter::end_cell(bool valid) {
  Column& column = columns_[column_];
  set_bit(column.cells++, valid, column.validity);
  column.nulls += valid ? 0 : 1;
  in_list_ = 0;
  if (++column_ < fields_.size()) return;
  column_ = 0;
  if (++rows_ == kBatchRows || is_full_) write_batch();
}

void ArrowWriter::add(double number) {
  append_value(number);
  if (++in_list_ >= fields_[column_].list) end_cell(true);
}

void ArrowWriter::add(std::string_view text) {
  assert(fields_[column_].type == ArrowType::kText);
  Column& column = columns_[column_];
  column.offsets.push_back(static_cast<std::int32_t>(column.values.size()));
  append_utf8(text, column.values);
  is_full_ = is_full_ || column.values.size() > kMaxBatchText;
  end_cell(true);
}

void ArrowWriter::add_null() {
  assert(in_list_ == 0);
  const ArrowField& field = fields_[column_];
  Column& column = columns_[column_];
  if (field.type == ArrowType::kText) {
    column.offsets.push_back(static_cast<std::int32_t>(column.values.size()));
  } else {
    for (std::size_t i = 0; i < std::max<std::size_t>(field.list, 1); ++i) append_value(0.0);
  }
  end_cell(false);
}

void ArrowWriter::write_batch() {
  Body body;
  for (std::size_t i = 0; i < fields_.size(); ++i) {
    const ArrowField& field = fields_[i];
    Column& column = columns_[i];
    body.add_node(rows_, column.nulls);
    body.add_buffer(column.nulls > 0 ? std::string_view(column.validity) : std::string_view());

    if (field.list > 0) {
      body.add_node(rows_ * field.list, 0);
      body.add_buffer({});
    }
    if (field.type == ArrowType::kText) {
      std::string offsets;
      column.offsets.push_back(static_cast<std::int32_t>(column.values.size()));
      for (const std::int32_t offset : column.offsets) append_bytes(offset, offsets);
      body.add_buffer(offsets);
    }
    body.add_buffer(column.values);
    column = {};
  }

  FlatBuffer buffer;
  const Place nodes = buffer.add_structs(body.nodes.size() / 2, body.nodes);
  const Place buffers = buffer.add_structs(body.buffers.size() / 2, body.buffers);
  buffer.begin_table();
  buffer.add_number(0, static_cast<std::int64_t>(rows_), 8);
  buffer.add_place(1, nodes);
  buffer.add_place(2, buffers);
  const Place batch = buffer.end_table();
  blocks_.push_back(
      write_message(message(buffer, kRecordBatchMessage, batch, body.bytes.size()), body.bytes));

  rows_ = 0;
  is_full_ = false;
}

void ArrowWriter::close() {
  assert(column_ == 0 && in_list_ == 0);
  if (rows_ > 0) write_batch();

  std::string end;
  append_bytes(kContinues, end);
  append_bytes(std::int32_t{0}, end);
  write(end);

  FlatBuffer buffer;
  const Place schema = add_schema(buffer, fields_, metadata_);
  std::vector<std::int64_t> blocks;
  for (const Block& block : blocks_) {
    blocks.insert(blocks.end(), {block.offset, block.metadata, block.body});
  }

  const Place dictionaries = buffer.add_structs(0, {});
  const Place batches = buffer.add_structs(blocks_.size(), blocks);
  buffer.begin_table();
  buffer.add_place(1, schema);
  buffer.add_place(2, dictionaries);
  buffer.add_place(3, batches);
  buffer.add_number(0, kMetadataV5, 2);

  std::string footer = buffer.finish(buffer.end_table());
  append_bytes(static_cast<std::int32_t>(footer.size()), footer);
  write(footer);
  write(kMagic);
}

}  // namespace cls::base
