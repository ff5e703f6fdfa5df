// SPDX-License-Identifier: Apache-2.0
use crate::fixture::*;
use std::fs;
use toothseg::*;

fn text(labels: &[u32]) -> String {
    labels.iter().map(|label| format!("{label}\n")).collect()
}

#[test]
fn labels_are_those_of_ts_segment() {
    let mut segmentation = prepared();
    loop {
        let positions = segmentation.propose_clicks().unwrap();
        if positions.is_empty() {
            break;
        }
        let statuses = segmentation.clicks(&positions, None).unwrap();
        assert!(statuses.iter().all(|s| s.is_ok()), "{statuses:?}");
    }
    assert_eq!(text(&segmentation.labels().unwrap()), fs::read_to_string(file("labels.txt")).unwrap());
    assert_eq!(segmentation.clicks(&[], None), Ok(vec![]));
}

#[test]
fn what_a_click_found() {
    let (segmentation, tooth) = clicked();
    assert_eq!(segmentation.click_count(), Ok(1));
    let click = segmentation.click_info(0).unwrap();
    let neighbour = click.neighbour.unwrap();
    assert!(click.neighbour_iso.is_some() && click.target_iso < 1.0 && click.ms.total > 0.0);
    let mut teeth = segmentation.teeth().unwrap();
    teeth.sort_unstable();
    let mut both = [tooth, neighbour];
    both.sort_unstable();
    assert_eq!(teeth, both);

    let faces = model().report().unwrap().faces;
    let field = segmentation.field(0).unwrap();
    assert_eq!(field.len(), model().report().unwrap().vertices as usize);
    let bins = segmentation.histogram(0).unwrap();
    assert_eq!(bins.len(), 50);
    let contours = segmentation.contours(0).unwrap();
    let at = contours.iter().position(|c| c.chosen == Some(ChosenFor::Target)).unwrap();
    let lines = segmentation.contour(0, at as u32).unwrap();
    assert_eq!(lines.len(), contours[at].polylines as usize);
    assert_eq!(lines.iter().map(|l| l.points.len()).sum::<usize>(), contours[at].points as usize);
    assert!(lines.iter().any(|l| l.closed));
    fails(Status::NOT_FOUND, segmentation.contour(0, 100_000));

    let info = segmentation.tooth(tooth).unwrap();
    assert_eq!((info.id, info.click), (tooth, 0));
    assert_eq!(segmentation.tooth_faces(tooth).unwrap().len(), info.faces as usize);
    assert_eq!(segmentation.tooth_vertices(tooth).unwrap().len(), info.vertices as usize);
    assert!(!segmentation.tooth_seeds(tooth).unwrap().is_empty());
    let infos: Vec<ToothInfo> = segmentation.tooth_infos().unwrap().map(|t| t.unwrap()).collect();
    assert!(infos.contains(&info) && infos.len() == 2);

    let cut = segmentation.cut(tooth, 0).unwrap();
    assert_eq!(cut.points.len(), cut.info.points as usize);
    assert!(cut.info.closed && cut.info.length > 10.0);
    let positions = model().positions().unwrap();
    for point in &cut.points {
        let (a, b) = (positions[point.a as usize], positions[point.b as usize]);
        let between = [0, 1, 2].map(|k| (1.0 - point.t) * a[k] + point.t * b[k]);
        assert!(distance(between, point.position) < 1e-9);
    }

    let labels = segmentation.labels().unwrap();
    assert_eq!(labels.len(), model().report().unwrap().input_faces as usize);
    assert!(labels.contains(&info.label) && labels.contains(&0) && faces as usize <= labels.len());
    let frame = segmentation.tooth_frame(tooth).unwrap();
    assert!(frame.from_arch && frame.width > 2.0 && distance(frame.buccal, [0.0; 3]) > 0.99);
    assert!(segmentation.memory().unwrap().model > 0);
    assert!(segmentation.prepare_times().unwrap().factorise > 0.0);
    assert!(segmentation.review().unwrap().iter().filter(|item| !item.separated).count() >= 10);
    assert!(segmentation.overlaps().unwrap().iter().all(|o| o.winner != o.loser && o.faces > 0));
}

