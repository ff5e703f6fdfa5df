// SPDX-License-Identifier: Apache-2.0
#nullable enable
using System;
using System.Runtime.InteropServices;
using System.Text;

namespace Toothseg
{
    /// <summary>A place or a direction: three doubles, mm.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct Point
    {
        public double X, Y, Z;

        public Point(double x, double y, double z) { X = x; Y = y; Z = z; }

        public override string ToString()
        {
            return string.Format(System.Globalization.CultureInfo.InvariantCulture, "{0:R} {1:R} {2:R}", X, Y, Z);
        }
    }

    /// <summary>The three vertex indices of a face.</summary>
    [StructLayout(LayoutKind.Sequential)]
    public struct Triangle
    {
        public uint A, B, C;

        public Triangle(uint a, uint b, uint c) { A = a; B = b; C = c; }
    }

    /// <summary>What belongs to no object.</summary>
    public static unsafe class Library
    {
        /// <summary>"No index": a face, vertex, group or tooth that is not there.</summary>
        public const uint None = Native.TS_NONE;

        /// <summary>The version of the native library.</summary>
        public static string Version { get { return Text.Decode(Native.ts_version(), int.MaxValue); } }
    }

    /// <summary>Numbers of permanent teeth in other notations.</summary>
    public static unsafe class Fdi
    {
        public static uint ToUniversal(uint fdi)
        {
            uint universal;
            ToothsegException.Check(Native.ts_fdi_to_universal(fdi, &universal));
            return universal;
        }

        public static uint FromUniversal(uint universal)
        {
            uint fdi;
            ToothsegException.Check(Native.ts_universal_to_fdi(universal, &fdi));
            return fdi;
        }

        public static Palmer ToPalmer(uint fdi)
        {
            var palmer = new Palmer { StructSize = (uint)sizeof(Palmer) };
            ToothsegException.Check(Native.ts_fdi_to_palmer(fdi, &palmer));
            return palmer;
        }
    }

    // UTF-8 in and out.
    internal static unsafe class Text
    {
        internal static string Decode(byte* text, int most)
        {
            int length = 0;
            while (length < most && text[length] != 0) ++length;
            return length == 0 ? "" : Encoding.UTF8.GetString(text, length);
        }

        internal static byte[] ZeroTerminated(string text, string what)
        {
            if (text == null) throw new ArgumentNullException(what);
            if (text.IndexOf('\0') >= 0) throw new ArgumentException("a zero character within", what);
            var bytes = new byte[Encoding.UTF8.GetByteCount(text) + 1];
            Encoding.UTF8.GetBytes(text, 0, text.Length, bytes, 0);
            return bytes;
        }
    }

    // Getters by the two-call idiom: into new arrays, or into those of the caller.
    internal static unsafe class Elements
    {
        internal delegate Status Getter(void* buffer, uint capacity, uint* count);

        internal static T[] All<T>(Getter get) where T : struct
        {
            uint count;
            ToothsegException.Check(get(null, 0, &count));
            var elements = new T[count];
            if (count != 0) Into(elements, get);
            return elements;
        }

        // How many there are; a Status.BufferTooSmall exception where they do not fit.
        internal static int Into<T>(T[] elements, Getter get) where T : struct
        {
            if (elements == null) throw new ArgumentNullException("elements");
            uint count;
            GCHandle pinned = GCHandle.Alloc(elements, GCHandleType.Pinned);
            try
            {
                void* buffer = elements.Length == 0 ? null : (void*)pinned.AddrOfPinnedObject();
                ToothsegException.Check(get(buffer, (uint)elements.Length, &count));
            }
            finally
            {
                pinned.Free();
            }
            if (count > elements.Length) throw ToothsegException.Of(Status.BufferTooSmall, "no room for " + count + " elements");
            return (int)count;
        }
    }
}
