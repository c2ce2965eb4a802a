//! An FMU for the tests: a rail of 100 m under two vehicles.

use std::fs;
use std::sync::{Arc, Mutex};

use fmu::Instance;
use railheat::RailHeat;

/// The columns of a weather file with the sun.
pub const WEATHER: &str =
    "time_s,air_degC,wind_m_s,direct_W_m2,diffuse_W_m2,sun_elevation_deg,sun_azimuth_deg";

const FILE: &str = "wheelsets_per_vehicle = [2, 1]\ndepths_mm = [20.0, 60.0]\n\
                    [[probe]]\nchainage_m = 30.05\n";

/// An FMU with its messages; files in a folder of its own.
pub struct Bench {
    pub instance: Instance<RailHeat>,
    pub messages: Arc<Mutex<Vec<String>>>,
    pub folder: tempfile::TempDir,
}

impl Bench {
    pub fn new() -> Self {
        let folder = tempfile::tempdir().unwrap();
        fs::write(folder.path().join("railheat.toml"), FILE).unwrap();
        let messages = Arc::new(Mutex::new(Vec::new()));
        let sink = messages.clone();
        let keep = Box::new(move |_, message: &str| sink.lock().unwrap().push(message.to_owned()));
        let mut instance = Instance::new(folder.path(), "left rail", keep).unwrap();
        instance.setup_experiment(0.0, None).unwrap();
        let mut bench = Self { instance, messages, folder };
        bench.set("track.length", 100.0);
        bench
    }

    /// With the paper's model, under its sun.
    pub fn of_paper() -> Self {
        let mut bench = Self::new();
        bench.set_texts(&[("model", "paper")]);
        bench.set("solar.irradiance", 1366.0);
        bench.set("solar.filter", 0.5);
        bench
    }

    pub fn reference(&self, name: &str) -> u32 {
        let variables = self.instance.declaration().variables();
        let found = variables.iter().find(|variable| variable.name == name);
        found.unwrap_or_else(|| panic!("no variable {name}")).reference
    }

    pub fn set(&mut self, name: &str, value: f64) {
        self.try_set(name, value).unwrap();
    }

    pub fn try_set(&mut self, name: &str, value: f64) -> Result<(), String> {
        let reference = self.reference(name);
        self.instance.set_real(&[reference], [value]).map_err(|error| chain(&error))
    }

    pub fn set_texts(&mut self, texts: &[(&str, &str)]) {
        for (name, text) in texts {
            let reference = self.reference(name);
            self.instance.set_string(&[reference], [*text]).unwrap();
        }
    }

    pub fn get(&mut self, name: &str) -> f64 {
        let reference = self.reference(name);
        self.instance.get_real(&[reference]).unwrap().next().unwrap()
    }

    pub fn start(&mut self) -> Result<(), String> {
        self.instance.enter_initialization_mode().map_err(|error| error.to_string())?;
        self.instance.exit_initialization_mode().map_err(|error| chain(&error))
    }

    /// One step in which all wheels end at these chainages.
    pub fn step(&mut self, start: f64, length: f64, head: f64) -> Result<(), String> {
        for (wheel, offset) in [
            ("vehicle[1].wheelset[1]", 0.0),
            ("vehicle[1].wheelset[2]", 1.83),
            ("vehicle[2].wheelset[1]", 20.0),
        ] {
            for (signal, value) in [
                ("position", head - offset),
                ("speed", 16.67),
                ("creepage.longitudinal", 0.003),
                ("force.normal", 109_500.0),
                ("contact.a", 0.0063),
                ("contact.b", 0.0063),
            ] {
                self.set(&format!("{wheel}.{signal}"), value);
            }
        }
        self.instance.do_step(start, length).map_err(|error| chain(&error))
    }

    /// Steps of 10 ms from one step to another, with the first wheel at 28 m at the start.
    pub fn steps(&mut self, from: u32, to: u32) {
        for step in from..to {
            let start = 0.01 * f64::from(step);
            self.step(start, 0.01, 28.003 + 16.67 * (start + 0.01)).unwrap();
        }
    }
}

/// An error with its causes.
pub fn chain(error: &dyn std::error::Error) -> String {
    match error.source() {
        Some(source) => format!("{error}: {}", chain(source)),
        None => error.to_string(),
    }
}
