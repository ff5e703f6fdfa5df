# SPDX-License-Identifier: Apache-2.0
"""Progress, cancellation, changes, log and allocator: called, and what they raise."""
import functools
import sys
import threading
import unittest
from unittest import mock

import fixture
import toothseg
from toothseg import Cancelled, Context, Features, Job, LogLevel, Model, Segmentation, Session, Status


class Wrong(Exception):
    pass


@functools.cache
def alone():
    """With one thread: several are not always heard as often."""
    return Context(threads=1)


@functools.cache
def small():
    model = Model.load(alone(), fixture.arch(5000))
    features = Features.detect(model)
    with Segmentation(features) as s:
        s.segment_all()
        return model, features, s.write_session()


def long_calls(segmentation):
    """Those that take a job, as functions of it."""
    model, features, session = small()
    xyz, triangles = model.positions(), model.triangles()
    yield "load", lambda job: Model.load(alone(), fixture.arch(5000), job=job).close()
    yield "create", lambda job: Model(alone(), xyz, triangles, job=job).close()
    yield "detect", lambda job: Features.detect(model, job=job).close()
    yield "prepare", lambda job: Segmentation(features, job=job).close()
    yield "session", lambda job: Session.read(model, session, job=job).close()
    yield "click", lambda job: segmentation.click(segmentation.propose_clicks()[0], job=job)
    yield "clicks", lambda job: segmentation.clicks(segmentation.propose_clicks(), job=job)
    yield "all", lambda job: segmentation.segment_all(job=job)


