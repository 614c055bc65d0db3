// Shows a file in the user's browser.
#pragma once

#include <filesystem>
#include <memory>
#include <string>

#include "process/scratch_folder.h"

namespace cls::cli {

/// The file as a URL: file:///...
std::string file_url(const std::filesystem::path& file);

/// Asks the desktop to show a URL; false without a display or without xdg-open. Does not wait.
bool open_in_browser(const std::string& url);

/// The same for a URL that is a secret, which every program would see among the arguments of the
/// browser: that opens a file which only this user can read and which leads on. The file lasts as
/// long as the result; null: nothing was opened.
std::unique_ptr<process::ScratchFolder> open_privately(const std::string& url);

}  // namespace cls::cli
