// Wavefront OBJ: v and f; all else is passed over.
#include "mesh/file_size.h"
#include "mesh/read.h"
#include "mesh/text.h"

namespace ts::mesh {
namespace {

void read_vertex(Text &text, RawMesh &raw) {
  Vec3 p;
  for (double &x : p) x = text.real(text.word_on_line(), "a coordinate");
  raw.position.push_back(p);
}

// "v", "v/vt", "v//vn" or "v/vt/vn": 1-based, or counted back from the last vertex so far.
Index corner(const Text &text, std::string_view word, const RawMesh &raw) {
  const long long i = text.integer(word.substr(0, word.find('/')), "a vertex index");
  const auto so_far = static_cast<long long>(raw.position.size());
  if (i == 0 || i < -so_far || i > static_cast<long long>(none))
    text.fail(Fault::mesh_index_range, "there is no vertex " + std::to_string(i));
  return static_cast<Index>(i > 0 ? i - 1 : so_far + i);
}

void read_obj_face(Text &text, RawMesh &raw) {
  int corners = 0;
  for (std::string_view word = text.word_on_line(); !word.empty(); word = text.word_on_line(), ++corners)
    raw.corner.push_back(corner(text, word, raw));
  if (corners < 3) text.fail("", "another vertex index of a face");
  raw.face_start.push_back(static_cast<Index>(raw.corner.size()));
}

}  // namespace

RawMesh read_obj(std::span<const std::byte> file, Progress progress) {
  Text text(as_text(file), '#');
  RawMesh raw;
  raw.face_start.push_back(0);
  for (std::size_t statement = 0; text.find_word(); ++statement) {
    if (statement % 65536 == 0) progress(static_cast<double>(text.at()) / static_cast<double>(file.size()));
    const std::string_view word = text.word_on_line();
    if (word == "v")
      read_vertex(text, raw);
    else if (word == "f")
      read_obj_face(text, raw);
    // Not next_line: a statement may go on behind a backslash.
    while (!text.word_on_line().empty()) {
    }
    if (raw.position.size() > most_elements || raw.corner.size() > 3 * most_elements)
      text.fail(Fault::mesh_too_large, "more than 2^30 vertices or faces");
  }
  if (raw.position.empty()) throw Error(Fault::file_format, "no vertex: not an OBJ file");
  // A file may be cut off between two faces without a trace; a name that no vertex has is all that can show it.
  return raw;
}

}  // namespace ts::mesh
