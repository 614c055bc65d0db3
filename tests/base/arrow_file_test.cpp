// Arrow files read by a reader of this test, which follows the format without the writer's code.
#include "base/io/arrow_file.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <map>
#include <optional>
#include <random>
#include <string>
#include <vector>

namespace cls::base {
namespace {

template <typename T>
T load(std::string_view bytes, std::size_t at) {
  T value{};
  if (at + sizeof value > bytes.size()) throw std::out_of_range("beyond the bytes");
  std::memcpy(&value, bytes.data() + at, sizeof value);
  return value;
}

/// A table of a FlatBuffer.
struct Table {
  std::string_view bytes;
  std::size_t at = 0;

  static Table root(std::string_view bytes) { return {bytes, load<std::uint32_t>(bytes, 0)}; }

  /// Where the field is; 0: default.
  std::size_t field(std::size_t slot) const {
    const std::size_t vtable = at - static_cast<std::size_t>(load<std::int32_t>(bytes, at));
    if (4 + 2 * slot >= load<std::uint16_t>(bytes, vtable)) return 0;
    const auto offset = load<std::uint16_t>(bytes, vtable + 4 + 2 * slot);
    return offset == 0 ? 0 : at + offset;
  }
  template <typename T>
  T number(std::size_t slot) const {
    const std::size_t place = field(slot);
    if (place == 0) return T{};
    EXPECT_EQ(place % sizeof(T), 0U) << "alignment";
    return load<T>(bytes, place);
  }
  std::size_t target(std::size_t slot) const {
    const std::size_t place = field(slot);
    EXPECT_EQ(place % 4, 0U) << "alignment";
    return place + load<std::uint32_t>(bytes, place);
  }
  Table table(std::size_t slot) const { return {bytes, target(slot)}; }
  std::size_t count(std::size_t slot) const {
    return field(slot) == 0 ? 0 : load<std::uint32_t>(bytes, target(slot));
  }
  Table item(std::size_t slot, std::size_t i) const {
    const std::size_t place = target(slot) + 4 + 4 * i;
    return {bytes, place + load<std::uint32_t>(bytes, place)};
  }
  /// Where the structs of a vector begin.
  std::size_t structs(std::size_t slot) const {
    EXPECT_EQ((target(slot) + 4) % 8, 0U) << "alignment";
    return target(slot) + 4;
  }
  std::string text(std::size_t slot) const {
    const std::size_t place = target(slot);
    const auto size = load<std::uint32_t>(bytes, place);
    EXPECT_EQ(bytes.at(place + 4 + size), '\0');
    return std::string(bytes.substr(place + 4, size));
  }
};

using Cell = std::optional<std::vector<double>>;

struct ReadColumn {
  std::string name;
  std::string unit;
  std::vector<Cell> numbers;
  std::vector<std::optional<std::string>> texts;
};

/// Reads files of ArrowWriter, and checks what the format demands of them.
class Reader {
 public:
  explicit Reader(std::string_view file) : file_(file) {
    EXPECT_EQ(file.substr(0, 8), std::string_view("ARROW1\0\0", 8));
    EXPECT_EQ(file.substr(file.size() - 6), "ARROW1");
    const auto size = load<std::int32_t>(file, file.size() - 10);
    footer_ = file.substr(file.size() - 10 - static_cast<std::size_t>(size),
                          static_cast<std::size_t>(size));
    const Table footer = Table::root(footer_);
    EXPECT_EQ(footer.number<std::int16_t>(0), 4) << "V5";
    read_fields(footer.table(1));
    // Offset, length of the metadata (32 bit and padding) and of the body.
    const std::size_t blocks = footer.structs(3);
    for (std::size_t i = 0; i < footer.count(3); ++i) {
      read_batch(load<std::int64_t>(footer_, blocks + 24 * i),
                 load<std::int32_t>(footer_, blocks + 24 * i + 8),
                 load<std::int64_t>(footer_, blocks + 24 * i + 16));
    }
  }

  const std::vector<ReadColumn>& columns() const { return columns_; }
  std::size_t batches() const { return batches_; }
  std::map<std::string, std::string> metadata;

 private:
  struct Field {
    int type;
    int width;
    std::size_t list;
  };

  static Field type_of(const Table& field) {
    const int type = field.number<std::uint8_t>(2);
    EXPECT_TRUE(field.number<std::uint8_t>(1)) << "nullable";
    if (type == 2) {
      EXPECT_TRUE(field.table(3).number<std::uint8_t>(1)) << "signed";
    } else if (type == 3) {
      EXPECT_EQ(field.table(3).number<std::int16_t>(0), 1) << "single precision";
    }
    return {type, type == 2 ? field.table(3).number<std::int32_t>(0) : 32, 0};
  }

