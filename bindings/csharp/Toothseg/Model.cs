// SPDX-License-Identifier: Apache-2.0
#nullable enable
using System;
using System.Runtime.InteropServices;

namespace Toothseg
{
    /// <summary>A mesh after intake: welded, clean, manifold, consistently wound. Never changes once made.</summary>
    public sealed unsafe class Model : IDisposable
    {
        internal readonly ModelHandle Handle;

        private Model(ModelHandle handle) { Handle = handle; }

        /// <summary>From an STL, PLY, OBJ or OFF file.</summary>
        public static Model Load(Context context, string path, IntakeOptions? options = null, Job? job = null)
        {
            if (context == null) throw new ArgumentNullException("context");
            ts_intake_options intake = (options ?? new IntakeOptions()).Value;
            ts_intake_options* given = &intake;
            fixed (byte* name = Text.ZeroTerminated(path, "path"))
            {
                byte* file = name;
                return new Model(Toothseg.Handle.Make(new ModelHandle(context.Handle.Hooks), job,
                    made => Native.ts_model_load(context.Handle, file, given, Job.Of(job), made)));
            }
        }

        /// <summary>From a file that is in memory already.</summary>
        public static Model Read(Context context, byte[] bytes, FileFormat format = FileFormat.Auto,
                                 IntakeOptions? options = null, Job? job = null)
        {
            if (context == null) throw new ArgumentNullException("context");
            if (bytes == null) throw new ArgumentNullException("bytes");
            ts_intake_options intake = (options ?? new IntakeOptions()).Value;
            ts_intake_options* given = &intake;
            fixed (byte* first = bytes.Length == 0 ? new byte[1] : bytes)
            {
                byte* file = first;
                return new Model(Toothseg.Handle.Make(new ModelHandle(context.Handle.Hooks), job,
                    made => Native.ts_model_read(context.Handle, file, (UIntPtr)bytes.Length, format, given, Job.Of(job), made)));
            }
        }

        /// <summary>From arrays, which are read only during the call: 3 coordinates a vertex, 3 indices a face. Without
        /// triangles every 3 vertices are a face.</summary>
        public static Model Create(Context context, double[] positions, uint[]? triangles = null,
                                   IntakeOptions? options = null, Job? job = null)
        {
            uint vertices = Triples(positions, "positions"), faces = triangles == null ? 0 : Triples(triangles, "triangles");
            fixed (double* xyz = positions)
            fixed (uint* corners = triangles)
                return Create(context, Scalar.Float64, xyz, vertices, triangles != null, corners, faces, options, job);
        }

        public static Model Create(Context context, float[] positions, uint[]? triangles = null,
                                   IntakeOptions? options = null, Job? job = null)
        {
            uint vertices = Triples(positions, "positions"), faces = triangles == null ? 0 : Triples(triangles, "triangles");
            fixed (float* xyz = positions)
            fixed (uint* corners = triangles)
                return Create(context, Scalar.Float32, xyz, vertices, triangles != null, corners, faces, options, job);
        }

        public static Model Create(Context context, Point[] positions, Triangle[]? triangles = null,
                                   IntakeOptions? options = null, Job? job = null)
        {
            if (positions == null) throw new ArgumentNullException("positions");
            fixed (Point* xyz = positions)
            fixed (Triangle* corners = triangles)
                return Create(context, Scalar.Float64, xyz, (uint)positions.Length, triangles != null, (uint*)corners,
                              triangles == null ? 0 : (uint)triangles.Length, options, job);
        }

#if TOOTHSEG_SPAN
        public static Model Create(Context context, ReadOnlySpan<double> positions, ReadOnlySpan<uint> triangles,
                                   IntakeOptions? options = null, Job? job = null)
        {
            fixed (double* xyz = &MemoryMarshal.GetReference(positions))
            fixed (uint* corners = &MemoryMarshal.GetReference(triangles))
                return Create(context, Scalar.Float64, xyz, Third(positions.Length, "positions"), true, corners,
                              Third(triangles.Length, "triangles"), options, job);
        }

        public static Model Create(Context context, ReadOnlySpan<float> positions, ReadOnlySpan<uint> triangles,
                                   IntakeOptions? options = null, Job? job = null)
        {
            fixed (float* xyz = &MemoryMarshal.GetReference(positions))
            fixed (uint* corners = &MemoryMarshal.GetReference(triangles))
                return Create(context, Scalar.Float32, xyz, Third(positions.Length, "positions"), true, corners,
                              Third(triangles.Length, "triangles"), options, job);
        }
#endif

        private static Model Create(Context context, Scalar scalar, void* positions, uint vertices, bool indexed, uint* triangles,
                                    uint faces, IntakeOptions? options, Job? job)
        {
            if (context == null) throw new ArgumentNullException("context");
            ts_mesh_input input;
            ToothsegException.Check(Native.ts_mesh_input_init(&input, (uint)sizeof(ts_mesh_input)));
            uint nothing = 0;
            input.scalar = scalar;
            input.positions = positions == null ? &nothing : positions; // an empty array: the library says what is wrong with it
            input.vertex_count = vertices;
            input.triangles = indexed && triangles == null ? &nothing : triangles; // null means: every 3 vertices are a face
            input.triangle_count = faces;
            ts_mesh_input* mesh = &input;
            ts_intake_options intake = (options ?? new IntakeOptions()).Value;
            ts_intake_options* given = &intake;
            return new Model(Toothseg.Handle.Make(new ModelHandle(context.Handle.Hooks), job,
                made => Native.ts_model_create(context.Handle, mesh, given, Job.Of(job), made)));
        }

        private static uint Triples(Array array, string what)
        {
            if (array == null) throw new ArgumentNullException(what);
            return Third(array.Length, what);
        }

        private static uint Third(int length, string what)
        {
            if (length % 3 != 0) throw new ArgumentException("not three numbers each", what);
            return (uint)(length / 3);
        }

        public void Dispose() { Handle.Dispose(); }

        /// <summary>What intake found and repaired.</summary>
        public IntakeReport GetReport()
        {
            var report = new IntakeReport { StructSize = (uint)sizeof(IntakeReport) };
            ToothsegException.Check(Native.ts_model_get_report(Handle, &report));
            return report;
        }

        public Point[] GetPositions()
        {
            return Elements.All<Point>((to, room, count) => Native.ts_model_get_positions(Handle, (double*)to, room, count));
        }

        public Triangle[] GetTriangles()
        {
            return Elements.All<Triangle>((to, room, count) => Native.ts_model_get_triangles(Handle, (uint*)to, room, count));
        }

        /// <summary>For each face of the model the caller's face it came from.</summary>
        public uint[] GetFaceSources()
        {
            return Elements.All<uint>((to, room, count) => Native.ts_model_get_face_sources(Handle, (uint*)to, room, count));
        }

        /// <summary>For each of the caller's vertices that of the model, Library.None where it was dropped.</summary>
        public uint[] GetVertexMap()
        {
            return Elements.All<uint>((to, room, count) => Native.ts_model_get_vertex_map(Handle, (uint*)to, room, count));
        }

        /// <summary>The surface point nearest to a position.</summary>
        public SurfacePoint Nearest(Point position)
        {
            SurfacePoint found;
            ToothsegException.Check(Native.ts_model_nearest(Handle, &position, &found));
            return found;
        }

        /// <summary>The first surface point hit by a ray; Status.NotFound where it misses.</summary>
        public SurfacePoint Raycast(Point origin, Point direction)
        {
            SurfacePoint found;
            ToothsegException.Check(Native.ts_model_raycast(Handle, &origin, &direction, &found));
            return found;
        }
    }
}
