// What happens to files: cut off, bits turned, pieces swapped, counts and numbers that are wrong.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <random>
#include <string>

#include "good_files.h"

// One to three kinds of damage, one after another: the same for the same state of `random`.
std::string damaged(const GoodFile &file, std::mt19937_64 &random);
