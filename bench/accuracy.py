#!/usr/bin/env python3
"""The accuracy table: ts-segment on the labelled real scans, clicks and scores from the one scorer.

    accuracy.py [--tool build/release/samples/ts-segment] [--scans ../shared/data/scans] [--scorer ../shared/tools/score_labels.py]
                [--presets default,paper] [--ablate] [--synthetic] [--modes auto,pairs,each] [--seeds 1,2,3] [--only SUBSTRING] [--json OUT] [--markdown OUT] [--jobs 2]

--ablate: the default preset with each of its steps off in turn, clicks by ts-segment.
Modes: auto (ts-segment clicks for itself), pairs (N/2 clicks), each (a click a tooth).
Figures a scan: teeth; groups right (the tooth owns exactly one group, and that group no other tooth), split (more than
one), merged (one shared), missed (none), false (groups without a tooth); clicks that took the tooth under them; IoU
mean and least, Dice, share of teeth at 0.9 and more, teeth under 0.5, boundary error in mm. Totals are over all teeth.
Where the scans are not (they are no part of the project), or with --synthetic, the same is done on synthetic arches with
exact labels, some as hard as the failures on real scans; border distances are then left out.
Needs python3-numpy and python3-scipy.
"""
import argparse
import concurrent.futures
import importlib.util
import contextlib
import io
import json
import os
import statistics
import subprocess
import sys
import tempfile

import numpy as np

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))


