#!/usr/bin/env python3
"""The paper's study on arches that anyone can generate: runs what has not been measured yet and writes the report.

scripts/study.sh installs and builds what this needs and calls it with the same options. What was measured is kept in the folder
and is not measured again while library, programs and code are the same: a run that was stopped goes on where it was.

    study.py             the report is docs/study.md, its pictures docs/study/*.png
    study.py --quick     fewer and smaller arches; the report is build/study-quick/study.md
    study.py --check     exit 1 when a headline figure is worse than the one in bench/study/headline.json by more than its
                         tolerance. Exit 1 with or without it when a piece failed
    study.py --store     makes this run's headline figures the stored ones of its form (quick or full)
"""
import argparse
import datetime
import importlib
import os
import shlex
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, HERE)
import crowding  # noqa: E402
import targets  # noqa: E402
from library import Library  # noqa: E402
from pieces import PICTURE, Study, library_path, machine, run  # noqa: E402

ROOT = os.path.dirname(os.path.dirname(HERE))
# In the order of the report. Each has pieces(study) and section(study, results), and headline(study, results) if it has figures.
SECTIONS = ("crowding", "resolution", "weights", "constraints", "rival", "times", "scans", "anatomy")


def read_options():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--quick", action="store_true", help="fewer and smaller arches, without the real scans")
    parser.add_argument("--check", action="store_true", help="fail when a headline figure got worse")
    parser.add_argument("--store", action="store_true", help="write bench/study/headline.json")
    parser.add_argument("--sections", default=",".join(SECTIONS), metavar="LIST",
                        help="some of %(default)s; the report then is that of a part and goes to the folder")
    parser.add_argument("--no-pictures", action="store_true")
    parser.add_argument("--scans", default=os.path.join(ROOT, "..", "shared", "data", "scans"), metavar="DIR",
                        help="labelled real scans, a folder each; no part of the project")
    parser.add_argument("--scorer", default=os.path.join(ROOT, "..", "shared", "tools", "score_labels.py"), help="of the real scans")
    parser.add_argument("--build", default=os.path.join(ROOT, "build", "release"))
    parser.add_argument("--folder", default=None, help="of what was measured; build/study or build/study-quick")
    parser.add_argument("--out", default=None, help="the report")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    options = parser.parse_args()
    options.sections = options.sections.split(",")
    unknown = set(options.sections) - set(SECTIONS)
    if unknown:
        parser.error("no section " + ", ".join(sorted(unknown)))
    options.folder = os.path.abspath(options.folder or os.path.join(ROOT, "build", "study-quick" if options.quick else "study"))
    whole = not options.quick and set(options.sections) == set(SECTIONS) and not options.no_pictures
    options.out = os.path.abspath(options.out or os.path.join(os.path.join(ROOT, "docs") if whole else options.folder, "study.md"))
    return options


def header(study):
    git = subprocess.run(["git", "-C", ROOT, "describe", "--always", "--dirty"], capture_output=True, text=True).stdout.strip()
    m, specs = machine(), crowding.models(study).values()
    sizes, seeds = [s["triangles"] for s in specs], ", ".join(str(s["seed"]) for s in specs)
    size = "%d" % sizes[0] if min(sizes) == max(sizes) else "%d to %d" % (min(sizes), max(sizes))
    return ["# The paper's study", "",
            "Written by `scripts/study.sh`; every number below comes from its run. toothseg %s, commit %s, %s; %s, %d cores. %d synthetic "
            "arches of %s triangles, seeds %s, clicks of seeds %s; other sizes and seeds are in the tables. Command: "
            "`scripts/study.sh%s`. The paper is *Interactive Tooth Separation from Dental Model Using Segmentation Field* (Li & Wang, "
            "PLOS ONE 2016); figures and tables in brackets are its." % (
                Library(library_path(study)).version, git or "unknown", datetime.date.today(), m["cpu"], m["cores"], len(sizes), size, seeds,
                ", ".join(map(str, crowding.SEEDS[:1] if study.quick else crowding.SEEDS)),
                "".join(" " + shlex.quote(a) for a in sys.argv[1:])), ""]


def main():
    options = read_options()
    study = Study(options.quick, options.folder, os.path.abspath(options.build), os.path.abspath(options.scans),
                  os.path.abspath(options.scorer), not options.no_pictures, options.out)
    modules = {name: importlib.import_module(name) for name in SECTIONS if name in options.sections}
    pieces = {name: module.pieces(study) for name, module in modules.items()}
    # The arches of section 1 first, each made once: other sections are measured on them, and pictures drawn of them.
    first = [p for p in pieces.get("crowding", []) if not p.name.startswith(PICTURE)]
    results = run(study, [first, [p for some in pieces.values() for p in some if p not in first]], options.jobs)

    figures = {name: module.headline(study, results) for name, module in modules.items() if pieces[name] and hasattr(module, "headline")}
    text = header(study) + targets.section(figures)
    for module in modules.values():
        text += module.section(study, results)
    os.makedirs(os.path.dirname(options.out), exist_ok=True)
    with open(options.out, "w") as f:
        f.write("\n".join(text))
    print("written:", options.out)

    failed = {name: r["error"] for name, r in results.items() if "error" in r}
    for name, error in failed.items():
        print("FAILED %s: %s" % (name, error))
    form, good = "quick" if study.quick else "full", not failed
    if options.check:
        lines, kept = targets.compare(form, figures)
        print("\n".join(lines))
        good = good and kept
    if options.store and failed:
        print("not stored: pieces failed")
    elif options.store:
        targets.store(form, figures)
        print("stored:", targets.STORED)
    return 0 if good else 1


if __name__ == "__main__":
    sys.exit(main())
