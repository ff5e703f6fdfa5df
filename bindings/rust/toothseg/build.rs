// SPDX-License-Identifier: Apache-2.0
//! Lets tests and samples find at run time the library that they were built with.

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    if std::env::var_os("CARGO_CFG_UNIX").is_some() {
        if let Ok(dir) = std::env::var("DEP_TOOTHSEG_LIB_DIR") {
            println!("cargo:rustc-link-arg=-Wl,-rpath,{dir}");
        }
    }
}
