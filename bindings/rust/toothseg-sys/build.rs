// SPDX-License-Identifier: Apache-2.0
//! Finds libtoothseg: in the folder that TOOTHSEG_LIB_DIR names, else by pkg-config.

use std::path::Path;
use std::process::Command;

fn pkg_config_lib_dir() -> String {
    let output = Command::new("pkg-config")
        .args(["--variable=libdir", "toothseg"])
        .output()
        .expect("pkg-config cannot be run: set TOOTHSEG_LIB_DIR to the folder with libtoothseg");
    assert!(
        output.status.success(),
        "pkg-config does not know toothseg: set TOOTHSEG_LIB_DIR to the folder with libtoothseg, or PKG_CONFIG_PATH\n{}",
        String::from_utf8_lossy(&output.stderr)
    );
    String::from_utf8_lossy(&output.stdout).trim().to_owned()
}

fn main() {
    println!("cargo:rerun-if-changed=build.rs");
    println!("cargo:rerun-if-env-changed=TOOTHSEG_LIB_DIR");
    println!("cargo:rerun-if-env-changed=PKG_CONFIG_PATH");
    let dir = std::env::var("TOOTHSEG_LIB_DIR").unwrap_or_else(|_| pkg_config_lib_dir());
    let path = Path::new(&dir);
    assert!(path.is_absolute() && path.is_dir(), "{dir}: not the whole path of a folder that is there");
    println!("cargo:rustc-link-search=native={dir}");
    println!("cargo:rustc-link-lib=dylib=toothseg");
    // For the tests of this package; others read `lib_dir` as DEP_TOOTHSEG_LIB_DIR.
    if std::env::var_os("CARGO_CFG_UNIX").is_some() {
        println!("cargo:rustc-link-arg=-Wl,-rpath,{dir}");
    }
    println!("cargo:lib_dir={dir}");
}
