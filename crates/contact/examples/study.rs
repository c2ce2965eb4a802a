use contact::kalker::CreepCoefficients;
use contact::rolling::{Cells, RollingContact, RollingForces, RollingMotion};
use std::f64::consts::PI;
use std::time::Instant;

fn main() {
    let arg: Vec<String> = std::env::args().collect();
    match arg[1].as_str() {
        "kalker" => {
            for r in [1.0, 0.1, 10.0] {
                let k = CreepCoefficients::new(r, 0.28);
                for n in [12, 18, 24, 36] {
                    let cells = cells(r, n);
                    let t = Instant::now();
                    let mut c = RollingContact::new(r, 0.28, cells);
                    let e = 1e-5;
                    let x = c.solve(&RollingMotion { longitudinal: e, ..Default::default() });
                    c.reset();
                    let y = c.solve(&RollingMotion { lateral: e, ..Default::default() });
                    c.reset();
                    let s = c.solve(&RollingMotion { spin: e, ..Default::default() });
                    let u = 2.0 / 3.0 * PI / e;
                    println!(
                        "a/b {r} n {n} {cells:?}: c11 {:.4} ({:.4}) c22 {:.4} ({:.4}) c23 {:.4} {:.4} ({:.4}) c33 {:.4} ({:.4}) it {} {} {} {:?}",
                        x.longitudinal * u,
                        k.c11,
                        y.lateral * u,
                        k.c22,
                        s.lateral * u,
                        y.moment * u,
                        k.c23,
                        s.moment * u,
                        k.c33,
                        x.iterations,
                        y.iterations,
                        s.iterations,
                        t.elapsed()
                    );
                }
            }
        }
        "one" => {
            let v: Vec<f64> = arg[2].split(',').map(|x| x.parse().unwrap()).collect();
            let k = CreepCoefficients::new(v[0], 0.28);
            let mn = 2.0 / 3.0 * PI;
            let m = RollingMotion {
                longitudinal: v[1] * 3.0 * mn / k.c11,
                lateral: v[2] * 3.0 * mn / k.c22,
                spin: v[3] * mn / k.c23,
            };
            for n in arg[3].split(',') {
                let n = n.parse().unwrap();
                let t = Instant::now();
                let f = RollingContact::new(v[0], 0.28, cells(v[0], n)).solve(&m);
                println!("{n} {:?} {:?}", f, t.elapsed());
            }
        }
        "table" => {
            let text = include_str!("../tests/validation/kalker-tables-sample.csv");
            let n: usize = arg[2].parse().unwrap();
            let mut sums = vec![];
            let t = Instant::now();
            for line in text.lines().filter(|l| !l.starts_with('#') && !l.starts_with("aob")) {
                let v: Vec<f64> = line.split(',').map(|x| x.parse().unwrap()).collect();
                let k = CreepCoefficients::new(v[0], 0.28);
                let mn = 2.0 / 3.0 * PI;
                let m = RollingMotion {
                    longitudinal: v[1] * 3.0 * mn / k.c11,
                    lateral: v[2] * 3.0 * mn / k.c22,
                    spin: v[3] * mn / k.c23,
                };
                let f: Vec<RollingForces> = [n, n * 7 / 6]
                    .iter()
                    .map(|&n| RollingContact::new(v[0], 0.28, cells(v[0], n)).solve(&m))
                    .collect();
                let ex = |g: fn(&RollingForces) -> f64| 3.0 * g(&f[1]) - 2.0 * g(&f[0]);
                let (fx, fy) = (ex(|f| f.longitudinal), ex(|f| f.lateral));
                let err = |x: f64, y: f64| (x - v[4]).hypot(y - v[5]);
                let e = [
                    err(f[0].longitudinal, f[0].lateral),
                    err(f[1].longitudinal, f[1].lateral),
                    err(fx, fy),
                ];
                println!(
                    "{line}: {:.4} {:.4} | {:.4} {:.4} | {fx:.4} {fy:.4} err {:.4} {:.4} {:.4} it {} {} res {:.3} flash {:.3} {:.3}",
                    f[0].longitudinal,
                    f[0].lateral,
                    f[1].longitudinal,
                    f[1].lateral,
                    e[0],
                    e[1],
                    e[2],
                    f[0].iterations,
                    f[1].iterations,
                    f[1].resolved,
                    f[0].flash,
                    f[1].flash
                );
                sums.push(e);
            }
            for i in 0..3 {
                let mean: f64 = sums.iter().map(|e| e[i]).sum::<f64>() / sums.len() as f64;
                let max = sums.iter().map(|e| e[i]).fold(0.0, f64::max);
                println!("mean {mean:.4} max {max:.4}");
            }
            println!("{:?}", t.elapsed());
        }
        _ => {}
    }
}

fn cells(a_over_b: f64, number: usize) -> Cells {
    let stretch = a_over_b.powf(0.25).clamp(0.7, 1.5);
    let count = |factor: f64| (number as f64 * factor / 2.0).round() as usize * 2;
    Cells { along: count(stretch), across: count(1.0 / stretch) }
}
