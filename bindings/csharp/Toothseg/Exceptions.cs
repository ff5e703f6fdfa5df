// SPDX-License-Identifier: Apache-2.0
#nullable enable
using System;

namespace Toothseg
{
    /// <summary>A call that the library refused or could not finish; nothing has changed by it.</summary>
    public unsafe class ToothsegException : Exception
    {
        internal ToothsegException(Status status, string message) : base(message) { Status = status; }

        public Status Status { get; private set; }

        /// <summary>The status as the C header has it, "TS_E_NO_TEETH".</summary>
        public string Name { get { return Text.Decode(Native.ts_status_name(Status), int.MaxValue); } }

        /// <summary>The exception of a status: that of its block, or of the base class for a block that is not known.</summary>
        public static ToothsegException Of(Status status, string message)
        {
            switch ((int)status / 50 * 50)
            {
                case 100: case 150: return new UsageException(status, message);
                case 200: case 250: return new SurroundingsException(status, message);
                case 300: case 350: return new FileException(status, message);
                case 400: case 450: return new MeshException(status, message);
                case 500: case 550: return new FeaturesException(status, message);
                case 600: return new SegmentationException(status, message);
                case 650: return new EditException(status, message);
                case 700: return new NumberException(status, message);
                case 750: return new ToothMeshException(status, message);
                default: return new ToothsegException(status, message);
            }
        }

        // On the thread of the call: the message is a thread's own.
        internal static void Check(Status status)
        {
            if (status != Status.Ok) throw Of(status, Text.Decode(Native.ts_last_error_message(), int.MaxValue));
        }
    }

    /// <summary>100: the call itself is wrong.</summary>
    public sealed class UsageException : ToothsegException
    {
        internal UsageException(Status status, string message) : base(status, message) { }
    }

    /// <summary>200: out of memory, cancelled, a fault in the library.</summary>
    public sealed class SurroundingsException : ToothsegException
    {
        internal SurroundingsException(Status status, string message) : base(status, message) { }
    }

    /// <summary>300: files.</summary>
    public sealed class FileException : ToothsegException
    {
        internal FileException(Status status, string message) : base(status, message) { }
    }

    /// <summary>400: the mesh.</summary>
    public sealed class MeshException : ToothsegException
    {
        internal MeshException(Status status, string message) : base(status, message) { }
    }

    /// <summary>500: features.</summary>
    public sealed class FeaturesException : ToothsegException
    {
        internal FeaturesException(Status status, string message) : base(status, message) { }
    }

    /// <summary>600: clicks, corrections, undo.</summary>
    public sealed class SegmentationException : ToothsegException
    {
        internal SegmentationException(Status status, string message) : base(status, message) { }
    }

    /// <summary>650: edits of a cut.</summary>
    public sealed class EditException : ToothsegException
    {
        internal EditException(Status status, string message) : base(status, message) { }
    }

    /// <summary>700: numbers of teeth.</summary>
    public sealed class NumberException : ToothsegException
    {
        internal NumberException(Status status, string message) : base(status, message) { }
    }

    /// <summary>750: the meshes of teeth.</summary>
    public sealed class ToothMeshException : ToothsegException
    {
        internal ToothMeshException(Status status, string message) : base(status, message) { }
    }
}
