#include "mesh/read.h"

#include <algorithm>
#include <array>

#include "base/whole_file.h"
#include "mesh/text.h"

namespace ts::mesh {
namespace {

// The keywords that an OBJ file can begin with.
bool is_obj_word(std::string_view w) {
  static constexpr std::array<std::string_view, 14> words = {"v", "vt", "vn", "vp",     "f",      "o",      "g",
                                                             "s", "l",  "p",  "usemtl", "mtllib", "cstype", "deg"};
  return std::find(words.begin(), words.end(), w) != words.end();
}

bool is_text(std::string_view begin, bool or_zero) {
  return std::all_of(begin.begin(), begin.end(), [&](char c) {
    return static_cast<unsigned char>(c) >= 32 || (c >= 9 && c <= 13) || (or_zero && c == 0);
  });
}

std::string_view without_byte_order_mark(std::string_view text) {
  return text.starts_with("\xef\xbb\xbf") ? text.substr(3) : text;
}

}  // namespace

Format format_of(std::span<const std::byte> file) {
  const std::string_view all = without_byte_order_mark(as_text(file));
  if (all.starts_with("OFF BINARY")) return Format::off;
  if (all.starts_with("ply\n") || all.starts_with("ply\r")) return Format::ply;
  Text text(all, '#');
  const std::string_view word = text.word();
  // What begins like one of these is one, whatever characters its comments have.
  const bool off = word.ends_with("OFF") && is_text(word, false), obj = is_obj_word(word);
  const bool complete = is_complete_stl(file);
  if (complete || (is_binary_stl(file) && !off && !obj)) {
    // Told from an image or an archive by its header, which is text, or text and zeros, or has the colour of the part.
    const std::string_view header = all.substr(0, 80);
    if (is_text(header, true) || header.find("COLOR=") != header.npos || complete) return Format::stl;
  }
  if (off) return Format::off;
  if (obj) return Format::obj;
  if (same_word(word, "solid") && is_text(all.substr(0, 4096), false)) return Format::stl;
  throw Error(Fault::file_format, file.empty() ? "the file is empty" : "neither STL nor PLY, OBJ or OFF");
}

RawMesh read_mesh(std::span<const std::byte> file, Format format, Progress progress) {
  const Progress reading = progress.part(0, 1, "reading");
  if (format == Format::automatic) format = format_of(file);
  if (as_text(file).starts_with("\xef\xbb\xbf")) file = file.subspan(3);
  switch (format) {
    case Format::stl: return read_stl(file, reading);
    case Format::ply: return read_ply(file, reading);
    case Format::obj: return read_obj(file, reading);
    case Format::off: return read_off(file, reading);
    case Format::automatic: break;
  }
  throw Error(Fault::invalid_argument, "format " + std::to_string(static_cast<int>(format)) + " is not one");
}

RawMesh load_mesh(const std::string &path, Progress progress) {
  const Vec<std::byte> file = read_whole_file(path);
  return read_mesh(file, Format::automatic, progress);
}

}  // namespace ts::mesh