def load_scorer(path):
    spec = importlib.util.spec_from_file_location("score_labels", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


# Arguments of make-arch: both jaws, crowding from none to severe, teeth missing, noise, coarse.
ARCHES = {
    "lower-none": ["--jaw", "lower", "--crowding", "none"],
    "upper-mild": ["--jaw", "upper", "--crowding", "mild"],
    "lower-mild-missing": ["--jaw", "lower", "--crowding", "mild", "--missing", "36,45"],
    "upper-moderate": ["--jaw", "upper", "--crowding", "moderate"],
    "lower-moderate": ["--jaw", "lower", "--crowding", "moderate"],
    "upper-severe": ["--jaw", "upper", "--crowding", "severe"],
    "lower-severe": ["--jaw", "lower", "--crowding", "severe"],
    "upper-missing-incisor": ["--jaw", "upper", "--missing", "11,24"],
    "lower-base-noise": ["--jaw", "lower", "--crowding", "mild", "--base", "--noise", "0.2"],
    "upper-coarse": ["--jaw", "upper", "--crowding", "mild", "--triangles", "12000"],
}


def make_arches(tool, folder):
    """Scan folders of synthetic arches, as the real ones are laid out."""
    maker = os.path.join(os.path.dirname(tool), "make-arch")
    for name, arguments in ARCHES.items():
        os.makedirs(os.path.join(folder, name))
        size = [] if "--triangles" in arguments else ["--triangles", "60000"]
        subprocess.run([maker, os.path.join(folder, name, "mesh.ply"), "--labels",
                        os.path.join(folder, name, "face_labels.txt"), *arguments, *size], check=True, capture_output=True)


def clicks_for(scorer, v, f, ref, mode, seed, path):
    text = io.StringIO()
    with contextlib.redirect_stdout(text):
        scorer.make_clicks(v, f, ref, mode, seed)
    with open(path, "w") as out:
        out.write(text.getvalue())
    return [int(line.split()[3]) for line in text.getvalue().splitlines()]


def teeth_of_groups(features, v, f, ref):
    """For each group the teeth that its points lie on (label of the face nearest to the point)."""
    from scipy.spatial import cKDTree
    tree = cKDTree(v[f].mean(1))
    return {g["id"]: [int(ref[tree.query(p["position"])[1]]) for p in g["points"]] for g in features["groups"]}


def group_figures(groups, ref):
    teeth = [t for t in np.unique(ref) if t]
    owners = {t: [g for g, on in groups.items() if t in on] for t in teeth}
    alone = {g: len(set(on) - {0}) == 1 for g, on in groups.items()}
    return {"teeth": len(teeth), "groups": len(groups),
            "right": sum(1 for t in teeth if len(owners[t]) == 1 and alone[owners[t][0]]),
            "split": sum(1 for t in teeth if len(owners[t]) > 1),
            "merged": sum(1 for t in teeth if any(not alone[g] for g in owners[t])),
            "missed": sum(1 for t in teeth if not owners[t]),
            "false": sum(1 for on in groups.values() if not set(on) - {0})}


def majority(on):
    """The tooth that most of a group's points lie on; 0 if all lie on gingiva."""
    on = [t for t in on if t]
    return max(set(on), key=on.count) if on else 0


# Each step of the default preset turned off, or back to what the paper has.
ABLATIONS = {
    "weights of Eq. 8, theta 0.2": ["weights=1", "beta=0.01"],
    "cotangent weights (ref. 39)": ["weights=2"],
    "uniform weights": ["weights=3"],
    "seeds: one vertex": ["seed_radius=0"],
    "background: gingiva and the neighbour only": ["background=1"],
    "background: the neighbour only": ["background=0"],
    "one point a tooth": ["points_per_group=1"],
    "level: half way": ["cut_rule=2"],
    "level: the paper's largest gradient": ["cut_rule=0"],
    "no minimum cut": ["refine_band=0"],
    "holes left open": ["hole_area=0"],
    "outliers kept": ["reject_outliers=0"],
    "clicks by plain distance": ["click_concavity=0"],
}


def run(options, scan, preset, mode, seed):
    scorer = load_scorer(options.scorer)
    folder = os.path.join(options.scans, scan)
    v, f = scorer.read_ply(folder + "/mesh.ply")
    ref = np.loadtxt(folder + "/face_labels.txt", dtype=int)
    with tempfile.TemporaryDirectory() as tmp:
        settings = [x for s in ABLATIONS.get(preset, []) for x in ("--set", s)]
        command = [options.tool, folder + "/mesh.ply", "--preset", "default" if settings else preset, *settings, "--labels", tmp + "/labels.txt",
                   "--report", tmp + "/report.json", "--features", tmp + "/features.json", "--threads", "1"]
        clicked = None
        if mode != "auto":
            clicked = clicks_for(scorer, v, f, ref, mode, seed, tmp + "/clicks.txt")
            command += ["--clicks", tmp + "/clicks.txt"]
        done = subprocess.run(command, capture_output=True, text=True)
        if not os.path.exists(tmp + "/labels.txt"):
            return {"scan": scan, "preset": preset, "mode": mode, "seed": seed, "error": done.stderr.strip()}
        pred = np.loadtxt(tmp + "/labels.txt", dtype=int)
        report = json.load(open(tmp + "/report.json"))
        features = json.load(open(tmp + "/features.json"))
    figures = scorer.score(v, f, ref, pred)
    groups = teeth_of_groups(features, v, f, ref)
    out = {"scan": scan, "preset": preset, "mode": mode, "seed": seed, "ms": report["ms"], **figures,
           "group": group_figures(groups, ref), "failed_clicks": report["counts"]["failed_clicks"],
           "clicks": report["counts"]["clicks"]}
    if clicked:
        took = [majority(groups[c["target"]["group"]]) if c["status"] == "TS_OK" else -1 for c in report["clicks"]]
        out["click_right"] = sum(1 for a, b in zip(took, clicked) if a == b)
    instance = {t["label"]: t["confidence"] for t in report["teeth"]}
    area = scorer.face_areas(v, f)
    out["calibration"] = [(c, best_iou(area, ref, pred == label)) for label, c in instance.items()]
    return out


def best_iou(area, ref, part):
    on, own = np.unique(ref[part]), area[part].sum()
    best = 0.0
    for t in on[on > 0]:
        common = area[part & (ref == t)].sum()
        best = max(best, common / (own + area[ref == t].sum() - common))
    return float(best)


def row(runs):
    """One line of figures from runs that belong together (scans of one seed)."""
    teeth = sum(r["teeth"] for r in runs)
    mean = lambda key: sum(r[key] * r["teeth"] for r in runs) / teeth
    out = {"teeth": teeth, "clicks": sum(r["clicks"] for r in runs), "iou": mean("iou_mean"),
           "min": min(r["iou_min"] for r in runs), "dice": mean("dice_mean"), "share90": mean("share_090"),
           "under50": sum(r["missed"] for r in runs), "false": sum(r["false"] for r in runs),
           "edge": mean("edge_mean"), "p95": mean("edge_p95"), "failed": sum(r["failed_clicks"] for r in runs)}
    if "click_right" in runs[0]:
        out["click_right"] = sum(r["click_right"] for r in runs) / max(1, out["clicks"])
    return out


def median_row(rows):
    return {k: statistics.median(r[k] for r in rows) for k in rows[0]}


COLUMNS = [("teeth", "%d"), ("clicks", "%d"), ("click_right", "%.3f"), ("failed", "%d"), ("iou", "%.4f"), ("min", "%.3f"),
           ("dice", "%.4f"), ("share90", "%.3f"), ("under50", "%d"), ("false", "%d"), ("edge", "%.3f"), ("p95", "%.3f")]


def table(lines):
    head = ["what"] + [c for c, _ in COLUMNS]
    out = ["| " + " | ".join(head) + " |", "|" + "---|" * len(head)]
    for name, r in lines:
        out.append("| " + " | ".join([name] + [fmt % r[c] if c in r else "" for c, fmt in COLUMNS]) + " |")
    return "\n".join(out)


def calibration(runs):
    sure = [iou for r in runs for c, iou in r["calibration"] if c >= 0.9]
    everyone = [iou for r in runs for c, iou in r["calibration"]]
    return {"given": len(everyone), "sure": len(sure),
            "right_of_sure": sum(i >= 0.8 for i in sure) / len(sure) if sure else float("nan"),
            "right_of_all": sum(i >= 0.8 for i in everyone) / max(1, len(everyone))}


def ablation_table(results):
    names = list(dict.fromkeys(r["preset"] for r in results))
    return table([(n, row([r for r in results if r["preset"] == n])) for n in names])


def summarise(results, options):
    text = []
    good = [r for r in results if "error" not in r]
    for r in results:
        if "error" in r:
            text.append("FAILED %(scan)s %(preset)s %(mode)s: %(error)s" % r)
    first = {r["scan"]: r["group"] for r in good}
    text += ["## Features", "", "| scan | teeth | groups | right | split | merged | missed | false |", "|" + "---|" * 8]
    total = dict.fromkeys(["teeth", "groups", "right", "split", "merged", "missed", "false"], 0)
    for scan, g in sorted(first.items()):
        text.append("| %s | %s |" % (scan, " | ".join(str(g[k]) for k in total)))
        for k in total:
            total[k] += g[k]
    text.append("| all | %s |" % " | ".join(str(total[k]) for k in total))
    if total["teeth"]:
        text.append("\nTeeth that own exactly one group of theirs alone: %.1f %%. Scans with the right number of groups: %d of %d.\n" %
                    (100 * total["right"] / total["teeth"], sum(g["groups"] == g["teeth"] for g in first.values()), len(first)))
    for preset in options.presets:
        text += ["## Preset " + preset, ""]
        lines = []
        for mode in options.modes:
            by_seed = {}
            for r in good:
                if r["preset"] == preset and r["mode"] == mode:
                    by_seed.setdefault(r["seed"], []).append(r)
            if by_seed:
                lines.append(("**%s**, all scans" % mode, median_row([row(rs) for rs in by_seed.values()])))
                for scan in sorted(first):
                    rs = [[r for r in b if r["scan"] == scan] for b in by_seed.values()]
                    rs = [row(x) for x in rs if x]
                    if rs:
                        lines.append((mode + " " + scan, median_row(rs)))
        text += [table(lines), ""]
        for mode in options.modes:
            runs = [r for r in good if r["preset"] == preset and r["mode"] == mode]
            if runs:
                text.append("Confidence, %s: of %d teeth %d are given 0.9 or more; of these %.1f %% have IoU >= 0.8 (of all: %.1f %%)." %
                            (mode, *(lambda c: (c["given"], c["sure"], 100 * c["right_of_sure"], 100 * c["right_of_all"]))(calibration(runs))))
        text.append("")
    return "\n".join(text)


def main():
    a = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    a.add_argument("--tool", default=ROOT + "/build/release/samples/ts-segment")
    a.add_argument("--scans", default=ROOT + "/../shared/data/scans")
    a.add_argument("--scorer", default=ROOT + "/../shared/tools/score_labels.py")
    a.add_argument("--presets", default="default,paper")
    a.add_argument("--ablate", action="store_true")
    a.add_argument("--synthetic", action="store_true")
    a.add_argument("--modes", default="auto,pairs,each")
    a.add_argument("--seeds", default="1,2,3")
    a.add_argument("--only", default="")
    a.add_argument("--json")
    a.add_argument("--markdown")
    a.add_argument("--jobs", type=int, default=os.cpu_count())
    o = a.parse_args()
    o.presets, o.modes = o.presets.split(","), o.modes.split(",")
    if o.ablate:
        o.presets, o.modes = ["default", *ABLATIONS], ["auto"]
    made = None
    if o.synthetic or not os.path.isdir(o.scans):
        made = tempfile.TemporaryDirectory()
        o.scans, o.scorer = made.name, os.path.join(ROOT, "bench", "score.py")
        make_arches(o.tool, o.scans)
    scans = [s for s in sorted(os.listdir(o.scans))
             if o.only in s and os.path.exists(os.path.join(o.scans, s, "face_labels.txt"))]
    work = [(s, p, m, k) for s in scans for p in o.presets for m in o.modes
            for k in ([1] if m == "auto" else [int(x) for x in o.seeds.split(",")])]
    with concurrent.futures.ProcessPoolExecutor(o.jobs) as pool:
        results = list(pool.map(run, [o] * len(work), *zip(*work)))
    text = ablation_table([r for r in results if "error" not in r]) if o.ablate else summarise(results, o)
    print(text)
    if o.json:
        json.dump(results, open(o.json, "w"), indent=1)
    if o.markdown:
        open(o.markdown, "w").write(text + "\n")
    if any("error" in r for r in results):
        sys.exit(1)


if __name__ == "__main__":
    main()
