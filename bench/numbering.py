#!/usr/bin/env python3
"""Are the FDI numbers right: ts-segment --fdi on synthetic arches and on the labelled real scans.

    numbering.py [--tool build/release/samples/ts-segment] [--scans ../shared/data/scans] [--seeds 1,2,3] [--triangles 40000]
               [--only real|synthetic] [--json OUT] [--jobs 2]

Synthetic: both jaws, crowding none to severe, each seed with 0 to 4 teeth missing in random places. Real: scans whose
meta.json says that their numbers are to be trusted ("reference"). Each once with the jaw given and once without.
A tooth is found if a separated part has an IoU over .5 with it; a found one is right or wrong by its number. `sure`: numbers
of found teeth with a confidence of .9 and more, and how many of these are wrong. `untold`: arches whose jaw ts-segment
refuses to tell. Nothing is fitted to these scans: widths and spreads are published ones (src/tooth/numbering.cpp).
Needs python3-numpy.
"""
import argparse
import concurrent.futures
import json
import os
import random
import subprocess
import sys
import tempfile

import numpy as np

import score

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
CROWDING = ["none", "mild", "moderate", "severe"]


def arches(seeds, triangles):
    """Name, jaw and make-arch arguments."""
    for jaw in ("upper", "lower"):
        for crowding in CROWDING:
            for seed in seeds:
                for missing in range(5):
                    rng = random.Random("%s %s %d %d" % (jaw, crowding, seed, missing))
                    teeth = [10 * q + p for q in ((1, 2) if jaw == "upper" else (3, 4)) for p in range(1, 8)]
                    gone = ",".join(map(str, sorted(rng.sample(teeth, missing))))
                    name = "%s-%s-%d%s" % (jaw, crowding, seed, "-without-" + gone if gone else "")
                    yield name, jaw, ["--jaw", jaw, "--crowding", crowding, "--seed", str(seed), "--triangles",
                                      str(triangles)] + (["--missing", gone] if gone else [])


def trusted(folder):
    for scan in sorted(os.listdir(folder)) if os.path.isdir(folder) else []:
        path = os.path.join(folder, scan)
        if os.path.exists(path + "/meta.json"):
            meta = json.load(open(path + "/meta.json"))
            if meta["use_labels_as"] == "reference":
                yield scan, meta["jaw"], path


def compare(v, f, reference, predicted, confidence):
    """For each reference tooth: its number, that of the part found for it (0: none), and the confidence."""
    area, out = score.areas(v, f), []
    for t in (t for t in np.unique(reference) if t):
        own = reference == t
        best, number = 0.5, 0
        for p in (p for p in np.unique(predicted[own]) if p):
            common = area[own & (predicted == p)].sum()
            iou = common / (area[own | (predicted == p)].sum())
            if iou > best:
                best, number = iou, int(p)
        out.append((int(t), number, confidence.get(number, 0)))
    return out


def run(options, name, jaw, source):
    with tempfile.TemporaryDirectory() as tmp:
        mesh, truth = tmp + "/mesh.ply", tmp + "/truth.txt"
        if isinstance(source, list):
            maker = os.path.join(os.path.dirname(options.tool), "make-arch")
            subprocess.run([maker, mesh, "--labels", truth, *source], check=True, capture_output=True)
            kind = "synthetic"
        else:
            mesh, truth, kind = source + "/mesh.ply", source + "/face_labels.txt", "real"
        v, f = score.read_ply(mesh)
        reference = np.loadtxt(truth, dtype=int)
        rows = []
        for given in (True, False):
            row = {"name": name, "kind": kind, "given": given, "jaw": jaw, "teeth": []}
            command = [options.tool, mesh, "--fdi", "--labels", tmp + "/l.txt", "--report", tmp + "/r.json", "--threads", "1"]
            done = subprocess.run(command + (["--jaw", jaw] if given else []), capture_output=True, text=True)
            if done.returncode in (0, 1):
                report = json.load(open(tmp + "/r.json"))
                row["told"], row["jaw_confidence"] = report["jaw"], report["jaw_confidence"]
                confidence = {t["fdi"]: t["fdi_confidence"] for t in report["teeth"]}
                row["teeth"] = compare(v, f, reference, np.loadtxt(tmp + "/l.txt", dtype=int), confidence)
                os.remove(tmp + "/l.txt")
            else:
                row["error"] = done.stderr.strip().splitlines()[-1]
                row["untold"] = "jaw cannot be told" in row["error"]
                row["missed"] = len(np.unique(reference)) - 1
            rows.append(row)
        return rows


