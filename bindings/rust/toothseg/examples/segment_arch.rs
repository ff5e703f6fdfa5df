// SPDX-License-Identifier: Apache-2.0
//! Separates all teeth of a scan:
//!
//!     segment_arch SCAN [--all] [--threads N] [--labels OUT.txt] [--teeth DIR] [--closed]
//!
//! By the clicks that the library proposes, one for two teeth; with --all without clicks. Ctrl-C cancels.

use std::error::Error;
use std::fs;
use std::io::{stderr, BufWriter, Write};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::sync::atomic::{AtomicBool, Ordering};
use toothseg::{
    Context, ContextOptions, Features, IntakeOptions, Job, LogLevel, Mesh, Model, OutputFormat, Segmentation, Status,
    ToothMeshOptions,
};

const USAGE: &str = "usage: segment_arch SCAN [--all] [--threads N] [--labels OUT.txt] [--teeth DIR] [--closed]";

#[derive(Default)]
struct Arguments {
    scan: PathBuf,
    all: bool,
    threads: u32,
    labels: Option<PathBuf>,
    teeth: Option<PathBuf>,
    closed: bool,
}

fn parse() -> Option<Arguments> {
    let mut out = Arguments::default();
    let mut words = std::env::args().skip(1);
    while let Some(word) = words.next() {
        match word.as_str() {
            "--all" => out.all = true,
            "--closed" => out.closed = true,
            "--threads" => out.threads = words.next()?.parse().ok()?,
            "--labels" => out.labels = Some(words.next()?.into()),
            "--teeth" => out.teeth = Some(words.next()?.into()),
            scan if out.scan.as_os_str().is_empty() && !scan.starts_with('-') => out.scan = scan.into(),
            _ => return None,
        }
    }
    (!out.scan.as_os_str().is_empty()).then_some(out)
}

/// Ctrl-C, which the standard library has nothing for: a flag that the progress callback looks at.
mod interrupt {
    use super::{AtomicBool, Ordering};
    use std::os::raw::c_int;

    static ASKED: AtomicBool = AtomicBool::new(false);
    const SIGINT: c_int = 2;

    extern "C" {
        fn signal(number: c_int, handler: extern "C" fn(c_int)) -> usize;
    }

    extern "C" fn on_signal(_: c_int) {
        ASKED.store(true, Ordering::Relaxed);
    }

    pub fn catch() {
        unsafe { signal(SIGINT, on_signal) };
    }

    pub fn is_asked() -> bool {
        ASKED.load(Ordering::Relaxed)
    }
}

/// The rounds of proposed clicks until none is left, or one separates nothing more; how many clicks were made and failed.
fn click(segmentation: &mut Segmentation, job: &mut Job) -> toothseg::Result<(usize, usize)> {
    let (mut made, mut failed, mut teeth) = (0, 0, 0);
    loop {
        let positions = segmentation.propose_clicks()?;
        if positions.is_empty() {
            return Ok((made, failed));
        }
        let statuses = segmentation.clicks(&positions, Some(job))?;
        for (position, status) in positions.iter().zip(statuses).filter(|(_, status)| !status.is_ok()) {
            failed += 1;
            eprintln!("\rsegment_arch: click at {position:?}: {}", status.name());
        }
        made += positions.len();
        let now = segmentation.teeth()?.len();
        if now <= teeth {
            return Ok((made, failed));
        }
        teeth = now;
    }
}

/// A number a face, in the order of the faces of the scan.
fn write_labels(path: &Path, labels: &[u32]) -> std::io::Result<()> {
    let mut file = BufWriter::new(fs::File::create(path)?);
    for label in labels {
        writeln!(file, "{label}")?;
    }
    file.flush()
}

/// tooth_LABEL.stl for each tooth and gingiva.stl; how many could not be made.
fn write_teeth(
    folder: &Path,
    closed: bool,
    segmentation: &Segmentation,
    job: &mut Job,
) -> Result<usize, Box<dyn Error>> {
    let options = ToothMeshOptions { closed };
    let mut failed = 0;
    fs::create_dir_all(folder)?;
    let mut parts = vec![("gingiva.stl".to_owned(), None)];
    for tooth in segmentation.tooth_infos()? {
        let tooth = tooth?;
        parts.push((format!("tooth_{}.stl", tooth.label), Some(tooth.id)));
    }
    for (name, tooth) in parts {
        let made = match tooth {
            Some(tooth) => Mesh::tooth(segmentation, tooth, &options, Some(job)),
            None => Mesh::gingiva(segmentation, &options, Some(job)),
        };
        match made {
            Ok(mesh) => mesh.save(folder.join(name), OutputFormat::STL, None)?,
            Err(error) if [Status::NOT_CLOSED, Status::NO_CUT].contains(&error.status()) => {
                failed += 1;
                eprintln!("\rsegment_arch: {name}: {error}");
            }
            Err(error) => return Err(error.into()),
        }
    }
    Ok(failed)
}

fn run(arguments: &Arguments) -> Result<bool, Box<dyn Error>> {
    let options = ContextOptions::default().threads(arguments.threads).log(|level, text| {
        if level == LogLevel::WARNING {
            eprintln!("\rsegment_arch: {text}");
        }
    });
    let context = Context::with(options)?;
    let mut job = Job::with_progress(&context, |fraction, stage| {
        eprint!("\r{:3.0} % {stage:<30}", 100.0 * fraction);
        let _ = stderr().flush(); // progress that cannot be shown is no reason to stop
        !interrupt::is_asked()
    })?;

    let model = Model::load_with(&context, &arguments.scan, &IntakeOptions::default(), Some(&mut job))?;
    let features = Features::detect_with(&model, &Default::default(), Some(&mut job))?;
    let mut segmentation = Segmentation::new_with(&features, &Default::default(), Some(&mut job))?;
    let (clicks, mut failed) = if arguments.all {
        segmentation.segment_all(Some(&mut job))?;
        (0, 0)
    } else {
        click(&mut segmentation, &mut job)?
    };
    if let Some(folder) = &arguments.teeth {
        failed += write_teeth(folder, arguments.closed, &segmentation, &mut job)?;
    }
    if let Some(path) = &arguments.labels {
        write_labels(path, &segmentation.labels()?)?;
    }
    eprintln!();
    println!("{} teeth from {clicks} clicks, {failed} failed", segmentation.teeth()?.len());
    Ok(failed == 0)
}

fn main() -> ExitCode {
    let arguments = match parse() {
        Some(arguments) => arguments,
        None => {
            eprintln!("{USAGE}");
            return ExitCode::from(2);
        }
    };
    interrupt::catch();
    match run(&arguments) {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::from(1), // the others are written
        Err(error) => {
            eprintln!("\nsegment_arch: {error}");
            ExitCode::from(2)
        }
    }
}
