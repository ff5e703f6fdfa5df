// Files, read and written as a whole. Paths are UTF-8.
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>

#include "base/error.h"
#include "base/memory.h"

namespace ts {

// A name as the system takes it: in wide characters on Windows. Throws `fault` where the bytes are no name there;
// elsewhere any are.
std::filesystem::path native_path(const std::string &path, Fault fault);

// Throws Fault::file_open.
Vec<std::byte> read_whole_file(const std::string &path);

// Into a temporary file beside it, which then takes its place. Throws Fault::file_write, and what was
// there stays as it was.
void write_whole_file(const std::string &path, std::span<const char> bytes);

}  // namespace ts
