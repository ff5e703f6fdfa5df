// What goes wrong, who owns what, and who calls whom. SPDX-License-Identifier: Apache-2.0
using System;
using System.Collections.Generic;
using System.IO;
using System.Reflection;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Threading;
using Toothseg;

static partial class Tests
{
    // ---------------------------------------------------------------------------------------------------- what fails

    static Point[] Plane()
    {
        var positions = new Point[41 * 41];
        for (int i = 0; i < positions.Length; ++i) positions[i] = new Point(i % 41, i / 41, 0);
        return positions;
    }

    static Triangle[] PlaneFaces()
    {
        var faces = new List<Triangle>();
        for (uint i = 0; i < 40; ++i)
            for (uint k = 0; k < 40; ++k)
            {
                uint a = 41 * i + k;
                faces.Add(new Triangle(a, a + 1, a + 41));
                faces.Add(new Triangle(a + 1, a + 42, a + 41));
            }
        return faces.ToArray();
    }

    static void FaultsOfFilesMeshesAndFeatures()
    {
        string bad = Path.Combine(scratch, "bad.ply");
        Refused<FileException>(Status.FileOpen, () => Model.Load(context, Path.Combine(scratch, "nowhere.ply")));
        File.WriteAllText(bad, "this is no mesh");
        Refused<FileException>(Status.FileFormat, () => Model.Load(context, bad));
        byte[] bytes = File.ReadAllBytes(scan);
        Array.Resize(ref bytes, bytes.Length - 100);
        Throws<FileException>(() => Model.Read(context, bytes));
        Throws<FileException>(() => Model.Read(context, new byte[0]));
        Throws<ArgumentException>(() => Model.Load(context, "a\0b"));
        Throws<ArgumentNullException>(() => Model.Load(context, null));
        Throws<ArgumentNullException>(() => Model.Load(null, scan));
        Throws<ArgumentException>(() => Model.Create(context, new double[4]));
        Refused<MeshException>(Status.MeshEmpty, () => Model.Create(context, new double[0]));
        Refused<MeshException>(Status.MeshEmpty, () => Model.Create(context, Plane(), new Triangle[0]));
        Refused<MeshException>(Status.MeshIndexRange, () => Model.Create(context, Plane(), new[] { new Triangle(0, 1, 99999) }));
        Point[] positions = Plane();
        positions[3].X = double.NaN;
        Refused<MeshException>(Status.MeshNonFinite, () => Model.Create(context, positions, PlaneFaces()));
        positions = Plane();
        for (int i = 0; i < positions.Length; ++i) positions[i].X *= 100;
        Refused<MeshException>(Status.MeshUnits, () => Model.Create(context, positions, PlaneFaces()));
        using (Model plane = Model.Create(context, Plane(), PlaneFaces()))
        {
            Refused<FeaturesException>(Status.NoTeeth, () => Features.Detect(plane));
            using (var none = new Features(plane)) Refused<FeaturesException>(Status.NoConstraint, () => new Segmentation(none));
        }
        Refused<UsageException>(Status.InvalidArgument, () => new Context(new ContextOptions { Threads = 5000 }));
        Refused<UsageException>(Status.InvalidArgument, () => model.Nearest(new Point(double.NaN, 0, 0)));
        Refused<UsageException>(Status.NotFound, () => model.Raycast(new Point(500, 500, 500), new Point(1, 0, 0)));
        Refused<UsageException>(Status.NotFound, () => features.RemovePoint(4711));
    }

