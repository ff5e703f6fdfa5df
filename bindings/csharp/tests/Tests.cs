// Tests of the C# layers: Tests SCAN BINDIR BUILD SCRATCH. SPDX-License-Identifier: Apache-2.0
using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Reflection;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Text;
using System.Threading;
using Toothseg;

sealed class Failure : Exception
{
    internal Failure(string message) : base(message) { }
}

static partial class Tests
{
    static string scan, programs, build, scratch;
    static Context context;
    static Model model;
    static Features features;

    static void Check(bool good, string what) { if (!good) throw new Failure(what); }

    static void Equal<T>(T expected, T found, string what)
    {
        if (!EqualityComparer<T>.Default.Equals(expected, found)) throw new Failure(what + ": " + found + " instead of " + expected);
    }

    static void Same(uint[] expected, uint[] found, string what)
    {
        Equal(expected.Length, found.Length, what);
        for (int i = 0; i < expected.Length; ++i) Equal(expected[i], found[i], what + " " + i);
    }

    // The call throws exactly E, with the status and its name, and a message.
    static void Refused<E>(Status status, Action call) where E : ToothsegException
    {
        try
        {
            call();
        }
        catch (E e)
        {
            Equal(typeof(E), e.GetType(), "type");
            Equal(status, e.Status, "status");
            Check(e.Name.StartsWith("TS_E_", StringComparison.Ordinal) && e.Name != "TS_E_?", "name " + e.Name);
            Check(e.Message.Length > 5, "message");
            return;
        }
        throw new Failure("not refused: " + status);
    }

    static void Throws<E>(Action call) where E : Exception
    {
        try { call(); }
        catch (E) { return; }
        throw new Failure("no " + typeof(E).Name);
    }

    static Segmentation Separated()
    {
        var segmentation = new Segmentation(features);
        segmentation.Clicks(segmentation.ProposeClicks());
        return segmentation;
    }

    // All that a segmentation is, as text.
    static string Dump(Segmentation s)
    {
        var text = new StringBuilder(s.WriteSession());
        foreach (uint label in s.GetLabels()) text.Append(label).Append(' ');
        foreach (uint tooth in s.GetTeeth())
        {
            ToothInfo info = s.GetTooth(tooth);
            text.Append(info.Area).Append(' ').Append(info.Warnings).Append(' ').Append(s.IsLocked(tooth));
            foreach (EdgePoint p in s.GetCut(tooth).Points) text.Append(p.Position);
            text.Append(s.GetCutEdits(tooth).Length);
        }
        HistoryInfo history = s.GetHistory();
        return text.Append(history.Undo).Append(' ').Append(history.Redo).Append(' ').Append(s.ClickCount).ToString();
    }

    static Point Beside(Segmentation s, uint tooth, int point, double mm)
    {
        Point p = s.GetCut(tooth).Points[point].Position, centre = s.GetToothFrame(tooth).Centre;
        double x = p.X - centre.X, y = p.Y - centre.Y, z = p.Z - centre.Z, length = Math.Sqrt(x * x + y * y + z * z);
        return model.Nearest(new Point(p.X + mm * x / length, p.Y + mm * y / length, p.Z + mm * z / length)).Position;
    }

    // ------------------------------------------------------------------------------------------------- lowest layer

    static Type Known(string name)
    {
        return typeof(Context).Assembly.GetType("Toothseg." + name, true);
    }

    static void StructsAreThoseOfC()
    {
        Check(Layout.Structs.Length > 20, "structs");
        foreach (object[] s in Layout.Structs)
        {
            Type type = Known((string)s[0]);
            Equal((int)s[1], Marshal.SizeOf(type), type.Name);
            int fields = type.GetFields(BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic).Length;
            Equal((s.Length - 2) / 2, fields, type.Name + ": number of fields");
            for (int i = 2; i < s.Length; i += 2)
                Equal((int)s[i + 1], (int)Marshal.OffsetOf(type, (string)s[i]), type.Name + "." + s[i]);
            GCHandle.Alloc(Array.CreateInstance(type, 1), GCHandleType.Pinned).Free(); // throws where it is not blittable
        }
    }

