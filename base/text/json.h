// A JSON value. nlohmann-json parses and prints it behind this header, which is light: it costs the
// files that only build documents a twentieth of the library's header.
#pragma once

#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <iosfwd>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

namespace cls::base {

/// Objects keep the order of their members. Values convert from numbers, texts, booleans and
/// containers of them; `{{"key", value}, ...}` is an object, other lists are arrays. Wrong types
/// and missing members throw Json::exception with the text of nlohmann-json.
class Json {
 public:
  using Array = std::vector<Json>;
  using Member = std::pair<std::string, Json>;
  using Object = std::vector<Member>;
  struct exception : std::runtime_error {
    explicit exception(const char* text, std::size_t position = 0)
        : std::runtime_error(text), byte(position) {}
    std::size_t byte;  ///< of a syntax error, from 1; 0: unknown
  };

  Json() noexcept;  ///< null
  Json(std::nullptr_t) noexcept;
  Json(bool value) noexcept;
  Json(double value) noexcept;
  Json(const char* text);
  Json(std::string text);
  Json(std::string_view text);
  template <typename Integer>
  requires(std::is_integral_v<Integer> && !std::is_same_v<Integer, bool>) Json(Integer value)
  noexcept : Json(whole(value)) {}
  template <typename Pointee>
  Json(const Pointee*) = delete;
  /// An array of the elements, or an object of the pairs of a map.
  template <typename Container>
  requires(std::is_class_v<typename Container::const_iterator> ||
           std::is_pointer_v<typename Container::const_iterator>) Json(const Container& container);
  Json(std::initializer_list<Json> list);

  Json(const Json& other);
  Json(Json&& other) noexcept;
  Json& operator=(const Json& other);
  Json& operator=(Json&& other) noexcept;
  ~Json();

  static Json array() { return Json(Value(Array())); }
  static Json array(std::initializer_list<Json> list);
  static Json object() { return Json(Value(Object())); }

  /// Throws Json::exception, which names the place. Values nest at most kMaxDepth deep.
  static Json parse(std::string_view text, bool ignore_comments = false);
  /// A value that is_discarded() if the text is not JSON.
  static Json parse_or_discarded(std::string_view text);
  static constexpr int kMaxDepth = 1000;

  /// Bytes that are not UTF-8 become U+FFFD. A negative indent: one line. `ascii`: other characters
  /// are escaped.
  std::string dump(int indent = -1, bool ascii = false) const;

  /// "3.11.2": the version of nlohmann-json.
  static std::string library_version();

  bool is_discarded() const;
  bool is_null() const;
  bool is_boolean() const;
  bool is_number() const;
  bool is_number_integer() const;   ///< written without a fraction or an exponent
  bool is_number_unsigned() const;  ///< and not negative
  bool is_number_float() const;
  bool is_string() const;
  bool is_array() const;
  bool is_object() const;
  bool is_primitive() const { return !is_array() && !is_object(); }
  const char* type_name() const;

  /// bool, a number, std::string, Json, or a vector of them. Numbers are converted as static_cast
  /// does.
  template <typename T>
  T get() const;

  /// Elements or members; 0 of null, 1 of other values.
  std::size_t size() const;
  bool empty() const { return size() == 0; }
  bool contains(std::string_view key) const { return find(key) != nullptr; }
  /// The member of an object; nullptr if there is none.
  const Json* find(std::string_view key) const;
  /// The member, or `otherwise` if there is none.
  template <typename T>
  T value(std::string_view key, T otherwise) const;
  std::string value(std::string_view key, const char* otherwise) const {
    return value(key, std::string(otherwise));
  }

  const Json& at(std::string_view key) const;
  const Json& at(std::size_t index) const;
  const Json& operator[](std::string_view key) const { return at(key); }
  /// Adds a member that is missing.
  Json& operator[](std::string_view key);
  template <typename Index>
  requires(std::is_integral_v<Index>) const Json& operator[](Index index) const {
    return at(static_cast<std::size_t>(index));
  }
  template <typename Index>
  requires(std::is_integral_v<Index>) const Json& operator[](Index index) {  // 0 is no text
    return at(static_cast<std::size_t>(index));
  }

  /// The elements of an array; none of null.
  const Json* begin() const { return elements().data(); }
  const Json* end() const { return begin() + elements().size(); }
  const Json& front() const { return elements().front(); }
  const Json& back() const { return elements().back(); }
  Json& back();
  /// The members of an object; none of null.
  const Object& items() const;

  /// null becomes an array.
  void push_back(Json value);
  void emplace_back(Json value) { push_back(std::move(value)); }
  /// Sets all members of `other`.
  void update(const Json& other);
  void erase(std::string_view key);

  /// Numbers are equal by value.
  bool operator==(const Json& other) const;

 private:
  struct Discarded {};
  using Value = std::variant<std::nullptr_t, Discarded, bool, std::int64_t, std::uint64_t, double,
                             std::string, Array, Object>;
  struct Library;  // what converts from and to nlohmann-json

  explicit Json(Value value);
  template <typename Integer>
  static Value whole(Integer value) {
    if constexpr (std::is_signed_v<Integer>) return static_cast<std::int64_t>(value);
    return static_cast<std::uint64_t>(value);
  }

  template <typename Number>
  Number number() const;
  const bool& boolean() const;
  const std::string& string() const;
  const Array& elements() const;
  Object& members_to_change();

  Value value_;
};

/// For GoogleTest.
void PrintTo(const Json& json, std::ostream* out);

template <typename Container>
requires(
    std::is_class_v<typename Container::const_iterator> ||
    std::is_pointer_v<typename Container::const_iterator>) Json::Json(const Container& container) {
  if constexpr (requires { typename Container::mapped_type; }) {
    Object members;
    for (const auto& [key, value] : container) members.emplace_back(key, value);
    value_ = std::move(members);
  } else {
    Array list;
    for (const auto& element : container) list.emplace_back(element);
    value_ = std::move(list);
  }
}

template <typename T>
T Json::get() const {
  if constexpr (std::is_same_v<T, Json>) {
    return *this;
  } else if constexpr (std::is_same_v<T, bool>) {
    return boolean();
  } else if constexpr (std::is_same_v<T, std::string>) {
    return string();
  } else if constexpr (requires { typename T::value_type; }) {
    T all;
    for (const Json& element : elements()) all.push_back(element.get<typename T::value_type>());
    return all;
  } else if constexpr (std::is_floating_point_v<T>) {
    return static_cast<T>(number<double>());
  } else if constexpr (std::is_signed_v<T>) {
    return static_cast<T>(number<std::int64_t>());
  } else {
    return static_cast<T>(number<std::uint64_t>());
  }
}

template <typename T>
T Json::value(std::string_view key, T otherwise) const {
  if (!is_object()) static_cast<void>(at(key));  // throws
  const Json* found = find(key);
  return found == nullptr ? otherwise : found->get<T>();
}

}  // namespace cls::base
