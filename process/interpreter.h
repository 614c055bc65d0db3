// The files that the kernel needs to start a program: its interpreter or loader.
#pragma once

#include <filesystem>
#include <string>

namespace cls::process {

/// Why a program that exists cannot be started: the interpreter of its first line or the loader of
/// its machine code is missing, or the first line ends with a carriage return. The kernel reports
/// all of them as "No such file or directory". Empty: nothing is missing.
std::string missing_interpreter(const std::filesystem::path& program);

}  // namespace cls::process
