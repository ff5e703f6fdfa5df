// SPDX-License-Identifier: Apache-2.0
use crate::raw::static_text;
use crate::values::Status;
use std::fmt;

/// What a call of the library comes to.
pub type Result<T> = std::result::Result<T, Error>;

/// The block that a status is of.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum ErrorKind {
    /// 100: the call itself is wrong, a bug in the calling program.
    Usage,
    /// 200: memory, cancellation, or a fault in the library.
    Surroundings,
    /// 300: a file.
    File,
    /// 400: the mesh.
    Mesh,
    /// 500: feature points.
    Features,
    /// 600: clicks and corrections.
    Segmentation,
    /// 650: edits of a cut.
    Edit,
    /// 700: numbers of teeth.
    Number,
    /// 750: the meshes of teeth.
    ToothMesh,
    /// A block that only a newer library has.
    Other,
}

/// Why a call failed.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Error {
    status: Status,
    message: String,
}

impl Error {
    pub(crate) fn new(status: Status, message: impl Into<String>) -> Self {
        Error { status, message: message.into() }
    }

    /// The status, to be matched with the constants of [`Status`].
    pub fn status(&self) -> Status {
        self.status
    }

    /// The name of the status, such as "TS_E_NO_TEETH".
    pub fn name(&self) -> &'static str {
        self.status.name()
    }

    /// What was wrong, and where, in one line.
    pub fn message(&self) -> &str {
        &self.message
    }

    /// The block that the status is of.
    pub fn kind(&self) -> ErrorKind {
        match self.status.code() {
            100..=199 => ErrorKind::Usage,
            200..=299 => ErrorKind::Surroundings,
            300..=399 => ErrorKind::File,
            400..=499 => ErrorKind::Mesh,
            500..=599 => ErrorKind::Features,
            600..=649 => ErrorKind::Segmentation,
            650..=699 => ErrorKind::Edit,
            700..=749 => ErrorKind::Number,
            750..=799 => ErrorKind::ToothMesh,
            _ => ErrorKind::Other,
        }
    }

    /// Whether the job was cancelled.
    pub fn is_cancelled(&self) -> bool {
        self.status == Status::CANCELLED
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}: {}", self.name(), self.message)
    }
}

impl std::error::Error for Error {}

impl Status {
    /// Its name in the C API, such as "TS_E_NO_TEETH"; "TS_E_?" for one that the library does not know.
    pub fn name(self) -> &'static str {
        static_text(unsafe { toothseg_sys::ts_status_name(self.code()) })
    }

    /// Whether it is [`Status::OK`].
    pub fn is_ok(self) -> bool {
        self == Status::OK
    }
}
