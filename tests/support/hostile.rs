//! A vehicle FMU in C that misbehaves on request, built for a test.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Command;

use zip::write::SimpleFileOptions;

/// The GUID that the binary agrees to.
pub const GUID: &str = "{a hostile vehicle}";

/// What the FMU's model description says.
pub struct Claims {
    /// `guid`.
    pub guid: &'static str,
    /// Attributes of the element `CoSimulation`.
    pub flags: &'static str,
    /// An element before it.
    pub model_exchange: &'static str,
}

impl Default for Claims {
    /// What fits the binary.
    fn default() -> Self {
        Self {
            guid: GUID,
            flags: "canHandleVariableCommunicationStepSize=\"true\" canGetAndSetFMUstate=\"true\"",
            model_exchange: "",
        }
    }
}

/// Builds `hostile.fmu` in `folder`: a vehicle that behaves as the word of `hostile.c` says.
///
/// # Panics
/// When there is no C compiler, or the folder is not writable.
pub fn hostile_vehicle(folder: &Path, behaviour: &str, claims: &Claims) -> PathBuf {
    let binary = folder.join("hostile.so");
    let source = crate::root().join("tests/hostile/hostile.c");
    let behaviour = format!("-DBEHAVIOUR={behaviour}");
    let arguments = ["-shared", "-fPIC", "-fvisibility=hidden", "-w", &behaviour, "-o"];
    let status = Command::new("cc").args(arguments).arg(&binary).arg(&source).status();
    assert!(status.expect("a C compiler named cc").success(), "{} compiles", source.display());
    let library = std::fs::read(&binary).expect("it was just built");
    let entries: [(&str, &[u8]); 2] = [
        ("modelDescription.xml", &description(claims).into_bytes()),
        ("binaries/linux64/hostile.so", &library),
    ];
    let fmu = folder.join("hostile.fmu");
    archive(&fmu, &entries);
    fmu
}

/// Writes an archive with these entries.
///
/// # Panics
/// When the file cannot be written.
pub fn archive(file: &Path, entries: &[(&str, &[u8])]) {
    let mut zip = zip::ZipWriter::new(std::fs::File::create(file).expect("writable"));
    for (name, content) in entries {
        zip.start_file(*name, SimpleFileOptions::default()).expect("writable");
        zip.write_all(content).expect("writable");
    }
    zip.finish().expect("writable");
}

fn description(claims: &Claims) -> String {
    let Claims { guid, flags, model_exchange } = claims;
    let variable = |(reference, name): (usize, &str)| {
        let (causality, start) = match reference {
            0 | 1 => ("causality=\"parameter\" variability=\"fixed\"", "start=\"0\""),
            2..=4 => ("causality=\"input\"", "start=\"0\""),
            _ => ("causality=\"output\"", ""),
        };
        format!(
            "<ScalarVariable name=\"{name}\" valueReference=\"{reference}\" {causality}>\
             <Real {start}/></ScalarVariable>\n"
        )
    };
    let names = [
        "initial.position",
        "initial.velocity",
        "coupler.front.force",
        "coupler.rear.force",
        "sync.force",
        "position",
        "velocity",
    ];
    let variables: String = names.into_iter().enumerate().map(variable).collect();
    format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
         <fmiModelDescription fmiVersion=\"2.0\" modelName=\"hostile\" guid=\"{guid}\">\n\
         {model_exchange}<CoSimulation modelIdentifier=\"hostile\" {flags}/>\n\
         <LogCategories><Category name=\"logStatusError\"/></LogCategories>\n\
         <DefaultExperiment stopTime=\"1\" tolerance=\"1e-6\" stepSize=\"0.001\"/>\n\
         <ModelVariables>\n{variables}\
         <ScalarVariable name=\"count\" valueReference=\"0\" causality=\"parameter\" \
         variability=\"tunable\"><Integer start=\"1\"/></ScalarVariable>\n\
         <ScalarVariable name=\"worn\" valueReference=\"0\" causality=\"parameter\" \
         variability=\"fixed\"><Boolean start=\"false\"/></ScalarVariable>\n\
         <ScalarVariable name=\"file\" valueReference=\"0\" causality=\"parameter\" \
         variability=\"fixed\"><String start=\"\"/></ScalarVariable>\n\
         </ModelVariables>\n<ModelStructure>\
         <Outputs><Unknown index=\"6\" dependencies=\"\"/><Unknown index=\"7\" dependencies=\"\"/>\
         </Outputs><InitialUnknowns><Unknown index=\"6\"/><Unknown index=\"7\"/>\
         </InitialUnknowns></ModelStructure>\n</fmiModelDescription>\n"
    )
}
