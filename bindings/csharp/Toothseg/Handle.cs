// SPDX-License-Identifier: Apache-2.0
#nullable enable
using System;
using System.Diagnostics;
using System.Reflection;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Threading;

namespace Toothseg
{
    // A native object. The runtime holds it during every call that it is passed to, so that one that is disposed meanwhile
    // is destroyed after the call; one that is forgotten is destroyed by its finalizer.
    internal abstract unsafe class Handle : SafeHandle
    {
        internal delegate Status Maker(IntPtr* native);

        private Hooks? hooks; // those of its context, which have to be there as long as any object of the context is

        // What a native callback's user pointer refers to, freed with the object.
        internal GCHandle Listener;

        protected Handle(Hooks? hooks) : base(IntPtr.Zero, true)
        {
            if (hooks != null) hooks.Retain();
            this.hooks = hooks;
        }

        internal Hooks? Hooks { get { return hooks; } }

        public override bool IsInvalid { get { return handle == IntPtr.Zero; } }

        protected abstract void Destroy(IntPtr native);

        protected override bool ReleaseHandle()
        {
            Destroy(handle);
            LetGo();
            return true;
        }

        protected override void Dispose(bool disposing)
        {
            if (IsInvalid) LetGo(); // of a native object that was never made: ReleaseHandle is not called
            base.Dispose(disposing);
        }

        private void LetGo()
        {
            if (Listener.IsAllocated) Listener.Free();
            Hooks? mine = hooks;
            hooks = null;
            if (mine != null) mine.Release();
        }

        internal void Adopt(IntPtr native) { SetHandle(native); }

        // The native object is owned before the status is looked at: a callback may throw at the very end of the call.
        internal static T Make<T>(T made, Job? job, Maker make) where T : Handle
        {
            try
            {
                IntPtr native = IntPtr.Zero;
                Status status = make(&native);
                made.Adopt(native);
                Job.Check(job, status);
                return made;
            }
            catch
            {
                made.Dispose();
                throw;
            }
        }
    }

    // Threads of the library that come into managed code by a callback. They live as long as the process, and Mono, which takes
    // them for threads of the program, would wait for their end when it is over, for ever.
    internal static class LibraryThreads
    {
        private const long NotManaged = 1; // what Mono's own helper threads have among their flags (MONO_THREAD_FLAG_DONT_MANAGE)

        // Fields of Mono's Thread, null on other runtimes, which do not wait for such threads.
        private static readonly FieldInfo? Internal =
            typeof(Thread).GetField("internal_thread", BindingFlags.Instance | BindingFlags.NonPublic);
        private static readonly FieldInfo? Flags = Internal == null ? null :
            Internal.FieldType.GetField("flags", BindingFlags.Instance | BindingFlags.NonPublic | BindingFlags.Public);

        [ThreadStatic] private static bool known;

        // At the start of a hook. On a thread of the library there is no managed frame below that of the hook; the caller's
        // own threads stay what they are.
        [MethodImpl(MethodImplOptions.NoInlining)]
        internal static void Enter()
        {
            if (known) return;
            known = true;
            if (new StackTrace(1, false).FrameCount > 1) return;
            Thread thread = Thread.CurrentThread;
            if (Internal != null && Flags != null && Flags.FieldType == typeof(IntPtr))
            {
                object mono = Internal.GetValue(thread);
                Flags.SetValue(mono, (IntPtr)((long)(IntPtr)Flags.GetValue(mono) | NotManaged));
            }
            thread.IsBackground = true;
        }
    }

    // The hooks of a context, alive until the last object made from it is gone.
    internal sealed unsafe class Hooks
    {
        private readonly Action<LogLevel, string>? log;
        private readonly Func<UIntPtr, IntPtr>? allocate;
        private readonly Action<IntPtr>? free;
        private readonly GCHandle self;
        private int users;
        private bool gone;

        // Static, so that the native code may call them for ever. Nothing that is thrown may reach its frames.
        private static readonly ts_log_fn Tell = TellHook;
        private static readonly ts_alloc_fn Allocate = AllocateHook;
        private static readonly ts_free_fn Free = FreeHook;

        internal Hooks(Action<LogLevel, string>? log, Func<UIntPtr, IntPtr>? allocate, Action<IntPtr>? free)
        {
            this.log = log;
            this.allocate = allocate;
            this.free = free;
            self = GCHandle.Alloc(this);
        }

        internal void SetIn(ts_context_options* options)
        {
            void* user = (void*)GCHandle.ToIntPtr(self);
            if (log != null) options->log = Marshal.GetFunctionPointerForDelegate(Tell);
            if (allocate != null) options->alloc = Marshal.GetFunctionPointerForDelegate(Allocate);
            if (free != null) options->free = Marshal.GetFunctionPointerForDelegate(Free);
            options->log_user = user;
            options->alloc_user = user;
        }

        internal void Retain()
        {
            lock (this)
            {
                if (gone) throw new ObjectDisposedException("Context");
                ++users;
            }
        }

        internal void Release()
        {
            lock (this)
            {
                if (--users != 0) return;
                gone = true;
                self.Free();
            }
        }

        private static Hooks Of(void* user) { return (Hooks)GCHandle.FromIntPtr((IntPtr)user).Target; }

        private static void TellHook(LogLevel level, byte* text, void* user)
        {
            try { LibraryThreads.Enter(); Of(user).log!(level, Text.Decode(text, int.MaxValue)); }
            catch { } // a line is lost; the work goes on
        }

        private static void* AllocateHook(UIntPtr bytes, void* user)
        {
            try { LibraryThreads.Enter(); return (void*)Of(user).allocate!(bytes); }
            catch { return null; } // out of memory
        }

        private static void FreeHook(void* memory, void* user)
        {
            try { LibraryThreads.Enter(); Of(user).free!((IntPtr)memory); }
            catch { } // nobody could make anything of it
        }
    }
}