    static void FunctionsAreThere()
    {
        Type native = Known("Native");
        Check(Layout.Functions.Length > 90, "functions");
        foreach (string name in Layout.Functions)
        {
            MethodInfo method = native.GetMethod(name, BindingFlags.Static | BindingFlags.NonPublic);
            Check(method != null, name);
            Marshal.Prelink(method); // throws where the library does not have it
        }
    }

    static void EveryStatusHasItsException()
    {
        foreach (Status status in Enum.GetValues(typeof(Status)))
        {
            if (status == Status.Ok) continue;
            ToothsegException e = ToothsegException.Of(status, "text");
            Check(e.GetType() != typeof(ToothsegException), status + " is of no block");
            Equal("TS_E_" + UpperCase(status.ToString()), e.Name, "name");
        }
        Equal(typeof(ToothMeshException), ToothsegException.Of(Status.NotClosed, "").GetType(), "750");
        Equal(typeof(ToothsegException), ToothsegException.Of((Status)9000, "").GetType(), "a block to come");
    }

    static string UpperCase(string name)
    {
        var text = new StringBuilder();
        foreach (char c in name)
        {
            if (char.IsUpper(c) && text.Length != 0) text.Append('_');
            text.Append(char.ToUpperInvariant(c));
        }
        return text.ToString();
    }

    static void ReferencesCoreLibraryAlone()
    {
        foreach (AssemblyName name in typeof(Context).Assembly.GetReferencedAssemblies()) Equal("mscorlib", name.Name, "reference");
    }

    // --------------------------------------------------------------------------------------------------- the results

    // Standard error is a few kB, which a pipe holds.
    static int Run(string program, string arguments, out string output)
    {
        var start = new ProcessStartInfo(program, arguments) { UseShellExecute = false, RedirectStandardOutput = true, RedirectStandardError = true };
        using (Process process = Process.Start(start))
        {
            bool ended = true; // a program that does not end is a failure, not a wait
            using (new Timer(unused => { ended = false; process.Kill(); }, null, 30000, Timeout.Infinite))
            {
                output = process.StandardOutput.ReadToEnd() + process.StandardError.ReadToEnd();
                process.WaitForExit();
            }
            Check(ended, program + " " + arguments + " does not end");
            return process.ExitCode;
        }
    }

    static void LabelsAreThoseOfTheCommand()
    {
        string said, theirs = Path.Combine(scratch, "theirs.txt"), ours = Path.Combine(scratch, "ours.txt");
        string theirTeeth = Path.Combine(scratch, "theirs"), ourTeeth = Path.Combine(scratch, "ours");
        Equal(0, Run(Path.Combine(programs, "ts-segment"), scan + " --labels " + theirs + " --teeth " + theirTeeth, out said), "ts-segment");
        Equal(0, Run("mono", Path.Combine(build, "segment_arch.exe") + " " + scan + " --labels " + ours + " --teeth " + ourTeeth, out said), "segment_arch");
        Check(said.Contains("14 teeth") && said.Contains("100 % intake"), said);
        Check(File.ReadAllText(theirs) == File.ReadAllText(ours), "labels of segment_arch");
        string[] files = Directory.GetFiles(theirTeeth);
        Equal(15, files.Length, "files");
        foreach (string file in files)
            Check(Convert.ToBase64String(File.ReadAllBytes(file)) == Convert.ToBase64String(File.ReadAllBytes(Path.Combine(ourTeeth, Path.GetFileName(file)))), file);
        using (Segmentation s = Separated())
        {
            uint[] labels = s.GetLabels();
            Check(File.ReadAllText(theirs) == string.Join("\n", labels) + "\n", "labels of the API");
            var room = new uint[labels.Length + 5];
            Equal(labels.Length, s.GetLabels(room), "number of labels");
            Array.Resize(ref room, labels.Length);
            Same(labels, room, "labels into an array");
            Refused<UsageException>(Status.BufferTooSmall, () => s.GetLabels(new uint[labels.Length - 1]));
            Refused<UsageException>(Status.BufferTooSmall, () => s.GetLabels(new uint[0]));
#if TOOTHSEG_SPAN
            Array.Clear(room, 0, room.Length);
            Equal(labels.Length, s.GetLabels(new Span<uint>(room)), "number of labels");
            Same(labels, room, "labels into a span");
            Refused<UsageException>(Status.BufferTooSmall, () => s.GetLabels(new Span<uint>(room, 0, 3)));
            Refused<UsageException>(Status.BufferTooSmall, () => s.GetLabels(Span<uint>.Empty));
#endif
        }
    }