    static void WhatIsRefusedChangesNothing()
    {
        using (Segmentation s = Separated())
        using (var job = new Job(context))
        {
            uint[] teeth = s.GetTeeth();
            var far = new Point(500, 500, 500);
            s.SetLocked(teeth[1], true);
            job.Cancel();
            string before = Dump(s);
            Refused<SegmentationException>(Status.ClickOffSurface, () => s.Click(far));
            Refused<SegmentationException>(Status.ClickOffSurface, () => s.Include(teeth[2], far));
            Refused<SegmentationException>(Status.Locked, () => s.Remove(teeth[1]));
            Refused<SegmentationException>(Status.NoChange, () => s.SetLocked(teeth[1], true));
            Refused<SegmentationException>(Status.NoChange, () => s.Merge(teeth[2], teeth[2]));
            Refused<SegmentationException>(Status.NoHistory, () => s.Redo());
            Refused<EditException>(Status.EditNothing, () => s.OffsetCut(teeth[2], 0));
            Refused<EditException>(Status.EditNoLoop, () => s.OffsetCut(teeth[2], -5));
            Refused<UsageException>(Status.InvalidArgument, () => s.OffsetCut(teeth[2], double.PositiveInfinity));
            Refused<UsageException>(Status.InvalidArgument, () => s.DrawCut(teeth[2], new Point[0]));
            Refused<UsageException>(Status.NotFound, () => s.GetTooth(4711));
            Refused<UsageException>(Status.NotFound, () => s.GetNumber(teeth[0]));
            Refused<UsageException>(Status.NotFound, () => s.MakeToothMesh(4711));
            Refused<FileException>(Status.FileWrite, () => s.Save(Path.Combine(scratch, "no/such/folder.ply"), OutputFormat.Ply));
            Refused<FileException>(Status.FileWrite, () => s.SaveSession(Path.Combine(scratch, "no/such/folder.json")));
            Refused<SurroundingsException>(Status.Cancelled, () => s.OffsetCut(teeth[2], 0.2, job));
            Refused<SurroundingsException>(Status.Cancelled, () => s.MakeToothMesh(teeth[2], null, job));
            Check(before == Dump(s), "something has changed");
        }
        using (Features many = features.Clone())
        {
            FeaturePoint[] points = many.GetPoints();
            for (int i = 1, added = 0; i < points.Length && added < 6; ++i)
                if (points[i].Group == points[i - 1].Group) { many.SetGroup(points[i].Id); ++added; }
            using (var s = new Segmentation(many)) Refused<NumberException>(Status.TooManyTeeth, () => s.AssignNumbers());
        }
    }

    // A spike through the crown and down through the gums: no membrane closes the socket without crossing it.
    static void WhatCannotBeClosed()
    {
        Point centre, up = features.Occlusal;
        using (Segmentation s = Separated()) centre = s.GetToothFrame(s.GetTeeth()[4]).Centre;
        var positions = new List<Point>(model.GetPositions());
        var triangles = new List<Triangle>(model.GetTriangles());
        var n = (uint)positions.Count;
        double[][] corners = { new[] { -3.0, -3, -25 }, new[] { 3.0, -3, -25 }, new[] { 0.0, 3, -25 }, new[] { 0.0, 0, 5 } };
        foreach (double[] c in corners)
            positions.Add(new Point(centre.X + c[0] + c[2] * up.X, centre.Y + c[1] + c[2] * up.Y, centre.Z + c[2] * up.Z));
        foreach (Triangle t in new[] { new Triangle(0, 2, 1), new Triangle(0, 1, 3), new Triangle(1, 2, 3), new Triangle(2, 0, 3) })
            triangles.Add(new Triangle(n + t.A, n + t.B, n + t.C));
        using (Model pierced = Model.Create(context, positions.ToArray(), triangles.ToArray()))
        using (Features found = Features.Detect(pierced))
        using (var s = new Segmentation(found))
        {
            s.SegmentAll();
            string before = Dump(s);
            Refused<ToothMeshException>(Status.NotClosed, () => s.MakeGingivaMesh(new ToothMeshOptions { Closed = true }));
            Check(before == Dump(s), "something has changed");
            s.MakeGingivaMesh().Dispose();
        }
    }

    // ----------------------------------------------------------------------------------------------------- ownership

    static object Example(ParameterInfo parameter)
    {
        Type type = parameter.ParameterType;
        if (type.IsByRef) type = type.GetElementType();
        if (type == typeof(string)) return Path.Combine(scratch, "never");
        if (type == typeof(uint[])) return new uint[1];
        if (type == typeof(Point[])) return new Point[1];
        return type.IsValueType ? Activator.CreateInstance(type) : null;
    }

