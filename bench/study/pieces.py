"""What is measured, piece by piece. A piece is a function with arguments; its result is a JSON file in the study's folder
whose name holds all that it depends on, so that what was measured once is not measured again."""
import concurrent.futures
import hashlib
import importlib
import json
import multiprocessing
import os
import platform
import sys
import time
from collections import namedtuple

import plots
from meshes import HERE, digest, tool

Study = namedtuple("Study", "quick folder build scans scorer pictures report")  # two flags; the rest are paths

# `module` and `function` say what is run; `alone`: nothing else may run meanwhile (it is timed); `tools`: programs whose
# change makes the result old. A piece named picture/NAME draws the picture NAME (plots.drawn).
Piece = namedtuple("Piece", "name module function arguments alone tools", defaults=((), False, ()))

COMMON = ("clicking.py", "library.py", "scoring.py", "meshes.py", "../score.py")
DRAWING = ("draw.py", "fields.py", "plots.py", "../../scripts/render.py")
PICTURE = "picture/"


def library_path(study):
    return os.path.join(study.build, "src", "api", "libtoothseg.so")


def machine():
    """The processor, and how many cores of it."""
    name = platform.machine()
    if os.path.exists("/proc/cpuinfo"):
        with open("/proc/cpuinfo") as f:
            name = next((line.split(":")[1].strip() for line in f if line.startswith("model name")), name)
    return {"cpu": name, "cores": os.cpu_count()}


def key_of(study, piece):
    code = [piece.module + ".py", *COMMON, *(DRAWING if piece.name.startswith(PICTURE) else ())]
    binaries = [library_path(study)] + [tool(study, t) for t in piece.tools]
    parts = [piece.name, piece.function, piece.arguments, [digest(os.path.join(HERE, c)) for c in code],
             [digest(b) if b and os.path.exists(b) else None for b in binaries], machine() if piece.alone else None]
    return hashlib.sha256(json.dumps(parts, sort_keys=True).encode()).hexdigest()[:16]


def result_file(study, piece):
    return os.path.join(study.folder, "pieces", "%s.%s.json" % (piece.name.replace("/", "-"), key_of(study, piece)))


def there(study, piece):
    """Whether it is measured; of a picture, whether it still is where it was drawn."""
    picture = piece.name[len(PICTURE):] if piece.name.startswith(PICTURE) else None
    return os.path.exists(result_file(study, piece)) and (picture is None or os.path.exists(plots.drawn(study, picture)))


def measure(study, piece):
    """In a process of its own. Returns seconds."""
    begin = time.monotonic()
    sys.path.insert(0, HERE)
    result = getattr(importlib.import_module(piece.module), piece.function)(study, **piece.arguments)
    path = result_file(study, piece)
    with open(path + ".new", "w") as f:
        json.dump(result, f, indent=1)
    os.replace(path + ".new", path)
    return time.monotonic() - begin


class Progress:
    def __init__(self, total):
        self.total, self.done, self.begin = total, 0, time.monotonic()

    def tell(self, piece, text):
        self.done += 1
        print("[%3d/%d] %5.0f s  %-28s %s" % (self.done, self.total, time.monotonic() - self.begin, piece.name, text), flush=True)


def run(study, stages, jobs):
    """All pieces of the stages, one stage after the other. Results by name; a piece that failed has {"error": ...}."""
    os.makedirs(os.path.join(study.folder, "pieces"), exist_ok=True)
    progress = Progress(sum(len(s) for s in stages))
    results = {}
    for stage in stages:
        for alone in (False, True):
            todo = []
            for piece in (p for p in stage if p.alone == alone):
                if there(study, piece):
                    progress.tell(piece, "there already")
                else:
                    todo.append(piece)
            run_some(study, todo, 1 if alone else jobs, progress, results)
        for piece in stage:
            if piece.name not in results:  # it did not fail
                with open(result_file(study, piece)) as f:
                    results[piece.name] = json.load(f)
    return results


def run_some(study, todo, jobs, progress, results):
    if not todo:
        return
    context = multiprocessing.get_context("spawn")
    with concurrent.futures.ProcessPoolExecutor(jobs, mp_context=context, max_tasks_per_child=1) as pool:
        waiting = {pool.submit(measure, study, piece): piece for piece in todo}
        for future in concurrent.futures.as_completed(waiting):
            piece = waiting[future]
            try:
                progress.tell(piece, "%.1f s" % future.result())
            except Exception as e:  # told in the report; the other pieces go on
                results[piece.name] = {"error": "%s: %s" % (type(e).__name__, e)}
                progress.tell(piece, "FAILED: %s" % e)