    static void SegmentArchDoesAll()
    {
        string said, file = Path.Combine(scratch, "all.txt"), program = Path.Combine(build, "segment_arch.exe") + " " + scan;
        Equal(0, Run("mono", program + " --all --labels " + file, out said), "segment_arch");
        using (var s = new Segmentation(features))
        {
            s.SegmentAll();
            Check(File.ReadAllText(file) == string.Join("\n", s.GetLabels()) + "\n", "labels of --all");
        }
        Equal(2, Run("mono", program + " --no-such-option", out said), "usage");
        Equal(2, Run("mono", program + " --labels " + Path.Combine(scratch, "no/such.txt"), out said), "no folder");
    }

    static void HelloToothPrintsACut()
    {
        string said;
        Equal(0, Run("mono", Path.Combine(build, "hello_tooth.exe") + " " + scan, out said), "hello_tooth");
        Check(said.Split('\n').Length > 50 && said.Split('\n')[0].Split(' ').Length == 3, said);
        Equal(1, Run("mono", Path.Combine(build, "hello_tooth.exe") + " " + Path.Combine(scratch, "nowhere.ply"), out said), "no file");
    }

    static void ModelsFromArrays()
    {
        Point[] positions = model.GetPositions();
        Triangle[] triangles = model.GetTriangles();
        var xyz = new double[3 * positions.Length];
        var small = new float[xyz.Length];
        for (int i = 0; i < positions.Length; ++i)
        {
            xyz[3 * i] = positions[i].X;
            xyz[3 * i + 1] = positions[i].Y;
            xyz[3 * i + 2] = positions[i].Z;
        }
        for (int i = 0; i < xyz.Length; ++i) small[i] = (float)xyz[i];
        var corners = new uint[3 * triangles.Length];
        var soup = new double[9 * triangles.Length];
        for (int i = 0; i < triangles.Length; ++i)
        {
            corners[3 * i] = triangles[i].A;
            corners[3 * i + 1] = triangles[i].B;
            corners[3 * i + 2] = triangles[i].C;
        }
        for (int i = 0; i < corners.Length; ++i) Array.Copy(xyz, 3 * (int)corners[i], soup, 3 * i, 3);
        IntakeReport report = model.GetReport();
        var made = new List<Model>
        {
            Model.Create(context, positions, triangles), Model.Create(context, xyz, corners), Model.Create(context, small, corners),
            Model.Create(context, soup), Model.Read(context, File.ReadAllBytes(scan), FileFormat.Ply),
#if TOOTHSEG_SPAN
            Model.Create(context, new ReadOnlySpan<double>(xyz), new ReadOnlySpan<uint>(corners)),
            Model.Create(context, new ReadOnlySpan<float>(small), new ReadOnlySpan<uint>(corners)),
#endif
        };
        foreach (Model m in made)
            using (m)
            {
                Equal(report.Faces, m.GetReport().Faces, "faces");
                Equal(report.Vertices, m.GetReport().Vertices, "vertices");
                Check(Math.Abs(report.Area - m.GetReport().Area) < 1e-3, "area");
            }
        using (Model metres = Model.Create(context, positions, triangles, new IntakeOptions { Unit = Unit.M }))
            Check(Math.Abs(metres.GetReport().Diagonal / report.Diagonal - 1000) < 1e-6, "metres");
        Equal(report.Faces, (uint)model.GetFaceSources().Length, "sources");
        Equal(report.InputVertices, (uint)model.GetVertexMap().Length, "map");
        SurfacePoint on = model.Nearest(positions[7]);
        Equal(7u, on.NearestVertex, "nearest");
        Check(on.Distance < 1e-9 && Math.Abs(on.Barycentric.X + on.Barycentric.Y + on.Barycentric.Z - 1) < 1e-9, "weights");
        Point up = features.Occlusal;
        SurfacePoint hit = model.Raycast(new Point(positions[7].X + 50 * up.X, positions[7].Y + 50 * up.Y, positions[7].Z + 50 * up.Z), new Point(-up.X, -up.Y, -up.Z));
        Check(hit.Face < report.Faces && hit.Distance > 0, "ray");
    }

