#include "api/session_json.h"

#include <algorithm>
#include <cmath>

#include "api/json.h"
#include "base/error.h"

namespace ts::api {
namespace {

using mesh::Index;
using mesh::Vec3;
using Set = features::FeatureSet;

constexpr std::uint32_t kFormat = 1;
constexpr const char *kActs[] = {"click",          "clicks",     "all",    "include", "exclude",
                                 "split",          "merge",      "remove", "lock",    "unlock",
                                 "assign_numbers", "set_number", "edit",   "reset",   "move_point"};

// FNV-1a: tells meshes apart, keeps out nobody.
struct Hash {
  std::uint64_t value = 14695981039346656037u;
  void add(const void *data, std::size_t size) {
    for (std::size_t i = 0; i < size; ++i)
      value = (value ^ static_cast<const unsigned char *>(data)[i]) * std::uint64_t{1099511628211u};
  }
};

std::uint64_t hash_of_mesh(const mesh::Surface &s) {
  Hash h;
  h.add(s.position.data(), s.position.size() * sizeof s.position[0]);
  h.add(s.triangle.data(), s.triangle.size() * sizeof s.triangle[0]);
  return h.value;
}

// Calls field(name, member) for each option.
template <class Options, class Field>
void each_option(Options &o, const Field &field) {
  field("preset", o.preset), field("weights", o.weights), field("background", o.background);
  field("cut_rule", o.cut_rule), field("contours", o.contours), field("histogram_bins", o.histogram_bins);
  field("points_per_group", o.points_per_group), field("alpha", o.alpha), field("beta", o.beta);
  field("gamma", o.gamma), field("theta", o.theta), field("c0", o.c0), field("normal_radius", o.normal_radius);
  field("seed_radius", o.seed_radius), field("gingiva_distance", o.gingiva_distance), field("area_min", o.area_min);
  field("area_max", o.area_max), field("hole_area", o.hole_area), field("refine_band", o.refine_band);
  field("smooth_radius", o.smooth_radius), field("click_reach", o.click_reach);
  field("click_concavity", o.click_concavity), field("reject_outliers", o.reject_outliers);
  field("memory_limit", o.memory_limit);
}

Json to_json(const Vec3 &p) {
  Json all = Json::array();
  for (const double x : p) all.add(x);
  return all;
}
Json to_json(const Vec<Vec3> &points) {
  Json all = Json::array();
  for (const Vec3 &p : points) all.add(to_json(p));
  return all;
}

Json to_json(const Set::State &s) {
  Json points = Json::array(), groups = Json::array(), looks = Json::array(), next = Json::array();
  for (const Set::Point &p : s.points) {
    Json point = Json::object();
    point.set("id", p.id).set("group", p.group).set("vertex", p.vertex).set("position", to_json(p.position));
    point.set("convexity", p.convexity).set("by_hand", p.by_hand);
    points.add(std::move(point));
  }
  for (const Set::Group &g : s.groups) {
    Json group = Json::object();
    group.set("id", g.id).set("from", g.from).set("to", g.to).set("confidence", g.confidence);
    groups.add(std::move(group));
  }
  for (const double x : {s.looks.opposed, s.looks.coverage, s.looks.length}) looks.add(x);
  looks.add(s.looks.warnings);
  next.add(s.next_point), next.add(s.next_group);
  Json all = Json::object();
  all.set("occlusal", to_json(s.occlusal)).set("arch", to_json(s.arch)).set("inside_out", s.inside_out);
  all.set("looks", std::move(looks)).set("groups", std::move(groups)).set("points", std::move(points));
  all.set("next", std::move(next));
  return all;
}

[[noreturn]] void wrong(const std::string &where, const std::string &why) {
  throw Error(Fault::file_syntax, "the session's " + where + " " + why);
}

// One place in the file, with its name for messages.
class Place {
 public:
  Place(const Json &value, std::string name) : value_(&value), name_(std::move(name)) {}

  Place operator[](const char *key) const {
    const Json *const there = value_->find(key);
    if (!there) wrong(name_, std::string("has no \"") + key + "\"");
    return {*there, name_.empty() ? key : name_ + "." + key};
  }
  bool has(const char *key) const { return value_->find(key) != nullptr; }
  template <class Each>
  void each(const Each &each) const {
    if (value_->kind() != Json::Kind::array) wrong(name_, "is no array");
    for (std::size_t i = 0; i < size(); ++i) each(Place(value_->items()[i], name_ + "[" + std::to_string(i) + "]"));
  }
  std::size_t size() const { return value_->kind() == Json::Kind::array ? value_->items().size() : 0; }

