// OFF, ASCII: a header, the counts, one vertex and then one face a line. Columns of colours and normals are passed
// over.
#include "mesh/file_size.h"
#include "mesh/read.h"
#include "mesh/text.h"

namespace ts::mesh {
namespace {

// [ST][C][N]OFF; 4OFF and nOFF have other coordinates than x, y, z.
void check_header(std::string_view word, const Text &text) {
  std::string_view prefix = word;
  if (!prefix.ends_with("OFF")) text.fail(Fault::file_format, "not an OFF file");
  prefix.remove_suffix(3);
  for (const std::string_view part : {"ST", "C", "N"})
    if (prefix.starts_with(part)) prefix.remove_prefix(part.size());
  if (!prefix.empty())
    text.fail(Fault::file_format, "the OFF variant '" + std::string(word.substr(0, 16)) + "' is not read");
}

std::uint64_t count(Text &text, const char *what) {
  const std::string_view word = text.word();
  if (same_word(word, "binary")) text.fail(Fault::file_format, "binary OFF is not read");
  const long long n = text.integer(word, what);
  if (n < 0) text.fail(Fault::file_count, std::string(what) + " is negative");
  return static_cast<std::uint64_t>(n);
}

void read_off_face(Text &text, RawMesh &raw) {
  text.find_word();
  const long long corners = text.integer(text.word_on_line(), "a number of corners");
  if (corners < 0) text.fail(Fault::file_count, "a negative number of corners");
  check_count(static_cast<std::uint64_t>(corners), 2, text.left() + 1, "corners of a face");
  for (long long k = 0; k < corners; ++k) {
    const long long v = text.integer(text.word_on_line(), "a vertex index");
    if (v < 0 || v >= none) text.fail(Fault::mesh_index_range, "there is no vertex " + std::to_string(v));
    raw.corner.push_back(static_cast<Index>(v));
  }
  if (raw.corner.size() > 3 * most_elements) text.fail(Fault::mesh_too_large, "more than 3 * 2^30 corners");
  raw.face_start.push_back(static_cast<Index>(raw.corner.size()));
  text.next_line();
}

}  // namespace

RawMesh read_off(std::span<const std::byte> file, Progress progress) {
  Text text(as_text(file), '#');
  check_header(text.word(), text);
  const std::uint64_t vertices = count(text, "the number of vertices"), faces = count(text, "the number of faces");
  text.next_line();  // the number of edges is often wrong, and not needed
  check_count(vertices, 6, text.left() + 1, "vertices");
  check_count(faces, 2, text.left() + 1 - 6 * vertices, "faces");
  RawMesh raw;
  raw.position.resize(static_cast<std::size_t>(vertices));
  for (std::size_t v = 0; v < vertices; ++v) {
    if (v % 65536 == 0) progress(0.5 * static_cast<double>(v) / static_cast<double>(vertices));
    text.find_word();
    for (double &x : raw.position[v]) x = text.real(text.word_on_line(), "a coordinate");
    text.next_line();
  }
  raw.corner.reserve(static_cast<std::size_t>(3 * faces));
  raw.face_start.reserve(static_cast<std::size_t>(faces + 1));
  raw.face_start.push_back(0);
  for (std::size_t f = 0; f < faces; ++f) {
    if (f % 65536 == 0) progress(0.5 + 0.5 * static_cast<double>(f) / static_cast<double>(faces));
    read_off_face(text, raw);
  }
  if (text.find_word()) text.fail(Fault::file_trailing, "text after the last face of the header");
  return raw;
}

}  // namespace ts::mesh
