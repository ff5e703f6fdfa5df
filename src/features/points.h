// Feature points of one tooth: cusps and the corners of incisal edges.
#pragma once

#include "features/features.h"
#include "features/ridges.h"

namespace ts::features {

// Best first; at most `most`; of one of a span's ridges if there is one. Empty where the span has no crown to speak of.
Vec<Point> tooth_points(const mesh::Surface &surface, const Strip &strip, const TopView &view, const Plan &plan,
                        const ToothSpan &tooth, unsigned most, const Ridge *ridge = nullptr);

}  // namespace ts::features
