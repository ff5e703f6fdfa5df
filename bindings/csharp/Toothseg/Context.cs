// SPDX-License-Identifier: Apache-2.0
#nullable enable
using System;
using System.Runtime.ExceptionServices;
using System.Runtime.InteropServices;
using System.Threading;

namespace Toothseg
{
    /// <summary>Hooks and threads of a context. Hooks may be called from any thread, until the last object made from the
    /// context is gone.</summary>
    public sealed unsafe class ContextOptions
    {
        public ContextOptions() { Threads = Defaults().threads; }

        /// <summary>Worker threads: 0 = one a core, 1 = only the calling thread.</summary>
        public uint Threads { get; set; }

        /// <summary>Gets one line at a time; what it throws is dropped.</summary>
        public Action<LogLevel, string>? Log { get; set; }

        /// <summary>Bytes to memory aligned to 16 bytes, IntPtr.Zero where there is none. Give both or none.</summary>
        public Func<UIntPtr, IntPtr>? Allocate { get; set; }

        public Action<IntPtr>? Free { get; set; }

        internal static ts_context_options Defaults()
        {
            ts_context_options options;
            ToothsegException.Check(Native.ts_context_options_init(&options, (uint)sizeof(ts_context_options)));
            return options;
        }
    }

    /// <summary>What all objects are made from.</summary>
    public sealed unsafe class Context : IDisposable
    {
        internal readonly ContextHandle Handle;

        public Context(ContextOptions? options = null)
        {
            ts_context_options native = ContextOptions.Defaults();
            Hooks? hooks = null;
            if (options != null)
            {
                native.threads = options.Threads;
                if (options.Log != null || options.Allocate != null || options.Free != null)
                    hooks = new Hooks(options.Log, options.Allocate, options.Free);
            }
            var handle = new ContextHandle(hooks);
            if (hooks != null) hooks.SetIn(&native);
            ts_context_options* given = &native;
            Handle = Toothseg.Handle.Make(handle, null, made => Native.ts_context_create(given, made));
        }

        /// <summary>Gives it back; objects made from it live on.</summary>
        public void Dispose() { Handle.Dispose(); }
    }

    /// <summary>Progress and cancellation of one long call at a time.</summary>
    public sealed unsafe class Job : IDisposable
    {
        private static readonly ts_progress_fn Proceed = ProceedHook; // static: as long as native code may call it
        private static readonly JobHandle Nobody = new JobHandle(null);

        internal readonly JobHandle Handle;
        private readonly Func<double, string, bool>? progress;
        private ExceptionDispatchInfo? thrown;

        /// <summary>`progress` gets the fraction done and the name of the stage, from a thread that works for the call;
        /// where it returns false or throws, the call is cancelled, and what it throws comes out of the call.</summary>
        public Job(Context context, Func<double, string, bool>? progress = null)
        {
            if (context == null) throw new ArgumentNullException("context");
            this.progress = progress;
            var handle = new JobHandle(context.Handle.Hooks);
            // Weak, so that a job that is forgotten goes. During a call it is there: Check comes after.
            handle.Listener = GCHandle.Alloc(this, GCHandleType.Weak);
            IntPtr callback = progress == null ? IntPtr.Zero : Marshal.GetFunctionPointerForDelegate(Proceed);
            void* user = (void*)GCHandle.ToIntPtr(handle.Listener);
            Handle = Toothseg.Handle.Make(handle, null, made => Native.ts_job_create(context.Handle, callback, user, made));
        }

        /// <summary>The running call stops soon, with Status.Cancelled. Sticky until Reset. From any thread.</summary>
        public void Cancel() { Native.ts_job_cancel(Handle); }

        /// <summary>Makes a cancelled job usable again. Not while a call uses it.</summary>
        public void Reset() { Native.ts_job_reset(Handle); }

        /// <summary>The last reported fraction. From any thread.</summary>
        public double Progress { get { return Native.ts_job_progress(Handle); } }

        public void Dispose() { Handle.Dispose(); }

        internal static JobHandle Of(Job? job) { return job == null ? Nobody : job.Handle; }

        // Throws what the callback threw, else what the status says.
        internal static void Check(Job? job, Status status)
        {
            ExceptionDispatchInfo? thrown = job == null ? null : Interlocked.Exchange(ref job.thrown, null);
            if (thrown != null) thrown.Throw();
            ToothsegException.Check(status);
        }

        private static int ProceedHook(double fraction, byte* stage, void* user)
        {
            var job = (Job)GCHandle.FromIntPtr((IntPtr)user).Target;
            try
            {
                LibraryThreads.Enter();
                return job.progress!(fraction, Text.Decode(stage, int.MaxValue)) ? 0 : 1;
            }
            catch (Exception e)
            {
                job.thrown = ExceptionDispatchInfo.Capture(e);
                return 1;
            }
        }
    }
}
