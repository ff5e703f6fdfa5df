// SPDX-License-Identifier: Apache-2.0
#nullable enable
using System;
using System.Runtime.ExceptionServices;
using System.Runtime.InteropServices;
using System.Text;
using System.Threading;

namespace Toothseg
{
    /// <summary>A cut of a tooth: one closed line.</summary>
    public sealed class Cut
    {
        internal Cut(CutInfo info, EdgePoint[] points) { Info = info; Points = points; }

        public CutInfo Info { get; private set; }
        public EdgePoint[] Points { get; private set; }
    }

    /// <summary>A piece of a contour.</summary>
    public sealed class Polyline
    {
        internal Polyline(EdgePoint[] points, bool closed) { Points = points; Closed = closed; }

        public EdgePoint[] Points { get; private set; }
        public bool Closed { get; private set; }
    }

    /// <summary>A prepared scan and the teeth separated so far. What changes it needs it to itself; what reads it may run at
    /// the same time as other reading calls.</summary>
    public sealed unsafe partial class Segmentation : IDisposable
    {
        internal readonly SegmentationHandle Handle;

        internal Segmentation(SegmentationHandle handle) { Handle = handle; }

        /// <summary>Prepares a scan. The features are copied.</summary>
        public Segmentation(Features features, SegmentOptions? options = null, Job? job = null)
        {
            if (features == null) throw new ArgumentNullException("features");
            ts_segment_options native = (options ?? new SegmentOptions()).Value;
            ts_segment_options* given = &native;
            Handle = Toothseg.Handle.Make(new SegmentationHandle(features.Handle.Hooks), job,
                made => Native.ts_segmentation_create(features.Handle, given, Job.Of(job), made));
        }

        public void Dispose() { Handle.Dispose(); }

        // ------------------------------------------------------------------------------------------------- clicks

        /// <summary>Separates the tooth under a position and its neighbour; returns the number of the click.</summary>
        public uint Click(Point position, Job? job = null)
        {
            uint number;
            Check(Native.ts_segment_click(Handle, &position, Job.Of(job), &number), job);
            return number;
        }

        /// <summary>Several clicks, solved in parallel; a status each.</summary>
        public Status[] Clicks(Point[] positions, Job? job = null)
        {
            if (positions == null) throw new ArgumentNullException("positions");
            var statuses = new Status[positions.Length];
            if (positions.Length == 0) return statuses;
            fixed (Point* first = positions)
            fixed (Status* status = statuses)
                Check(Native.ts_segment_clicks(Handle, (double*)first, (uint)positions.Length, Job.Of(job), status), job);
            return statuses;
        }

        /// <summary>Every tooth that no click has separated so far, as one step.</summary>
        public void SegmentAll(Job? job = null) { Check(Native.ts_segment_all(Handle, Job.Of(job)), job); }

        /// <summary>The fewest clicks that cover what is not separated yet.</summary>
        public Point[] ProposeClicks()
        {
            return Elements.All<Point>((to, room, count) => Native.ts_propose_clicks(Handle, (double*)to, room, count));
        }

        public uint ClickCount
        {
            get
            {
                uint count;
                ToothsegException.Check(Native.ts_get_click_count(Handle, &count));
                return count;
            }
        }

        public ClickInfo GetClick(uint click)
        {
            var info = new ClickInfo { StructSize = (uint)sizeof(ClickInfo) };
            ToothsegException.Check(Native.ts_get_click(Handle, click, &info));
            return info;
        }

        /// <summary>u of a click, a value a vertex of the model.</summary>
        public double[] GetField(uint click)
        {
            return Elements.All<double>((to, room, count) => Native.ts_get_field(Handle, click, (double*)to, room, count));
        }

        public uint[] GetHistogram(uint click)
        {
            return Elements.All<uint>((to, room, count) => Native.ts_get_histogram(Handle, click, (uint*)to, room, count));
        }