    static void FeaturesCanBeEdited()
    {
        FeaturesInfo info = features.GetInfo();
        Equal(14u, info.Groups, "groups");
        Equal(info.Groups, (uint)features.GetGroups().Length, "groups");
        FeaturePoint[] points = features.GetPoints();
        Equal(info.Points, (uint)points.Length, "points");
        Check(!points[0].ByHand && !info.InsideOut && info.Warnings == FeaturesWarnings.None && info.ArchLength > 50, "info");
        Check(features.GetArch().Length > 9, "arch");
        using (Features edited = features.Clone())
        {
            uint group, alone = edited.AddPoint(points[0].Position, Library.None, out group);
            Equal(15, edited.GetGroups().Length, "a new group");
            Check(edited.SetGroup(alone, points[0].Group) == points[0].Group, "group");
            Equal(14, edited.GetGroups().Length, "the group is gone");
            edited.MovePoint(alone, points[1].Position);
            edited.RemovePoint(alone);
            edited.RemoveGroup(points[0].Group);
            Equal(13, edited.GetGroups().Length, "a group less");
            edited.Occlusal = new Point(0, 0, 2);
            Check(edited.Occlusal.Z == 1, "unit vector");
            edited.AddPoint(points[0].Position);
            Equal(14, edited.GetGroups().Length, "by hand");
        }
        Equal(14, features.GetGroups().Length, "the original");
    }

    static void OptionsHaveTheLibrarysDefaults()
    {
        var standard = new SegmentOptions();
        var paper = new SegmentOptions(Preset.Paper) { Contours = 50, RejectOutliers = true };
        Equal(Weights.Concavity, standard.Weights, "weights");
        Equal(Weights.Paper, paper.Weights, "weights");
        Check(standard.Contours == 100 && paper.Contours == 50 && paper.RejectOutliers && standard.SeedRadius == 0.7, "values");
        Check(new NumberOptions().LeastConfidence == 0.9 && !new NumberOptions().Mirrored && new FeatureOptions().MaxPoints == 8, "values");
        Equal(0u, new ContextOptions().Threads, "threads");
        using (var s = new Segmentation(features, new SegmentOptions { HistogramBins = 20 }))
        {
            s.Click(s.ProposeClicks()[0]);
            Equal(20, s.GetHistogram(0).Length, "bins");
        }
    }

    static void EverythingAboutAClick()
    {
        using (var s = new Segmentation(features))
        {
            Point[] clicks = s.ProposeClicks();
            Equal(7, clicks.Length, "clicks");
            uint click = s.Click(clicks[0]);
            ClickInfo info = s.GetClick(click);
            Check(info.Target != info.Neighbour && info.Ms.Total > 0, "click");
            Equal(model.GetReport().Vertices, (uint)s.GetField(click).Length, "field");
            ContourInfo[] contours = s.GetContours(click);
            int chosen = Array.FindIndex(contours, c => c.Polylines > 0 && c.Chosen == 1);
            Check(chosen >= 0, "a contour is chosen");
            Polyline[] lines = s.GetContour(click, (uint)chosen);
            Equal(contours[chosen].Polylines, (uint)lines.Length, "polylines");
            int sum = 0;
            foreach (Polyline line in lines) sum += line.Points.Length;
            Equal(contours[chosen].Points, (uint)sum, "points");
            Check(Array.Exists(lines, l => l.Closed), "closed");
            Refused<UsageException>(Status.NotFound, () => s.GetContour(click, 100000));
            ToothInfo tooth = s.GetTooth(info.Target);
            Equal(tooth.Faces, (uint)s.GetToothFaces(info.Target).Length, "faces");
            Equal(tooth.Vertices, (uint)s.GetToothVertices(info.Target).Length, "vertices");
            Equal(tooth.Seeds, (uint)s.GetToothSeeds(info.Target).Length, "seeds");
            Cut cut = s.GetCut(info.Target);
            Check(cut.Info.Points == cut.Points.Length && cut.Info.Closed && cut.Info.Length > 10, "cut");
            ToothFrame frame = s.GetToothFrame(info.Target);
            Check(frame.FromArch && frame.Width > 3 && frame.Height > 3, "frame");
            Status[] statuses = s.Clicks(new[] { clicks[1], new Point(500, 500, 500), clicks[2] });
            Check(statuses[0] == Status.Ok && statuses[1] == Status.ClickOffSurface && statuses[2] == Status.Ok, "statuses");
            Equal(3u, s.ClickCount, "clicks");
            Equal(0, s.Clicks(new Point[0]).Length, "no clicks");
            s.SegmentAll();
            Equal(14, s.GetTeeth().Length, "teeth");
            Check(s.GetPrepareTimes().Factorise > 0 && s.GetMemory().Factor > 1000, "times and memory");
            foreach (ReviewItem item in s.GetReview()) Check(item.Separated, "review");
            foreach (Overlap overlap in s.GetOverlaps()) Check(overlap.Winner != overlap.Loser, "overlap");
        }
    }

