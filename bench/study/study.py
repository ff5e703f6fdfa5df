#!/usr/bin/env python3
"""The paper's study on arches that anyone can generate: runs what has not been measured yet and writes the report.

    study.py [--quick] [--folder build/study] [--build build/release] [--out docs/study.md] [--jobs 2]

scripts/study.sh installs and builds what it needs and calls it. --quick: three arches of 60,000 triangles instead of the ten
of the paper's Table 1. What was measured is kept in the folder and is not measured again while library, programs and code
are the same. Sections so far: 1 (crowding) and 5 (the skeleton).
"""
import argparse
import datetime
import os
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)
import crowding  # noqa: E402
import rival  # noqa: E402
from library import Library  # noqa: E402
from pieces import Study, library_path, machine, run  # noqa: E402
from scoring import summary  # noqa: E402
from text import number, table  # noqa: E402

ROOT = os.path.dirname(os.path.dirname(HERE))


def targets(study, results):
    means, least = [], []
    for case in crowding.models(study):
        r = results.get("crowding/" + case, {})
        if "seeds" in r:
            s = summary(crowding.rows_of(r))
            means.append(s["iou"]), least.append(s["least"])
    if not means:
        return []
    rows = [["mean IoU of each arch", ">= .93", "%s to %s" % (number(min(means)), number(max(means))),
             "met" if min(means) >= 0.93 else "not met on %d of %d" % (sum(m < 0.93 for m in means), len(means))],
            ["least tooth", ">= .75", number(min(least)),
             "met" if min(least) >= 0.75 else "not met on %d of %d arches" % (sum(x < 0.75 for x in least), len(least))]]
    return ["## Targets", "", table(["figure", "target", "measured", ""], rows), ""]


def header(study):
    git = subprocess.run(["git", "-C", ROOT, "describe", "--always", "--dirty"], capture_output=True, text=True).stdout.strip()
    m = machine()
    return ["# The paper's study", "",
            "Written by `scripts/study.sh`; every number below comes from its run. toothseg %s, commit %s, %s; %s, %d cores. Ten synthetic "
            "arches, seeds 1 to 10; sizes in the tables. Not done yet: resolution and noise, weights, single constraints, CGAL, times, "
            "pictures; real scans are in `docs/accuracy.md`." % (
                Library(library_path(study)).lib.ts_version().decode(), git, datetime.date.today(), m["cpu"], m["cores"]), ""]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--quick", action="store_true")
    parser.add_argument("--folder", default=os.path.join(ROOT, "build", "study"))
    parser.add_argument("--build", default=os.path.join(ROOT, "build", "release"))
    parser.add_argument("--out", default=None)
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    options = parser.parse_args()
    study = Study(options.quick, options.folder, options.build, None, None, None)
    # The arches first, each once: both sections are measured on them.
    results = run(study, [crowding.pieces(study), rival.pieces(study)], options.jobs)
    text = header(study) + targets(study, results) + crowding.section(study, results) + rival.section(study, results)
    out = options.out or os.path.join(study.folder if study.quick else os.path.join(ROOT, "docs"), "study.md")
    with open(out, "w") as f:
        f.write("\n".join(text))
    print("written:", out)
    return 1 if any("error" in r for r in results.values()) else 0


if __name__ == "__main__":
    sys.exit(main())
