// Shows a file in the user's browser.
#pragma once

#include <filesystem>
#include <string>

namespace cls::cli {

/// The file as a URL: file:///...
std::string file_url(const std::filesystem::path& file);

/// Asks the desktop to show a URL; false without a display or without xdg-open. Does not wait.
bool open_in_browser(const std::string& url);

}  // namespace cls::cli
