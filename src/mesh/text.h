// Reading words and numbers of a text file, with the line for messages.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "base/error.h"

namespace ts::mesh {

inline std::string_view as_text(std::span<const std::byte> file) {
  return {reinterpret_cast<const char *>(file.data()), file.size()};
}

class Text {
 public:
  // `comment`: from this character to the end of the line is nothing; 0 = no comments.
  explicit Text(std::string_view all, char comment = 0) : all_(all), comment_(comment) {}

  std::size_t at() const { return at_; }
  std::size_t left() const { return all_.size() - at_; }

  // The next word of this line, empty at its end. A backslash at the end of a line joins the next one to it.
  std::string_view word_on_line();
  // The next word on this line or a later one, empty at the end of the file.
  std::string_view word();
  // Goes to the beginning of the next line; false at the end of the file.
  bool next_line();
  // The rest of this line without line break and trailing blanks.
  std::string_view rest_of_line();
  // To the next word, past blanks, comments and line breaks; false at the end of the file.
  bool find_word();

  // A number from `word`; "expected <what>" if it is none, file_truncated if the file ends before it.
  double real(std::string_view word, const char *what) const;
  long long integer(std::string_view word, const char *what) const;

  // Throws file_syntax (file_truncated at the end of the file) with the line.
  [[noreturn]] void fail(std::string_view found, const std::string &expected) const;
  [[noreturn]] void fail(Fault fault, const std::string &what) const;

 private:
  void skip_blanks();

  std::string_view all_;
  std::size_t at_ = 0;
  char comment_;
};

// ASCII only, whatever the locale.
bool same_word(std::string_view a, std::string_view lower_case);

}  // namespace ts::mesh