    static void CorrectionsUndoAndRedo()
    {
        using (Segmentation s = Separated())
        {
            uint[] teeth = s.GetTeeth();
            uint tooth = teeth[6];
            uint[] before = s.GetLabels();
            uint steps = s.GetHistory().Undo;
            int point = Array.FindIndex(s.GetCut(tooth).Points, p => Far(s, teeth, tooth, p.Position));
            Check(point >= 0, "a point on the gum");
            Point beyond = Beside(s, tooth, point, 1);
            double area = s.GetTooth(tooth).Area;
            s.Include(tooth, beyond);
            Check(s.GetTooth(tooth).Area > area, "include");
            s.Undo();
            s.DragCut(tooth, 0, (uint)point, beyond);
            Equal(1, s.GetCutEdits(tooth).Length, "edits");
            Equal(EditKind.Drag, s.GetCutEdits(tooth)[0].Kind, "kind");
            s.OffsetCut(tooth, -0.2);
            s.SmoothCut(tooth, 0.5);
            s.ResetCut(tooth);
            Equal(0, s.GetCutEdits(tooth).Length, "edits");
            EdgePoint[] cut = s.GetCut(tooth).Points;
            s.DrawCut(tooth, new[] { cut[point].Position, beyond, cut[(point + 8) % cut.Length].Position });
            Equal(EditKind.Draw, s.GetCutEdits(tooth)[0].Kind, "kind");
            s.SetLocked(teeth[0], true);
            Check(s.IsLocked(teeth[0]), "locked");
            s.SetLocked(teeth[0], false);
            s.Merge(teeth[12], teeth[13]);
            Equal(13, s.GetTeeth().Length, "merged");
            s.Undo();
            Point[] two = { s.GetToothFrame(teeth[13]).Centre, s.GetToothFrame(teeth[12]).Centre };
            s.Merge(teeth[12], teeth[13]);
            uint second = s.Split(teeth[12], model.Nearest(two[1]).Position, model.Nearest(two[0]).Position);
            Check(Array.IndexOf(s.GetTeeth(), second) >= 0, "split");
            s.Remove(teeth[3]);
            Same(new[] { teeth[3] }, s.GetChanges(), "changes");
            Point seed = Array.Find(features.GetPoints(), p => p.Group == teeth[5]).Position;
            s.MovePoint(teeth[5], seed, model.Nearest(new Point(seed.X + 1.5, seed.Y, seed.Z)).Position);
            s.Exclude(tooth, s.GetCut(tooth).Points[0].Position);
            string after = Dump(s);
            int undone = 0;
            while (s.GetHistory().Undo > steps) { s.Undo(); ++undone; }
            Check(undone > 8, "steps");
            Same(before, s.GetLabels(), "undone");
            while (undone-- > 0) s.Redo();
            Check(after == Dump(s), "redone");
            s.SetHistoryLimit(0);
            Refused<SegmentationException>(Status.NoHistory, () => s.Undo());
        }
    }

    static bool Far(Segmentation s, uint[] teeth, uint tooth, Point p)
    {
        foreach (uint other in teeth)
            if (other != tooth)
                foreach (EdgePoint q in s.GetCut(other).Points)
                {
                    double x = p.X - q.Position.X, y = p.Y - q.Position.Y, z = p.Z - q.Position.Z;
                    if (x * x + y * y + z * z < 4) return false;
                }
        return true;
    }

