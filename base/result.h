// Result<T>: a value or an error message. All functions report invalid input this way.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace cls::base {

/// `message` is one line that can be shown to a user without further context. It names the place
/// (file, line, byte, cycle) and the problem.
struct Error {
  std::string message;
};

/// Either a T or an Error. Check with `if (result)`; access to the absent one is a programming
/// error and throws std::bad_variant_access.
template <typename T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
  Result(Error error) : state_(std::in_place_index<1>, std::move(error)) {}

  bool ok() const { return state_.index() == 0; }
  explicit operator bool() const { return ok(); }

  T& value() & { return std::get<0>(state_); }
  const T& value() const& { return std::get<0>(state_); }
  T&& value() && { return std::get<0>(std::move(state_)); }
  T& operator*() & { return value(); }
  const T& operator*() const& { return value(); }
  T&& operator*() && { return std::move(*this).value(); }
  T* operator->() { return &value(); }
  const T* operator->() const { return &value(); }

  const Error& error() const& { return std::get<1>(state_); }
  Error&& error() && { return std::get<1>(std::move(state_)); }

 private:
  std::variant<T, Error> state_;
};

/// Success without a value, or an Error.
template <>
class [[nodiscard]] Result<void> {
 public:
  Result() = default;
  Result(Error error) : error_(std::move(error)) {}

  bool ok() const { return !error_.has_value(); }
  explicit operator bool() const { return ok(); }
  const Error& error() const& { return error_.value(); }
  Error&& error() && { return std::move(error_).value(); }

 private:
  std::optional<Error> error_;
};

}  // namespace cls::base

#define CLS_JOIN_TOKENS(left, right) left##right
#define CLS_JOIN(left, right) CLS_JOIN_TOKENS(left, right)

/// Returns the error of a result from the calling function, if it has one:
///   TRY(check_schema(json));
#define TRY(...)                                                                            \
  if (auto CLS_JOIN(result_at_, __LINE__) = (__VA_ARGS__); !CLS_JOIN(result_at_, __LINE__)) \
  return std::move(CLS_JOIN(result_at_, __LINE__)).error()

/// Returns the error of a result, if it has one; else initializes a variable with the value:
///   TRY_INIT(const int steps, json["steps"].integer(1, 100));
#define TRY_INIT(declaration, ...)                                                               \
  auto CLS_JOIN(result_at_, __LINE__) = (__VA_ARGS__);                                           \
  if (!CLS_JOIN(result_at_, __LINE__)) return std::move(CLS_JOIN(result_at_, __LINE__)).error(); \
  declaration = *std::move(CLS_JOIN(result_at_, __LINE__))
