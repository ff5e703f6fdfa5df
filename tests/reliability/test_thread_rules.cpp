// The thread rule of each function of the API, as abi/toothseg.json has it: what may go on at the same time does, with
// the results of one thread alone. A function that is left out fails.
//   test_thread_rules abi/toothseg.json FOLDER. For ThreadSanitizer above all. SPDX-License-Identifier: Apache-2.0
#include <barrier>
#include <cstdio>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <set>
#include <thread>

#include "thread_rules.h"

namespace {

using Index = std::uint32_t;
constexpr int kThreads = 4;

// work(k) on n threads that begin together.
void at_once(int n, const std::function<void(int)> &work) {
  std::barrier begin(n);
  std::vector<std::thread> threads;
  for (int k = 0; k < n; ++k)
    threads.emplace_back([&, k] {
      begin.arrive_and_wait();
      work(k);
    });
  for (std::thread &t : threads) t.join();
}

// The functions of the API by their rules. Each has its name before its rule, and nothing else there has a rule.
std::map<std::string, std::set<std::string>> rules_of(const char *path) {
  std::ifstream file(path);
  HOLDS(file.good());
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const auto value = [&](std::size_t key) {  // of "key": "value"
    const std::size_t from = text.find('"', text.find(':', key)) + 1;
    return text.substr(from, text.find('"', from) - from);
  };
  std::map<std::string, std::set<std::string>> rules;
  const std::string name = "\"name\": \"ts_", rule = "\"threads\": \"";
  std::size_t begin = text.find("\"functions\": [");
  HOLDS(begin != std::string::npos);
  for (std::size_t at = text.find(rule, begin); at != std::string::npos; at = text.find(rule, begin)) {
    HOLDS(rules[value(at)].insert(value(text.find(name, begin))).second);
    begin = at + rule.size();
  }
  return rules;
}

// The table has these functions, each once.
int all_there(const std::vector<Rule> &table, const std::set<std::string> &functions) {
  std::set<std::string> there;
  for (const Rule &r : table) HOLDS(there.insert(r.function).second);
  int wrong = 0;
  const auto difference = [&](const auto &of, const auto &without, const char *what) {
    for (const std::string &f : of)
      if (!without.contains(f)) std::printf("%s %s\n", f.c_str(), what), ++wrong;
  };
  difference(functions, there, "has no call that tests its thread rule");
  difference(there, functions, "is called under a thread rule that it does not have");
  return wrong;
}

class Test {
 public:
  explicit Test(const std::string &folder) : path_(folder + "/thread_rules") {
    ts_context_options o;
    HOLDS(ts_context_options_init(&o, sizeof o) == TS_OK);
    o.threads = 2;
    context_ = made<ts_context>([&](ts_context **out) { return ts_context_create(&o, out); });
    HOLDS(context_ != nullptr);
    model_ = model_of(context_.get(), rule_bumps());
  }

  // All threads on the same objects, which nobody has looked at before. Alone, another thread's results are the same.
  void shared(const Rule &rule) const {
    Objects o = objects();
    std::vector<std::string> results(kThreads);
    at_once(kThreads, [&](int k) { results[k] = rule.call(o); });
    expect(rule, results, rule.call(o));
  }

  // Each thread on objects of its own, of one model and one context; the same was done to all.
  void own(const Rule &rule) const {
    Objects alone = objects();
    std::vector<Objects> each;
    for (int k = 0; k < kThreads; ++k) each.push_back(objects());
    std::vector<std::string> results(kThreads);
    at_once(kThreads, [&](int k) { results[k] = rule.call(each[k]); });
    expect(rule, results, rule.call(alone));
  }

  // All functions that may be, at once on the same objects: each thread begins at another.
  void shared_by_all(const std::vector<Rule> &rules) const {
    Objects o = objects();
    at_once(2 * kThreads, [&](int k) {
      for (std::size_t i = 0; i < rules.size(); ++i)
        rules[(i + k * rules.size() / (2 * kThreads)) % rules.size()].call(o);
    });
    check::segmentation(o.model, o.s(), true);
  }