    static void NumbersOfTeeth()
    {
        using (Segmentation s = Separated())
        {
            uint[] teeth = s.GetTeeth();
            s.AssignNumbers(new NumberOptions { Jaw = Jaw.Upper });
            Check(s.GetJaw().Given && s.GetJaw().Jaw == Jaw.Upper, "jaw");
            NumberInfo number = s.GetNumber(teeth[3]);
            Check(number.Fdi > 10 && number.Fdi < 29 && !number.SetByHand && number.Confidence > 0.5, "number");
            s.SetNumber(teeth[3], number.Fdi);
            Check(s.GetNumber(teeth[3]).SetByHand, "by hand");
            Refused<NumberException>(Status.NumberTaken, () => s.SetNumber(teeth[2], number.Fdi));
            Refused<NumberException>(Status.NumberJaw, () => s.SetNumber(teeth[2], 36));
            Refused<UsageException>(Status.NotFound, () => s.SetNumber(4711, 11));
        }
        Equal(3u, Fdi.ToUniversal(16), "universal");
        Equal(16u, Fdi.FromUniversal(3), "universal");
        Palmer palmer = Fdi.ToPalmer(16);
        Check(palmer.Letters == "UR6" && palmer.Quadrant == 1 && palmer.Position == 6 && palmer.Symbol.Contains("6"), palmer.Letters + palmer.Symbol);
        Refused<UsageException>(Status.InvalidArgument, () => Fdi.ToUniversal(99));
    }

    static void MeshesOfTeeth()
    {
        using (Segmentation s = Separated())
        {
            uint tooth = s.GetTeeth()[4];
            using (ToothMesh open = s.MakeToothMesh(tooth))
            using (ToothMesh closed = s.MakeToothMesh(tooth, new ToothMeshOptions { Closed = true }))
            using (ToothMesh gingiva = s.MakeGingivaMesh())
            {
                MeshInfo info = closed.GetInfo();
                Check(info.OpenRims == 0 && info.Volume > 50 && open.GetInfo().OpenRims > 0, "closed");
                Equal(s.GetTooth(tooth).Label, info.Label, "label");
                Equal(0u, gingiva.GetInfo().Label, "gingiva");
                Equal(info.Vertices, (uint)closed.GetPositions().Length, "vertices");
                Equal(info.Vertices, (uint)closed.GetNormals().Length, "normals");
                Equal(info.Triangles, (uint)closed.GetTriangles().Length, "triangles");
                Equal(info.FillTriangles, (uint)Array.FindAll(closed.GetFaces(), f => f == Library.None).Length, "fill");
                byte[] flags = closed.GetVertexFlags();
                Equal(info.CutVertices, (uint)Array.FindAll(flags, f => ((MeshVertexFlags)f & MeshVertexFlags.OnCut) != 0).Length, "flags");
                string file = Path.Combine(scratch, "Zahn \u00e4.stl");
                closed.Save(file, OutputFormat.Stl);
                Equal(84 + 50L * info.Triangles, new FileInfo(file).Length, "STL");
            }
            string whole = Path.Combine(scratch, "whole.ply");
            s.Save(whole, OutputFormat.Ply, new SaveOptions { WholeFaces = true });
            using (Model again = Model.Load(context, whole)) Equal(model.GetReport().Faces, again.GetReport().Faces, "whole faces");
        }
    }

    static void SessionsGoOn()
    {
        using (Segmentation s = Separated())
        {
            string file = Path.Combine(scratch, "session.json");
            s.SaveSession(file);
            Equal(File.ReadAllText(file), s.WriteSession(), "text");
            using (Session loaded = Session.Load(model, file))
            using (Session read = Session.Read(model, s.WriteSession()))
            {
                Check(Dump(s) == Dump(loaded.Segmentation) && Dump(s) == Dump(read.Segmentation), "the same");
                Equal(14, loaded.Features.GetGroups().Length, "features");
                loaded.Segmentation.Undo();
            }
            Refused<FileException>(Status.FileFormat, () => Session.Read(model, "[]"));
            Refused<FileException>(Status.FileOpen, () => Session.Load(model, Path.Combine(scratch, "nowhere.json")));
            Throws<ToothsegException>(() => Session.Read(model, ""));
        }
    }
}
