#include "api/guard.h"
#include "api/session_json.h"
#include "base/whole_file.h"

using namespace ts::api;
using ts::AllocatorScope;
using ts::Error;
using ts::Fault;

namespace ts::api {
namespace {

std::string written(const ts_segmentation &s) {
  SavedSession saved;
  saved.features = s.prepared->features->set.state();
  saved.options = s.prepared->segmenter->options();
  saved.commands = s.history.forgotten();
  for (const History::Step &step : s.history.done()) saved.commands.push_back(step.command);
  const auto &undone = s.history.undone();
  // NOLINTNEXTLINE(modernize-loop-convert): clang 14 cannot read the views of GCC 12's library
  for (auto step = undone.rbegin(); step != undone.rend(); ++step) saved.commands.push_back(step->command);
  saved.undone = undone.size();
  saved.result_hash = hash_of(s.session);
  return to_json(saved, s.prepared->surface());
}

struct Loaded {
  std::unique_ptr<ts_features> features;
  std::unique_ptr<ts_segmentation> segmentation;
};

Loaded read_session(const ts_model &model, std::string_view text, ts_job *job) {
  const Context &context = *model.state->context;
  const ts::Progress progress = progress_of(job);
  const ts::StopScope stop(progress);
  const mesh::Surface &surface = model.state->model.surface;
  SavedSession saved = from_json(text, surface);
  auto state = std::make_shared<FeaturesState>();
  state->model = model.state;
  state->set = features::FeatureSet(std::move(saved.features));
  Loaded loaded;
  loaded.features = std::make_unique<ts_features>(ts_features{state});
  auto prepared = std::make_unique<Prepared>();
  prepared->features = state;
  prepared->segmenter = std::make_unique<const tooth::Segmenter>(surface, state->set.features(), saved.options,
                                                                 *context.executor, progress.part(0, 0.5, "session"));
  tooth::Session session(surface);
  // NOLINTNEXTLINE(modernize-make-unique): an aggregate, made in its place
  loaded.segmentation.reset(new ts_segmentation{std::move(prepared), std::move(session)});
  ts_segmentation &s = *loaded.segmentation;
  const double count = static_cast<double>(saved.commands.size());
  for (std::size_t i = 0; i < saved.commands.size(); ++i) {
    Command &command = saved.commands[i];
    const std::size_t points = command.at.size();
    try {
      const double from = 0.5 + 0.5 * static_cast<double>(i) / count;
      tooth::Session next = execute(*s.prepared, s.session, command, progress.part(from, from, "steps"));
      if (command.at.size() != points) throw Error(Fault::mismatch, "a click of it comes to nothing");
      commit(s, std::move(next), std::move(command));
    } catch (const Error &e) {
      if (e.fault() == Fault::cancelled || e.fault() == Fault::out_of_memory) throw;
      throw Error(Fault::mismatch, "step " + std::to_string(i) + " of the session: " + e.what());
    }
  }
  for (std::size_t i = 0; i < saved.undone; ++i) s.history.before(), s.history.undo(s.session);
  if (hash_of(s.session) != saved.result_hash)
    throw Error(Fault::mismatch, "what comes of the session's steps is not what it was");
  s.changes.clear();
  progress(1);
  return loaded;
}

void hand_out(Loaded loaded, ts_features **features, ts_segmentation **out) {
  if (features) *features = loaded.features.release();
  *out = loaded.segmentation.release();
}

}  // namespace
}  // namespace ts::api

ts_status ts_session_write(const ts_segmentation *segmentation, char *text, uint32_t capacity, uint32_t *count) {
  return guarded(__func__, [&] {
    need(segmentation, "segmentation");
    const AllocatorScope scope(segmentation->prepared->context().allocator);
    copy_out(written(*segmentation), text, capacity, count);
  });
}

ts_status ts_session_save(const ts_segmentation *segmentation, const char *path) {
  return guarded(__func__, [&] {
    need(segmentation, "segmentation");
    need(path, "path");
    const AllocatorScope scope(segmentation->prepared->context().allocator);
    ts::write_whole_file(path, written(*segmentation));
  });
}

ts_status ts_session_read(const ts_model *model, const char *text, size_t size, ts_job *job, ts_features **features,
                          ts_segmentation **out) {
  return guarded(__func__, [&] {
    need(model, "model");
    need(text, "text");
    need(out, "out");
    const AllocatorScope scope(model->state->context->allocator);
    hand_out(read_session(*model, {text, size}, job), features, out);
  });
}

ts_status ts_session_load(const ts_model *model, const char *path, ts_job *job, ts_features **features,
                          ts_segmentation **out) {
  return guarded(__func__, [&] {
    need(model, "model");
    need(path, "path");
    need(out, "out");
    const AllocatorScope scope(model->state->context->allocator);
    const ts::Vec<std::byte> bytes = ts::read_whole_file(path);
    hand_out(read_session(*model, {reinterpret_cast<const char *>(bytes.data()), bytes.size()}, job), features, out);
  });
}
