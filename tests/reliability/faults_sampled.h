// Failing memory on an arch of real size: of each long call some allocations, and how much of it is in the context's
// allocator. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

// Of the call of that name alone, where there is one. The exit status.
int sampled_faults(const std::string &folder, unsigned triangles, int samples, const std::string &only);
