// SPDX-License-Identifier: Apache-2.0
#include "damage.h"

#include <algorithm>
#include <cstring>
#include <limits>
#include <vector>

namespace {

using Random = std::mt19937_64;

std::size_t below(Random &random, std::size_t n) {
  return n == 0 ? 0 : static_cast<std::size_t>(random() % n);
}

struct Piece {
  std::size_t at, size;
};
Piece any_piece(const std::string &s, Random &random) {
  const std::size_t at = below(random, s.size() + 1);
  return {at, std::min(s.size() - at, 1 + below(random, 1 + below(random, s.size())))};
}

// Lines of text; whole files of one line have their commas for line ends.
std::vector<Piece> lines_of(const std::string &s) {
  const char end = std::count(s.begin(), s.end(), '\n') > 2 ? '\n' : ',';
  std::vector<Piece> lines;
  for (std::size_t at = 0; at < s.size();) {
    const std::size_t next = std::min(s.find(end, at), s.size() - 1) + 1;
    lines.push_back({at, next - at});
    at = next;
  }
  return lines;
}

bool in_number(char c) {
  return (c >= '0' && c <= '9') || c == '.' || c == '-' || c == '+';
}
// The numbers of a text, up to `end`.
std::vector<Piece> numbers_of(const std::string &s, std::size_t end) {
  std::vector<Piece> numbers;
  for (std::size_t at = 0; at < std::min(end, s.size()); ++at) {
    if (!in_number(s[at])) continue;
    const std::size_t from = at;
    while (at < s.size() && (in_number(s[at]) || s[at] == 'e' || s[at] == 'E')) ++at;
    numbers.push_back({from, at - from});
  }
  return numbers;
}

void cut_off(std::string &s, Random &random) {
  s.resize(below(random, s.size() + 1));
}
void turn_bits(std::string &s, Random &random) {
  if (s.empty()) return;
  for (std::size_t k = 1 + below(random, 8); k > 0; --k)
    s[below(random, s.size())] ^= static_cast<char>(1 << below(random, 8));
}
void change_bytes(std::string &s, Random &random) {
  if (s.empty()) return;
  for (std::size_t k = 1 + below(random, 16); k > 0; --k) s[below(random, s.size())] = static_cast<char>(random());
}
void swap_pieces(std::string &s, Random &random) {
  const Piece a = any_piece(s, random);
  const std::size_t b = below(random, s.size() + 1), size = std::min(a.size, s.size() - b);
  const std::string kept = s.substr(a.at, size);
  s.replace(a.at, size, s.substr(b, size));
  s.replace(b, size, kept);
}
void repeat_piece(std::string &s, Random &random) {
  const Piece a = any_piece(s, random);
  s.insert(below(random, s.size() + 1), s.substr(a.at, a.size));
}
void leave_out_piece(std::string &s, Random &random) {
  const Piece a = any_piece(s, random);
  s.erase(a.at, a.size);
}
void add_behind(std::string &s, Random &random) {
  static const char *const more[] = {"\n", "\n\n\n ", "end", "\r\n0 0 0\n", "}"};
  const std::size_t kind = below(random, 7);
  if (kind < 5)
    s += more[kind];
  else
    s.append(1 + below(random, 200), kind == 5 ? '\0' : static_cast<char>(random()));
}

void change_lines(std::string &s, Random &random) {
  const auto lines = lines_of(s);
  if (lines.empty()) return;
  const Piece a = lines[below(random, lines.size())], b = lines[below(random, lines.size())];
  const std::string text = s.substr(a.at, a.size);
  switch (below(random, 3)) {
    case 0: s.erase(a.at, a.size); break;
    case 1: s.insert(b.at, text); break;
    default: s.replace(b.at, b.size, text); break;
  }
}
void change_line_ends(std::string &s, Random &random) {
  static const char *const ends[] = {"\r\n", "\r", " ", "\n\n", ""};
  const char *const end = ends[below(random, 5)];
  const bool all = below(random, 2) == 0;
  std::string changed;
  for (const char c : s)
    if (c == '\n' && (all || below(random, 10) == 0))
      changed += end;
    else
      changed += c;
  s = changed;
}

std::string odd_number(const std::string &was, Random &random) {
  static const char *const odd[] = {"nan",        "-nan",
                                    "inf",        "-inf",
                                    "1e400",      "1e308",
                                    "-1e38",      "1e-320",
                                    "",           "-",
                                    "--1",        "1.5.2",
                                    "0x10",       "4294967295",
                                    "4294967296", "-1",
                                    "2147483647", "1073741825",
                                    "0",          "99999999999999999999",
                                    "1,5",        "18446744073709551615"};
  const std::size_t kind = below(random, std::size(odd) + 2);
  if (kind < std::size(odd)) return odd[kind];
  return kind == std::size(odd) ? was + "0" : std::string(1000, '9');
}
void change_number(std::string &s, Random &random, std::size_t end) {
  const auto numbers = numbers_of(s, end);
  if (numbers.empty()) return;
  const Piece n = numbers[below(random, numbers.size())];
  s.replace(n.at, n.size, odd_number(s.substr(n.at, n.size), random));
}

template <class T>
void put(std::string &s, std::size_t at, T value, bool big) {
  if (at + sizeof value > s.size()) return;
  char bytes[sizeof value];
  std::memcpy(bytes, &value, sizeof value);
  if (big) std::reverse(bytes, bytes + sizeof value);
  s.replace(at, sizeof value, bytes, sizeof value);
}
// A number among the bytes: one that is none, or far too large.
void change_binary_number(std::string &s, Random &random, bool big) {
  using Float = std::numeric_limits<float>;
  const float odd[] = {Float::quiet_NaN(), Float::infinity(), -Float::infinity(), Float::max(), Float::denorm_min()};
  const std::size_t at = below(random, s.size() + 1);
  if (below(random, 2) == 0)
    put(s, at, odd[below(random, std::size(odd))], big);
  else
    put(s, at, static_cast<std::uint32_t>(below(random, 2) == 0 ? random() : random() % 1000), big);
}

// The counts that the file begins with.
void change_counts(std::string &s, Random &random, const GoodFile &file) {
  constexpr std::size_t stl_count = 80;
  if (file.format == TS_FORMAT_STL && file.coding != Coding::text) {
    const std::uint32_t counts[] = {
        0, file.faces + 1, file.faces - 1, 0x7fffffff, 0xffffffff, 0x55555556, static_cast<std::uint32_t>(random())};
    put(s, stl_count, counts[below(random, std::size(counts))], false);
    return;
  }
  const std::size_t header = s.find("end_header");
  change_number(s, random, header == std::string::npos ? 40 : header);
}

void damage_once(std::string &s, Random &random, const GoodFile &file) {
  const bool text = file.coding == Coding::text;
  switch (below(random, 12)) {
    case 0: return cut_off(s, random);
    case 1: return turn_bits(s, random);
    case 2: return change_bytes(s, random);
    case 3: return swap_pieces(s, random);
    case 4: return repeat_piece(s, random);
    case 5: return leave_out_piece(s, random);
    case 6: return add_behind(s, random);
    case 7:
    case 8: return change_counts(s, random, file);
    case 9: return text ? change_lines(s, random) : turn_bits(s, random);
    case 10:
      return text ? change_line_ends(s, random) : change_binary_number(s, random, file.coding == Coding::big_endian);
    default:
      return text ? change_number(s, random, s.size())
                  : change_binary_number(s, random, file.coding == Coding::big_endian);
  }
}

}  // namespace

std::string damaged(const GoodFile &file, std::mt19937_64 &random) {
  std::string bytes = file.bytes;
  for (std::size_t k = 1 + below(random, 3); k > 0; --k) damage_once(bytes, random, file);
  return bytes;
}
