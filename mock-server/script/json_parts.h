// Parts of JSON documents that are optional, or lists.
#pragma once

#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/result.h"
#include "base/text/json_document.h"
#include "proto/rpc.h"

namespace cls::mock_server {

/// Sets `member` to what `parse` makes of the value of `key`, if there is one.
template <typename Member, typename Parse>
base::Result<void> read_key(const base::JsonValue& json, std::string_view key, Member& member,
                            Parse parse) {
  if (!json.has(key)) return {};
  TRY_INIT(member, parse(json[key]));
  return {};
}

template <typename Parse>
using Parsed =
    std::remove_cvref_t<decltype(*std::declval<Parse>()(std::declval<const base::JsonValue&>()))>;

/// The elements of a list, each as `parse` reads it; `error` says what must be a list.
template <typename Parse>
base::Result<std::vector<Parsed<Parse>>> list_of(const base::JsonValue& json, Parse parse,
                                                 std::string_view error = "must be a list") {
  if (!json.is_array()) return json.error(error);
  std::vector<Parsed<Parse>> list;
  for (std::size_t i = 0; i < json.size(); ++i) {
    TRY_INIT(auto element, parse(json[i]));
    list.push_back(std::move(element));
  }
  return list;
}

/// One element alone, as a list.
template <typename Parse>
base::Result<std::vector<Parsed<Parse>>> one_of(const base::JsonValue& json, Parse parse) {
  TRY_INIT(auto element, parse(json));
  return std::vector<Parsed<Parse>>{std::move(element)};
}

/// A list, or one element alone.
template <typename Parse>
base::Result<std::vector<Parsed<Parse>>> one_or_more(const base::JsonValue& json, Parse parse) {
  return json.is_array() ? list_of(json, parse) : one_of(json, parse);
}

/// The name of a call of one agent.
inline base::Result<proto::Rpc> parse_rpc(const base::JsonValue& json) {
  TRY_INIT(const auto name, json.one_of(proto::agent_rpc_names()));
  return *proto::rpc_from_name(name);
}

inline base::Result<std::string> parse_text(const base::JsonValue& json) { return json.string(); }

}  // namespace cls::mock_server
