use railheat::energy::model::Energy;
use railheat::energy::parameters::*;
use railheat::energy::weather::*;
use railheat::energy::wheels::WheelHeat;
use railheat::energy::bending::Beam;
use railheat::section::RailFile;
use railheat::wheels::Wheel;
use railheat::creep_force::Contact;
#[test]
fn disc() {
    let night = Weather::still(300.0);
    for rail in ["AS60", "60E1", "136RE"] {
        let mut fine: Option<Vec<f64>> = None;
        for size in [0.0015, 0.002, 0.0025, 0.0027, 0.003, 0.0033, 0.0035, 0.004, 0.005, 0.006] {
            let t = std::time::Instant::now();
            let outline = RailFile::open(rail).unwrap().outline();
            let base = Parameters::new(outline, Line { begin: 0.0, element_length: 0.1, elements: 2 });
            let p = Parameters {
                cell_size: size,
                wheel: WheelHeat { contact_quality: 0.0, ..base.wheel },
                beam: Beam { loss_factor: 0.0, ..base.beam },
                exchange: Exchange { convection: 15.0, emissivity: 0.0, absorptivity: 0.0, filter: 0.0, cold_sky: false, pad: 0.0 },
                train: TrainWeather { shade: None, ..base.train },
                start: Start::Uniform(300.0),
                ..base
            };
            let mut m = Energy::new(p, &[1], &night, 0.0).unwrap();
            let w = vec![Wheel { position: 0.05, friction_power: 12.5, contact: Contact { normal_force: 109_500.0, a: 0.0063, b: 0.0063 }, ..Wheel::default() }];
            for s in 0..156 { m.step(&w, &night, s as f64, 1.0); }
            let mut feet = vec![1e3 * m.excess(0, 1)];
            for (from, to) in [(156.0, 300.0), (300.0, 600.0), (600.0, 1500.0), (1500.0, 3600.0)] {
                m.step(&[Wheel::default()], &night, from, to - from);
                feet.push(1e3 * m.excess(0, 1));
            }
            let f = fine.get_or_insert(feet.clone());
            let e: Vec<f64> = feet.iter().zip(f.iter()).map(|(a, b)| a - b).collect();
            println!("{rail} {size}: {} modes, even {} | {feet:.3?} errors {e:.4?} {:.1} s", m.modes().count, m.modes().even, t.elapsed().as_secs_f64());
        }
    }
}