def line(what, rows):
    teeth = [t for r in rows for t in r["teeth"]]
    found = [t for t in teeth if t[1]]
    right = [t for t in found if t[0] == t[1]]
    sure = [t for t in found if t[2] >= 0.9]
    whole = sum(bool(r["teeth"]) and all(t[0] == t[1] for t in r["teeth"] if t[1]) for r in rows)
    return "| %s | %d | %d | %d | %d | %d | %d | %.4f | %d | %d | %d | %d |" % (
        what, len(rows), whole, len(teeth) + sum(r.get("missed", 0) for r in rows), len(found), len(right),
        len(found) - len(right), len(right) / max(1, len(found)), len(sure), sum(t[0] != t[1] for t in sure),
        sum(r.get("told", r["jaw"]) != r["jaw"] for r in rows), sum(r.get("untold", False) for r in rows))


def report(rows):
    out = ["| what | arches | all right | teeth | found | right | wrong | share | sure | sure, wrong | jaw wrong | untold |",
           "|" + "---|" * 12]
    for kind in ("synthetic", "real"):
        for given in (True, False):
            some = [r for r in rows if r["kind"] == kind and r["given"] == given]
            if not some:
                continue
            what = "%s, jaw %s" % (kind, "given" if given else "estimated")
            out.append(line("**%s**" % what, some))
            whole = [r for r in some if r["teeth"] and all(t[1] for t in r["teeth"])]
            out.append(line(what + ", all teeth found", whole))
            if kind == "synthetic":
                for crowding in CROWDING:
                    out.append(line(what + ", " + crowding, [r for r in some if crowding in r["name"]]))
            else:
                out += [line(what + ", " + r["name"], [r]) for r in some]
    out += ["", "Misses: tooth > number that it got, with its confidence; untold, wrong jaw.", ""]
    for r in rows:
        misses = ["%d > %d (%.2f)" % tuple(t) for t in r["teeth"] if t[1] and t[0] != t[1]]
        if "error" in r:
            misses = [r["error"]]
        if misses:
            out.append("- %s, jaw %s: %s" % (r["name"], "given" if r["given"] else "estimated: %s (%.2f)" % (
                r.get("told"), r.get("jaw_confidence", 0)), "; ".join(misses)))
    return "\n".join(out)


def main():
    a = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    a.add_argument("--tool", default=ROOT + "/build/release/samples/ts-segment")
    a.add_argument("--scans", default=ROOT + "/../shared/data/scans")
    a.add_argument("--seeds", default="1,2,3")
    a.add_argument("--triangles", type=int, default=40000)
    a.add_argument("--only", choices=["real", "synthetic"])
    a.add_argument("--json")
    a.add_argument("--jobs", type=int, default=os.cpu_count())
    o = a.parse_args()
    work = []
    if o.only != "real":
        work += arches([int(s) for s in o.seeds.split(",")], o.triangles)
    if o.only != "synthetic":
        work += trusted(o.scans)
    with concurrent.futures.ProcessPoolExecutor(o.jobs) as pool:
        rows = [r for rs in pool.map(run, [o] * len(work), *zip(*work)) for r in rs]
    print(report(rows))
    if o.json:
        json.dump(rows, open(o.json, "w"), indent=1)
    if any("error" in r and not r["untold"] for r in rows):
        sys.exit(1)


if __name__ == "__main__":
    main()
