# SPDX-License-Identifier: Apache-2.0
"""Lives of objects: given back in any order and when forgotten, closed ones refused, threads."""
import gc
import inspect
import itertools
import random
import sys
import threading
import time
import unittest

import numpy as np

import fixture
import toothseg
from toothseg import Context, Features, Job, Mesh, Model, Segmentation, Session
from toothseg._core import Owner, Resource

ARGUMENTS = {"stroke": [(0, 0, 0)] * 2, "positions": [(0, 0, 0)], "file": "x.stl", "format": 0, "hook": None, "fdi": 11,
             **dict.fromkeys(["position", "keep", "part", "start", "to", "origin", "direction"], (0, 0, 0))}


def all_of(context):
    """One object of each kind."""
    model = Model.load(context, fixture.arch(5000))
    features = Features.detect(model)
    segmentation = Segmentation(features)
    segmentation.on_change(lambda teeth: None)
    segmentation.click(segmentation.propose_clicks()[0])
    mesh = Mesh.tooth(segmentation, segmentation.teeth()[0])
    return [context, Job(context, lambda fraction, stage: True), model, features, segmentation, mesh]


class Closed(unittest.TestCase):
    def test_with_and_twice(self):
        objects = all_of(Context())
        for thing in objects:
            self.assertFalse(thing.closed)
            with thing as same:
                self.assertIs(same, thing)
            self.assertTrue(thing.closed)
            thing.close()
            with self.assertRaisesRegex(ValueError, f"this {type(thing).__name__} is closed"), thing:
                pass

    def test_every_method_is_refused(self):
        tried = 0
        for thing in all_of(Context()):
            thing.close()
            for name, member in inspect.getmembers(type(thing)):
                if name.startswith("_") or name in ("close", "closed") or hasattr(Resource, name) and name != "handle":
                    continue
                with self.subTest(f"{type(thing).__name__}.{name}"), self.assertRaisesRegex(ValueError, "closed"):
                    if isinstance(member, property):
                        getattr(thing, name)
                        continue
                    method = getattr(thing, name)
                    if inspect.ismethod(method) and method.__self__ is type(thing):
                        raise ValueError("closed")  # a class method has no object
                    needed = [p for p in inspect.signature(method).parameters.values() if p.default is p.empty]
                    method(*(ARGUMENTS.get(p.name, 0) for p in needed))
                tried += 1
        self.assertGreater(tried, 70)

    def test_closed_arguments(self):
        context, job, model, features, segmentation, mesh = all_of(Context())
        for thing in (context, job, model, features, segmentation):
            thing.close()
        self.assertRaises(ValueError, Model.load, context, fixture.arch())
        self.assertRaises(ValueError, Job, context)
        self.assertRaises(ValueError, Features.detect, model)
        self.assertRaises(ValueError, Segmentation, features)
        self.assertRaises(ValueError, Mesh.gingiva, segmentation)
        self.assertRaises(ValueError, Session.read, model, "{}")
        self.assertRaises(ValueError, mesh.save, fixture.path("x.stl"), toothseg.OutputFormat.STL, job=job)
        self.assertGreater(len(mesh.positions()), 10)  # a child lives on


class Memory(unittest.TestCase):
    """By an allocator that knows what is out."""

    def test_made_and_destroyed_again_and_again_in_any_order(self):
        counter, made = fixture.Counter(), set()
        orders = list(itertools.permutations(range(6)))
        for order in random.Random(1).sample(orders, 22) + [orders[0], orders[-1]]:
            before = counter.made
            objects = all_of(counter.context(threads=1))
            self.assertGreater(len(counter.live), 10)
            for i in order:
                objects[i].close()
            self.assertEqual(len(counter.live), 0, order)
            made.add(counter.made - before)
        self.assertEqual(len(made), 1, "each round does the same")

    def test_python_keeps_nothing(self):
        def owners():
            gc.collect()
            return sum(isinstance(o, Owner) for o in gc.get_objects()), len(gc.get_objects())
        all_of(Context())
        before = owners()
        for _ in range(8):
            all_of(Context())
        after = owners()
        self.assertEqual(before[0], after[0])
        self.assertLess(abs(after[1] - before[1]), 8)

    def test_forgotten(self):
        counter = fixture.Counter()
        objects = all_of(counter.context())
        del objects
        self.assertEqual(len(counter.live), 0)

    def test_forgotten_in_a_cycle(self):
        counter = fixture.Counter()
        objects = all_of(counter.context())
        segmentation = objects[4]
        segmentation.on_change(lambda teeth, s=segmentation: s.labels())
        cell = [objects]
        cell.append(cell)
        del objects, segmentation, cell
        gc.collect()
        self.assertEqual(len(counter.live), 0)

    def test_collected_within_a_callback(self):
        """Garbage that Python finds there waits until the library may be called again."""
        counter, seen = fixture.Counter(), []
        objects = all_of(counter.context(threads=1))
        context, live = objects[0], []

        def progress(fraction, stage):
            if objects:
                live.append(len(counter.live))
                objects.clear()
                gc.collect()
                live.append(len(counter.live))
            seen.append(fraction)

        with Job(fixture.context(), progress) as job:
            Model.load(fixture.context(), fixture.arch(5000), job=job).close()
        self.assertEqual(seen[-1], 1)
        self.assertEqual(live[0], live[1])
        self.assertGreater(live[0], 10)
        self.assertEqual(len(counter.live), 0)
        context.close()

    def test_a_call_that_fails_keeps_nothing(self):
        counter = fixture.Counter()
        with counter.context() as context:
            errors = [fixture.status_of(Model.load, context, "no such file") for _ in range(3)]
            model = Model.load(context, fixture.arch(5000))
            errors.append(fixture.status_of(model.nearest, (float("nan"), 0, 0)))
            model.close()  # while the exception, and so the frames that it went through, are still there
            self.assertEqual(len(counter.live), 0)
        self.assertEqual(len(errors), 4)


