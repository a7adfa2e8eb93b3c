use super::sample::{animation, drawing};
use super::vector::{cross, dot, norm, sub};
use super::*;

/// Parts that joints of this kind add.
fn of_kind(drawing: &Drawing, kind: &str) -> Vec<Solid> {
    let with = |kinds: &[&str]| {
        let mut some = drawing.clone();
        some.joints.retain(|joint| kinds.contains(&joint.kind.as_str()));
        solids(&some, &animation(drawing.bodies.len()))
    };
    with(&[kind]).split_off(with(&[]).len())
}

#[test]
fn every_body_and_every_joint_is_seen() {
    for space in [SpaceKind::Planar, SpaceKind::Spatial] {
        let drawing = drawing(space);
        let parts = solids(&drawing, &animation(drawing.bodies.len()));
        for body in 1..drawing.bodies.len() {
            assert!(parts.iter().any(|part| part.body == body && part.paint == Paint::Body), "{space:?} {body}");
        }
        for joint in drawing.joints.iter().filter(|joint| joint.kind != "weld") {
            assert!(!of_kind(&drawing, &joint.kind).is_empty(), "{space:?} {}", joint.kind);
        }
        assert!(of_kind(&drawing, "revolute").iter().any(|part| part.paint == Paint::Drive));
        assert!(of_kind(&drawing, "revolute").iter().any(|part| part.body == 0 && part.paint == Paint::Ground));
    }
}

#[test]
fn outlines_turn_left() {
    let drawing = drawing(SpaceKind::Planar);
    let parts = solids(&drawing, &animation(drawing.bodies.len()));
    let plates: Vec<_> = parts
        .iter()
        .filter_map(|part| match &part.shape {
            Shape::Plate { points, normal, .. } if points.len() > 2 => Some((points, normal)),
            _ => None,
        })
        .collect();
    assert!(plates.len() >= 10);
    for (points, normal) in plates {
        for k in 0..points.len() {
            let [a, b, c] = [0, 1, 2].map(|step| points[(k + step) % points.len()]);
            assert!(dot(cross(sub(b, a), sub(c, b)), *normal) > 0.0, "{points:?}");
        }
    }
}

#[test]
fn links_that_meet_lie_in_different_layers() {
    let drawing = drawing(SpaceKind::Planar);
    let parts = solids(&drawing, &animation(drawing.bodies.len()));
    let height = |body: usize| {
        parts.iter().find_map(|part| match &part.shape {
            Shape::Plate { points, .. } if part.body == body => Some(points[0][2]),
            _ => None,
        })
    };
    let pinned = drawing.joints.iter().filter(|joint| joint.kind == "revolute" && joint.first.0 != 0);
    for joint in pinned {
        assert!(height(joint.first.0) != height(joint.second.0), "{}", joint.name);
    }
    let slide = drawing.joints.iter().find(|joint| joint.kind == "prismatic").unwrap();
    assert_eq!(height(slide.first.0), height(slide.second.0));
}

#[test]
fn a_cylinder_keeps_its_rod_in_its_barrel() {
    let mut drawing = drawing(SpaceKind::Spatial);
    drawing.bodies.truncate(3);
    drawing.joints.truncate(2);
    drawing.joints[1].axis = [0.0, 0.6, 0.8];
    let mut animation = animation(3);
    // Body 2 slides from 0.4 to 0.65 m along the axis of body 1, which lies askew.
    for (k, frame) in animation.frames.iter_mut().enumerate() {
        let (first, out) = (frame[1], 0.4 + 0.25 * k as f64 / (sample::FRAMES - 1) as f64);
        let at = vector::along(drawing.joints[1].first.1, out, [0.0, 0.6, 0.8]);
        frame[2] = crate::Pose { position: vector::place(&first, at), quaternion: first.quaternion };
    }
    let parts = solids(&drawing, &animation);
    let rods = |body: usize| {
        let of = parts.iter().filter(move |part| part.body == body);
        of.filter_map(|part| match part.shape {
            Shape::Rod { from, to, radius, round: false } => Some((from, to, radius)),
            _ => None,
        })
    };
    let barrel = rods(1).max_by(|a, b| norm(sub(a.0, a.1)).total_cmp(&norm(sub(b.0, b.1)))).unwrap();
    let rod = rods(2).max_by(|a, b| norm(sub(a.0, a.1)).total_cmp(&norm(sub(b.0, b.1)))).unwrap();
    assert!(rod.2 < barrel.2);
    for frame in &animation.frames {
        let tip = vector::place(&frame[2], rod.1);
        let [foot, mouth] = [barrel.0, barrel.1].map(|at| vector::place(&frame[1], at));
        let along = dot(sub(tip, foot), sub(mouth, foot)) / dot(sub(mouth, foot), sub(mouth, foot));
        assert!((-0.05..1.0).contains(&along), "{along}");
    }
}

