// SPDX-License-Identifier: Apache-2.0
use crate::error::Result;
use crate::job::Job;
use crate::raw::{check, FromRaw, Handle};
use crate::values::LogLevel;
use std::alloc::{alloc, dealloc, Layout};
use std::any::Any;
use std::cell::Cell;
use std::ffi::CStr;
use std::fmt;
use std::marker::PhantomData;
use std::mem::forget;
use std::os::raw::{c_char, c_void};
use std::panic::{catch_unwind, resume_unwind, AssertUnwindSafe};
use std::ptr::null_mut;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use toothseg_sys as sys;

/// What a panic carries.
pub(crate) type Payload = Box<dyn Any + Send>;

/// Keeps the first panic. Another is forgotten, not dropped: what it carries may panic in turn, in a callback of the library.
pub(crate) fn keep_first(kept: &mut Option<Payload>, payload: Payload) {
    match kept {
        None => *kept = Some(payload),
        Some(_) => forget(payload),
    }
}

/// A log hook: gets a line without newline, from any thread that works for the context.
pub type Log = Box<dyn Fn(LogLevel, &str) + Send + Sync>;

/// Is asked for the library's large buffers, which come from the global allocator of the program: to count them, or to
/// set a limit. Called from any thread that works for the context.
pub trait MemoryHook: Send + Sync {
    /// Whether so many bytes may be had; `false` makes the call fail with [`Status::OUT_OF_MEMORY`](crate::Status).
    fn grant(&self, bytes: usize) -> bool;
    /// So many bytes that were granted are given back, or were not to be had.
    fn release(&self, bytes: usize);
}

/// Options of a context.
pub struct ContextOptions {
    /// Worker threads: 0 = one a core (default), 1 = only the calling thread, at most 1024.
    pub threads: u32,
    /// Counts or limits memory. Default: none.
    pub memory: Option<Box<dyn MemoryHook>>,
    /// Default: silent.
    pub log: Option<Log>,
}

impl ContextOptions {
    /// With this number of worker threads.
    pub fn threads(mut self, threads: u32) -> Self {
        self.threads = threads;
        self
    }

    /// With this memory hook.
    pub fn memory(mut self, hook: impl MemoryHook + 'static) -> Self {
        self.memory = Some(Box::new(hook));
        self
    }

    /// With this log hook.
    pub fn log(mut self, hook: impl Fn(LogLevel, &str) + Send + Sync + 'static) -> Self {
        self.log = Some(Box::new(hook));
        self
    }
}

impl Default for ContextOptions {
    fn default() -> Self {
        let mut raw = sys::ts_context_options::default();
        check(unsafe { sys::ts_context_options_init(&mut raw, raw.struct_size) }).expect("the library is too old");
        ContextOptions { threads: raw.threads, memory: None, log: None }
    }
}

/// The hooks of a context, and the first panic of one of them that has not gone on yet.
#[derive(Default)]
pub(crate) struct Hooks {
    memory: Option<Box<dyn MemoryHook>>,
    log: Option<Log>,
    has_panicked: AtomicBool,
    panic: Mutex<Option<Payload>>,
}

impl fmt::Debug for Hooks {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Hooks {{ memory: {}, log: {} }}", self.memory.is_some(), self.log.is_some())
    }
}

impl Hooks {
    /// Ends a call: goes on with the panic of a callback, else tells the error.
    pub fn finish(&self, status: sys::ts_status, job: Option<&mut Job>) -> Result<()> {
        let result = check(status);
        if let Some(payload) = job.and_then(Job::take_panic) {
            resume_unwind(payload);
        }
        if self.has_panicked.swap(false, Ordering::AcqRel) {
            let payload = self.panic.lock().unwrap_or_else(PoisonError::into_inner).take();
            if let Some(payload) = payload {
                resume_unwind(payload);
            }
        }
        result
    }

