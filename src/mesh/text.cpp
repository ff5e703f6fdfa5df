#include "mesh/text.h"

#include <algorithm>
#include <charconv>
#include <limits>

namespace ts::mesh {
namespace {

bool is_break(char c) {
  return c == '\n' || c == '\r';
}
bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

// What a message may show of a file's text.
std::string shown(std::string_view word) {
  std::string s;
  for (const char c : word.substr(0, 40)) s += c >= ' ' && c < 127 ? c : '?';
  return "'" + s + (word.size() > 40 ? "...'" : "'");
}

// from_chars takes no plus sign.
std::string_view without_plus(std::string_view w) {
  return w.size() > 1 && w[0] == '+' && w[1] != '-' && w[1] != '+' ? w.substr(1) : w;
}

}  // namespace

bool same_word(std::string_view a, std::string_view lower_case) {
  return std::equal(a.begin(), a.end(), lower_case.begin(), lower_case.end(),
                    [](char c, char l) { return (c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c) == l; });
}

void Text::skip_blanks() {
  while (at_ < all_.size()) {
    if (is_blank(all_[at_])) {
      ++at_;
    } else if (all_[at_] == '\\' && at_ + 1 < all_.size() && is_break(all_[at_ + 1])) {
      at_ += all_.substr(at_ + 1, 2) == "\r\n" ? 3 : 2;
    } else {
      break;
    }
  }
  if (comment_ && at_ < all_.size() && all_[at_] == comment_)
    while (at_ < all_.size() && !is_break(all_[at_])) ++at_;
}

std::string_view Text::word_on_line() {
  skip_blanks();
  const std::size_t begin = at_;
  while (at_ < all_.size() && !is_break(all_[at_]) && !is_blank(all_[at_]) && !(comment_ && all_[at_] == comment_)) {
    if (all_[at_] == '\\' && at_ + 1 < all_.size() && is_break(all_[at_ + 1])) break;
    ++at_;
  }
  return all_.substr(begin, at_ - begin);
}

bool Text::find_word() {
  for (;;) {
    skip_blanks();
    if (at_ == all_.size()) return false;
    if (!is_break(all_[at_])) return true;
    ++at_;
  }
}

std::string_view Text::word() {
  return find_word() ? word_on_line() : std::string_view();
}

bool Text::next_line() {
  while (at_ < all_.size() && !is_break(all_[at_])) ++at_;
  if (at_ < all_.size()) at_ += all_.substr(at_, 2) == "\r\n" ? 2 : 1;
  return at_ < all_.size();
}

std::string_view Text::rest_of_line() {
  const std::size_t begin = at_;
  while (at_ < all_.size() && !is_break(all_[at_])) ++at_;
  std::string_view line = all_.substr(begin, at_ - begin);
  while (!line.empty() && is_blank(line.back())) line.remove_suffix(1);
  return line;
}

double Text::real(std::string_view word, const char *what) const {
  const std::string_view w = without_plus(word);
  double x = 0;
  const auto [end, code] = std::from_chars(w.data(), w.data() + w.size(), x);
  if (w.empty() || end != w.data() + w.size()) fail(word, what);
  if (code == std::errc::result_out_of_range) {
    // Too small is 0, too large infinite; which of the two, only the text can tell.
    const bool small = w.find("e-") != w.npos || w.find("E-") != w.npos || w.starts_with("0.") || w.starts_with("-0.");
    return small ? 0 : std::numeric_limits<double>::infinity();
  }
  if (code != std::errc()) fail(word, what);
  return x;
}

long long Text::integer(std::string_view word, const char *what) const {
  const std::string_view w = without_plus(word);
  long long i = 0;
  const auto [end, code] = std::from_chars(w.data(), w.data() + w.size(), i);
  if (code != std::errc() || end != w.data() + w.size()) fail(word, what);
  return i;
}

void Text::fail(std::string_view found, const std::string &expected) const {
  if (found.empty() && at_ == all_.size())
    fail(Fault::file_truncated, "the file ends where " + expected + " is expected");
  fail(Fault::file_syntax,
       "expected " + expected + ", found " + (found.empty() ? "the end of the line" : shown(found)));
}

void Text::fail(Fault fault, const std::string &what) const {
  // Counted only now: \n, \r\n and \r each end a line.
  std::size_t line = 1;
  for (std::size_t i = 0; i < at_; ++i)
    line += all_[i] == '\n' || (all_[i] == '\r' && !(i + 1 < all_.size() && all_[i + 1] == '\n'));
  throw Error(fault, "line " + std::to_string(line) + ": " + what);
}

}  // namespace ts::mesh
