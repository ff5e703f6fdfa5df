// SPDX-License-Identifier: Apache-2.0
use crate::fixture::*;
use toothseg::*;

#[test]
fn a_model_from_arrays_is_that_from_the_file() {
    let model = model();
    let report = model.report().unwrap();
    let (positions, triangles) = (model.positions().unwrap(), model.triangles().unwrap());
    assert_eq!((positions.len(), triangles.len()), (report.vertices as usize, report.faces as usize));
    assert!(report.area > 100.0 && report.mean_edge > 0.0 && report.diagonal > 20.0);

    let flat: Vec<f64> = positions.iter().flatten().copied().collect();
    let floats: Vec<[f32; 3]> = positions.iter().map(|p| p.map(|c| c as f32)).collect();
    let flat_floats: Vec<f32> = floats.iter().flatten().copied().collect();
    let indices: Vec<u32> = triangles.iter().flatten().copied().collect();
    // with a normal after each position, but for the last
    let mut wide: Vec<f64> = positions.iter().flat_map(|p| [p[0], p[1], p[2], 0.0, 0.0, 1.0]).collect();
    wide.truncate(wide.len() - 3);
    let soup: Vec<[f64; 3]> = indices.iter().map(|&i| positions[i as usize]).collect();
    let inputs = [
        MeshInput::new(&positions, &triangles),
        MeshInput::new(&flat, &indices),
        MeshInput::new(&floats, &triangles),
        MeshInput::new(&flat_floats, &indices),
        MeshInput::new(&wide, &triangles).stride(6),
        MeshInput::soup(&soup),
    ];
    let context = context();
    for input in inputs {
        let other = Model::new(&context, &input).unwrap();
        assert_eq!(other.triangles().unwrap().len(), triangles.len(), "{input:?}");
        let corners = |model: &Model| -> Vec<[f64; 3]> {
            let at = model.positions().unwrap();
            model.triangles().unwrap().iter().flatten().map(|&i| at[i as usize]).collect()
        };
        let furthest = corners(&other).iter().zip(corners(&model)).map(|(a, b)| distance(*a, b)).fold(0.0, f64::max);
        assert!(furthest < 1e-5, "{furthest} in {input:?}");
    }
}

#[test]
fn a_model_tells_where_its_elements_came_from() {
    let model = model();
    let report = model.report().unwrap();
    let sources = model.face_sources().unwrap();
    assert_eq!(sources.len(), report.faces as usize);
    assert!(sources.iter().all(|&face| face < report.input_faces));
    let map = model.vertex_map().unwrap();
    assert_eq!(map.len(), report.input_vertices as usize);
    let dropped = map.iter().filter(|v| v.is_none()).count();
    assert_eq!(dropped, report.unreferenced_vertices as usize);
    assert!(map.iter().flatten().all(|&vertex| vertex < report.vertices));

    // One vertex that no face uses.
    let input = [[0.0f64, 0.0, 0.0], [30.0, 0.0, 0.0], [0.0, 30.0, 0.0], [5.0, 5.0, 5.0]];
    let small = Model::new(&context(), &MeshInput::new(&input, &[[0u32, 1, 2]])).unwrap();
    assert_eq!(small.vertex_map().unwrap()[3], None);
}

#[test]
fn points_on_the_surface() {
    let model = model();
    let corner = model.positions().unwrap()[100];
    let nearest = model.nearest(corner).unwrap();
    assert!(nearest.distance < 1e-9 && distance(nearest.position, corner) < 1e-9);
    assert!((nearest.barycentric.iter().sum::<f64>() - 1.0).abs() < 1e-9);
    let face = model.triangles().unwrap()[nearest.face as usize];
    assert!(face.contains(&nearest.nearest_vertex));

    let above = [corner[0], corner[1], corner[2] + 100.0];
    let hit = model.raycast(above, [0.0, 0.0, -2.0]).unwrap();
    assert!((hit.position[2] - (above[2] - hit.distance)).abs() < 1e-6);
    fails(Status::NOT_FOUND, model.raycast(above, [0.0, 0.0, 1.0]));
}

#[test]
fn a_model_from_bytes_and_with_a_job() {
    let context = context();
    let bytes = std::fs::read(file("arch.ply")).unwrap();
    let mut job = Job::new(&context).unwrap();
    let options = IntakeOptions { unit: Unit::MM, ..Default::default() };
    for model in [
        Model::read(&context, &bytes).unwrap(),
        Model::read_with(&context, &bytes, FileFormat::PLY, &options, Some(&mut job)).unwrap(),
        Model::load_with(&context, file("arch.ply"), &options, Some(&mut job)).unwrap(),
    ] {
        assert_eq!(model.report(), crate::fixture::model().report());
    }
    fails(Status::FILE_FORMAT, Model::read_with(&context, &bytes, FileFormat::OFF, &options, None));
}

#[test]
fn features_that_were_found() {
    let (_, features) = arch();
    let info = features.info().unwrap();
    let (points, groups) = (features.points().unwrap(), features.groups().unwrap());
    assert_eq!((info.points as usize, info.groups as usize), (points.len(), groups.len()));
    assert_eq!(groups.len(), 14);
    assert!(!info.inside_out && info.warnings.is_empty() && info.arch_length > 50.0, "{info:?}");
    assert_eq!((groups[0].previous, groups[0].next), (None, Some(groups[1].id)));
    assert_eq!(groups[13].next, None);
    assert!((distance(features.occlusal().unwrap(), [0.0; 3]) - 1.0).abs() < 1e-9);
    assert!(features.arch().unwrap().len() > 2);
    assert!(points.iter().all(|p| !p.by_hand && p.convexity > 0.0));
}

#[test]
fn features_by_hand() {
    let (model, found) = arch();
    let mut features = Features::new(&model).unwrap();
    let points = found.points().unwrap();
    let first = features.add_point(points[0].position, None).unwrap();
    let second = features.add_point(points[1].position, Some(first.group)).unwrap();
    assert_eq!(first.group, second.group);
    let moved = model.positions().unwrap()[points[points.len() - 1].vertex as usize];
    features.move_point(second.point, moved).unwrap();
    let now = features.set_group(second.point, None).unwrap();
    assert_ne!(now, first.group);
    let there = features.points().unwrap();
    assert_eq!(there.len(), 2);
    assert!(there.iter().all(|p| p.by_hand));
    assert!(distance(there.iter().find(|p| p.id == second.point).unwrap().position, moved) < 1e-6);
    let copy = features.try_clone().unwrap();
    features.remove_point(first.point).unwrap();
    features.remove_group(now).unwrap();
    assert_eq!((features.points().unwrap().len(), copy.points().unwrap().len()), (0, 2));
    features.set_occlusal([0.0, 0.0, 3.0]).unwrap();
    assert_eq!(features.occlusal(), Ok([0.0, 0.0, 1.0]));

    let options = FeatureOptions { max_points: 1, occlusal: Some(found.occlusal().unwrap()), ..Default::default() };
    let one_each = Features::detect_with(&model, &options, None).unwrap();
    assert!(one_each.groups().unwrap().iter().all(|g| g.points == 1));
}
