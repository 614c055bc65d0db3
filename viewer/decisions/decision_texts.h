// Codes texts of decisions: those of a player differ in little more than their numbers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "viewer/stream/bytes.h"

namespace cls::viewer {

/// Longer texts are cut.
constexpr std::size_t kMaxDecisionText = 32 * 1024;

/// Stands for a number in the shape of a text.
constexpr char kNumberPlace = '\x01';

/// The shapes that texts of one kind of one player had so far, and the last numbers at their
/// places. Writers and readers go through the same states.
struct TextShapes {
  std::vector<std::string> shapes;
  std::map<std::string, std::size_t, std::less<>> ids;
  std::vector<std::vector<std::int64_t>> last;  ///< by shape and place, in thousandths
};

/// Appends new shapes, a shape for each text, then the numbers (docs/formats/decisions.md).
void encode_texts(const std::vector<std::string_view>& texts, TextShapes& shapes, std::string& out);

/// The reverse; `in` fails for what no writer writes, and where the texts would be longer than
/// `room` together.
std::vector<std::string> decode_texts(std::size_t count, TextShapes& shapes, std::size_t room,
                                      ByteReader& in);

}  // namespace cls::viewer