    // Every public method of an object that is disposed.
    static int AllRefuse(object disposed)
    {
        int tried = 0;
        foreach (MethodInfo method in disposed.GetType().GetMethods(BindingFlags.Instance | BindingFlags.Public | BindingFlags.DeclaredOnly))
        {
            ParameterInfo[] parameters = method.GetParameters();
            if (method.Name == "Dispose" || Array.Exists(parameters, p => p.ParameterType.Name.StartsWith("Span", StringComparison.Ordinal))) continue;
            object[] arguments = Array.ConvertAll(parameters, Example);
            if (method.Name == "add_Changed") arguments = new object[] { (Action<uint[]>)(t => { }) };
            if (method.Name == "remove_Changed") continue; // there is nothing to take away
            try
            {
                method.Invoke(disposed, arguments);
                throw new Failure(disposed.GetType().Name + "." + method.Name + " works after Dispose");
            }
            catch (TargetInvocationException e)
            {
                Check(e.InnerException is ObjectDisposedException, disposed.GetType().Name + "." + method.Name + ": " + e.InnerException);
            }
            ++tried;
        }
        return tried;
    }

    static void NothingWorksAfterDispose()
    {
        var c = new Context();
        var j = new Job(c);
        Model m = Model.Load(c, scan);
        Features f = Features.Detect(m);
        var s = new Segmentation(f);
        s.Click(s.ProposeClicks()[0]);
        ToothMesh mesh = s.MakeToothMesh(s.GetTeeth()[0]);
        foreach (IDisposable each in new IDisposable[] { c, j, m, f, s, mesh })
        {
            each.Dispose();
            each.Dispose();
        }
        Check(AllRefuse(j) == 3 && AllRefuse(m) == 7 && AllRefuse(f) > 10 && AllRefuse(s) > 45 && AllRefuse(mesh) == 7, "methods");
        Throws<ObjectDisposedException>(() => new Job(c));
        Throws<ObjectDisposedException>(() => Model.Load(c, scan));
        Throws<ObjectDisposedException>(() => Model.Create(c, Plane(), PlaneFaces()));
        Throws<ObjectDisposedException>(() => Features.Detect(m));
        Throws<ObjectDisposedException>(() => new Features(m));
        Throws<ObjectDisposedException>(() => new Segmentation(f));
        Throws<ObjectDisposedException>(() => Session.Read(m, "{}"));
        Throws<ObjectDisposedException>(() => Model.Load(context, scan, null, j));
    }

    static void DisposedInAnyOrder()
    {
        int[][] orders = { new[] { 0, 1, 2, 3, 4, 5 }, new[] { 5, 4, 3, 2, 1, 0 }, new[] { 2, 0, 4, 1, 5, 3 }, new[] { 3, 5, 0, 4, 2, 1 } };
        foreach (int[] order in orders)
        {
            var c = new Context(new ContextOptions { Log = (level, text) => { } });
            Model m = Model.Load(c, scan);
            Features f = Features.Detect(m);
            var s = new Segmentation(f);
            s.Click(s.ProposeClicks()[0]);
            IDisposable[] all = { c, new Job(c), m, f, s, s.MakeToothMesh(s.GetTeeth()[0]) };
            var gone = new HashSet<int>();
            foreach (int i in order)
            {
                all[i].Dispose();
                gone.Add(i);
                if (!gone.Contains(2)) Check(m.GetReport().Faces > 0, "model"); // children go on without parents
                if (!gone.Contains(4)) Check(s.GetTeeth().Length > 0, "segmentation");
                if (!gone.Contains(5)) Check(((ToothMesh)all[5]).GetInfo().Vertices > 0, "mesh");
            }
        }
    }

    // An allocator that counts, and has no more to give than `limit`.
    sealed class Counter
    {
        internal long Live, Given, Limit = long.MaxValue;
        internal bool Throw;

        internal ContextOptions Options()
        {
            return new ContextOptions { Allocate = Allocate, Free = Free };
        }

