#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Separates the teeth of an arch and writes a label for each face, one a line in the order of the scan's faces; 0: no tooth.

With a click for each two teeth, as the library proposes them, or with --all in one call. Ctrl-C stops it, and then nothing is
written but the teeth that were by then.

Exit status: 0 done; 1 a click failed, or a tooth has no mesh, and the others are written; 2 nothing is written;
130 stopped."""
import argparse
import os
import sys
from concurrent.futures import ThreadPoolExecutor

import toothseg
from toothseg import Status

#: a click that fails for its own sake leaves the others standing
ABOUT_THE_CLICK = {Status.CLICK_OFF_SURFACE, Status.CLICK_ON_GINGIVA, Status.NO_CUT, Status.INVALID_ARGUMENT, Status.LOCKED}


def complain(text):
    print(f"\rsegment_arch: {text}", file=sys.stderr)


def show(fraction, stage):
    print(f"\r{stage:<16}{100 * fraction:4.0f} %", end="", file=sys.stderr, flush=True)


def click(segmentation, job):
    """Proposes until nothing is left, or until a round separates nothing more. How many clicks failed."""
    failed, before = 0, -1
    while before < len(segmentation.teeth()):
        before = len(segmentation.teeth())
        for position in segmentation.propose_clicks():
            try:
                segmentation.click(position, job=job)
            except toothseg.Error as e:
                if e.status not in ABOUT_THE_CLICK:
                    raise
                complain(f"click at {position}: {e}")
                failed += 1
    return failed


def write_teeth(segmentation, folder, options, job):
    """How many could not be made."""
    failed = 0
    os.makedirs(folder, exist_ok=True)
    for tooth in [None] + segmentation.teeth():
        name = "gingiva" if tooth is None else f"tooth_{segmentation.tooth(tooth).label}"
        try:
            mesh = (toothseg.Mesh.gingiva(segmentation, options, job=job) if tooth is None else
                    toothseg.Mesh.tooth(segmentation, tooth, options, job=job))
        except toothseg.Error as e:
            if e.status not in (Status.NOT_CLOSED, Status.NO_CUT):
                raise
            complain(f"{name}: {e}")
            failed += 1
            continue
        with mesh:
            mesh.save(os.path.join(folder, f"{name}.stl"), toothseg.OutputFormat.STL, job=job)
    return failed


def segment(o, context, job):
    """The labels, and how much failed."""
    with toothseg.Model.load(context, o.scan, job=job) as model, toothseg.Features.detect(model, job=job) as features, \
         toothseg.Segmentation(features, job=job) as segmentation:
        failed = 0
        if o.all:
            segmentation.segment_all(job=job)
        else:
            failed = click(segmentation, job)
        if o.teeth:
            failed += write_teeth(segmentation, o.teeth, toothseg.ToothMeshOptions(closed=o.closed), job)
        return segmentation.labels(), failed


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scan", metavar="SCAN", help="an STL, PLY, OBJ or OFF file in mm")
    parser.add_argument("--all", action="store_true", help="all teeth in one call, without clicks")
    parser.add_argument("--labels", metavar="OUT.txt", required=True)
    parser.add_argument("--teeth", metavar="DIR", help="the mesh of each tooth, tooth_LABEL.stl, and gingiva.stl")
    parser.add_argument("--closed", action="store_true", help="these meshes watertight")
    parser.add_argument("--threads", type=int, default=0, help="0: one a core")
    o = parser.parse_args()

    def log(level, text):
        if level <= toothseg.LogLevel.WARNING:
            complain(text)

    try:
        # The work has a thread of its own, so that this one is there for Ctrl-C.
        with toothseg.Context(threads=o.threads, log=log) as context, toothseg.Job(context, show) as job, \
             ThreadPoolExecutor(1) as worker:
            try:
                labels, failed = worker.submit(segment, o, context, job).result()
            except KeyboardInterrupt:
                job.cancel()
                complain("stopped")
                return 130
        print(file=sys.stderr)
        with open(o.labels, "w", encoding="ascii") as f:
            f.writelines(f"{label}\n" for label in labels.tolist())
    except (toothseg.Error, OSError) as e:
        complain(f"{o.scan}: {e}")
        return 2
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
