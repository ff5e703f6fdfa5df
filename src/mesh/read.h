// Readers: STL, PLY, OBJ and OFF to a raw mesh. Numbers are read without regard to the locale; a wrong file is refused
// with the line or the byte at which it goes wrong.
#pragma once

#include <span>
#include <string>

#include "base/progress.h"
#include "mesh/raw_mesh.h"

namespace ts::mesh {

enum class Format { automatic, stl, ply, obj, off };

// Throws file_format, file_truncated, file_trailing, file_count, file_syntax, mesh_too_large, cancelled.
RawMesh read_mesh(std::span<const std::byte> file, Format format, Progress progress);

// The format is told from the content. `path` is UTF-8. Throws file_open besides.
RawMesh load_mesh(const std::string &path, Progress progress = {});

// The format the content looks like; file_format if none.
Format format_of(std::span<const std::byte> file);

// One reader a format.
RawMesh read_stl(std::span<const std::byte> file, Progress progress);
RawMesh read_ply(std::span<const std::byte> file, Progress progress);
RawMesh read_obj(std::span<const std::byte> file, Progress progress);
RawMesh read_off(std::span<const std::byte> file, Progress progress);

// Whether an STL file is binary, whatever its header says.
bool is_binary_stl(std::span<const std::byte> file);
bool is_complete_stl(std::span<const std::byte> file);  // binary, and of the size that its count promises

}  // namespace ts::mesh
