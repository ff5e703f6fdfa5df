#include "api/guard.h"
#include "api/handles.h"

using namespace ts::api;
using ts::Error;
using ts::Fault;

ts_status ts_context_options_init(ts_context_options *options, uint32_t struct_size) {
  return guarded(__func__, [&] {
    need(options, "options");
    write_struct(options, ts_context_options{}, struct_size, "ts_context_options");
  });
}

ts_status ts_context_create(const ts_context_options *options, ts_context **out) {
  return guarded(__func__, [&] {
    need(out, "out");
    const ts_context_options o = read_options(options, ts_context_options{}, "ts_context_options");
    if (o.threads > 1024)
      throw Error(Fault::invalid_argument, "threads is " + std::to_string(o.threads) + ", at most 1024");
    if (!o.alloc != !o.free) throw Error(Fault::invalid_argument, "alloc and free must both be given, or neither");
    auto state = std::make_shared<Context>();
    if (o.alloc)
      state->allocator = std::make_shared<const ts::AllocatorHooks>(ts::AllocatorHooks{o.alloc, o.free, o.alloc_user});
    state->executor = std::make_unique<ts::Executor>(o.threads);
    state->log = o.log;
    state->log_user = o.log_user;
    *out = new ts_context{std::move(state)};
  });
}

void ts_context_destroy(ts_context *context) {
  delete context;
}

bool ts_job::proceed(double f, const char *stage) noexcept {
  if (cancelled) return false;
  stage_now = stage;
  if (!progress) {
    fraction = std::max(fraction.load(), f);
    return true;
  }
  const std::lock_guard lock(calling);
  if (cancelled) return false;
  if (f < fraction) return true;  // another thread was faster: never falling
  fraction = f;
  if (progress(f, stage, user) != 0) cancelled = true;
  return !cancelled;
}

ts_status ts_job_create(ts_context *context, ts_progress_fn progress, void *user, ts_job **out) {
  return guarded(__func__, [&] {
    need(context, "context");
    need(out, "out");
    *out = new ts_job(context->state, progress, user);
  });
}

void ts_job_cancel(ts_job *job) {
  if (job) job->cancelled = true;
}

void ts_job_reset(ts_job *job) {
  if (!job) return;
  job->cancelled = false;
  job->fraction = 0;
}

double ts_job_progress(const ts_job *job) {
  return job ? job->fraction.load() : 0.0;
}

void ts_job_destroy(ts_job *job) {
  delete job;
}