        public ContourInfo[] GetContours(uint click)
        {
            return Elements.All<ContourInfo>((to, room, count) => Native.ts_get_contours(Handle, click, (ContourInfo*)to, room, count));
        }

        /// <summary>The polylines of one contour of a click.</summary>
        public Polyline[] GetContour(uint click, uint contour)
        {
            ContourInfo[] contours = GetContours(click);
            if (contour >= contours.Length) throw ToothsegException.Of(Status.NotFound, "no contour " + contour);
            uint polylines = contours[contour].Polylines;
            var starts = new uint[polylines + 1]; // one more, for the end of the last
            var closed = new byte[polylines + 1];
            EdgePoint[] all;
            fixed (uint* firstStart = starts)
            fixed (byte* firstClosed = closed)
            {
                uint* start = firstStart;
                byte* isClosed = firstClosed;
                all = Elements.All<EdgePoint>((to, room, count) => Native.ts_get_contour_points(Handle, click, contour,
                    (EdgePoint*)to, room, count, to == null ? null : start, to == null ? null : isClosed));
            }
            starts[polylines] = (uint)all.Length;
            var lines = new Polyline[polylines];
            for (uint i = 0; i < polylines; ++i)
            {
                var points = new EdgePoint[starts[i + 1] - starts[i]];
                Array.Copy(all, (int)starts[i], points, 0, points.Length);
                lines[i] = new Polyline(points, closed[i] != 0);
            }
            return lines;
        }

        // -------------------------------------------------------------------------------------------------- teeth

        /// <summary>Ids of the teeth separated so far, along the arch.</summary>
        public uint[] GetTeeth()
        {
            return Elements.All<uint>((to, room, count) => Native.ts_get_teeth(Handle, (uint*)to, room, count));
        }

        public ToothInfo GetTooth(uint tooth)
        {
            var info = new ToothInfo { StructSize = (uint)sizeof(ToothInfo) };
            ToothsegException.Check(Native.ts_get_tooth(Handle, tooth, &info));
            return info;
        }

        public uint[] GetToothFaces(uint tooth)
        {
            return Elements.All<uint>((to, room, count) => Native.ts_get_tooth_faces(Handle, tooth, (uint*)to, room, count));
        }

        public uint[] GetToothVertices(uint tooth)
        {
            return Elements.All<uint>((to, room, count) => Native.ts_get_tooth_vertices(Handle, tooth, (uint*)to, room, count));
        }

        /// <summary>Vertices of the model held as this tooth's constraint.</summary>
        public uint[] GetToothSeeds(uint tooth)
        {
            return Elements.All<uint>((to, room, count) => Native.ts_get_tooth_seeds(Handle, tooth, (uint*)to, room, count));
        }

        /// <summary>Which way a tooth looks, and its extent.</summary>
        public ToothFrame GetToothFrame(uint tooth)
        {
            var frame = new ToothFrame { StructSize = (uint)sizeof(ToothFrame) };
            ToothsegException.Check(Native.ts_get_tooth_frame(Handle, tooth, &frame));
            return frame;
        }

        /// <summary>A loop of a tooth's cut, 0 the longest.</summary>
        public Cut GetCut(uint tooth, uint loop = 0)
        {
            var info = new CutInfo { StructSize = (uint)sizeof(CutInfo) };
            CutInfo* its = &info;
            EdgePoint[] points = Elements.All<EdgePoint>((to, room, count) => Native.ts_get_cut(Handle, tooth, loop, its, (EdgePoint*)to, room, count));
            return new Cut(info, points);
        }

        /// <summary>A label for each of the caller's faces: 0 no tooth, else ToothInfo.Label.</summary>
        public uint[] GetLabels()
        {
            return Elements.All<uint>((to, room, count) => Native.ts_get_labels(Handle, (uint*)to, room, count));
        }