 private:
  Objects objects() const { return objects_on(context_.get(), model_.get(), path_); }
  static void expect(const Rule &rule, const std::vector<std::string> &results, const std::string &expected) {
    for (const std::string &r : results)
      if (r != expected || r.empty()) {
        std::printf("%s: another result where several threads call it\n", rule.function);
        HOLDS(r == expected && !r.empty());
      }
  }

  std::string path_;
  Handle<ts_context> context_;
  Handle<ts_model> model_;
};

}  // namespace

const Bumps &rule_bumps() {
  static const Bumps made = make_bumps(3, 4, 4);
  return made;
}

Objects objects_on(ts_context *context, const ts_model *model, const std::string &path) {
  Objects o{context, model, features_of(model, rule_bumps()), nullptr, nullptr, nullptr, {}, path};
  o.segmentation = made<ts_segmentation>(
      [&](ts_segmentation **out) { return ts_segmentation_create(o.features.get(), nullptr, nullptr, out); });
  ts_segmentation *const s = o.segmentation.get();
  HOLDS(s != nullptr && ts_segment_click(s, rule_bumps().top[0].data(), nullptr, nullptr) == TS_OK);
  o.teeth = check::all<Index>([&](Index *p, Index n, Index *c) { return ts_get_teeth(s, p, n, c); });
  HOLDS(o.teeth.size() == 2);
  HOLDS(ts_assign_numbers(s, nullptr) == TS_OK);
  HOLDS(ts_cut_smooth(s, o.teeth[1], 0.3, nullptr) == TS_OK);
  o.mesh = made<ts_mesh>([&](ts_mesh **out) { return ts_gingiva_mesh_create(s, nullptr, nullptr, out); });
  o.job = made<ts_job>([&](ts_job **out) { return ts_job_create(context, nullptr, nullptr, out); });
  HOLDS(o.mesh != nullptr && o.job != nullptr);
  return o;
}

std::string all_of(const ts_model *m) {
  return got<double>([&](double *p, Index n, Index *c) { return ts_model_get_positions(m, p, n, c); }, 3) +
         got<Index>([&](Index *p, Index n, Index *c) { return ts_model_get_triangles(m, p, n, c); }, 3);
}
std::string all_of(const ts_features *f) {
  double d[3];
  HOLDS(ts_features_get_occlusal(f, d) == TS_OK);
  return bytes_of(d, 3) + got<ts_feature_point>([&](ts_feature_point *p, Index n, Index *c) {
           return ts_features_get_points(f, p, n, c);
         });
}
std::string all_of(const ts_segmentation *s) {
  return got<Index>([&](Index *p, Index n, Index *c) { return ts_get_labels(s, p, n, c); }) +
         got<char>([&](char *p, Index n, Index *c) { return ts_session_write(s, p, n, c); });
}
std::string all_of(const ts_mesh *m) {
  return got<double>([&](double *p, Index n, Index *c) { return ts_mesh_get_positions(m, p, n, c); }, 3) +
         got<Index>([&](Index *p, Index n, Index *c) { return ts_mesh_get_triangles(m, p, n, c); }, 3);
}

int main(int argc, char **argv) {
  if (argc != 3) return std::fprintf(stderr, "usage: test_thread_rules abi/toothseg.json FOLDER\n"), 2;
  std::setvbuf(stdout, nullptr, _IOLBF, 1024);
  auto rules = rules_of(argv[1]);
  const auto any = any_rules(), concurrent = concurrent_rules(), exclusive = exclusive_rules();
  int failed = all_there(any, rules["any"]);
  failed += all_there(concurrent, rules["concurrent"]);
  failed += all_there(exclusive, rules["exclusive"]);
  HOLDS(rules.size() == 3);
  const Test test(argv[2]);
  for (const auto &table : {any, concurrent})
    for (const Rule &r : table) test.shared(r);
  for (const Rule &r : exclusive) test.own(r);
  test.shared_by_all(concurrent);
  std::printf("%zu functions: %zu any, %zu concurrent, %zu exclusive\n",
              any.size() + concurrent.size() + exclusive.size(), any.size(), concurrent.size(), exclusive.size());
  std::printf("%zu passed, %d failed\n", any.size() + concurrent.size() + exclusive.size() + 1, failed);
  return failed != 0;
}
