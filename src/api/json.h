// A JSON value: the tree of nlohmann/json allocates when it is destroyed, and where that fails it ends the process.
// This one frees without memory. Reading is nlohmann's, event by event.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/memory.h"

namespace ts::api {

class Json {
 public:
  enum class Kind { null, boolean, integer, number, text, array, object };

  Json() = default;
  // NOLINTBEGIN(google-explicit-constructor): a value of JSON is what it is made of
  Json(bool value) : kind_(Kind::boolean), integer_(value) {}
  Json(std::uint64_t value) : kind_(Kind::integer), integer_(value) {}
  Json(std::uint32_t value) : Json(std::uint64_t{value}) {}
  Json(double value) : kind_(Kind::number), number_(value) {}
  Json(std::string value) : kind_(Kind::text), text_(std::move(value)) {}
  Json(const char *value) : Json(std::string(value)) {}
  // NOLINTEND(google-explicit-constructor)
  static Json array() { return of(Kind::array); }
  static Json object() { return of(Kind::object); }

  Kind kind() const { return kind_; }
  bool boolean() const { return integer_ != 0; }
  std::uint64_t integer() const { return integer_; }  // whole and not negative
  double number() const { return kind_ == Kind::integer ? static_cast<double>(integer_) : number_; }
  const std::string &text() const { return text_; }
  const Vec<Json> &items() const { return items_; }  // of an array, or the values of an object
  const Json *find(std::string_view key) const;      // of an object; nullptr if it has none. Of equal keys the last

  void add(Json item) { items_.push_back(std::move(item)); }
  Json &set(std::string key, Json value);  // at the end

  std::string dump() const;  // a number, text, key or bracket a line; doubles as they read back the same

 private:
  static Json of(Kind kind);
  void write(std::string &out, std::size_t depth) const;

  Kind kind_ = Kind::null;
  std::uint64_t integer_ = 0;
  double number_ = 0;
  std::string text_;
  Vec<Json> items_;
  Vec<std::string> keys_;
};

// Throws Fault::file_truncated and file_syntax, with the byte.
Json parse_json(std::string_view text);

}  // namespace ts::api
