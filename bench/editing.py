#!/usr/bin/env python3
"""What each correction costs against a click, on a synthetic arch, in one run.

    editing.py [--triangles 300000] [--build build/release] [--seed 1] [--threads 2] [--json OUT]

Every call is made for every tooth, or pair, of the arch and taken back; each after a click on the same tooth, which is taken
back as well. Medians, and of call over its click: target 1. Clicks separate two teeth, so do `split` and corrections on which
a second tooth lies.
"""
import argparse
import ctypes
import json
import os
import subprocess
import sys
import tempfile
import time

import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(HERE)
sys.path[:0] = [HERE, os.path.join(HERE, "study")]
import score  # noqa: E402
from library import Failure, Library, Scan, f64, u32  # noqa: E402
from text import number, table  # noqa: E402


class Measured:
    def __init__(self):
        self.ms, self.refused, self.over = {}, {}, {}

    def time(self, name, call):
        begin = time.perf_counter()
        try:
            call()
        except Failure:
            self.refused[name] = self.refused.get(name, 0) + 1
            return False
        self.ms.setdefault(name, []).append((time.perf_counter() - begin) * 1e3)
        return True


def measure(library, scan, v, f, seed):
    seg, out, random = scan.prepare(), Measured(), np.random.default_rng(seed)
    library.call("ts_segment_all", seg.handle, None)
    middle, labels = v[f].mean(1), seg.labels()
    clicks = {}
    ids = [int(t) for t in seg.teeth()]
    for t in ids:
        own = np.flatnonzero(labels == seg.tooth(t).label)
        clicks[t] = middle[own[((middle[own] - middle[own].mean(0)) ** 2).sum(1).argmin()]]
    gum = np.flatnonzero(labels == 0)
    point = {g: [tuple(p.position) for p in scan.points() if p.group == g] for g in ids}

    def and_back(name, call, on, before=None):
        clicked = out.time("click", lambda: seg.click(clicks[on]))
        if clicked:
            seg.undo()
        if before:
            before()
        if out.time(name, call):
            if clicked:
                out.over.setdefault(name, []).append(out.ms[name][-1] / out.ms["click"][-1])
            out.time("undo", seg.undo)
            out.time("redo", lambda: library.call("ts_redo", seg.handle))
            seg.undo()
        if before:
            seg.undo()

    for t in ids:
        own = np.flatnonzero(labels == seg.tooth(t).label)
        beside = middle[gum[((middle[gum] - clicks[t]) ** 2).sum(1).argsort()[len(own) // 20]]]
        inside = middle[random.choice(own)]
        and_back("include", lambda: seg.correct("include", t, beside), t)
        and_back("exclude", lambda: seg.correct("exclude", t, inside), t)
        and_back("remove", lambda: library.call("ts_tooth_remove", seg.handle, u32(t)), t)
        and_back("move", lambda: seg.move_point(t, point[t][0], inside), t)
        and_back("lock", lambda: library.call("ts_tooth_set_locked", seg.handle, u32(t), u32(1)), t)
    for a, b in zip(ids, ids[1:]):
        merge = lambda: library.call("ts_tooth_merge", seg.handle, u32(a), u32(b), None)  # noqa: E731
        and_back("merge", merge, a)
        and_back("split", lambda: library.call("ts_tooth_split", seg.handle, u32(a), (f64 * 3)(*point[a][0]),
                                               (f64 * 3)(*point[b][0]), None, ctypes.byref(u32())), a, merge)
    return out


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--triangles", type=int, default=300000)
    parser.add_argument("--build", default=os.path.join(ROOT, "build", "release"))
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--threads", type=int, default=2)
    parser.add_argument("--json")
    o = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "arch.ply")
        subprocess.run([os.path.join(o.build, "samples", "make-arch"), path, "--triangles", str(o.triangles), "--seed", str(o.seed)],
                       check=True, capture_output=True)
        v, f = score.read_ply(path)
        library = Library(os.path.join(o.build, "src", "api", "libtoothseg.so"), o.threads)
        out = measure(library, Scan(library, path), v, f, o.seed)
    rows = [[n, len(x), out.refused.get(n, 0), number(float(np.median(x)), 2),
             number(float(np.median(out.over.get(n) or x / np.median(out.ms["click"]))), 2)] for n, x in out.ms.items()]
    print(table(["call", "calls", "refused", "median, ms", "over a click"], rows))
    if o.json:
        with open(o.json, "w") as file:
            json.dump({r[0]: float(r[4]) for r in rows}, file, indent=1)


if __name__ == "__main__":
    main()
