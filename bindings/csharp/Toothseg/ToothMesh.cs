// SPDX-License-Identifier: Apache-2.0
#nullable enable
using System;

namespace Toothseg
{
    /// <summary>A tooth, or the gingiva, as a mesh of its own. Never changes once made.</summary>
    public sealed unsafe class ToothMesh : IDisposable
    {
        internal readonly MeshHandle Handle;

        internal ToothMesh(MeshHandle handle) { Handle = handle; }

        public void Dispose() { Handle.Dispose(); }

        public MeshInfo GetInfo()
        {
            var info = new MeshInfo { StructSize = (uint)sizeof(MeshInfo) };
            ToothsegException.Check(Native.ts_mesh_get_info(Handle, &info));
            return info;
        }

        public Point[] GetPositions()
        {
            return Elements.All<Point>((to, room, count) => Native.ts_mesh_get_positions(Handle, (double*)to, room, count));
        }

        /// <summary>Unit normals of the vertices, outwards.</summary>
        public Point[] GetNormals()
        {
            return Elements.All<Point>((to, room, count) => Native.ts_mesh_get_normals(Handle, (double*)to, room, count));
        }

        public Triangle[] GetTriangles()
        {
            return Elements.All<Triangle>((to, room, count) => Native.ts_mesh_get_triangles(Handle, (uint*)to, room, count));
        }

        /// <summary>For each triangle the face of the model that it is of, Library.None for those that close the mesh.</summary>
        public uint[] GetFaces()
        {
            return Elements.All<uint>((to, room, count) => Native.ts_mesh_get_faces(Handle, (uint*)to, room, count));
        }

        /// <summary>For each vertex a sum of MeshVertexFlags.</summary>
        public byte[] GetVertexFlags()
        {
            return Elements.All<byte>((to, room, count) => Native.ts_mesh_get_vertex_flags(Handle, (byte*)to, room, count));
        }

        public void Save(string path, OutputFormat format, Job? job = null)
        {
            fixed (byte* name = Text.ZeroTerminated(path, "path"))
                Job.Check(job, Native.ts_mesh_save(Handle, name, format, Job.Of(job)));
        }
    }
}
