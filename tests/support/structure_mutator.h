// Mutations of texts by their structure: lines, groups in brackets, numbers, words.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace cls::tests {

/// Where changes of single bytes only make syntax errors. Brackets stay balanced if they were.
class StructureMutator {
 public:
  explicit StructureMutator(std::uint64_t seed) : state_(seed * 2 + 1) {}

  /// A text of at most `max_size` bytes after one to four changes: lines and groups repeated,
  /// removed, exchanged and nested, numbers and words replaced by others.
  std::string mutate(std::string text, std::size_t max_size);

 private:
  struct Span {
    std::size_t begin = 0;
    std::size_t end = 0;
  };

  std::size_t below(std::size_t end);
  std::string change(const std::string& text);
  Span line(const std::string& text);
  Span group(const std::string& text);
  Span word(const std::string& text, std::string_view characters);
  std::string repeated(const std::string& text, Span span);
  std::string exchanged(const std::string& text, Span one, Span other);

  std::uint64_t state_;
};

}  // namespace cls::tests