        IntPtr Allocate(UIntPtr bytes)
        {
            if (Interlocked.Increment(ref Given) > Limit)
            {
                if (Throw) throw new InvalidOperationException("none left");
                return IntPtr.Zero;
            }
            Interlocked.Increment(ref Live);
            return Marshal.AllocHGlobal((IntPtr)(long)(ulong)bytes); // malloc, which aligns to 16
        }

        void Free(IntPtr memory)
        {
            Interlocked.Decrement(ref Live);
            Marshal.FreeHGlobal(memory);
        }
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    static void WorkWith(Counter counter, bool forget)
    {
        var c = new Context(counter.Options());
        var job = new Job(c, (fraction, stage) => true);
        Model m = Model.Create(c, model.GetPositions(), model.GetTriangles());
        Features f = Features.Detect(m, null, job);
        var s = new Segmentation(f);
        s.Changed += teeth => s.GetTeeth();
        s.Click(s.ProposeClicks()[0], job);
        ToothMesh mesh = s.MakeToothMesh(s.GetTeeth()[0]);
        Throws<ToothsegException>(() => s.Click(new Point(500, 0, 0)));
        Throws<ToothsegException>(() => Features.Detect(m, new FeatureOptions { Radius = -1 }));
        Check(Interlocked.Read(ref counter.Live) > 10, "the allocator is used");
        if (forget) return;
        foreach (IDisposable each in new IDisposable[] { c, job, m, f, s, mesh }) each.Dispose();
    }

    static void NothingLeaks()
    {
        var counter = new Counter();
        for (int i = 0; i < 12; ++i)
        {
            WorkWith(counter, false);
            Equal(0L, Interlocked.Read(ref counter.Live), "live allocations");
        }
        for (int i = 0; i < 30; ++i)
        {
            using (var c = new Context(counter.Options()))
            using (Model m = Model.Create(c, Plane(), PlaneFaces()))
            {
                Throws<FeaturesException>(() => Features.Detect(m));
                Check(Interlocked.Read(ref counter.Live) > 0, "the allocator is used");
            }
            Equal(0L, Interlocked.Read(ref counter.Live), "live allocations");
        }
    }

