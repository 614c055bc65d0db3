// Parameter messages from the parameter tables.
#include "soccer/messages/parameter_message.h"

#include <variant>

#include "soccer/messages/sense_groups.h"
#include "soccer/protocol/scanner.h"

namespace cls::soccer {
namespace {

void append_value(double value, std::string& out) { base::append_g(value, out); }
void append_value(int value, std::string& out) { base::append_int(value, out); }
void append_value(bool value, std::string& out) { out.push_back(value ? '1' : '0'); }
void append_value(const std::string& value, std::string& out) {
  out.append("\"").append(value).push_back('"');
}

bool read_value(Scanner& in, double& value) { return in.number(value); }
bool read_value(Scanner& in, int& value) { return in.any_integer(value); }
// Servers write 0 and 1, rcgverconv writes words.
bool read_value(Scanner& in, bool& value) {
  value = in.optional("1") || in.optional("true");
  return value || in.optional("0") || in.optional("false") || in.fail("0 or 1");
}
// Strings are not escaped: they end at the quote before the next parenthesis.
bool read_value(Scanner& in, std::string& value) {
  if (!in.literal("\"")) return false;
  const std::size_t length = in.rest().find("\")");
  if (length == std::string_view::npos) return in.fail("a closing quote");
  const std::string_view text = in.rest().substr(0, length);
  value = text;
  return in.literal(text) && in.literal("\"");
}

bool skip_value(Scanner& in) {
  std::string ignored;
  std::string_view token;
  return in.peek() == '"' ? read_value(in, ignored) : in.token(token);
}

template <typename Params>
void format_all(std::string_view start, const Params& params, const ParameterTable<Params>& table,
                int version, std::string& out) {
  out.append(start);
  for (const Parameter<Params>& row : table) {
    if (row.since > version) continue;
    out.append("(").append(row.name).push_back(' ');
    std::visit([&](auto member) { append_value(params.*member, out); }, row.member);
    out.push_back(')');
  }

  out.push_back(')');
}

template <typename Params>
bool read_pair(Scanner& in, const ParameterTable<Params>& table, Params& out) {
  std::string_view name;
  if (!(in.literal("(") && in.token(name) && in.literal(" "))) return false;

  const Parameter<Params>* row = find_parameter(table, name);
  const bool read =
      row == nullptr
          ? skip_value(in)
          : std::visit([&](auto member) { return read_value(in, out.*member); }, row->member);
  return read && in.literal(")");
}

template <typename Params>
base::Result<void> parse_all(std::string_view start, std::string_view message,
                             const ParameterTable<Params>& table, Params& out) {
  Scanner in(message);
  bool ok = in.literal(start);
  while (ok && in.peek() == '(') ok = read_pair(in, table, out);

  return in.finish(ok && in.literal(")"), start.substr(1, start.size() - 2));
}

constexpr std::string_view kServerParam = "(server_param ";
constexpr std::string_view kPlayerParam = "(player_param ";
constexpr std::string_view kPlayerType = "(player_type ";

}  // namespace

void format(const ServerParams& params, int version, std::string& out) {
  format_all(kServerParam, params, server_param_table(), version, out);
}
void format(const PlayerParams& params, int version, std::string& out) {
  format_all(kPlayerParam, params, player_param_table(), version, out);
}
void format(const PlayerType& type, int version, std::string& out) {
  format_all(kPlayerType, type, player_type_table(), version, out);
}

base::Result<void> parse(std::string_view message, ServerParams& out) {
  return parse_all(kServerParam, message, server_param_table(), out);
}
base::Result<void> parse(std::string_view message, PlayerParams& out) {
  return parse_all(kPlayerParam, message, player_param_table(), out);
}
base::Result<void> parse(std::string_view message, PlayerType& out) {
  return parse_all(kPlayerType, message, player_type_table(), out);
}

}  // namespace cls::soccer