class Progress(unittest.TestCase):
    def test_rises_to_the_end(self):
        with Segmentation(small()[1]) as s:
            for name, call in long_calls(s):
                seen = []
                with self.subTest(name), Job(fixture.context(), lambda *a: seen.append(a)) as job:
                    call(job)
                    fractions = [f for f, _ in seen]
                    self.assertGreaterEqual(len(seen), 2)
                    self.assertEqual(fractions, sorted(fractions))
                    self.assertEqual((fractions[-1], job.fraction), (1, 1))
                    self.assertTrue(all(type(stage) is str and stage for _, stage in seen))
                while s.history().undo:
                    s.undo()

    def test_false_and_exceptions_stop(self):
        """At the first callback, in the middle, and at the very last."""
        def stop_with(what, calls, at):
            def progress(fraction, stage):
                calls.append(fraction)
                if len(calls) == at and what is not False:
                    raise what
                return len(calls) != at
            return progress

        with Segmentation(small()[1]) as s:
            before = fixture.dump(s)
            for name, call in long_calls(s):
                calls = []
                with Job(fixture.context(), stop_with(False, calls, 0)) as job:
                    call(job)
                while s.history().undo:
                    s.undo()
                for at in {1, (len(calls) + 1) // 2, len(calls)}:
                    for what in (False, Wrong("of mine"), KeyboardInterrupt()):
                        made = []
                        with self.subTest(f"{name} {what!r} at {at}"), Job(fixture.context(), stop_with(what, made, at)) as job:
                            with self.assertRaises(Cancelled if what is False else type(what)) as raised:
                                call(job)
                            if what is not False:
                                self.assertIs(raised.exception, what)
                            self.assertEqual(fixture.dump(s)[:3], before[:3])
                            self.assertEqual(s.click_count(), 0)
                            job.reset()
                            call(job)
                        while s.history().undo:
                            s.undo()

    def test_raised_though_the_call_succeeded(self):
        """As when the report of a worker comes too late to stop anything: what was made is given back at once."""
        counter = fixture.Counter()
        with counter.context(threads=1) as context, Job(context, lambda fraction, stage: None) as job:
            for make in (lambda: Model.load(context, fixture.arch(5000), job=job),
                         lambda: Session.read(model, small()[2], job=job)):
                live = len(counter.live)
                job._watcher.thrown = mine = Wrong("of mine")
                try:
                    make()
                except Wrong as e:
                    self.assertIs(e, mine)  # held, and with it the frames that it went through
                    self.assertEqual(len(counter.live), live)
                    mine = None
                self.assertIsNone(mine)
                model = Model.load(context, fixture.arch(5000))
            model.close()
            self.assertEqual(len(counter.live), 0)

    def test_none_goes_on(self):
        with Job(fixture.context(), lambda fraction, stage: None) as job:
            Model.load(fixture.context(), fixture.arch(), job=job).close()

    def test_cancelled_by_another_thread(self):
        entered, cancelled = threading.Event(), threading.Event()

        def progress(fraction, stage):
            entered.set()
            cancelled.wait(20)
            return True

        def cancel():
            entered.wait(20)
            job.cancel()
            cancelled.set()

        with fixture.unclicked() as s, Job(fixture.context(), progress) as job:
            other = threading.Thread(target=cancel)
            other.start()
            with self.assertRaises(Cancelled) as raised:
                s.segment_all(job=job)
            other.join()
            self.assertIs(raised.exception.status, Status.CANCELLED)
            self.assertEqual(s.teeth(), [])


class Changes(unittest.TestCase):
    def test_told(self):
        told = []
        with fixture.unclicked() as s:
            s.on_change(lambda teeth: told.append((teeth, s.changes(), len(s.labels()), threading.get_ident())))
            s.click(s.propose_clicks()[0])
            s.undo()
            s.redo()
            self.assertEqual([t[0] for t in told], [s.teeth()] * 3)
            self.assertTrue(all(t[0] == t[1] and t[2] > 0 and t[3] == threading.get_ident() for t in told))
            s.on_change(None)
            s.undo()
            self.assertEqual(len(told), 3)

    def test_what_it_raises_comes_out_and_the_change_stands(self):
        mine = Wrong("of mine")

        def hook(teeth):
            raise mine

        with fixture.unclicked() as s:
            s.on_change(hook)
            with self.assertRaises(Wrong) as raised:
                s.segment_all()
            self.assertIs(raised.exception, mine)
            self.assertEqual(len(s.teeth()), 14)
            self.assertEqual(fixture.status_of(s.redo).status, Status.NO_HISTORY)  # and not the same again

    def test_it_must_not_change_or_close(self):
        refused = []

        def hook(teeth):
            for call in (s.undo, s.segment_all, s.close, lambda: s.on_change(None), lambda: s.click((0, 0, 0))):
                try:
                    call()
                except RuntimeError as e:
                    refused.append(str(e))

        with fixture.unclicked() as s:
            s.on_change(hook)
            s.click(s.propose_clicks()[0])
            self.assertEqual(len(refused), 5)
            self.assertFalse(s.closed)
            self.assertEqual(s.history().undo, 1)


class Hooks(unittest.TestCase):
    def test_log(self):
        lines = []
        with Context(log=lambda *a: lines.append(a)) as context, Model.load(context, fixture.arch()):
            pass
        self.assertTrue(lines)
        self.assertTrue(all(type(level) is LogLevel and type(text) is str and text for level, text in lines))

    def test_the_log_lives_as_long_as_its_objects(self):
        lines = []
        context = Context(log=lambda level, text: lines.append(text))
        model = Model.load(context, fixture.arch())
        context.close()
        del context
        lines.clear()
        Features.detect(model).close()
        model.close()
        self.assertTrue(lines)

    def test_what_a_log_raises(self):
        def log(level, text):
            raise Wrong(text)

        with mock.patch.object(sys, "unraisablehook") as hook:
            with Context(log=log) as context, Model.load(context, fixture.arch()) as model:
                self.assertGreater(model.report().faces, 0)
        self.assertIs(hook.call_args[0][0].exc_type, Wrong)

    def test_what_an_allocator_raises(self):
        def alloc(size):
            raise Wrong(size)

        with mock.patch.object(sys, "unraisablehook") as hook:
            with Context(allocator=(alloc, lambda memory: None), threads=1) as context:
                error = fixture.status_of(Model.load, context, fixture.arch())
        self.assertIs(type(error), toothseg.OutOfMemory)
        self.assertIs(hook.call_args[0][0].exc_type, Wrong)

    def test_memory_error_is_no_memory(self):
        def alloc(size):
            raise MemoryError

        with mock.patch.object(sys, "unraisablehook") as hook:
            with Context(allocator=(alloc, lambda memory: None), threads=1) as context:
                self.assertIs(type(fixture.status_of(Model.load, context, fixture.arch())), toothseg.OutOfMemory)
        hook.assert_not_called()
