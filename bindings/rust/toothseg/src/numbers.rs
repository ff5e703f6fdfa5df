// SPDX-License-Identifier: Apache-2.0
use crate::data::Palmer;
use crate::error::Result;
use crate::raw::{check, FromRaw};
use toothseg_sys as sys;

/// FDI to Universal.
pub fn fdi_to_universal(fdi: u32) -> Result<u32> {
    let mut universal = 0;
    check(unsafe { sys::ts_fdi_to_universal(fdi, &mut universal) })?;
    Ok(universal)
}

/// Universal to FDI.
pub fn universal_to_fdi(universal: u32) -> Result<u32> {
    let mut fdi = 0;
    check(unsafe { sys::ts_universal_to_fdi(universal, &mut fdi) })?;
    Ok(fdi)
}

/// FDI to Palmer's notation.
pub fn fdi_to_palmer(fdi: u32) -> Result<Palmer> {
    let mut palmer = sys::ts_palmer::default();
    check(unsafe { sys::ts_fdi_to_palmer(fdi, &mut palmer) })?;
    Ok(Palmer::from_raw(palmer))
}
