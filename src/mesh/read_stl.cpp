// STL, binary and ASCII: triangles without shared vertices.
#include <algorithm>
#include <bit>
#include <cstring>
#include <numeric>

#include "mesh/file_size.h"
#include "mesh/read.h"
#include "mesh/text.h"

namespace ts::mesh {
namespace {

constexpr std::size_t header = 80, preamble = header + 4, record = 50, normal = 12;
constexpr std::size_t most_padding = 64;  // bytes of zeros or blanks behind the last record that some writers leave

std::uint32_t little_endian(const std::byte *p) {
  std::uint32_t x = 0;
  for (int i = 3; i >= 0; --i) x = x << 8 | std::to_integer<std::uint32_t>(p[i]);
  return x;
}

std::uint64_t promised(std::span<const std::byte> file) {
  return preamble + std::uint64_t{record} * little_endian(file.data() + header);
}

bool is_padding(std::span<const std::byte> rest) {
  return rest.size() <= most_padding && std::all_of(rest.begin(), rest.end(), [](std::byte b) {
           const int c = std::to_integer<int>(b);
           return c == 0 || c == ' ' || (c >= 9 && c <= 13);
         });
}

RawMesh read_binary(std::span<const std::byte> file, Progress progress) {
  if (file.size() < preamble)
    throw Error(Fault::file_truncated,
                "a binary STL file has at least 84 bytes, this one has " + std::to_string(file.size()));
  const std::size_t count = little_endian(file.data() + header);
  check_count(count, record, file.size() - preamble, "triangles");
  const std::size_t end = static_cast<std::size_t>(promised(file));
  if (!is_padding(file.subspan(end)))
    throw Error(Fault::file_trailing, "byte " + std::to_string(end) + ": the " + std::to_string(count) +
                                          " triangles of the header end here, but " +
                                          std::to_string(file.size() - end) + " more bytes follow");
  RawMesh raw;
  raw.position.resize(3 * count);
  for (std::size_t f = 0; f < count; ++f) {
    if (f % 65536 == 0) progress(static_cast<double>(f) / static_cast<double>(count));
    const std::byte *p = file.data() + preamble + f * record + normal;
    for (std::size_t i = 0; i < 9; ++i)
      raw.position[3 * f + i / 3][static_cast<Eigen::Index>(i % 3)] = std::bit_cast<float>(little_endian(p + 4 * i));
  }
  return raw;
}

void expect(Text &text, std::string_view keyword) {
  const std::string_view word = text.word();
  if (!same_word(word, keyword)) text.fail(word, "'" + std::string(keyword) + "'");
}

void read_facet(Text &text, RawMesh &raw) {
  // The normal is not needed, and some writers put no numbers there.
  std::string_view word = text.word();
  for (int i = 0; i < 4 && !same_word(word, "outer"); ++i) word = text.word();
  if (!same_word(word, "outer")) text.fail(word, "'outer loop'");
  expect(text, "loop");
  for (int corner = 0; corner < 3; ++corner) {
    expect(text, "vertex");
    Vec3 p;
    for (double &x : p) x = text.real(text.word(), "a coordinate");
    raw.position.push_back(p);
  }
  expect(text, "endloop");
  expect(text, "endfacet");
}

RawMesh read_ascii(std::string_view file, Progress progress) {
  Text text(file);
  RawMesh raw;
  expect(text, "solid");
  for (bool open = true; open;) {
    text.next_line();  // the rest of the line is the solid's name
    for (;;) {
      const std::string_view word = text.word();
      if (same_word(word, "endsolid")) break;
      if (!same_word(word, "facet")) text.fail(word, "'facet' or 'endsolid'");
      if (raw.position.size() % 65536 < 3) progress(static_cast<double>(text.at()) / static_cast<double>(file.size()));
      read_facet(text, raw);
    }
    text.next_line();
    open = text.find_word();
    if (open && !same_word(text.word(), "solid")) text.fail(Fault::file_trailing, "text after 'endsolid'");
  }
  return raw;
}

}  // namespace

bool is_complete_stl(std::span<const std::byte> file) {
  return file.size() >= preamble && promised(file) == file.size();
}

// The word "solid" tells nothing: many binary files begin with it. What does is that the size agrees with the count, or
// bytes that no text has.
bool is_binary_stl(std::span<const std::byte> file) {
  if (is_complete_stl(file)) return true;
  const std::string_view begin = as_text(file).substr(0, 4096);
  return std::any_of(begin.begin(), begin.end(), [](char c) { return c >= 0 && c < 9; });
}

RawMesh read_stl(std::span<const std::byte> file, Progress progress) {
  RawMesh raw = is_binary_stl(file) ? read_binary(file, progress) : read_ascii(as_text(file), progress);
  if (raw.position.size() > most_elements) throw Error(Fault::mesh_too_large, "more than 2^30 vertices");
  raw.corner.resize(raw.position.size());
  std::iota(raw.corner.begin(), raw.corner.end(), 0);
  return raw;
}

}  // namespace ts::mesh