#[test]
fn nothing_is_drawn_of_nothing() {
    let drawing = drawing(SpaceKind::Spatial);
    assert!(solids(&drawing, &Animation::default()).is_empty());
    let mut lost = animation(drawing.bodies.len());
    lost.frames.iter_mut().flatten().for_each(|pose| pose.position = [f64::NAN; 3]);
    assert!(solids(&drawing, &lost).is_empty());
}

#[test]
fn a_load_is_the_block_of_its_inertia() {
    let mut drawing = drawing(SpaceKind::Spatial);
    let block_of = |drawing: &Drawing| {
        let parts = solids(drawing, &animation(drawing.bodies.len()));
        parts.into_iter().find_map(|part| match part.shape {
            Shape::Block { center, size, .. } if part.body == 10 => Some((center, size)),
            _ => None,
        })
    };
    let load = &mut drawing.bodies[10];
    (load.lines, load.center, load.block) = (Vec::new(), Some([0.1, 0.2, 0.3]), Some([0.5, 0.4, 0.25]));
    assert_eq!(block_of(&drawing), Some(([0.1, 0.2, 0.3], [0.5, 0.4, 0.25])));
    let again = crate::DrawnJoint { first: drawing.joints[0].first, ..drawing.joints[9].clone() };
    drawing.joints.push(again);
    assert_eq!(block_of(&drawing), None, "two joints: a link, which its joints show");
}

/// A real form in place of what is drawn for want of one.
fn with_surface(space: SpaceKind) -> Drawing {
    let mut drawing = drawing(space);
    drawing.bodies[2].surface = Some(super::sample::tetrahedron());
    drawing
}

#[test]
fn a_real_form_takes_the_place_of_a_drawn_one() {
    for space in [SpaceKind::Planar, SpaceKind::Spatial] {
        let drawing = with_surface(space);
        let parts = solids(&drawing, &animation(drawing.bodies.len()));
        let own: Vec<_> = parts.iter().filter(|part| part.body == 2 && part.paint == Paint::Body).collect();
        assert!(own.iter().any(|part| matches!(part.shape, Shape::Surface(_))), "{space:?}");
        assert!(!own.iter().any(|part| matches!(part.shape, Shape::Plate { .. })), "{space:?}");
    }
}

#[test]
fn drawn_links_lie_beside_real_ones() {
    let drawing = with_surface(SpaceKind::Planar);
    let animation = animation(drawing.bodies.len());
    let scale = Scale::of(&drawing, &animation).unwrap();
    let plan = Plan { drawing: &drawing, animation: &animation, scale, layers: Layers::of(&drawing) };
    assert_eq!((plan.layers.layer(2), bodies::height(&plan, 2)), (0, 0.0));
    let thick = plan.scale.thickest;
    assert!(thick > bodies::THICK * plan.scale.bar);
    for body in (1..drawing.bodies.len()).filter(|body| plan.layers.layer(*body) != 0) {
        let [low, high] = bodies::extent(&plan, body);
        assert!(low >= thick || high <= -thick, "{body}: {low} {high} {thick}");
    }
}
