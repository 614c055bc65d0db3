// Differences, predictions and lists of changes.
#include "viewer/stream/column_codec.h"

#include <cmath>

namespace cls::viewer {
namespace {

std::int64_t floor_divided(std::int64_t value, std::int64_t by) {
  const std::int64_t quotient = value / by;
  return value % by < 0 ? quotient - 1 : quotient;
}

void encode_changes(const Integers& values, ColumnState& state, std::string& out) {
  const std::size_t frames = values.size() / state.previous.size();
  std::string pairs;
  std::uint64_t count = 0;
  std::size_t next = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    std::int64_t& previous = state.previous[i / frames];
    if (values[i] == previous) continue;

    append_varint(i - next, pairs);
    append_zigzag(values[i] - previous, pairs);
    previous = values[i];
    next = i + 1;
    ++count;
  }

  append_varint(count, out);
  out += pairs;
}

Integers decode_changes(std::size_t frames, ColumnState& state, ByteReader& in) {
  Integers values(frames * state.previous.size());
  std::uint64_t left = in.varint();
  std::uint64_t change = left > 0 ? in.varint() : values.size();
  for (std::size_t i = 0; i < values.size() && in.good(); ++i) {
    std::int64_t& previous = state.previous[i / frames];
    if (i == change) {
      previous += in.zigzag();
      if (std::abs(previous) > kMaxInteger) in.fail();
      --left;
      change = left > 0 ? i + 1 + in.varint() : values.size();
    }
    values[i] = previous;
  }

  if (left > 0) in.fail();
  return values;
}

std::int64_t encoded(const CodingInput& input, std::int64_t value, std::size_t entry,
                     std::int64_t& previous, std::int64_t& difference) {
  const std::int64_t step = value - previous;
  std::int64_t code = step;
  if (input.coding == Coding::kSecond) code = step - difference;
  if (input.coding == Coding::kAngle) code = wrapped(step, input.half_turn);
  if (input.coding == Coding::kVelocity) code = value - (*input.predictions)[entry];

  previous = value;
  difference = step;
  return code;
}

std::int64_t decoded(const CodingInput& input, std::int64_t code, std::size_t entry,
                     std::int64_t& previous, std::int64_t& difference) {
  switch (input.coding) {
    case Coding::kSecond:
      difference += code;
      previous += difference;
      break;
    case Coding::kAngle:
      previous = wrapped(previous + code, input.half_turn);
      break;
    case Coding::kVelocity:
      previous = code + (*input.predictions)[entry];
      break;
    default:
      previous += code;
      break;
  }
  return previous;
}

}  // namespace

std::int64_t wrapped(std::int64_t angle, std::int64_t half_turn) {
  const std::int64_t turns = floor_divided(angle + half_turn - 1, 2 * half_turn);
  return angle - turns * 2 * half_turn;
}

Integers predicted_velocities(const Integers& positions, const std::vector<std::int64_t>& before,
                              const Integers& decays) {
  Integers predictions(positions.size());
  const std::size_t frames = positions.size() / before.size();
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const std::int64_t last = i % frames == 0 ? before[i / frames] : positions[i - 1];
    predictions[i] = floor_divided(decays[i] * (positions[i] - last) + kDecayUnit / 2, kDecayUnit);
  }
  return predictions;
}

void encode_column(const CodingInput& input, const Integers& values, ColumnState& state,
                   std::string& out) {
  if (input.coding == Coding::kChanges) return encode_changes(values, state, out);

  const std::size_t frames = values.size() / state.previous.size();
  for (std::size_t series = 0; series < state.previous.size(); ++series) {
    std::int64_t previous = state.previous[series];
    std::int64_t difference = state.difference[series];
    for (std::size_t i = series * frames; i < (series + 1) * frames; ++i) {
      append_zigzag(encoded(input, values[i], i, previous, difference), out);
    }
    state.previous[series] = previous;
    state.difference[series] = difference;
  }
}

Integers decode_column(const CodingInput& input, std::size_t frames, ColumnState& state,
                       ByteReader& in) {
  if (input.coding == Coding::kChanges) return decode_changes(frames, state, in);

  Integers values(frames * state.previous.size());
  for (std::size_t series = 0; series < state.previous.size(); ++series) {
    std::int64_t previous = state.previous[series];
    std::int64_t difference = state.difference[series];
    for (std::size_t i = series * frames; i < (series + 1) * frames && in.good(); ++i) {
      values[i] = decoded(input, in.zigzag(), i, previous, difference);
      if (std::abs(previous) > kMaxInteger || std::abs(difference) > 2 * kMaxInteger) in.fail();
    }
    state.previous[series] = previous;
    state.difference[series] = difference;
  }
  return values;
}

}  // namespace cls::viewer
