// Groups against labels.
#pragma once

#include "bench/scan_folder.h"
#include "features/features.h"

namespace ts::bench {

struct FeatureScore {
  int teeth = 0, groups = 0;
  int right = 0;  // teeth that own exactly one group, which has points on no other tooth
  int loose = 0;  // ... which may have
  int split = 0, merged = 0, missed = 0, spurious = 0, points = 0, on_crown = 0, scans = 0, counts = 0;
  bool sign = true;
  double ms = 0;

  void add(const FeatureScore &s);
  void print(const char *name) const;
};

// A group is owned by the tooth that most of its points lie on. `verbose`: prints each tooth that is not right.
FeatureScore score_features(const ScanFolder &scan, const features::Features &found, bool verbose);

}  // namespace ts::bench
