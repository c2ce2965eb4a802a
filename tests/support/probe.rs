//! The FMU of `tests/probe`, packages of it, and runs of them.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::OnceLock;

use hotfoot::recording::SeriesReader;

use crate::hostile::archive;
use crate::hotfoot;

/// Its model description.
pub const DESCRIPTION: &str = include_str!("../probe/modelDescription.xml");

/// Where its binary lies in it.
pub const BINARY: &str = "binaries/linux64/probe.so";

const NAMESPACES: &str = "xmlns:ssd=\"http://ssp-standard.org/SSP1/SystemStructureDescription\" \
    xmlns:ssc=\"http://ssp-standard.org/SSP1/SystemStructureCommon\" \
    xmlns:ssv=\"http://ssp-standard.org/SSP1/SystemStructureParameterValues\" \
    xmlns:ssm=\"http://ssp-standard.org/SSP1/SystemStructureParameterMapping\"";

/// Its binary.
///
/// # Panics
/// When there is no C compiler.
pub fn binary() -> &'static [u8] {
    static BINARY: OnceLock<Vec<u8>> = OnceLock::new();
    BINARY.get_or_init(|| {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let library = folder.path().join("probe.so");
        let source = crate::root().join("tests/probe/probe.c");
        let mut compiler = Command::new("cc");
        compiler.args(["-shared", "-fPIC", "-w", "-o"]).arg(&library).arg(&source);
        assert!(compiler.status().expect("a C compiler named cc").success(), "it compiles");
        std::fs::read(&library).expect("it was just built")
    })
}

/// Writes the FMU `name` into `folder`, with further files.
///
/// # Panics
/// When it cannot be written.
pub fn fmu(folder: &Path, name: &str, files: &[(&str, &[u8])]) -> PathBuf {
    let file = folder.join(name);
    let own: [(&str, &[u8]); 2] =
        [("modelDescription.xml", DESCRIPTION.as_bytes()), (BINARY, binary())];
    archive(&file, &[&own, files].concat());
    file
}

/// A package of the probe, and runs of it.
pub struct Package {
    folder: tempfile::TempDir,
}

impl Package {
    /// The package whose outermost system has this content, with further files.
    ///
    /// # Panics
    /// When it cannot be written.
    pub fn new(system: &str, files: &[(&str, &[u8])]) -> Self {
        let text = format!(
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n\
             <ssd:SystemStructureDescription {NAMESPACES} name=\"s\" version=\"1.0\">\n\
             <ssd:System name=\"root\">{system}</ssd:System>\n\
             <ssd:DefaultExperiment startTime=\"0\" stopTime=\"0.1\"/>\n\
             </ssd:SystemStructureDescription>\n"
        );
        let folder = tempfile::tempdir().expect("a temporary folder");
        let probe =
            std::fs::read(fmu(folder.path(), "probe.fmu", &[])).expect("it was just written");
        let own: [(&str, &[u8]); 2] =
            [("SystemStructure.ssd", text.as_bytes()), ("resources/my probe.fmu", &probe)];
        archive(&folder.path().join("s.ssp"), &[&own, files].concat());
        Self { folder }
    }

    /// Runs it, recording every step of 0.01 s, unless further arguments say otherwise.
    pub fn run(&self, arguments: &[&str]) -> Output {
        let mut all = vec!["run", "s.ssp", "--quiet", "--results", "r", "--overwrite"];
        for option in ["--step", "--interval"] {
            if !arguments.contains(&option) {
                all.extend([option, "0.01"]);
            }
        }
        hotfoot(self.folder.path(), &[&all, arguments].concat())
    }

    /// Runs it, which must succeed, and gives what it says.
    ///
    /// # Panics
    /// When it does not.
    pub fn run_well(&self, arguments: &[&str]) -> String {
        let output = self.run(arguments);
        let error = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{error}");
        String::from_utf8_lossy(&output.stdout).into_owned()
    }

    /// Runs it, which must fail, and gives the message.
    ///
    /// # Panics
    /// When it does not.
    pub fn refusal(&self) -> String {
        let output = self.run(&[]);
        assert!(!output.status.success(), "{}", String::from_utf8_lossy(&output.stdout));
        String::from_utf8_lossy(&output.stderr).into_owned()
    }

    /// Folder of the results of its run.
    pub fn results(&self) -> PathBuf {
        self.folder.path().join("r")
    }

    /// What was recorded of an output of a component.
    ///
    /// # Panics
    /// When nothing was.
    pub fn recorded(&self, component: &str, output: &str) -> Vec<f64> {
        let series = self.folder.path().join("r/series");
        let table = SeriesReader::open(&series, component).expect("the run has recorded it");
        table.read(output, &[]).expect("the output has a column")
    }
}

/// The element of a component that is a probe, with start values for Reals and the Integer `mode`.
pub fn component(name: &str, values: &[(&str, f64)]) -> String {
    let connector = |(name, kind)| {
        format!("<ssd:Connector name=\"{name}\" kind=\"{kind}\"><ssc:Real/></ssd:Connector>")
    };
    let connectors = [("u", "input"), ("y", "output"), ("k", "parameter")].map(connector).concat();
    format!(
        "<ssd:Component name=\"{name}\" source=\"resources/my%20probe.fmu\">\
         <ssd:Connectors>{connectors}</ssd:Connectors>{}</ssd:Component>",
        bindings(values)
    )
}

/// The element of start values.
pub fn bindings(values: &[(&str, f64)]) -> String {
    let set = parameter_set(values);
    format!(
        "<ssd:ParameterBindings><ssd:ParameterBinding><ssd:ParameterValues>{set}</ssd:ParameterValues>\
         </ssd:ParameterBinding></ssd:ParameterBindings>"
    )
}

/// A parameter set, as it stands in a file of its own too.
pub fn parameter_set(values: &[(&str, f64)]) -> String {
    let value = |(name, value): &(&str, f64)| {
        let kind = if name.ends_with("mode") { "Integer" } else { "Real" };
        format!("<ssv:Parameter name=\"{name}\"><ssv:{kind} value=\"{value}\"/></ssv:Parameter>")
    };
    let parameters: String = values.iter().map(value).collect();
    format!(
        "<ssv:ParameterSet {NAMESPACES} version=\"1.0\" name=\"p\"><ssv:Parameters>{parameters}\
         </ssv:Parameters></ssv:ParameterSet>"
    )
}

/// The element of connections, each from and to `element.connector` or a connector of the system.
pub fn connections(connections: &[(&str, &str, &str)]) -> String {
    let end = |which: &str, name: &str| match name.split_once('.') {
        Some((element, connector)) => {
            format!("{which}Element=\"{element}\" {which}Connector=\"{connector}\"")
        }
        None => format!("{which}Connector=\"{name}\""),
    };
    let connection = |(from, to, content): &(&str, &str, &str)| {
        let (from, to) = (end("start", from), end("end", to));
        format!("<ssd:Connection {from} {to}>{content}</ssd:Connection>")
    };
    let all: String = connections.iter().map(connection).collect();
    format!("<ssd:Connections>{all}</ssd:Connections>")
}
