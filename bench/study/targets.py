"""Headline figures: held against the targets of the study, and against those stored in headline.json by --store, of which none
may get worse by more than its tolerance."""
import json
import math
import os
from collections import namedtuple

from text import number, table

# `name` is its own among those of its module. `target` (a number, said as `target_text`) may be None: only guarded. `better`: "more"
# or "less". `tolerance`: by how much it may be worse than the stored one before --check fails.
Figure = namedtuple("Figure", "name value target_text target better tolerance")

STORED = os.path.join(os.path.dirname(os.path.abspath(__file__)), "headline.json")


def measured(x):
    return x is not None and math.isfinite(x)


def short_of(figure, bound, by=0.0):
    """Whether the figure is worse than `bound` by more than `by`."""
    return (bound - figure.value if figure.better == "more" else figure.value - bound) > by + 1e-9


def section(figures):
    """The table of the targets. `figures`: {module: [Figure]}."""
    rows = []
    for f in (f for some in figures.values() for f in some if f.target is not None):
        verdict = "not measured" if not measured(f.value) else "**not met**" if short_of(f, f.target) else "met"
        rows.append([f.name, f.target_text, number(f.value, 4), verdict])
    return ["## Targets", "", table(["figure", "target", "measured", ""], rows), ""] if rows else []


def read():
    if not os.path.exists(STORED):
        return {}
    with open(STORED) as f:
        return json.load(f)


def store(form, figures):
    """Puts the modules of `figures` into the block `form` (quick or full); the other modules' figures stay."""
    everything = read()
    block = everything.setdefault(form, {})
    for module, some in figures.items():
        block[module] = {f.name: {"value": round(float(f.value), 5), "tolerance": round(float(f.tolerance), 5)} for f in some if measured(f.value)}
    with open(STORED, "w") as out:
        json.dump(everything, out, indent=1, sort_keys=True)
        out.write("\n")


def compare(form, figures):
    """A table of all figures of these modules, stored and now, and whether none got worse. A module that had nothing to measure
    with (its programs are not built, the scans are not there) is left out of `figures` by the caller."""
    block, rows, good = read().get(form, {}), [], True
    for module, some in figures.items():
        now, then = {f.name: f for f in some if measured(f.value)}, block.get(module, {})
        for name in list(then) + [n for n in now if n not in then]:
            value = now[name].value if name in now else None
            stored, tolerance = then[name]["value"] if name in then else None, then[name]["tolerance"] if name in then else None
            if name not in now:
                verdict, good = "NOT MEASURED", False
            elif name not in then:
                verdict = "not stored yet"
            elif short_of(now[name], stored, tolerance):
                verdict, good = "WORSE", False
            else:
                verdict = "ok"
            rows.append(["%s: %s" % (module, name), stored, value, tolerance, verdict])
    width = max((len(r[0]) for r in rows), default=0)
    lines = ["%-*s  %10s %10s %10s" % (width, "figure", "stored", "now", "tolerance")]
    lines += ["%-*s  %10s %10s %10s  %s" % (width, r[0], *(number(x, 4) for x in r[1:4]), r[4]) for r in rows]
    if not any(module in block for module in figures):
        return ["nothing is stored for the %s form: run with --store first" % form], False
    return lines, good
