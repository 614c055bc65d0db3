// The frame of all HTML reports: style, elements, tables.
#pragma once

#include <string>
#include <string_view>

#include "base/text/table.h"

namespace cls::viewer {

/// The style sheet: light, or dark where the reader's browser prefers it, and for print.
std::string_view report_style();

/// An element with escaped text; empty without text. `kind` is its class.
std::string text_element(std::string_view tag, std::string_view text, std::string_view kind = {});

/// Shell commands, in an element that scrolls and that keys reach.
std::string commands_box(std::string_view commands);

/// A chart in an element that scrolls where the window is too narrow for its text. `label` names
/// it.
std::string chart_box(std::string_view label, std::string_view svg);

/// The table with its caption in an element that scrolls. `kind` is the class of that: "scroll",
/// "scroll dense" or "scroll long".
std::string table_box(std::string_view title, const base::Table& table,
                      std::string_view kind = "scroll");

/// A heading, the table, and a note; empty for a table without columns.
std::string table_section(std::string_view title, const base::Table& table,
                          std::string_view note = {}, std::string_view kind = "scroll");

}  // namespace cls::viewer
