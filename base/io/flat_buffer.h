// Builds one FlatBuffer, the encoding of the metadata of Arrow files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace cls::base {

/// FlatBuffers are built from their end: what a table refers to is added before the table. All
/// functions that add an object return its place, for those that refer to it.
class FlatBuffer {
 public:
  /// Distance of an object from the end of the buffer; 0: none.
  using Place = std::uint32_t;

  Place add_text(std::string_view text);
  Place add_vector(const std::vector<Place>& places);
  /// A vector of `count` structs of 64-bit values: `values` has all of them, in order.
  Place add_structs(std::size_t count, const std::vector<std::int64_t>& values);

  /// Between these two, the fields of one table; fields that are not added have their default.
  void begin_table();
  Place end_table();
  /// `slot` is the number of the field in the schema; `bytes` the size of the value.
  void add_number(std::size_t slot, std::int64_t value, std::size_t bytes);
  void add_place(std::size_t slot, Place place);

  /// The buffer with this root, a multiple of 8 bytes.
  std::string finish(Place root);

 private:
  Place size() const { return static_cast<Place>(reversed_.size()); }
  /// Pads so that what has `bytes` more bytes begins at a multiple of `alignment`.
  void align(std::size_t alignment, std::size_t bytes);
  void put(std::int64_t value, std::size_t bytes);
  void put_reference(Place place);

  std::string reversed_;
  std::size_t alignment_ = 8;
  Place table_end_ = 0;
  std::vector<Place> fields_;  // by slot; 0: default
};

}  // namespace cls::base
