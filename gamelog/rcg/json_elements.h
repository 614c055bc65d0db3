// JSON game logs that another program has formatted.
#pragma once

#include "base/io/byte_source.h"
#include "base/io/input_buffer.h"

namespace cls::gamelog {

/// True if the array at `input` has not one element a line, as soccer servers write it: `jq .`
/// breaks elements, `jq -c .` joins them.
bool has_other_lines(base::InputBuffer& input);

/// The bytes of `input` with a line feed for each comma between elements and a space for each line
/// feed within one. Every byte keeps its place, so offsets in errors hold.
class ElementLines : public base::ByteSource {
 public:
  explicit ElementLines(base::InputBuffer& input) : input_(input) {}
  std::size_t read(char* to, std::size_t size) override;

 private:
  char line_form(char c);

  base::InputBuffer& input_;
  int depth_ = 0;  ///< open brackets and braces; 1: between elements
  bool in_string_ = false;
  bool escaped_ = false;
};

}  // namespace cls::gamelog
