"""Section 6 (paper, Fig. 11): how long a click takes, stage by stage, the paper's way and ours."""
import json
import subprocess

import crowding
import meshes
import plots
from pieces import Piece
from targets import Figure
from text import ms, number, table

STAGES = ("field", "cut", "label")
ROUNDS = 3


def measure(study, spec):
    mesh = meshes.arch(study, **spec)
    done = subprocess.run([meshes.tool(study, "ts-click-times"), mesh.path, "--rounds", str(1 if study.quick else ROUNDS)], check=True,
                          capture_output=True, text=True)
    return json.loads(done.stdout)


def pieces(study):
    if not meshes.tool(study, "ts-click-times"):
        return []
    return [Piece("times/" + case, "times", "measure", {"spec": spec}, alone=True, tools=("make-arch", "ts-click-times"))
            for case, spec in crowding.models(study).items()]


def ways(r):
    """ms a stage: the paper's way and ours. The paper preset's field here is a solution only: all of it is put in place of that."""
    theirs = {"field": r["paper_field"]["total"], "cut": r["paper_preset"]["cut"], "label": r["paper_preset"]["label"]}
    ours = r["ours"]
    # Ours solves the field where the cut looks at it, so that its time is a share of the other stages' (ts_click_times).
    return {**theirs, "total": sum(theirs.values())}, {stage: ours[stage] for stage in (*STAGES, "total")}


def measured(study, results):
    got = {case: results.get("times/" + case, {"error": "not measured"}) for case in crowding.models(study)}
    return {case: r for case, r in got.items() if "error" not in r}, [case for case, r in got.items() if "error" in r]


def headline(study, results):
    totals = [ways(r) for r in measured(study, results)[0].values()]
    least = min((a["total"] / b["total"] for a, b in totals), default=float("nan"))
    return [Figure("a click, the paper's way / ours, least", least, None, None, "more", least / 2)]


def section(study, results):
    got, failed = measured(study, results)
    text = ["## 6. Time of a click (Fig. 11)", "",
            "Medians over the clicks that the library proposes, ms, on the untouched scan with all cores, each model alone on the machine, both "
            "ways in turns (%d rounds). The paper's way assembles, analyses, factorises and solves the whole system for each click (Eigen's "
            "SimplicialLDLT), then selects the cut and labels as the library does it with the paper's preset. Ours prepares a scan once and "
            "solves the field where the cut looks at it: its `field` is a share of `cut` and `label`, and not added again. `total` is from the "
            "point to the labels of all faces." % (1 if study.quick else ROUNDS), ""]
    if not got:
        return text + ["Not measured: ts-click-times is not built.", ""]
    rows = []
    for case, r in got.items():
        a, b = ways(r)
        rows.append([case, r["vertices"], r["ours"]["clicks"] // r["rounds"], *(ms(a[k]) for k in (*STAGES, "total")),
                     *(ms(b[k]) for k in (*STAGES, "total")), number(a["field"] / b["field"], 0), number(a["total"] / b["total"], 1),
                     ms(r["prepare"]["total"]), number((r["prepare"]["total"] + b["total"]) / a["total"], 2)])
    head = ["model", "vertices", "clicks", "paper's: field", "cut", "label", "total", "ours: field", "cut", "label", "total",
            "field, paper's / ours", "total, paper's / ours", "our preparation, once", "preparation and a click / paper's click"]
    text += [table(head, rows), ""] + (["Failed: " + ", ".join(failed) + ".", ""] if failed else [])
    if study.pictures:
        pairs = [ways(r) for r in got.values()]
        plots.bars(study, "times", list(got), {
            "The paper's way": {stage: [a[stage] for a, _ in pairs] for stage in STAGES},
            "Ours": {"field": [b["field"] for _, b in pairs], "cut and label": [b["total"] - b["field"] for _, b in pairs]}}, "ms a click")
        text += plots.placed(study, "times", "Milliseconds a click, each way on its own scale")
    return text
