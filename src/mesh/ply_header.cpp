#include "mesh/ply_header.h"

#include <algorithm>
#include <utility>

namespace ts::mesh {
namespace {

PlyType type_named(std::string_view word, const Text &text) {
  static constexpr std::pair<std::string_view, PlyType> names[] = {
      {"char", PlyType::int8},      {"int8", PlyType::int8},       {"uchar", PlyType::uint8},
      {"uint8", PlyType::uint8},    {"short", PlyType::int16},     {"int16", PlyType::int16},
      {"ushort", PlyType::uint16},  {"uint16", PlyType::uint16},   {"int", PlyType::int32},
      {"int32", PlyType::int32},    {"uint", PlyType::uint32},     {"uint32", PlyType::uint32},
      {"float", PlyType::float32},  {"float32", PlyType::float32}, {"double", PlyType::float64},
      {"float64", PlyType::float64}};
  for (const auto &[name, type] : names)
    if (word == name) return type;
  text.fail(word, "a PLY type");
}

PlyCoding coding_named(std::string_view word, const Text &text) {
  if (word == "ascii") return PlyCoding::ascii;
  if (word == "binary_little_endian") return PlyCoding::little_endian;
  if (word == "binary_big_endian") return PlyCoding::big_endian;
  text.fail(word, "'ascii', 'binary_little_endian' or 'binary_big_endian'");
}

PlyProperty read_property(Text &text) {
  PlyProperty p;
  std::string_view word = text.word_on_line();
  if (word == "list") {
    p.is_list = true;
    p.count_type = type_named(text.word_on_line(), text);
    if (!is_integer(p.count_type)) text.fail(Fault::file_format, "a list whose count is not an integer");
    word = text.word_on_line();
  }
  p.type = type_named(word, text);
  p.name = text.word_on_line();
  if (p.name.empty()) text.fail("", "the name of a property");
  return p;
}

PlyElement read_element(Text &text) {
  PlyElement e;
  e.name = text.word_on_line();
  const long long count = text.integer(text.word_on_line(), "a number of elements");
  if (count < 0) text.fail(Fault::file_count, "a negative number of elements");
  e.count = static_cast<std::uint64_t>(count);
  return e;
}

}  // namespace

const PlyProperty *PlyElement::find(std::string_view property) const {
  const auto p =
      std::find_if(properties.begin(), properties.end(), [&](const PlyProperty &q) { return q.name == property; });
  return p == properties.end() ? nullptr : &*p;
}

bool PlyElement::has_list() const {
  return std::any_of(properties.begin(), properties.end(), [](const PlyProperty &p) { return p.is_list; });
}

std::size_t PlyElement::least_bytes(PlyCoding coding) const {
  if (coding == PlyCoding::ascii) return 2 * properties.size();  // a digit and a blank each
  std::size_t bytes = 0;
  for (const PlyProperty &p : properties) bytes += size_of(p.is_list ? p.count_type : p.type);
  return bytes;
}

PlyHeader read_ply_header(Text &text) {
  PlyHeader header;
  if (text.word_on_line() != "ply") text.fail(Fault::file_format, "not a PLY file");
  bool has_coding = false;
  while (text.next_line()) {
    const std::string_view word = text.word_on_line();
    if (word == "format") {
      header.coding = coding_named(text.word_on_line(), text);
      has_coding = true;
    } else if (word == "element") {
      header.elements.push_back(read_element(text));
    } else if (word == "property") {
      if (header.elements.empty()) text.fail(Fault::file_syntax, "a property before the first element");
      header.elements.back().properties.push_back(read_property(text));
    } else if (word == "end_header") {
      if (!has_coding) text.fail(Fault::file_syntax, "no 'format' line before 'end_header'");
      text.next_line();
      return header;
    } else if (word != "comment" && word != "obj_info" && !word.empty()) {
      text.fail(word, "a line of a PLY header");
    }
  }
  text.fail(Fault::file_truncated, "the file ends in its header");
}

}  // namespace ts::mesh
