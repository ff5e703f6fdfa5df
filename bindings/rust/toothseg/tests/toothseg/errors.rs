// SPDX-License-Identifier: Apache-2.0
//! A status of every block, and that nothing has changed after it.

use crate::fixture::*;
use std::fs;
use toothseg::*;

#[track_caller]
fn fails_as<T>(kind: ErrorKind, status: Status, result: Result<T>) {
    let error = fails(status, result);
    assert_eq!(error.kind(), kind, "{error}");
    assert_eq!(error.is_cancelled(), status == Status::CANCELLED);
    let plain: Box<dyn std::error::Error + Send + Sync> = error.into();
    assert!(plain.to_string().starts_with("TS_E_"));
}

/// Everything that a segmentation holds.
fn state(s: &Segmentation) -> (String, Vec<u32>, Vec<u32>, u32, Vec<Vec<EdgePoint>>) {
    let teeth = s.teeth().unwrap();
    let cuts = teeth.iter().map(|&tooth| s.cut(tooth, 0).unwrap().points).collect();
    (s.write_session().unwrap(), s.labels().unwrap(), teeth, s.click_count().unwrap(), cuts)
}

#[test]
fn usage_100() {
    use ErrorKind::Usage;
    let (s, tooth) = clicked();
    fails_as(Usage, Status::NOT_FOUND, s.tooth(tooth + 1000));
    fails_as(Usage, Status::NOT_FOUND, s.click_info(99));
    fails_as(Usage, Status::INVALID_ARGUMENT, fdi_to_universal(19));
    fails_as(Usage, Status::INVALID_ARGUMENT, model().nearest([f64::NAN, 0.0, 0.0]));
    fails_as(Usage, Status::INVALID_ARGUMENT, Context::with(ContextOptions::default().threads(5000)));
    let triangle = [[0.0f64, 0.0, 0.0], [30.0, 0.0, 0.0], [0.0, 30.0, 0.0]];
    let other = Model::new(&context(), &MeshInput::soup(&triangle)).unwrap();
    fails_as(Usage, Status::MISMATCH, Session::read(&other, &s.write_session().unwrap(), None));
    // What the binding itself refuses.
    fails_as(Usage, Status::INVALID_ARGUMENT, Model::load(&context(), "zero\0inside"));
    fails_as(Usage, Status::INVALID_ARGUMENT, Model::new(&context(), &MeshInput::soup(&[0.0f32; 4])));
    fails_as(Usage, Status::INVALID_ARGUMENT, Model::new(&context(), &MeshInput::soup(&[0.0f32; 9]).stride(2)));
    fails_as(Usage, Status::INVALID_ARGUMENT, Model::new(&context(), &MeshInput::soup(&triangle).stride(usize::MAX)));
    fails_as(Usage, Status::INVALID_ARGUMENT, Model::new(&context(), &MeshInput::new(&triangle, &[0u32, 1])));
}

#[test]
fn cancelled_201() {
    let mut s = prepared();
    let before = state(&s);
    let mut job = Job::new(&context()).unwrap();
    job.cancel();
    fails_as(ErrorKind::Surroundings, Status::CANCELLED, s.segment_all(Some(&mut job)));
    assert_eq!(state(&s), before);
}

#[test]
fn files_300() {
    use ErrorKind::File;
    let context = context();
    fails_as(File, Status::FILE_OPEN, Model::load(&context, file("not there.stl")));
    fails_as(File, Status::FILE_FORMAT, Model::read(&context, b"no mesh at all"));
    let bytes = fs::read(file("arch.ply")).unwrap();
    fails_as(File, Status::FILE_TRUNCATED, Model::read(&context, &bytes[..bytes.len() - 5]));
    fails_as(File, Status::FILE_SYNTAX, Model::read(&context, b"OFF\n3 1 0\n0 0 0\n1 0 x\n0 1 0\n3 0 1 2\n"));
    let (s, _) = clicked();
    fails_as(File, Status::FILE_WRITE, s.save(file("no such folder/teeth.ply"), OutputFormat::PLY));
    fails_as(File, Status::FILE_WRITE, s.save_session(file("no such folder/session.json")));
    let newer = s.write_session().unwrap().replacen("\"toothseg_session\": 1", "\"toothseg_session\": 99", 1);
    fails_as(File, Status::FILE_NEWER, Session::read(&model(), &newer, None));
}

#[test]
fn mesh_400() {
    use ErrorKind::Mesh;
    let context = context();
    let none: [[f64; 3]; 0] = [];
    fails_as(Mesh, Status::MESH_EMPTY, Model::new(&context, &MeshInput::soup(&none)));
    let infinite = [[0.0f64, 0.0, 0.0], [30.0, 0.0, 0.0], [0.0, f64::INFINITY, 0.0]];
    fails_as(Mesh, Status::MESH_NON_FINITE, Model::new(&context, &MeshInput::soup(&infinite)));
    let triangle = [[0.0f32, 0.0, 0.0], [3.0, 0.0, 0.0], [0.0, 3.0, 0.0]];
    fails_as(Mesh, Status::MESH_INDEX_RANGE, Model::new(&context, &MeshInput::new(&triangle, &[[0u32, 1, 3]])));
    fails_as(Mesh, Status::MESH_UNITS, Model::new(&context, &MeshInput::soup(&triangle)));
    let options = IntakeOptions { unit: Unit::CM, ..Default::default() };
    let model = Model::new_with(&context, &MeshInput::soup(&triangle), &options, None).unwrap();
    assert_eq!(model.positions().unwrap()[1], [30.0, 0.0, 0.0]);
}