class Threads(unittest.TestCase):
    def test_two_read_one_model(self):
        model = fixture.model()
        expected = model.positions().tobytes(), [model.nearest((x, x, 0)) for x in range(40)]
        found, barrier = [], threading.Barrier(2)

        def read():
            barrier.wait()
            for _ in range(10):
                found.append((model.positions().tobytes(), [model.nearest((x, x, 0)) for x in range(40)]))

        threads = [threading.Thread(target=read) for _ in range(2)]
        for t in threads:
            t.start()
        for t in threads:
            t.join()
        self.assertEqual(found, [expected] * 20)

    def test_two_segmentations_of_one_model(self):
        with fixture.separated() as s:
            expected = s.labels()
        labels = {}

        def work(name):
            with fixture.separated() as mine:
                labels[name] = mine.labels()

        threads = [threading.Thread(target=work, args=(n,)) for n in range(2)]
        for t in threads:
            t.start()
        for t in threads:
            t.join()
        self.assertTrue(all((labels[n] == expected).all() for n in range(2)))

    def test_messages_are_a_threads_own(self):
        """Two threads that fail differently, each with its message."""
        wrong, barrier = [], threading.Barrier(2)

        def fail(fdi):
            barrier.wait()
            for _ in range(500):
                if str(fdi) not in fixture.status_of(toothseg.fdi_to_universal, fdi).message:
                    wrong.append(fdi)

        threads = [threading.Thread(target=fail, args=(fdi,)) for fdi in (77, 99)]
        for t in threads:
            t.start()
        for t in threads:
            t.join()
        self.assertEqual(wrong, [])

    def test_python_runs_during_a_call(self):
        """With so long a switch interval another thread only gets on when this one lets go of the interpreter lock."""
        ticks, stop = [0], threading.Event()

        def count():
            while not stop.is_set():
                ticks[0] += 1
                time.sleep(.0005)

        counting = threading.Thread(target=count)
        interval = sys.getswitchinterval()
        with Context(threads=1) as context, Model.load(context, fixture.arch()) as model:
            counting.start()
            sys.setswitchinterval(30)
            try:
                time.sleep(.01)
                idle = ticks[0]
                sum(range(2_000_000))  # holds the lock
                idle = ticks[0] - idle
                start, before = time.perf_counter(), ticks[0]
                Features.detect(model).close()
                during, took = ticks[0] - before, time.perf_counter() - start
            finally:
                sys.setswitchinterval(interval)
                stop.set()
                counting.join()
        self.assertLessEqual(idle, 1)
        self.assertGreater(during, 5, f"in {took:.3f} s")

    def test_closed_by_another_thread_during_a_call(self):
        """The call goes on to its end, and then the object is gone."""
        counter = fixture.Counter()
        context, job, model, features, segmentation, mesh = objects = all_of(counter.context(threads=1))
        job.close()
        entered, closed, result = threading.Event(), threading.Event(), []

        def progress(fraction, stage):
            entered.set()
            closed.wait(20)

        def work(job):
            try:
                segmentation.segment_all(job=job)
                result.append("done")
            except BaseException as e:
                result.append(e)

        watched = Job(context, progress)
        thread = threading.Thread(target=work, args=(watched,))
        thread.start()
        self.assertTrue(entered.wait(20))
        for thing in objects + [watched]:
            thing.close()
        self.assertGreater(len(counter.live), 0)
        closed.set()
        thread.join()
        self.assertEqual(result, ["done"])
        self.assertEqual(len(counter.live), 0)
        self.assertRaises(ValueError, segmentation.labels)


class Indices(unittest.TestCase):
    def test_numpy_scalars_are_indices(self):
        with fixture.separated() as s:
            tooth = np.array(s.teeth(), np.uint32)[2]
            self.assertEqual(s.tooth(tooth), s.tooth(int(tooth)))
            self.assertEqual(s.tooth(tooth).id, tooth)
            self.assertIs(type(s.tooth(tooth).id), int)
