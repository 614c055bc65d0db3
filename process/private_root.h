// A root folder of its own for the programs of a namespace.
#pragma once

#include "process/command_plan.h"

namespace cls::process {

/// Gives this process, the first of its mount and process namespaces, a root folder with nothing
/// but `files`, and a /proc of its own processes. The working directory becomes "/". Folders that
/// are only read cannot be changed in any way, their permissions and times included. False with
/// errno set on failure; then the process must exit.
bool enter_private_root(const FileAccess& files);

}  // namespace cls::process