    fn keep(&self, payload: Payload) {
        keep_first(&mut self.panic.lock().unwrap_or_else(PoisonError::into_inner), payload);
        self.has_panicked.store(true, Ordering::Release);
    }

    fn grant(&self, bytes: usize) -> bool {
        let memory = self.memory.as_ref();
        catch_unwind(AssertUnwindSafe(|| memory.map_or(true, |hook| hook.grant(bytes)))).unwrap_or_else(|payload| {
            self.keep(payload);
            false
        })
    }

    fn release(&self, bytes: usize) {
        if let Some(hook) = &self.memory {
            if let Err(payload) = catch_unwind(AssertUnwindSafe(|| hook.release(bytes))) {
                self.keep(payload);
            }
        }
    }
}

// Each block begins with its size, in as many bytes as it is aligned to.
const ALIGN: usize = 16;

fn block(bytes: usize) -> Option<Layout> {
    Layout::from_size_align(bytes.checked_add(ALIGN)?, ALIGN).ok()
}

unsafe extern "C" fn on_alloc(bytes: usize, user: *mut c_void) -> *mut c_void {
    let hooks = &*(user as *const Hooks);
    let layout = match block(bytes) {
        Some(layout) if hooks.grant(bytes) => layout,
        _ => return null_mut(),
    };
    let start = alloc(layout);
    if start.is_null() {
        hooks.release(bytes);
        return null_mut();
    }
    (start as *mut usize).write(bytes);
    start.add(ALIGN) as *mut c_void
}

unsafe extern "C" fn on_free(memory: *mut c_void, user: *mut c_void) {
    if memory.is_null() {
        return;
    }
    let start = (memory as *mut u8).sub(ALIGN);
    let bytes = (start as *const usize).read();
    dealloc(start, Layout::from_size_align_unchecked(bytes + ALIGN, ALIGN));
    (*(user as *const Hooks)).release(bytes);
}

unsafe extern "C" fn on_log(level: sys::ts_log_level, text: *const c_char, user: *mut c_void) {
    let hooks = &*(user as *const Hooks);
    let text = CStr::from_ptr(text).to_string_lossy();
    if let Some(log) = &hooks.log {
        if let Err(payload) = catch_unwind(AssertUnwindSafe(|| log(LogLevel::from_raw(level), &text))) {
            hooks.keep(payload);
        }
    }
}

/// Holds the hooks and worker threads for all objects made from it. They keep it alive.
///
/// It may go to another thread, but not be used by two at a time: making a model or a job needs it to itself. What is made
/// from it has no such limit.
#[derive(Debug)]
pub struct Context {
    handle: Handle<sys::ts_context>,
    not_sync: PhantomData<Cell<()>>,
}

impl Context {
    /// With the default options.
    pub fn new() -> Result<Self> {
        Self::with(ContextOptions::default())
    }

    /// With these options. A panic of a hook goes on out of the call that it happened in or, where several run at once, of
    /// one of these.
    pub fn with(options: ContextOptions) -> Result<Self> {
        let mut raw = sys::ts_context_options::default();
        check(unsafe { sys::ts_context_options_init(&mut raw, raw.struct_size) })?;
        let hooks = Arc::new(Hooks { memory: options.memory, log: options.log, ..Hooks::default() });
        let user = Arc::as_ptr(&hooks) as *mut c_void;
        raw.threads = options.threads;
        if hooks.memory.is_some() {
            raw.alloc = Some(on_alloc);
            raw.free = Some(on_free);
            raw.alloc_user = user;
        }
        if hooks.log.is_some() {
            raw.log = Some(on_log);
            raw.log_user = user;
        }
        let handle = Handle::make(&hooks, None, |_, out| unsafe { sys::ts_context_create(&raw, out) })?;
        Ok(Context { handle, not_sync: PhantomData })
    }

    pub(crate) fn handle(&self) -> &Handle<sys::ts_context> {
        &self.handle
    }
}
