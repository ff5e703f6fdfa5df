#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What the binding costs: overhead.py LIBDIR BINDIR prints, as JSON, ns a no-op call (of the fastest of
many batches, so that what else the machine does has no say) and ms (median of 50) a read-back of the
labels of a scan with 300,000 faces, into a new array and into the same one again (../overhead.sh: beside C).
LIBDIR has libtoothseg.so, and ../include; BINDIR make-arch."""
import json
import os
import statistics
import subprocess
import sys
import tempfile
import time
import timeit

CALLS, BATCHES, RUNS = 500, 400, 50


def median_ms(call):
    runs = []
    for _ in range(RUNS):
        start = time.perf_counter()
        call()
        runs.append((time.perf_counter() - start) * 1e3)
    return round(statistics.median(runs), 4)


def in_python(scan):
    import numpy as np
    import toothseg

    batch = min(timeit.repeat(lambda: toothseg.fdi_to_universal(11), number=CALLS, repeat=BATCHES))
    with toothseg.Context() as context, toothseg.Model.load(context, scan) as model, \
         toothseg.Features.detect(model) as features, toothseg.Segmentation(features) as segmentation:
        segmentation.segment_all()
        out = np.empty_like(segmentation.labels())
        return {"call_ns": round(batch * 1e9 / CALLS), "faces": len(out), "labels_ms": median_ms(segmentation.labels),
                "labels_into_ms": median_ms(lambda: segmentation.labels(out))}


def main():
    if len(sys.argv) != 3:
        sys.exit("usage: overhead.py LIBDIR BINDIR")
    libraries, programs = (os.path.abspath(a) for a in sys.argv[1:])
    os.environ["TOOTHSEG_LIBRARY"] = os.path.join(libraries, "libtoothseg.so")
    with tempfile.TemporaryDirectory() as folder:
        scan = os.path.join(folder, "arch.ply")
        subprocess.run([os.path.join(programs, "make-arch"), scan, "--triangles", "300000"], check=True,
                       env={**os.environ, "LD_LIBRARY_PATH": libraries}, stdout=subprocess.DEVNULL)
        print(json.dumps(in_python(scan)))


if __name__ == "__main__":
    main()
