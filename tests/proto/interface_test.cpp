// The compiled interface compared with its specification: names, numbers, types, methods.
#include <google/protobuf/descriptor.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "proto/playmaker.grpc.pb.h"
#include "proto/playmaker.pb.h"
#include "tests/support/files.h"

namespace cls::tests {
namespace {

namespace pb = google::protobuf;

using Lines = std::multiset<std::string>;

std::string plain_type(const pb::FieldDescriptor& field) {
  if (field.message_type() != nullptr) return field.message_type()->name();
  if (field.enum_type() != nullptr) return field.enum_type()->name();
  return field.type_name();
}

std::string type_of(const pb::FieldDescriptor& field) {
  if (field.is_map()) {
    const pb::Descriptor& entry = *field.message_type();
    return "map<" + plain_type(*entry.map_key()) + "," + plain_type(*entry.map_value()) + ">";
  }

  if (field.is_repeated()) {
    const bool unpacked = field.is_packable() && !field.is_packed();
    return (unpacked ? "unpacked repeated " : "repeated ") + plain_type(field);
  }
  return (field.has_optional_keyword() ? "optional " : "") + plain_type(field);
}

std::string oneof_of(const pb::FieldDescriptor& field) {
  const pb::OneofDescriptor* oneof = field.real_containing_oneof();
  return oneof == nullptr ? "" : " oneof " + oneof->name();
}

void list_message(const pb::Descriptor& message, Lines& lines) {
  lines.insert("message " + message.name());

  for (int i = 0; i < message.field_count(); ++i) {
    const pb::FieldDescriptor& field = *message.field(i);
    lines.insert("field " + message.name() + "." + field.name() + " " +
                 std::to_string(field.number()) + " " + type_of(field) + oneof_of(field));
  }

  for (int i = 0; i < message.nested_type_count(); ++i) {
    const pb::Descriptor& nested = *message.nested_type(i);
    if (!nested.options().map_entry()) lines.insert("nested message " + nested.full_name());
  }
  for (int i = 0; i < message.enum_type_count(); ++i) {
    lines.insert("nested enum " + message.enum_type(i)->full_name());
  }
}

void list_enum(const pb::EnumDescriptor& type, Lines& lines) {
  lines.insert("enum " + type.name());
  for (int i = 0; i < type.value_count(); ++i) {
    const pb::EnumValueDescriptor& value = *type.value(i);
    lines.insert("value " + type.name() + "." + value.name() + " " +
                 std::to_string(value.number()));
  }
}

void list_service(const pb::ServiceDescriptor& service, Lines& lines) {
  for (int i = 0; i < service.method_count(); ++i) {
    const pb::MethodDescriptor& method = *service.method(i);
    const bool streams = method.client_streaming() || method.server_streaming();
    lines.insert("rpc " + service.name() + "." + method.name() + " " + method.input_type()->name() +
                 " " + method.output_type()->name() + (streams ? " stream" : ""));
  }
}

Lines list_compiled(const pb::FileDescriptor& file) {
  Lines lines;
  lines.insert(std::string("syntax ") + pb::FileDescriptor::SyntaxName(file.syntax()));
  lines.insert("package " + file.package());
  for (int i = 0; i < file.message_type_count(); ++i) list_message(*file.message_type(i), lines);
  for (int i = 0; i < file.enum_type_count(); ++i) list_enum(*file.enum_type(i), lines);
  for (int i = 0; i < file.service_count(); ++i) list_service(*file.service(i), lines);
  return lines;
}

Lines list_specified() {
  Lines lines;
  std::istringstream text(read_file(fixture("proto/playmaker-1.10.txt")));
  for (std::string line; std::getline(text, line);) {
    if (!line.empty() && line[0] != '#') lines.insert(line);
  }
  return lines;
}

/// Lines that are in `left` but not in `right`.
std::string missing(const Lines& left, const Lines& right) {
  std::vector<std::string> only_left;
  std::set_difference(left.begin(), left.end(), right.begin(), right.end(),
                      std::back_inserter(only_left));
  std::string text;
  for (const std::string& line : only_left) text += line + "\n";
  return text;
}

TEST(PlaymakerInterface, MatchesSpecification) {
  const Lines compiled = list_compiled(*protos::Empty::descriptor()->file());
  const Lines specified = list_specified();
  EXPECT_EQ(missing(specified, compiled), "") << "specified, not compiled";
  EXPECT_EQ(missing(compiled, specified), "") << "compiled, not specified";
}

TEST(PlaymakerInterface, SpecificationIsComplete) {
  const Lines specified = list_specified();
  const auto count = [&](const std::string& word) {
    return std::count_if(specified.begin(), specified.end(),
                         [&](const std::string& line) { return line.starts_with(word); });
  };

  EXPECT_EQ(count("rpc "), 10);
  EXPECT_EQ(count("enum "), 9);
  EXPECT_EQ(count("value "), 86);
  EXPECT_EQ(count("message "), 145);
  EXPECT_EQ(count("field "), 837);
}

TEST(PlaymakerInterface, HasServiceNameOfUpstream) {
  EXPECT_STREQ(protos::Game::service_full_name(), "protos.Game");
}

}  // namespace
}  // namespace cls::tests
