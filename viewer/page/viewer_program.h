// The program in a page: viewer/web, joined and embedded.
#pragma once

#include <string_view>

namespace cls::viewer {

/// JavaScript and CSS between the tags of a page; neither contains a closing tag.
std::string_view viewer_script();
/// The viewer script for pages that may have texts and drawings of Playmakers.
std::string_view drawings_script();
/// The viewer script with the decision debugger, for pages with recorded decisions.
std::string_view debugger_script();
/// The viewer script for two matches side by side.
std::string_view comparison_script();
std::string_view viewer_style();
/// The program of the list of matches.
std::string_view list_script();
/// The program of the page for spectators.
std::string_view spectator_script();

}  // namespace cls::viewer