  double number() const {
    if (value_->kind() != Json::Kind::number && value_->kind() != Json::Kind::integer) wrong(name_, "is no number");
    if (!std::isfinite(value_->number())) wrong(name_, "is not finite");
    return value_->number();
  }
  std::uint64_t integer(std::uint64_t most) const {
    if (value_->kind() != Json::Kind::integer || value_->integer() > most)
      wrong(name_, "is no whole number up to " + std::to_string(most));
    return value_->integer();
  }
  Index index(std::uint64_t below) const {
    if (below == 0) wrong(name_, "is a number where none can be");
    return static_cast<Index>(integer(below - 1));
  }
  bool boolean() const {
    if (value_->kind() != Json::Kind::boolean) wrong(name_, "is neither true nor false");
    return value_->boolean();
  }
  const std::string &text() const {
    if (value_->kind() != Json::Kind::text) wrong(name_, "is no text");
    return value_->text();
  }
  Vec3 point() const {
    if (size() != 3) wrong(name_, "is no point of three numbers");
    Vec3 p;
    for (int k = 0; k < 3; ++k) p[k] = Place(value_->items()[static_cast<std::size_t>(k)], name_).number();
    return p;
  }
  Vec<Vec3> points() const {
    Vec<Vec3> all;
    each([&](const Place &p) { all.push_back(p.point()); });
    return all;
  }
  std::uint64_t hash() const {
    const std::string &digits = text();
    if (digits.size() != 16 || digits.find_first_not_of("0123456789abcdef") != std::string::npos)
      wrong(name_, "is no hash of 16 hexadecimal digits");
    return std::stoull(digits, nullptr, 16);
  }
  const std::string &name() const { return name_; }

 private:
  const Json *value_;
  std::string name_;
};

void set_option(const Place &place, double &to) {
  to = place.number();
}
void set_option(const Place &place, bool &to) {
  to = place.boolean();
}
void set_option(const Place &place, std::uint32_t &to) {
  to = static_cast<std::uint32_t>(place.integer(UINT32_MAX));
}
void set_option(const Place &place, std::size_t &to) {
  to = static_cast<std::size_t>(std::min<std::uint64_t>(place.integer(UINT64_MAX), SIZE_MAX));
}
template <class Enum>
requires std::is_enum_v<Enum>
void set_option(const Place &place, Enum &to) {
  to = static_cast<Enum>(place.integer(4));
}

Set::State features_of(const Place &f, std::size_t vertices) {
  constexpr std::uint64_t kIds = mesh::none;
  Set::State s;
  s.occlusal = f["occlusal"].point();
  s.arch = f["arch"].points();
  s.inside_out = f["inside_out"].boolean();
  Vec<double> looks;
  f["looks"].each([&](const Place &p) { looks.push_back(p.number()); });
  if (looks.size() != 4) wrong("features.looks", "are not four numbers");
  s.looks = {looks[0], looks[1], looks[2], static_cast<std::uint32_t>(std::clamp(looks[3], 0., 4294967295.))};
  Vec<Index> next;
  f["next"].each([&](const Place &p) { next.push_back(p.index(kIds)); });
  if (next.size() != 2) wrong("features.next", "are not two numbers");
  s.next_point = next[0], s.next_group = next[1];
  f["groups"].each([&](const Place &p) {
    Set::Group g{};
    g.centre = Vec3::Zero();
    g.id = p["id"].index(s.next_group);
    for (const Set::Group &other : s.groups)
      if (other.id == g.id) wrong(p.name(), "has the id of another");
    g.from = p["from"].number(), g.to = p["to"].number(), g.confidence = p["confidence"].number();
    if (g.confidence < 0 || g.confidence > 1) wrong(p.name(), "has a confidence outside 0 to 1");
    s.groups.push_back(g);
  });
  if (s.groups.empty()) wrong("features.groups", "are none");
  std::size_t place = 0;  // of the group of the last point: points are in the order of the groups
  f["points"].each([&](const Place &p) {
    Set::Point q{};
    q.id = p["id"].index(s.next_point), q.group = p["group"].index(s.next_group);
    q.vertex = p["vertex"].index(vertices);
    q.position = p["position"].point();
    q.convexity = p["convexity"].number(), q.by_hand = p["by_hand"].boolean();
    while (place < s.groups.size() && s.groups[place].id != q.group) ++place;
    if (place == s.groups.size()) wrong(p.name(), "is of no group, or not in the order of the groups");
    Set::Group &g = s.groups[place];
    g.centre += q.position;
    ++g.points;
    s.points.push_back(q);
  });
  Vec<Index> ids;
  for (const Set::Point &q : s.points) ids.push_back(q.id);
  std::ranges::sort(ids);
  if (std::ranges::adjacent_find(ids) != ids.end()) wrong("features.points", "have two with one id");
  for (Set::Group &g : s.groups) {
    if (g.points == 0) wrong("features.groups", "have one without a point");
    g.centre /= g.points;
  }
  return s;
}

Command command_of(const Place &step) {
  Command c;
  const std::string act = step["act"].text();
  const auto *const known = std::ranges::find(kActs, act);
  if (known == std::end(kActs)) wrong(step.name(), "has the unknown act \"" + act + "\"");
  c.act = static_cast<Command::Act>(known - std::begin(kActs));
  if (step.has("tooth")) c.tooth = step["tooth"].index(mesh::none);
  if (step.has("other")) c.other = step["other"].index(mesh::none);
  if (step.has("at")) c.at = step["at"].points();
  using Act = Command::Act;
  if (c.act == Act::edit) {
    const Place edit = step["edit"];
    c.edit.kind = static_cast<tooth::EditKind>(edit["kind"].integer(4));
    if (c.edit.kind < tooth::EditKind::drag) wrong(step.name(), "is no edit");
    c.edit.points = edit["points"].points(), c.edit.amount = edit["amount"].number();
    if (c.edit.kind == tooth::EditKind::drag && c.edit.points.size() != 2) wrong(step.name(), "is no drag");
  }
  if (c.act == Act::set_number) c.number = static_cast<std::uint32_t>(step["number"].integer(48));
  if (c.act == Act::assign_numbers) {
    const std::string jaw = step["jaw"].text();
    if (jaw != "unknown" && jaw != "upper" && jaw != "lower") wrong(step.name(), "is of no jaw");
    if (jaw != "unknown") c.numbering.jaw = jaw == "upper" ? features::Jaw::upper : features::Jaw::lower;
    c.numbering.mirrored = step["mirrored"].boolean();
    c.numbering.least_confidence = step["least_confidence"].number();
  }
  const std::size_t least = c.act == Act::divide || c.act == Act::move                                ? 2
                            : c.act == Act::click || c.act == Act::take_in || c.act == Act::leave_out ? 1
                                                                                                      : 0;
  if (c.at.size() < least) wrong(step.name(), "has too few points");
  return c;
}

std::string hex(std::uint64_t value) {
  char digits[17];
  static_cast<void>(std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(value)));
  return digits;
}

}  // namespace

