// What numbers are told from, measured on the arch.
#pragma once

#include <span>

#include "features/features.h"
#include "tooth/numbering.h"
#include "tooth/tooth.h"

namespace ts::tooth {

// A place along the arch where a tooth is: of a feature group, of a separated tooth, or of both.
struct RowTooth {
  const features::Group *group = nullptr;
  const Tooth *tooth = nullptr;
};

// `teeth` in the order of the arch.
ArchRow arch_row(const mesh::Surface &surface, const features::Features &features, std::span<const RowTooth> teeth);

}  // namespace ts::tooth
