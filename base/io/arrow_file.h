// Writes a table as an Arrow IPC file ("Feather 2"), which pandas, polars, R and others map into
// memory. Debian 12 has no library for it; of the format, this needs the metadata (flat_buffer.h)
// and plain arrays.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/io/byte_sink.h"

namespace cls::base {

enum class ArrowType : std::uint8_t { kBool, kInt8, kInt16, kInt32, kInt64, kFloat32, kText };

/// A column.
struct ArrowField {
  std::string name;
  ArrowType type = ArrowType::kFloat32;
  std::string unit{};    ///< "m", "m/cycle", "deg", "cycle"; empty: none. In the field's metadata
  std::size_t list = 0;  ///< numbers in each cell; 0: one number or text
};

/// Writes row by row, in batches of kBatchRows or fewer with long texts, so memory does not grow
/// with the table. The bytes depend on fields, metadata and cells only.
class ArrowWriter {
 public:
  static constexpr std::size_t kBatchRows = 8192;

  /// Writes the schema. `metadata` are keys and values of the whole table. `sink` must outlive the
  /// writer; its errors are those of its close().
  ArrowWriter(ByteSink& sink, std::vector<ArrowField> fields,
              std::vector<std::pair<std::string, std::string>> metadata = {});

  // One cell, in the order of the fields; a row ends with its last cell. A list takes as many
  // numbers as it has.
  void add(double number);          ///< of a type that can hold it; also for kBool
  void add(std::string_view text);  ///< bytes that are not UTF-8 become U+FFFD
  void add_null();                  ///< the cell, or the whole list, is unknown

  /// Writes the last rows and the footer. Called last, after a whole row.
  void close();

 private:
  struct Column {
    std::string values;
    std::vector<std::int32_t> offsets;  // of texts
    std::string validity;               // a bit per row
    std::size_t bits = 0;               // of kBool, in values
    std::size_t nulls = 0;
    std::size_t cells = 0;
  };
  struct Block {
    std::int64_t offset;
    std::int64_t metadata;
    std::int64_t body;
  };

  void end_cell(bool valid);
  void append_value(double number);
  void write_batch();
  /// Writes metadata with its length, then the body. Returns where.
  Block write_message(std::string_view metadata, std::string_view body);
  void write(std::string_view bytes);

  ByteSink& sink_;
  std::vector<ArrowField> fields_;
  std::vector<std::pair<std::string, std::string>> metadata_;
  std::vector<Column> columns_;
  std::vector<Block> blocks_;
  std::int64_t written_ = 0;
  std::size_t rows_ = 0;    // of the batch
  std::size_t column_ = 0;  // of the next cell
  std::size_t in_list_ = 0;
  bool is_full_ = false;  // before kBatchRows, because its texts are long
};

}  // namespace cls::base