std::uint64_t hash_of(const tooth::Session &session) {
  Hash h;
  const Vec<std::uint32_t> labels = session.labels();
  h.add(labels.data(), labels.size() * sizeof labels[0]);
  return h.value;
}

std::string to_json(const SavedSession &session, const mesh::Surface &surface) {
  Json options = Json::object(), steps = Json::array();
  each_option(session.options, [&](const char *name, const auto &value) {
    using T = std::decay_t<decltype(value)>;
    if constexpr (std::is_enum_v<T>)
      options.set(name, static_cast<std::uint32_t>(value));
    else if constexpr (std::is_same_v<T, std::size_t>)  // no type of Json's everywhere
      options.set(name, std::uint64_t{value});
    else
      options.set(name, value);
  });
  for (const Command &c : session.commands) {
    Json step = Json::object();
    step.set("act", kActs[static_cast<std::size_t>(c.act)]);
    if (c.tooth != mesh::none) step.set("tooth", c.tooth);
    if (c.other != mesh::none) step.set("other", c.other);
    if (!c.at.empty()) step.set("at", to_json(c.at));
    if (c.act == Command::Act::edit) {
      Json edit = Json::object();
      edit.set("kind", static_cast<std::uint32_t>(c.edit.kind)).set("points", to_json(c.edit.points));
      edit.set("amount", c.edit.amount);
      step.set("edit", std::move(edit));
    }
    if (c.act == Command::Act::set_number) step.set("number", c.number);
    if (c.act == Command::Act::assign_numbers) {
      const tooth::NumberOptions &o = c.numbering;
      step.set("jaw", !o.jaw ? "unknown" : *o.jaw == features::Jaw::upper ? "upper" : "lower");
      step.set("mirrored", o.mirrored).set("least_confidence", o.least_confidence);
    }
    steps.add(std::move(step));
  }
  Json all = Json::object();
  all.set("toothseg_session", kFormat).set("mesh", hex(hash_of_mesh(surface))).set("options", std::move(options));
  all.set("features", to_json(session.features)).set("steps", std::move(steps));
  all.set("undone", std::uint64_t{session.undone}).set("labels", hex(session.result_hash));
  return all.dump();
}

SavedSession from_json(std::string_view text, const mesh::Surface &surface) {
  const Json all = parse_json(text);
  if (!all.find("toothseg_session")) throw Error(Fault::file_format, "JSON, but no session of toothseg");
  const Place file(all, "");
  const std::uint64_t format = file["toothseg_session"].integer(UINT32_MAX);
  if (format > kFormat)
    throw Error(Fault::file_newer, "the session has format " + std::to_string(format) + ", this library reads up to " +
                                       std::to_string(kFormat));
  if (format == 0) throw Error(Fault::file_format, "there is no format 0 of a session");
  SavedSession s;
  if (file["mesh"].hash() != hash_of_mesh(surface)) throw Error(Fault::mismatch, "the session is of another mesh");
  s.result_hash = file["labels"].hash();
  const Place options = file["options"];
  each_option(s.options, [&](const char *name, auto &value) { set_option(options[name], value); });
  try {
    tooth::check(s.options);
  } catch (const Error &e) {  // here it is the file that is wrong, not the call
    wrong("options", std::string("are out of range: ") + e.what());
  }
  s.features = features_of(file["features"], surface.vertices());
  file["steps"].each([&](const Place &step) { s.commands.push_back(command_of(step)); });
  s.undone = static_cast<std::size_t>(file["undone"].integer(s.commands.size()));
  return s;
}

}  // namespace ts::api
