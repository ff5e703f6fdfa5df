// SPDX-License-Identifier: Apache-2.0
#nullable enable
using System;
using System.Runtime.InteropServices;

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
            try { Of(user).log!(level, Text.Decode(text, int.MaxValue)); }
            catch { } // a line is lost; the work goes on
        }

        private static void* AllocateHook(UIntPtr bytes, void* user)
        {
            try { return (void*)Of(user).allocate!(bytes); }
            catch { return null; } // out of memory
        }

        private static void FreeHook(void* memory, void* user)
        {
            try { Of(user).free!((IntPtr)memory); }
            catch { } // nobody could make anything of it
        }
    }
}