        /// <summary>Into an array of the caller's; returns their number.</summary>
        public int GetLabels(uint[] labels)
        {
            return Elements.Into(labels, (to, room, count) => Native.ts_get_labels(Handle, (uint*)to, room, count));
        }

#if TOOTHSEG_SPAN
        public int GetLabels(Span<uint> labels)
        {
            uint count;
            fixed (uint* first = &MemoryMarshal.GetReference(labels))
                ToothsegException.Check(Native.ts_get_labels(Handle, first, (uint)labels.Length, &count));
            if (count > labels.Length) throw ToothsegException.Of(Status.BufferTooSmall, "no room for " + count + " elements");
            return (int)count;
        }
#endif

        /// <summary>Teeth that want a look, and groups without a tooth, those that need it most first.</summary>
        public ReviewItem[] GetReview()
        {
            return Elements.All<ReviewItem>((to, room, count) => Native.ts_get_review(Handle, (ReviewItem*)to, room, count));
        }

        /// <summary>Faces that two teeth hold.</summary>
        public Overlap[] GetOverlaps()
        {
            return Elements.All<Overlap>((to, room, count) => Native.ts_get_overlaps(Handle, (Overlap*)to, room, count));
        }

        public PrepareTimes GetPrepareTimes()
        {
            var times = new PrepareTimes { StructSize = (uint)sizeof(PrepareTimes) };
            ToothsegException.Check(Native.ts_get_prepare_times(Handle, &times));
            return times;
        }

        public MemoryInfo GetMemory()
        {
            var info = new MemoryInfo { StructSize = (uint)sizeof(MemoryInfo) };
            ToothsegException.Check(Native.ts_get_memory(Handle, &info));
            return info;
        }

        // ------------------------------------------------------------------------------------------------ numbers

        /// <summary>Gives the teeth their FDI numbers.</summary>
        public void AssignNumbers(NumberOptions? options = null)
        {
            ts_number_options native = (options ?? new NumberOptions()).Value;
            Check(Native.ts_assign_numbers(Handle, &native));
        }

        /// <summary>Sets the number of a tooth by hand; 0 forgets it.</summary>
        public void SetNumber(uint tooth, uint fdi) { Check(Native.ts_set_number(Handle, tooth, fdi)); }

        public NumberInfo GetNumber(uint tooth)
        {
            var info = new NumberInfo { StructSize = (uint)sizeof(NumberInfo) };
            ToothsegException.Check(Native.ts_get_number(Handle, tooth, &info));
            return info;
        }

        /// <summary>The jaw that the numbers are of.</summary>
        public JawInfo GetJaw()
        {
            var info = new JawInfo { StructSize = (uint)sizeof(JawInfo) };
            ToothsegException.Check(Native.ts_get_jaw(Handle, &info));
            return info;
        }

        // ------------------------------------------------------------------------------------------ meshes, files

        /// <summary>A tooth as a mesh of its own, cut exactly along its cut.</summary>
        public ToothMesh MakeToothMesh(uint tooth, ToothMeshOptions? options = null, Job? job = null)
        {
            ts_tooth_mesh_options native = (options ?? new ToothMeshOptions()).Value;
            ts_tooth_mesh_options* given = &native;
            return new ToothMesh(Toothseg.Handle.Make(new MeshHandle(Handle.Hooks), job,
                made => Native.ts_tooth_mesh_create(Handle, tooth, given, Job.Of(job), made)));
        }

        /// <summary>What belongs to no tooth separated so far.</summary>
        public ToothMesh MakeGingivaMesh(ToothMeshOptions? options = null, Job? job = null)
        {
            ts_tooth_mesh_options native = (options ?? new ToothMeshOptions()).Value;
            ts_tooth_mesh_options* given = &native;
            return new ToothMesh(Toothseg.Handle.Make(new MeshHandle(Handle.Hooks), job,
                made => Native.ts_gingiva_mesh_create(Handle, given, Job.Of(job), made)));
        }

