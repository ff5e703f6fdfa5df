// Which way a tooth looks, and how large it is that way.
#pragma once

#include <span>

#include "features/features.h"
#include "tooth/tooth.h"

namespace ts::tooth {

struct ToothFrame {
  Vec3 centre = Vec3::Zero();                                                  // of the area of its faces
  Vec3 occlusal = Vec3::Zero(), mesial = Vec3::Zero(), buccal = Vec3::Zero();  // unit, orthogonal
  double width = 0;                                                            // extent along mesial, mm
  double depth = 0;                                                            // along buccal
  double height = 0;                                                           // along occlusal
  bool from_arch = false;
};

// `occlusal` unit, `arch` from one end to the other, or empty: then mesial is the direction in which the tooth is
// widest across the occlusal direction, to one side or the other. The direction of the arch beside the tooth is mesial,
// towards the middle of the arch's length; buccal points away from the middle between its ends.
ToothFrame frame_of(const mesh::Surface &surface, const Tooth &tooth, const Vec3 &occlusal, std::span<const Vec3> arch);

}  // namespace ts::tooth
