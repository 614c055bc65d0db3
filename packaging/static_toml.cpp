// The code of toml++, for static programs: Debian has it as a shared library without an archive.
#define TOML_HEADER_ONLY 0
#define TOML_IMPLEMENTATION
#include <toml++/toml.h>