  void read_fields(const Table& schema) {
    for (std::size_t i = 0; i < schema.count(2); ++i) {
      metadata[schema.item(2, i).text(0)] = schema.item(2, i).text(1);
    }
    for (std::size_t i = 0; i < schema.count(1); ++i) {
      const Table field = schema.item(1, i);
      columns_.push_back(
          {field.text(0), field.count(6) > 0 ? field.item(6, 0).text(1) : "", {}, {}});
      if (field.number<std::uint8_t>(2) != 16) {
        fields_.push_back(type_of(field));
        continue;
      }
      Field item = type_of(field.item(5, 0));
      item.list = static_cast<std::size_t>(field.table(3).number<std::int32_t>(0));
      fields_.push_back(item);
    }
  }

  void read_batch(std::int64_t offset, std::int32_t metadata_size, std::int64_t body_size) {
    ++batches_;
    const auto at = static_cast<std::size_t>(offset);
    EXPECT_EQ(at % 8, 0U);
    EXPECT_EQ(metadata_size % 8, 0);
    EXPECT_EQ(load<std::uint32_t>(file_, at), 0xFFFFFFFF);
    EXPECT_EQ(load<std::int32_t>(file_, at + 4), metadata_size - 8);
    const auto metadata_bytes = static_cast<std::size_t>(metadata_size);
    const std::string_view message = file_.substr(at + 8, metadata_bytes - 8);
    body_ = file_.substr(at + metadata_bytes, static_cast<std::size_t>(body_size));
    const Table root = Table::root(message);
    EXPECT_EQ(root.number<std::int64_t>(3), body_size);
    const Table batch = root.table(2);
    rows_ = static_cast<std::size_t>(batch.number<std::int64_t>(0));
    message_ = message;
    node_ = batch.structs(1);
    buffer_ = batch.structs(2);
    for (std::size_t i = 0; i < fields_.size(); ++i) read_column(fields_[i], columns_[i]);
  }

  std::string_view next_buffer() {
    const auto offset = load<std::int64_t>(message_, buffer_);
    const auto length = load<std::int64_t>(message_, buffer_ + 8);
    buffer_ += 16;
    EXPECT_EQ(offset % 64, 0);
    EXPECT_LE(offset + length, static_cast<std::int64_t>(body_.size()));
    return body_.substr(static_cast<std::size_t>(offset), static_cast<std::size_t>(length));
  }

  std::int64_t next_node(std::size_t length) {
    EXPECT_EQ(load<std::int64_t>(message_, node_), static_cast<std::int64_t>(length));
    const auto nulls = load<std::int64_t>(message_, node_ + 8);
    node_ += 16;
    return nulls;
  }

  static bool bit(std::string_view bits, std::size_t i) {
    return (static_cast<unsigned char>(bits.at(i / 8)) >> i % 8 & 1) != 0;
  }

  static double value(const Field& field, std::string_view values, std::size_t i) {
    if (field.type == 6) return bit(values, i) ? 1 : 0;
    if (field.type == 3) return load<float>(values, 4 * i);
    switch (field.width) {
      case 8:
        return load<std::int8_t>(values, i);
      case 16:
        return load<std::int16_t>(values, 2 * i);
      case 32:
        return load<std::int32_t>(values, 4 * i);
      default:
        return static_cast<double>(load<std::int64_t>(values, 8 * i));
    }
  }

  void read_column(const Field& field, ReadColumn& column) {
    std::int64_t nulls = next_node(rows_);
    const std::string_view validity = next_buffer();
    const auto valid = [&](std::size_t row) { return validity.empty() || bit(validity, row); };

    for (std::size_t row = 0; row < rows_; ++row) nulls -= valid(row) ? 0 : 1;
    EXPECT_EQ(nulls, 0) << column.name;

    if (field.list > 0) {
      EXPECT_EQ(next_node(rows_ * field.list), 0);
      EXPECT_TRUE(next_buffer().empty());
    }
    const std::string_view offsets = field.type == 5 ? next_buffer() : std::string_view();
    const std::string_view values = next_buffer();
    for (std::size_t row = 0; row < rows_; ++row) {
      if (field.type == 5) {
        const auto from = static_cast<std::size_t>(load<std::int32_t>(offsets, 4 * row));
        const auto to = static_cast<std::size_t>(load<std::int32_t>(offsets, 4 * row + 4));
        column.texts.push_back(
            valid(row) ? std::optional(std::string(values.substr(from, to - from))) : std::nullopt);
        continue;
      }
      const std::size_t each = std::max<std::size_t>(field.list, 1);
      std::vector<double> cell;
      for (std::size_t i = 0; i < each; ++i) cell.push_back(value(field, values, row * each + i));
      column.numbers.push_back(valid(row) ? Cell(cell) : std::nullopt);
    }
  }

