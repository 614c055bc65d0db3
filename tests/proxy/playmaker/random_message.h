// Random messages of any type, valid and not, by reflection over every field.
#pragma once

#include <google/protobuf/message.h>

#include <cstddef>
#include <cstdint>
#include <string>

namespace cls::tests {

/// The same seed gives the same messages.
class RandomMessages {
 public:
  explicit RandomMessages(std::uint64_t seed) : state_(seed * 2 + 1) {}

  /// The bytes of a reply of the type of `prototype`. Most parse: with extreme numbers (NaN,
  /// infinity, limits), unknown values of enumerations, texts of any characters, missing and
  /// repeated fields. The others are cut, changed, nested deeply, repeated up to 100'000 times, too
  /// large or no message at all.
  std::string reply(const google::protobuf::Message& prototype);

  /// Sets random fields.
  void fill(google::protobuf::Message& message, int depth = 0);

  /// A number below `end`.
  std::size_t below(std::size_t end);
  /// True in one of `n` cases.
  bool one_in(std::size_t n) { return below(n) == 0; }

 private:
  void put(google::protobuf::Message& message, const google::protobuf::FieldDescriptor& field,
           int depth);
  double number();
  std::int64_t integer();
  std::string text();
  std::string damaged(std::string bytes);

  std::uint64_t state_;
};

}  // namespace cls::tests