        /// <summary>Writes the whole scan with its teeth.</summary>
        public void Save(string path, OutputFormat format, SaveOptions? options = null, Job? job = null)
        {
            ts_save_options native = (options ?? new SaveOptions()).Value;
            fixed (byte* name = Text.ZeroTerminated(path, "path"))
                Job.Check(job, Native.ts_segmentation_save(Handle, name, format, &native, Job.Of(job)));
        }

        /// <summary>The session as JSON.</summary>
        public string WriteSession()
        {
            return Encoding.UTF8.GetString(Elements.All<byte>((to, room, count) => Native.ts_session_write(Handle, (byte*)to, room, count)));
        }

        public void SaveSession(string path)
        {
            fixed (byte* name = Text.ZeroTerminated(path, "path")) ToothsegException.Check(Native.ts_session_save(Handle, name));
        }

        // ------------------------------------------------------------------------------------------------ history

        public void Undo() { Check(Native.ts_undo(Handle)); }

        public void Redo() { Check(Native.ts_redo(Handle)); }

        public HistoryInfo GetHistory()
        {
            var info = new HistoryInfo { StructSize = (uint)sizeof(HistoryInfo) };
            ToothsegException.Check(Native.ts_get_history(Handle, &info));
            return info;
        }

        /// <summary>How many bytes the steps may keep.</summary>
        public void SetHistoryLimit(ulong bytes) { ToothsegException.Check(Native.ts_set_history_limit(Handle, bytes)); }

        /// <summary>Ids of the teeth that the last step, Undo or Redo changed.</summary>
        public uint[] GetChanges()
        {
            return Elements.All<uint>((to, room, count) => Native.ts_get_changes(Handle, (uint*)to, room, count));
        }

        /// <summary>Called after a change with the ids of the teeth changed, on the thread of the call. It may read the
        /// segmentation, and must not change it. What it throws comes out of the call.</summary>
        public event Action<uint[]>? Changed
        {
            add { Listen(listener == null ? value : listener.Callback + value); }
            remove { if (listener != null) Listen(listener.Callback - value); }
        }

        private sealed class Listener
        {
            internal Action<uint[]>? Callback;
            internal ExceptionDispatchInfo? Thrown;
        }

        private static readonly ts_change_fn Tell = TellHook; // static: as long as native code may call it
        private Listener? listener;

        private void Listen(Action<uint[]>? callback)
        {
            if (callback != null && listener == null)
            {
                var fresh = new Listener();
                // Weak, so that a segmentation that its own listener knows can be forgotten. It is there during a call: Check
                // comes after.
                GCHandle weak = GCHandle.Alloc(fresh, GCHandleType.Weak);
                Status status = Status.Internal;
                try
                {
                    status = Native.ts_set_change_callback(Handle, Marshal.GetFunctionPointerForDelegate(Tell), (void*)GCHandle.ToIntPtr(weak));
                }
                finally
                {
                    if (status != Status.Ok) weak.Free();
                }
                ToothsegException.Check(status);
                Handle.Listener = weak;
                listener = fresh;
            }
            else if (callback == null && listener != null)
            {
                ToothsegException.Check(Native.ts_set_change_callback(Handle, IntPtr.Zero, null));
                Handle.Listener.Free();
                listener = null;
            }
            if (listener != null) listener.Callback = callback;
        }

        private static void TellHook(void* user, uint* teeth, uint count)
        {
            var listener = (Listener)GCHandle.FromIntPtr((IntPtr)user).Target;
            try
            {
                var changed = new uint[count];
                for (uint i = 0; i < count; ++i) changed[i] = teeth[i];
                Action<uint[]>? callback = listener.Callback;
                if (callback != null) callback(changed);
            }
            catch (Exception e)
            {
                listener.Thrown = ExceptionDispatchInfo.Capture(e);
            }
        }

        // After a call that may have changed something.
        private void Check(Status status, Job? job = null)
        {
            ExceptionDispatchInfo? thrown = listener == null ? null : Interlocked.Exchange(ref listener.Thrown, null);
            Job.Check(job, status);
            if (thrown != null) thrown.Throw();
        }
    }
}
