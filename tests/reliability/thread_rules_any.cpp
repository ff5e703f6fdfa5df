// SPDX-License-Identifier: Apache-2.0
#include <atomic>

#include "thread_rules.h"

namespace {

// Of a function that fills options.
template <class T, class Init>
std::string initialised(const Init &init) {
  T t{};
  HOLDS(init(&t, static_cast<std::uint32_t>(sizeof t)) == TS_OK);
  return bytes_of(t);
}

const char kOff[] = "OFF\n4 4 0\n0 0 0\n20 0 0\n0 20 0\n0 0 20\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";

// A call that goes on while the job is looked at and cancelled, by all threads that share it.
std::string with_job(Objects &o, void (*use)(ts_job *)) {
  ts_model *model = nullptr;
  const ts_status got = ts_model_read(o.context, kOff, sizeof kOff - 1, TS_FORMAT_OFF, nullptr, nullptr, &model);
  HOLDS(got == TS_OK);
  use(o.job.get());
  ts_model_destroy(model);
  return "used";
}

}  // namespace

std::vector<Rule> any_rules() {
  return {
      {"ts_version", [](Objects &) { return std::string(ts_version()); }},
      {"ts_status_name", [](Objects &) { return std::string(ts_status_name(TS_E_NO_CUT)) + ts_status_name(TS_OK); }},
      {"ts_last_error_message",
       [](Objects &o) {
         // A thread's own: each asks for another file.
         static std::atomic<int> number{0};
         const std::string path = o.path + "-none-" + std::to_string(++number) + "-";
         ts_model *none = nullptr;
         HOLDS(ts_model_load(o.context, path.c_str(), nullptr, nullptr, &none) == TS_E_FILE_OPEN);
         HOLDS(std::string(ts_last_error_message()).find(path) != std::string::npos);
         return std::string("own");
       }},
      {"ts_context_options_init", [](Objects &) { return initialised<ts_context_options>(ts_context_options_init); }},
      {"ts_context_create",
       [](Objects &) {
         const auto context = made<ts_context>([](ts_context **out) { return ts_context_create(nullptr, out); });
         return all_of(model_of(context.get(), rule_bumps()).get());
       }},
      {"ts_job_create",
       [](Objects &o) {
         const auto job = made<ts_job>([&](ts_job **out) { return ts_job_create(o.context, nullptr, nullptr, out); });
         HOLDS(job != nullptr);
         return bytes_of(ts_job_progress(job.get()));
       }},
      {"ts_job_cancel", [](Objects &o) { return with_job(o, ts_job_cancel); }},
      {"ts_job_progress",
       [](Objects &o) { return with_job(o, [](ts_job *job) { HOLDS(ts_job_progress(job) <= 1); }); }},
      {"ts_mesh_input_init", [](Objects &) { return initialised<ts_mesh_input>(ts_mesh_input_init); }},
      {"ts_intake_options_init", [](Objects &) { return initialised<ts_intake_options>(ts_intake_options_init); }},
      {"ts_model_create", [](Objects &o) { return all_of(model_of(o.context, rule_bumps()).get()); }},
      {"ts_model_load",
       [](Objects &o) {
         const std::string path = o.path + ".ply";
         HOLDS(ts_mesh_save(o.mesh.get(), path.c_str(), TS_OUTPUT_PLY, nullptr) == TS_OK);
         return made_bytes<ts_model>(
             [&](ts_model **out) { return ts_model_load(o.context, path.c_str(), nullptr, nullptr, out); });
       }},
      {"ts_model_read",
       [](Objects &o) {
         return made_bytes<ts_model>([&](ts_model **out) {
           return ts_model_read(o.context, kOff, sizeof kOff - 1, TS_FORMAT_AUTO, nullptr, nullptr, out);
         });
       }},
      {"ts_feature_options_init", [](Objects &) { return initialised<ts_feature_options>(ts_feature_options_init); }},
      {"ts_segment_options_init",
       [](Objects &) {
         return initialised<ts_segment_options>([](ts_segment_options *o, std::uint32_t size) {
           return ts_segment_options_init(o, size, TS_PRESET_PAPER);
         });
       }},
      {"ts_number_options_init", [](Objects &) { return initialised<ts_number_options>(ts_number_options_init); }},
      {"ts_fdi_to_universal",
       [](Objects &) {
         std::uint32_t number = 0;
         HOLDS(ts_fdi_to_universal(36, &number) == TS_OK);
         return bytes_of(number);
       }},
      {"ts_universal_to_fdi",
       [](Objects &) {
         std::uint32_t number = 0;
         HOLDS(ts_universal_to_fdi(3, &number) == TS_OK);
         return bytes_of(number);
       }},
      {"ts_fdi_to_palmer",
       [](Objects &) { return info<ts_palmer>([](ts_palmer *p) { return ts_fdi_to_palmer(11, p); }); }},
      {"ts_tooth_mesh_options_init",
       [](Objects &) { return initialised<ts_tooth_mesh_options>(ts_tooth_mesh_options_init); }},
      {"ts_save_options_init", [](Objects &) { return initialised<ts_save_options>(ts_save_options_init); }},
  };
}