#[test]
fn features_500() {
    use ErrorKind::Features as Kind;
    let triangle = [[0.0f64, 0.0, 0.0], [30.0, 0.0, 0.0], [0.0, 30.0, 0.0]];
    let flat = Model::new(&context(), &MeshInput::soup(&triangle)).unwrap();
    fails_as(Kind, Status::NO_TEETH, Features::detect(&flat));
    fails_as(Kind, Status::NO_CONSTRAINT, Segmentation::new(&Features::new(&flat).unwrap()));
}

#[test]
fn segmentation_600() {
    use ErrorKind::Segmentation as Kind;
    let (mut s, tooth) = clicked();
    s.set_locked(tooth, true).unwrap();
    let position = s.click_info(0).unwrap().position;
    let before = state(&s);
    fails_as(Kind, Status::CLICK_OFF_SURFACE, s.click([500.0, 500.0, 500.0], None));
    fails_as(Kind, Status::LOCKED, s.click(position, None));
    fails_as(Kind, Status::NO_CHANGE, s.set_locked(tooth, true));
    fails_as(Kind, Status::NO_HISTORY, s.redo());
    assert_eq!(state(&s), before);
    // In a batch the others stand.
    let other = s.propose_clicks().unwrap()[0];
    let statuses = s.clicks(&[[500.0; 3], other], None).unwrap();
    assert_eq!(statuses, [Status::CLICK_OFF_SURFACE, Status::OK]);
    assert_eq!(s.click_count(), Ok(2));
}

#[test]
fn edits_650() {
    use ErrorKind::Edit;
    let (mut s, tooth) = clicked();
    let before = state(&s);
    let cut = s.cut(tooth, 0).unwrap().points;
    let top = arch().1.points().unwrap().into_iter().find(|p| p.group == tooth).unwrap().position;
    fails_as(Edit, Status::EDIT_NOTHING, s.offset_cut(tooth, 0.0, None));
    fails_as(Edit, Status::EDIT_NOTHING, s.drag_cut(tooth, 0, 0, cut[0].position, 0.0, None));
    fails_as(Edit, Status::EDIT_OFF_CUT, s.draw_cut(tooth, &[cut[0].position, top], None));
    fails_as(Edit, Status::EDIT_NO_LOOP, s.offset_cut(tooth, -5.0, None));
    fails_as(Edit, Status::EDIT_ON_TOOTH, s.offset_cut(tooth, 9.0, None));
    fails_as(ErrorKind::Usage, Status::INVALID_ARGUMENT, s.draw_cut(tooth, &[], None));
    assert_eq!(state(&s), before);
}

#[test]
fn numbers_700() {
    use ErrorKind::Number;
    let mut s = prepared();
    let groups: Vec<u32> = arch().1.groups().unwrap().iter().map(|g| g.id).collect();
    s.assign_numbers(&NumberOptions { jaw: Jaw::UPPER, ..Default::default() }).unwrap();
    let numbers = |s: &Segmentation| groups.iter().map(|&g| s.number(g).unwrap()).collect::<Vec<_>>();
    let of_sixth = s.number(groups[6]).unwrap().fdi;
    s.set_number(groups[6], Some(of_sixth)).unwrap();
    let before = (state(&s), numbers(&s));
    fails_as(Number, Status::NUMBER_JAW, s.set_number(groups[2], Some(36)));
    fails_as(Number, Status::NUMBER_TAKEN, s.set_number(groups[7], Some(of_sixth)));
    let of_ninth = s.number(groups[9]).unwrap().fdi;
    fails_as(Number, Status::NUMBER_ORDER, s.set_number(groups[2], Some(of_ninth)));
    fails_as(Number, Status::NUMBER_JAW, s.assign_numbers(&NumberOptions { jaw: Jaw::LOWER, ..Default::default() }));
    assert_eq!((state(&s), numbers(&s)), before);
}

#[test]
fn features_are_as_they_were() {
    let mut features = arch().1.try_clone().unwrap();
    let before = (features.points().unwrap(), features.groups().unwrap());
    fails(Status::NOT_FOUND, features.remove_point(100_000));
    fails(Status::NOT_FOUND, features.add_point(before.0[0].position, Some(100_000)));
    fails(Status::INVALID_ARGUMENT, features.set_occlusal([0.0; 3]));
    fails(Status::INVALID_ARGUMENT, features.move_point(before.0[0].id, [f64::NAN; 3]));
    assert_eq!((features.points().unwrap(), features.groups().unwrap()), before);
}

#[test]
fn tooth_meshes_750() {
    // So noisy that the surface crosses itself.
    let model = Model::load(&context(), file("noisy.ply")).unwrap();
    let mut s = Segmentation::new(&Features::detect(&model).unwrap()).unwrap();
    s.segment_all(None).unwrap();
    let closed = ToothMeshOptions { closed: true };
    let tooth = s.teeth().unwrap()[0];
    fails_as(ErrorKind::ToothMesh, Status::NOT_CLOSED, Mesh::tooth(&s, tooth, &closed, None));
    Mesh::tooth(&s, tooth, &Default::default(), None).unwrap();
}
