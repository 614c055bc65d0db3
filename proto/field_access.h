// Fields of messages by reflection, with the C++ type of their values.
#pragma once

#include <google/protobuf/descriptor.h>
#include <google/protobuf/message.h>

#include <cstdint>
#include <string>
#include <utility>

namespace cls::proto {

/// Reflection's functions for fields of one type: a value, or the elements of a list.
template <typename T, auto kGet, auto kGetRepeated, auto kSet, auto kAdd>
struct FieldAccess {
  using Value = T;

  /// `index`: of the element, in a repeated field.
  static T get(const google::protobuf::Message& message,
               const google::protobuf::FieldDescriptor& field, int index) {
    const google::protobuf::Reflection& of = *message.GetReflection();
    return field.is_repeated() ? (of.*kGetRepeated)(message, &field, index)
                               : (of.*kGet)(message, &field);
  }

  /// Adds an element to a repeated field.
  static void put(google::protobuf::Message& message,
                  const google::protobuf::FieldDescriptor& field, T value) {
    const google::protobuf::Reflection& of = *message.GetReflection();
    field.is_repeated() ? (of.*kAdd)(&message, &field, std::move(value))
                        : (of.*kSet)(&message, &field, std::move(value));
  }
};

/// Calls `use` with the FieldAccess of the field, which has no messages. Enumerators are numbers.
template <typename Use>
auto with_access(const google::protobuf::FieldDescriptor& field, Use use) {
  using google::protobuf::FieldDescriptor;
  using google::protobuf::Reflection;
#define CLS_ACCESS(type, name)                                                  \
  use(FieldAccess<type, &Reflection::Get##name, &Reflection::GetRepeated##name, \
                  &Reflection::Set##name, &Reflection::Add##name>())

  switch (field.cpp_type()) {
    case FieldDescriptor::CPPTYPE_INT64:
      return CLS_ACCESS(std::int64_t, Int64);
    case FieldDescriptor::CPPTYPE_UINT32:
      return CLS_ACCESS(std::uint32_t, UInt32);
    case FieldDescriptor::CPPTYPE_UINT64:
      return CLS_ACCESS(std::uint64_t, UInt64);
    case FieldDescriptor::CPPTYPE_DOUBLE:
      return CLS_ACCESS(double, Double);
    case FieldDescriptor::CPPTYPE_FLOAT:
      return CLS_ACCESS(float, Float);
    case FieldDescriptor::CPPTYPE_BOOL:
      return CLS_ACCESS(bool, Bool);
    case FieldDescriptor::CPPTYPE_ENUM:
      return CLS_ACCESS(int, EnumValue);
    case FieldDescriptor::CPPTYPE_STRING:
      return CLS_ACCESS(std::string, String);
    default:
      return CLS_ACCESS(std::int32_t, Int32);
  }
#undef CLS_ACCESS
}

}  // namespace cls::proto