#[test]
fn options_reach_the_library() {
    let (_, features) = arch();
    let options = SegmentOptions { contours: 20, histogram_bins: 10, ..Default::default() };
    let mut segmentation = Segmentation::new_with(&features, &options, None).unwrap();
    let position = segmentation.propose_clicks().unwrap()[0];
    segmentation.click(position, None).unwrap();
    assert_eq!(segmentation.contours(0).unwrap().len(), 20);
    assert_eq!(segmentation.histogram(0).unwrap().len(), 10);
    let none = SegmentOptions { contours: 0, ..Default::default() };
    fails(Status::INVALID_ARGUMENT, Segmentation::new_with(&features, &none, None));
}

#[test]
fn numbers() {
    let mut segmentation = prepared();
    segmentation.segment_all(None).unwrap();
    fails(Status::NOT_FOUND, segmentation.jaw());
    segmentation.assign_numbers(&NumberOptions { jaw: Jaw::UPPER, ..Default::default() }).unwrap();
    let jaw = segmentation.jaw().unwrap();
    assert!(jaw.jaw == Jaw::UPPER && jaw.given && !jaw.uncertain);
    let teeth = segmentation.teeth().unwrap();
    assert_eq!(teeth.len(), 14);
    let number = |s: &Segmentation, tooth| s.number(tooth).unwrap();
    assert!(teeth.iter().all(|&t| (11..29).contains(&number(&segmentation, t).fdi)));
    let first = number(&segmentation, teeth[0]);
    segmentation.set_number(teeth[0], Some(first.fdi)).unwrap();
    assert!(number(&segmentation, teeth[0]).set_by_hand);
    segmentation.set_number(teeth[0], None).unwrap();
    assert!(!number(&segmentation, teeth[0]).set_by_hand);
}

#[test]
fn meshes() {
    let (segmentation, tooth) = clicked();
    let open = Mesh::tooth(&segmentation, tooth, &Default::default(), None).unwrap();
    let gingiva = Mesh::gingiva(&segmentation, &Default::default(), None).unwrap();
    let closed = Mesh::tooth(&segmentation, tooth, &ToothMeshOptions { closed: true }, None).unwrap();
    let info = closed.info().unwrap();
    assert_eq!(info.open_rims, 0);
    assert!(info.volume > 50.0 && info.fill_triangles > 0);
    assert_eq!(open.info().unwrap().label, segmentation.tooth(tooth).unwrap().label);
    assert_eq!(gingiva.info().unwrap().label, 0);

    let (vertices, triangles) = (info.vertices as usize, info.triangles as usize);
    assert_eq!((closed.positions().unwrap().len(), closed.normals().unwrap().len()), (vertices, vertices));
    assert!(closed.triangles().unwrap().iter().flatten().all(|&i| (i as usize) < vertices));
    let faces = closed.faces().unwrap();
    assert_eq!(faces.len(), triangles);
    assert_eq!(faces.iter().filter(|f| f.is_none()).count(), info.fill_triangles as usize);
    let flags = closed.vertex_flags().unwrap();
    assert_eq!(flags.len(), vertices);
    assert!(flags.iter().any(|f| f.contains(VertexFlags::OF_FILL)));

    let path = file("tooth.stl");
    closed.save(&path, OutputFormat::STL, None).unwrap();
    assert_eq!(fs::metadata(path).unwrap().len(), 84 + 50 * triangles as u64);
    let (split, whole) = (file("split.ply"), file("whole.ply"));
    segmentation.save(&split, OutputFormat::PLY).unwrap();
    segmentation.save_with(&whole, OutputFormat::PLY, &SaveOptions { whole_faces: true }, None).unwrap();
    let faces = |path| Model::load(&context(), path).unwrap().report().unwrap().input_faces;
    assert_eq!(faces(&whole), model().report().unwrap().faces);
    assert!(faces(&split) > faces(&whole));
}

#[test]
fn sessions() {
    let (mut segmentation, tooth) = clicked();
    segmentation.offset_cut(tooth, 0.2, None).unwrap();
    let text = segmentation.write_session().unwrap();
    let path = file("session.json");
    segmentation.save_session(&path).unwrap();
    assert_eq!(fs::read_to_string(&path).unwrap().trim_end(), text.trim_end());
    for session in [Session::read(&model(), &text, None).unwrap(), Session::load(&model(), &path, None).unwrap()] {
        assert_eq!(session.segmentation.labels(), segmentation.labels());
        assert_eq!(session.segmentation.cut(tooth, 0), segmentation.cut(tooth, 0));
        assert_eq!(session.features.points(), arch().1.points());
        let Session { segmentation: mut again, .. } = session;
        again.undo().unwrap();
        assert_ne!(again.cut(tooth, 0), segmentation.cut(tooth, 0));
    }
}
