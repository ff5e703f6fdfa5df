// A session as JSON (docs/session-file.md).
#pragma once

#include <string>
#include <string_view>

#include "api/segmentation_handle.h"

namespace ts::api {

// What a session file holds beside the mesh.
struct SavedSession {
  features::FeatureSet::State features;
  tooth::Options options;
  Vec<Command> commands;
  std::size_t undone = 0;         // of these, the last ones
  std::uint64_t result_hash = 0;  // of the labels after the others
};

std::uint64_t hash_of(const tooth::Session &session);

std::string to_json(const SavedSession &session, const mesh::Surface &surface);
// Throws file_format, file_newer, file_truncated, file_syntax, and mismatch if the session is of another mesh. What is
// read is in range for this one.
SavedSession from_json(std::string_view text, const mesh::Surface &surface);

}  // namespace ts::api
