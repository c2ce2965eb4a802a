//! The closed forms of `docs/reference/conduction.md` and the values that it gives for them.

use std::f64::consts::PI;

use railheat::contact::Material;

/// Height of that page's slab, m.
pub const SLAB: f64 = 0.172;

/// Error function's complement and its integral (V1), by the series for small and the continued
/// fraction for large arguments; that page's table tests them.
fn erfc(x: f64) -> f64 {
    if x < 2.5 {
        let term = |(sum, power): (f64, f64), n: u32| {
            let n = f64::from(n);
            let next = -power * x * x / n;
            (sum + next / (2.0 * n + 1.0), next)
        };
        let (sum, _) = (1..120).fold((x, x), term);
        return 1.0 - 2.0 / PI.sqrt() * sum;
    }
    let fraction = (1..=60).rev().fold(0.0, |below, k| 0.5 * f64::from(k) / (x + below));
    (-x * x).exp() / (PI.sqrt() * (x + fraction))
}

fn ierfc(x: f64) -> f64 {
    (-x * x).exp() / PI.sqrt() - x * erfc(x)
}

/// V2: half-space under a constant flux.
pub fn half_space_under_flux(flux: f64, depth: f64, time: f64) -> f64 {
    let reach = (Material::PAPER.diffusivity() * time).sqrt();
    2.0 * flux * reach / Material::PAPER.conductivity * ierfc(depth / (2.0 * reach))
}

/// V1 (eight digits given).
#[test]
fn analytic_v1_error_functions() {
    for (x, wanted, integral) in [
        (0.0, 1.0, 0.56418958),
        (0.1, 0.88753708, 0.46982209),
        (0.5, 0.47950012, 0.19964123),
        (1.0, 0.15729921, 0.050254542),
        (2.0, 0.004677735, 0.00097802271),
        (3.0, 2.2090497e-5, 3.355035e-6),
    ] {
        assert!((erfc(x) - wanted).abs() < 1e-8, "erfc({x}) = {}", erfc(x));
        assert!((ierfc(x) - integral).abs() < 1e-8, "ierfc({x}) = {}", ierfc(x));
    }
}

/// Slab of the half thickness `half` that convects on both sides: share of the initial excess at the distance x from
/// its middle; the roots of ζ tan ζ = Bi by bisection.
pub fn cooling_slab(half: f64, x: f64, time: f64, convection: f64) -> f64 {
    let biot = convection * half / Material::PAPER.conductivity;
    let fourier = Material::PAPER.diffusivity() * time / (half * half);
    let term = |n: u32| {
        let (mut low, mut high) = (f64::from(n) * PI, (f64::from(n) + 0.5) * PI);
        for _ in 0..80 {
            let middle = 0.5 * (low + high);
            let beyond = middle * middle.sin() > biot * middle.cos();
            // Below the root in even branches, above it in odd ones, where sine and cosine are negative.
            if beyond == n.is_multiple_of(2) { high = middle } else { low = middle }
        }
        let root = 0.5 * (low + high);
        4.0 * root.sin() / (2.0 * root + (2.0 * root).sin())
            * (root * x / half).cos()
            * (-root * root * fourier).exp()
    };
    (0..30).map(term).sum()
}

/// V8: slab with insulated ends after an impulse on top, at a depth: T over the rise when mixed.
pub fn impulse(depth: f64, time: f64) -> f64 {
    if time <= 0.0 {
        return 0.0;
    }
    let decay = PI * PI * Material::PAPER.diffusivity() * time / (SLAB * SLAB);
    let term = |n: f64| (n * PI * depth / SLAB).cos() * (-n * n * decay).exp();
    1.0 + 2.0 * (1..200).map(|n| term(f64::from(n))).sum::<f64>()
}

/// V5, slab with insulated foot under a constant flux of 1000 W/m², at a depth.
pub fn slab_under_flux(depth: f64, time: f64) -> f64 {
    let steel = Material::PAPER;
    let decay = PI * PI * steel.diffusivity() * time / (SLAB * SLAB);
    let x = SLAB - depth;
    let term = |n: i32| {
        let k = f64::from(n);
        let sign = if n % 2 == 0 { 1.0 } else { -1.0 };
        sign / (k * k) * (-k * k * decay).exp() * (k * PI * x / SLAB).cos()
    };
    let series = 2.0 / (PI * PI) * (1..400).map(term).sum::<f64>();
    let parabola = (3.0 * x * x - SLAB * SLAB) / (6.0 * SLAB * SLAB);
    1000.0 * time / (steel.heat_capacity() * SLAB)
        + 1000.0 * SLAB / steel.conductivity * (parabola - series)
}

/// The closed forms of this file give that page's values (eight digits there).
#[test]
fn analytic_closed_forms_are_those_of_the_reference() {
    for (time, top, middle, foot) in [
        (60.0, 3.7229652, 0.989_884_45, 1.3938e-4),
        (156.0, 2.3088852, 1.3872008, 0.070157935),
        (600.0, 1.2075623, 1.0946662, 0.79289969),
    ] {
        assert!((impulse(0.0, time) - top).abs() < 1e-7);
        assert!((impulse(0.06, time) - middle).abs() < 1e-7);
        assert!((impulse(SLAB, time) - foot).abs() < 1e-8);
    }
    for (time, top, middle, foot) in [
        (60.0, 0.7352916, 0.040117842, 1.1209e-6),
        (200.0, 1.3424528, 0.34324554, 0.011334995),
        (1800.0, 4.3948867, 3.1570414, 2.2468281),
    ] {
        // The series for the top falls as 1/n² at early times only.
        assert!((slab_under_flux(0.0, time) - top).abs() < 1e-6);
        assert!((slab_under_flux(0.06, time) - middle).abs() < 1e-7);
        assert!((slab_under_flux(SLAB, time) - foot).abs() < 1e-7);
    }
}