    static void WhatIsForgottenIsFinalized()
    {
        const int rounds = 4;
        var counters = new Counter[rounds];
        for (int i = 0; i < rounds; ++i)
        {
            counters[i] = new Counter();
            Counter its = counters[i];
            var thread = new Thread(() => WorkWith(its, true)); // so that no stack keeps what it forgot
            thread.Start();
            thread.Join();
        }
        int left = rounds;
        for (int i = 0; i < 50 && left != 0; ++i)
        {
            GC.Collect();
            GC.WaitForPendingFinalizers();
            left = Array.FindAll(counters, c => Interlocked.Read(ref c.Live) != 0).Length;
        }
        Equal(0, left, "rounds with memory left");
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    static WeakReference HookOfADisposedContext()
    {
        var held = new object();
        var c = new Context(new ContextOptions { Log = (level, text) => held.ToString() });
        using (Model m = Model.Create(c, Plane(), PlaneFaces()))
        {
            c.Dispose();
            Throws<FeaturesException>(() => Features.Detect(m)); // the hooks are there for the model
        }
        return new WeakReference(held);
    }

    static void HooksGoWithTheLastObject()
    {
        var hooks = new WeakReference[20];
        var thread = new Thread(() => { for (int i = 0; i < hooks.Length; ++i) hooks[i] = HookOfADisposedContext(); });
        thread.Start();
        thread.Join();
        GC.Collect();
        GC.WaitForPendingFinalizers();
        GC.Collect();
        int left = Array.FindAll(hooks, h => h.IsAlive).Length;
        Check(left <= 2, left + " hooks are left"); // the collector looks at the stack cautiously and may keep one
    }

    static void NoMemory()
    {
        foreach (bool throws in new[] { false, true })
        {
            var counter = new Counter();
            using (var c = new Context(counter.Options()))
            using (Model m = Model.Create(c, model.GetPositions(), model.GetTriangles()))
            using (Features f = Features.Detect(m))
            using (var s = new Segmentation(f))
            {
                string before = Dump(s);
                counter.Throw = throws;
                counter.Limit = 0;
                Refused<SurroundingsException>(Status.OutOfMemory, () => Model.Create(c, Plane(), PlaneFaces()));
                Refused<SurroundingsException>(Status.OutOfMemory, () => new Segmentation(f));
                counter.Limit = long.MaxValue;
                Check(before == Dump(s), "something has changed");
                s.Click(s.ProposeClicks()[0]);
            }
            Equal(0L, Interlocked.Read(ref counter.Live), "live allocations");
        }
        Refused<SurroundingsException>(Status.OutOfMemory, () => new Segmentation(features, new SegmentOptions { MemoryLimit = 1 }));
    }

    // ----------------------------------------------------------------------------------------------------- callbacks

    static void ProgressRises()
    {
        var seen = new List<double>();
        string stages = "";
        Thread mine = Thread.CurrentThread;
        bool background = mine.IsBackground;
        using (var job = new Job(context, (fraction, stage) => { seen.Add(fraction); stages += stage + " "; return true; }))
        {
            using (Features f = Features.Detect(model, null, job)) Equal(14, f.GetGroups().Length, "groups");
            Check(seen.Count > 3, "calls");
            for (int i = 1; i < seen.Count; ++i) Check(seen[i] >= seen[i - 1] && seen[i] <= 1, "fractions");
            Check(stages.Contains("features"), stages);
            Equal(seen[seen.Count - 1], job.Progress, "progress");
        }
        Equal(background, mine.IsBackground, "the caller's thread stays what it is");
    }

    sealed class Mine : Exception { }

    static void CallbacksCancelAndThrow()
    {
        var mine = new Mine();
        bool throws = false;
        using (Segmentation s = Separated())
        using (var job = new Job(context, (fraction, stage) => { if (throws) throw mine; return false; }))
        {
            string before = Dump(s);
            Refused<SurroundingsException>(Status.Cancelled, () => Features.Detect(model, null, job));
            job.Reset();
            throws = true;
            for (int i = 0; i < 3; ++i)
            {
                try
                {
                    s.SmoothCut(s.GetTeeth()[0], 0.5, job);
                    throw new Failure("nothing was thrown");
                }
                catch (Mine e)
                {
                    Check(ReferenceEquals(mine, e), "the same exception");
                }
                job.Reset();
            }
            Throws<Mine>(() => Model.Load(context, scan, null, job));
            job.Reset();
            Throws<Mine>(() => Session.Read(model, s.WriteSession(), job));
            job.Reset();
            Check(before == Dump(s), "something has changed");
        }
    }

    static void CancelFromAnotherThread()
    {
        using (var started = new ManualResetEvent(false))
        using (var cancelled = new ManualResetEvent(false))
        using (var job = new Job(context, (fraction, stage) => { started.Set(); cancelled.WaitOne(5000); return true; }))
        {
            var other = new Thread(() => { started.WaitOne(5000); job.Cancel(); cancelled.Set(); });
            other.Start();
            Refused<SurroundingsException>(Status.Cancelled, () => Features.Detect(model, null, job));
            other.Join();
            Refused<SurroundingsException>(Status.Cancelled, () => Features.Detect(model, null, job)); // sticky
            job.Reset();
            using (Features f = Features.Detect(model, null, job)) Equal(14, f.GetGroups().Length, "groups");
        }
    }

    static void ChangesAreTold()
    {
        using (Segmentation s = Separated())
        {
            uint tooth = s.GetTeeth()[0];
            var told = new List<uint[]>();
            Action<uint[]> listen = teeth => { told.Add(teeth); s.GetTooth(s.GetTeeth()[0]); };
            s.Changed += listen;
            s.SetLocked(tooth, true);
            Equal(1, told.Count, "calls");
            Same(new[] { tooth }, told[0], "teeth");
            Same(told[0], s.GetChanges(), "changes");
            Action<uint[]> fail = teeth => { throw new Mine(); };
            s.Changed += fail;
            Throws<Mine>(() => s.SetLocked(tooth, false));
            Check(!s.IsLocked(tooth) && told.Count == 2, "the change stands");
            s.Changed -= fail;
            Throws<SegmentationException>(() => s.SetLocked(tooth, false));
            s.Changed -= listen;
            s.SetLocked(tooth, true);
            Equal(2, told.Count, "no more calls");
            s.Changed += listen;
            GC.Collect();
            s.Undo();
            Equal(3, told.Count, "again");
        }
    }

    static void LogIsHeard()
    {
        var lines = new List<string>();
        bool fail = false;
        var options = new ContextOptions { Log = (level, text) => { lock (lines) lines.Add(level + " " + text); if (fail) throw new Mine(); } };
        using (var c = new Context(options))
        using (Model m = Model.Load(c, scan))
        using (Features f = Features.Detect(m))
        {
            int before = lines.Count;
            Check(before > 0, "lines");
            fail = true;
            using (Features g = Features.Detect(m)) Equal(14, g.GetGroups().Length, "groups"); // what a hook throws is dropped
            Check(lines.Count > before, "more lines");
        }
    }

    static void TwoThreadsReadOneModel()
    {
        using (Segmentation s = Separated())
        {
            uint[] labels = s.GetLabels(), teeth = s.GetTeeth();
            Exception wrong = null;
            ThreadStart read = () =>
            {
                try
                {
                    for (int i = 0; i < 20; ++i)
                    {
                        Same(labels, s.GetLabels(), "labels");
                        Equal(model.GetReport().Vertices, (uint)model.GetPositions().Length, "positions");
                        foreach (uint tooth in teeth) s.GetCut(tooth);
                        Refused<UsageException>(Status.NotFound, () => s.GetTooth(4711)); // each has a message of its own
                    }
                }
                catch (Exception e)
                {
                    wrong = e;
                }
            };
            var threads = new[] { new Thread(read), new Thread(read) };
            foreach (Thread t in threads) t.Start();
            foreach (Thread t in threads) t.Join();
            if (wrong != null) throw wrong;
        }
    }

    static int Main(string[] arguments)
    {
        scan = arguments[0];
        programs = arguments[1];
        build = arguments[2];
        scratch = arguments[3];
        context = new Context();
        model = Model.Load(context, scan);
        features = Features.Detect(model);
        Action[] tests =
        {
            StructsAreThoseOfC, FunctionsAreThere, EveryStatusHasItsException, ReferencesCoreLibraryAlone, LabelsAreThoseOfTheCommand,
            SegmentArchDoesAll, HelloToothPrintsACut, ModelsFromArrays, FeaturesCanBeEdited, OptionsHaveTheLibrarysDefaults, EverythingAboutAClick,
            CorrectionsUndoAndRedo, NumbersOfTeeth, MeshesOfTeeth, SessionsGoOn, FaultsOfFilesMeshesAndFeatures,
            WhatIsRefusedChangesNothing, WhatCannotBeClosed, NothingWorksAfterDispose, DisposedInAnyOrder, NothingLeaks, WhatIsForgottenIsFinalized, HooksGoWithTheLastObject,
            NoMemory,
            ProgressRises, CallbacksCancelAndThrow, CancelFromAnotherThread, ChangesAreTold, LogIsHeard, TwoThreadsReadOneModel
        };
        int passed = 0;
        foreach (Action test in tests)
        {
            var watch = System.Diagnostics.Stopwatch.StartNew();
            try
            {
                test();
                ++passed;
                Console.WriteLine("ok {0} ({1} ms)", test.Method.Name, watch.ElapsedMilliseconds);
            }
            catch (Exception e)
            {
                Console.WriteLine("FAILED {0}: {1}", test.Method.Name, e is Failure ? e.Message + e.StackTrace.Split('\n')[1] : e.ToString());
            }
        }
        Console.WriteLine("{0} passed, {1} failed", passed, tests.Length - passed);
        return passed == tests.Length ? 0 : 1;
    }
}