  std::string_view file_;
  std::string_view footer_;
  std::string_view message_;
  std::string_view body_;
  std::vector<Field> fields_;
  std::vector<ReadColumn> columns_;
  std::size_t rows_ = 0;
  std::size_t node_ = 0;
  std::size_t buffer_ = 0;
  std::size_t batches_ = 0;
};

TEST(ArrowFile, HasNamesUnitsAndMetadata) {
  StringSink sink;
  ArrowWriter writer(sink, {{"x", ArrowType::kFloat32, "m"}, {"name", ArrowType::kText}},
                     {{"schema", "test/1"}});
  writer.add(1.5);
  writer.add(std::string_view("a"));
  writer.close();
  const Reader read(sink.bytes());

  ASSERT_EQ(read.columns().size(), 2U);
  EXPECT_EQ(read.columns()[0].name, "x");
  EXPECT_EQ(read.columns()[0].unit, "m");
  EXPECT_EQ(read.columns()[1].unit, "");
  EXPECT_EQ(read.metadata.at("schema"), "test/1");
  EXPECT_EQ(read.columns()[0].numbers[0], Cell(std::vector<double>{1.5}));
  EXPECT_EQ(read.columns()[1].texts[0], "a");
}

TEST(ArrowFile, IsValidWithoutRows) {
  StringSink sink;
  ArrowWriter writer(sink, {{"x", ArrowType::kInt8}});
  writer.close();
  const Reader read(sink.bytes());
  EXPECT_EQ(read.batches(), 0U);
  EXPECT_TRUE(read.columns()[0].numbers.empty());
}

TEST(ArrowFile, ReplacesBytesThatAreNotUtf8) {
  StringSink sink;
  ArrowWriter writer(sink, {{"t", ArrowType::kText}});
  writer.add(
      std::string_view("a\xFF"
                       "b\xC3\xA4"));

  writer.close();
  EXPECT_EQ(Reader(sink.bytes()).columns()[0].texts[0],
            "a\xEF\xBF\xBD"
            "b\xC3\xA4");
}

/// A table of random columns, cells and nulls: what was written, and the file.
struct RandomTable {
  std::vector<ArrowField> fields;
  std::vector<ReadColumn> columns;
  std::string file;
};

double random_value(ArrowType type, std::mt19937& random) {
  const auto whole = [&random](std::int64_t max) {
    return static_cast<double>(std::uniform_int_distribution<std::int64_t>(-max - 1, max)(random));
  };

  switch (type) {
    case ArrowType::kBool:
      return static_cast<double>(random() % 2);
    case ArrowType::kInt8:
      return whole(127);
    case ArrowType::kInt16:
      return whole(32767);
    case ArrowType::kInt32:
      return whole(2147483647);
    case ArrowType::kInt64:
      return whole(std::int64_t{1} << 52);
    default:
      return static_cast<double>(static_cast<float>(whole(1000000)) / 1024.0F);
  }
}

RandomTable random_table(std::mt19937& random, std::size_t rows) {
  RandomTable table;
  const std::size_t count = 1 + random() % 6;

  for (std::size_t i = 0; i < count; ++i) {
    const auto type = static_cast<ArrowType>(random() % 7);
    const std::size_t list = type == ArrowType::kText || random() % 3 != 0 ? 0 : 1 + random() % 22;
    table.fields.push_back({"c" + std::to_string(i), type, random() % 2 == 0 ? "m" : "", list});
    table.columns.push_back({table.fields[i].name, table.fields[i].unit, {}, {}});
  }

  StringSink sink;
  ArrowWriter writer(sink, table.fields);

  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t i = 0; i < count; ++i) {
      const ArrowField& field = table.fields[i];
      const bool null = i % 2 == 0 && random() % 5 == 0;
      if (null) writer.add_null();
      if (field.type == ArrowType::kText) {
        const std::string text(random() % 20, static_cast<char>('a' + random() % 26));
        if (!null) writer.add(std::string_view(text));
        table.columns[i].texts.push_back(null ? std::nullopt : std::optional(text));
        continue;
      }
      std::vector<double> cell;
      for (std::size_t k = 0; k < std::max<std::size_t>(field.list, 1); ++k) {
        cell.push_back(random_value(field.type, random));
        if (!null) writer.add(cell.back());
      }
      table.columns[i].numbers.push_back(null ? Cell() : Cell(cell));
    }
  }

  writer.close();
  table.file = sink.bytes();
  return table;
}

TEST(ArrowFile, GivesBackRandomTables) {
  std::mt19937 random(38);

  for (int round = 0; round < 300; ++round) {
    const std::size_t rows = round % 50 == 0 ? 2 * ArrowWriter::kBatchRows + round : random() % 70;
    const RandomTable table = random_table(random, rows);
    const Reader read(table.file);
    EXPECT_EQ(read.batches(), (rows + ArrowWriter::kBatchRows - 1) / ArrowWriter::kBatchRows);
    ASSERT_EQ(read.columns().size(), table.columns.size());
    for (std::size_t i = 0; i < table.columns.size(); ++i) {
      EXPECT_EQ(read.columns()[i].name, table.columns[i].name);
      EXPECT_EQ(read.columns()[i].unit, table.columns[i].unit);
      ASSERT_TRUE(read.columns()[i].numbers == table.columns[i].numbers) << "round " << round;
      ASSERT_TRUE(read.columns()[i].texts == table.columns[i].texts) << "round " << round;
    }
  }
}

}  // namespace
}  // namespace cls::base
