#include "api/json.h"

#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "base/error.h"

namespace ts::api {
namespace {

constexpr std::size_t kDeepest = 32;  // a session has 5

void write_text(std::string &out, const std::string &text) {
  out += '"';
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (static_cast<unsigned char>(c) < 0x20) {
      constexpr char digits[] = "0123456789abcdef";
      out += "\\u00";
      out += digits[c >> 4];
      out += digits[c & 15];
    } else {
      out += c;
    }
  }
  out += '"';
}

template <class T>
void write_number(std::string &out, T value) {
  char digits[32];
  out.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
}

// What nlohmann's reader calls, in the order of the text.
class Builder {
 public:
  explicit Builder(std::size_t size) : size_(size) {}

  bool null() { return put({}); }
  bool boolean(bool value) { return put(value); }
  bool number_integer(std::int64_t value) { return put(static_cast<double>(value)); }
  bool number_unsigned(std::uint64_t value) { return put(value); }
  bool number_float(double value, const std::string &) { return put(value); }
  bool string(std::string &value) { return put(std::move(value)); }
  bool binary(nlohmann::json::binary_t &) { return false; }
  bool start_object(std::size_t) { return open(Json::object()); }
  bool start_array(std::size_t) { return open(Json::array()); }
  bool key(std::string &value) {
    keys_.back() = std::move(value);
    return true;
  }
  bool end_object() { return close(); }
  bool end_array() { return close(); }
  [[noreturn]] bool parse_error(std::size_t byte, const std::string &, const nlohmann::json::exception &) const {
    if (byte >= size_) throw Error(Fault::file_truncated, "the session ends in the middle of its text");
    throw Error(Fault::file_syntax, "no JSON at byte " + std::to_string(byte));
  }

  Json take() { return std::move(root_); }

 private:
  bool put(Json value) {
    if (open_.empty())
      root_ = std::move(value);
    else if (open_.back().kind() == Json::Kind::object)
      open_.back().set(std::move(keys_.back()), std::move(value));
    else
      open_.back().add(std::move(value));
    return true;
  }
  bool open(Json value) {
    if (open_.size() == kDeepest)
      throw Error(Fault::file_syntax, "the session is nested deeper than " + std::to_string(kDeepest));
    open_.push_back(std::move(value));
    keys_.emplace_back();
    return true;
  }
  bool close() {
    Json value = std::move(open_.back());
    open_.pop_back();
    keys_.pop_back();
    return put(std::move(value));
  }

  std::size_t size_;
  Json root_;
  Vec<Json> open_;
  Vec<std::string> keys_;  // of what is open: the key that waits for its value
};

}  // namespace

Json Json::of(Kind kind) {
  Json made;
  made.kind_ = kind;
  return made;
}

const Json *Json::find(std::string_view key) const {
  for (std::size_t i = keys_.size(); i > 0; --i)
    if (keys_[i - 1] == key) return &items_[i - 1];
  return nullptr;
}

Json &Json::set(std::string key, Json value) {
  items_.push_back(std::move(value));
  keys_.push_back(std::move(key));
  return *this;
}

std::string Json::dump() const {
  std::string out;
  write(out, 0);
  return out;
}

void Json::write(std::string &out, std::size_t depth) const {
  switch (kind_) {
    case Kind::null: out += "null"; return;
    case Kind::boolean: out += integer_ ? "true" : "false"; return;
    case Kind::integer: write_number(out, integer_); return;
    case Kind::number:
      if (std::isfinite(number_))
        write_number(out, number_);
      else
        out += "null";
      return;
    case Kind::text: write_text(out, text_); return;
    case Kind::array:
    case Kind::object: break;
  }
  const bool object = kind_ == Kind::object;
  out += object ? '{' : '[';
  for (std::size_t i = 0; i < items_.size(); ++i) {
    out += i ? ",\n" : "\n";
    out.append(depth + 1, ' ');
    if (object) {
      write_text(out, keys_[i]);
      out += ": ";
    }
    items_[i].write(out, depth + 1);
  }
  if (!items_.empty()) {
    out += '\n';
    out.append(depth, ' ');
  }
  out += object ? '}' : ']';
}

Json parse_json(std::string_view text) {
  Builder builder(text.size());
  nlohmann::json::sax_parse(text, &builder);
  return builder.take();
}

}  // namespace ts::api
