// Files, read and written as a whole. Paths are UTF-8.
#pragma once

#include <cstddef>
#include <span>
#include <string>

#include "base/memory.h"

namespace ts {

// Throws Fault::file_open.
Vec<std::byte> read_whole_file(const std::string &path);

// Into a temporary file beside it, which then takes its place. Throws Fault::file_write, and what was
// there stays as it was.
void write_whole_file(const std::string &path, std::span<const char> bytes);

}  // namespace ts
