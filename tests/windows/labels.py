#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""labels.py A B: which share of the labels of two files differs; fails where it is 1e-4 or more, or there is nothing to compare."""
import pathlib
import sys

a, b = (pathlib.Path(name).read_text().split() for name in sys.argv[1:3])
if not a or len(a) != len(b) or len(set(a)) < 2:
    sys.exit(f"{len(a)} and {len(b)} labels")
differing = sum(x != y for x, y in zip(a, b))
print(f"labels: {differing} of {len(a)} differ, share {differing / len(a):.2g}")
sys.exit(differing / len(a) >= 1e-4)
