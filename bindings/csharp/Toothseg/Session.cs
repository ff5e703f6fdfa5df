// SPDX-License-Identifier: Apache-2.0
#nullable enable
using System;
using System.Text;

namespace Toothseg
{
    /// <summary>A session gone through again: the features as they were, and the segmentation, to go on with.</summary>
    public sealed unsafe class Session : IDisposable
    {
        private delegate Status Reader(IntPtr* features, IntPtr* segmentation);

        public Features Features { get; private set; }
        public Segmentation Segmentation { get; private set; }

        private Session(Model model, Job? job, Reader read)
        {
            var features = new FeaturesHandle(model.Handle.Hooks);
            try
            {
                Segmentation = new Segmentation(Handle.Make(new SegmentationHandle(model.Handle.Hooks), job, made =>
                {
                    IntPtr its = IntPtr.Zero;
                    Status status = read(&its, made);
                    features.Adopt(its);
                    return status;
                }));
            }
            catch
            {
                features.Dispose();
                throw;
            }
            Features = new Features(features);
        }

        /// <summary>From a file that Segmentation.SaveSession wrote, on the model that it was of.</summary>
        public static Session Load(Model model, string path, Job? job = null)
        {
            if (model == null) throw new ArgumentNullException("model");
            fixed (byte* name = Text.ZeroTerminated(path, "path"))
            {
                byte* file = name;
                return new Session(model, job, (features, segmentation) =>
                    Native.ts_session_load(model.Handle, file, Job.Of(job), features, segmentation));
            }
        }

        /// <summary>From what Segmentation.WriteSession gave.</summary>
        public static Session Read(Model model, string text, Job? job = null)
        {
            if (model == null) throw new ArgumentNullException("model");
            if (text == null) throw new ArgumentNullException("text");
            int size = Encoding.UTF8.GetByteCount(text);
            var bytes = new byte[size + 1]; // of which one is there even for an empty text
            Encoding.UTF8.GetBytes(text, 0, text.Length, bytes, 0);
            fixed (byte* first = bytes)
            {
                byte* start = first;
                return new Session(model, job, (features, segmentation) =>
                    Native.ts_session_read(model.Handle, start, (UIntPtr)size, Job.Of(job), features, segmentation));
            }
        }

        public void Dispose()
        {
            Segmentation.Dispose();
            Features.Dispose();
        }
    }
}
