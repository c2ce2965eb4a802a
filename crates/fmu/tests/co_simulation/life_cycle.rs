//! Making, initialising, resetting and ending instances.

use std::ffi::{CStr, CString};
use std::ptr;

use fmu::Status;
use fmu::abi::CallbackFunctions;

use crate::calls::in_state;
use crate::fmi2::*;
use crate::tool::{Fmu, Order};

/// The reason why an order was not met.
fn refusal(order: Order) -> String {
    let messages = Fmu::order(order).err().expect("it must be refused");
    assert_eq!(messages.len(), 1, "{messages:?}");
    assert_eq!(messages[0].category, "logStatusError");
    messages[0].text.clone()
}

#[test]
fn version_and_platform_are_those_of_the_standard() {
    // SAFETY: the functions give texts that live for ever.
    let (version, platform) = unsafe {
        let version = CStr::from_ptr(fmi2GetVersion());
        (version, CStr::from_ptr(fmi2GetTypesPlatform()))
    };
    assert_eq!((version, platform), (c"2.0", c"default"));
}

#[test]
fn a_wrong_guid_is_refused_with_the_remedy() {
    let guid = Some("{00000000-0000-0000-0000-000000000000}".to_owned());
    let message = refusal(Order { guid, ..Order::default() });
    let remedy = "this modelDescription.xml is stale or belongs to another FMU";
    assert!(message.contains(remedy), "{message}");
    for blank in ["", "  "] {
        let message = refusal(Order { guid: Some(blank.to_owned()), ..Order::default() });
        assert!(message.contains(remedy), "{message}");
    }
    let message = refusal(Order { guid: None, ..Order::default() });
    assert!(message.contains("fmuGUID"), "{message}");
}

#[test]
fn an_instance_without_name_is_refused() {
    for name in [None, Some(""), Some("  ")] {
        let message = refusal(Order { name, ..Order::default() });
        assert!(message.contains("name") || message.contains("Name"), "{message}");
    }
}

#[test]
fn model_exchange_is_refused() {
    let message = refusal(Order { fmu_type: 0, ..Order::default() });
    assert!(message.contains("co-simulation"), "{message}");
}

#[test]
fn a_resource_location_that_is_no_file_is_refused() {
    let location = Some("https://example.org".to_owned());
    let message = refusal(Order { location, ..Order::default() });
    assert!(message.contains("is not a file URI"), "{message}");
}

#[test]
fn without_callbacks_there_is_no_instance() {
    // SAFETY: the texts are valid, and null stands for the callbacks.
    let component = unsafe {
        let (name, guid) = (c"a spring".as_ptr(), c"{}".as_ptr());
        fmi2Instantiate(name, 1, guid, ptr::null(), ptr::null(), 0, 0)
    };
    assert!(component.is_null());
}

/// A tool may give callbacks without a logger: then nobody is told, and all else is as ever.
#[test]
fn without_a_logger_the_fmu_works_and_is_silent() {
    let callbacks = CallbackFunctions {
        logger: None,
        allocate_memory: None,
        free_memory: None,
        step_finished: None,
        component_environment: ptr::null_mut(),
    };
    let guid = CString::new(Order::default().guid.expect("it has one")).expect("no NUL");
    // SAFETY: the texts and the callbacks are valid; the component is freed once.
    unsafe {
        let name = c"a spring".as_ptr();
        let c = fmi2Instantiate(name, 1, guid.as_ptr(), ptr::null(), &callbacks, 0, 1);
        assert!(!c.is_null());
        assert_eq!(fmi2DoStep(c, 0.0, 1.0, 1), Status::Error);
        assert_eq!(fmi2Reset(c), Status::Ok);
        assert_eq!(fmi2SetupExperiment(c, 1, 1e-6, 0.0, 0, 0.0), Status::Ok);
        assert_eq!(fmi2EnterInitializationMode(c), Status::Ok);
        assert_eq!(fmi2ExitInitializationMode(c), Status::Ok);
        assert_eq!(fmi2DoStep(c, 0.0, 0.1, 1), Status::Ok);
        fmi2FreeInstance(c);
        let wrong = fmi2Instantiate(name, 1, c"{}".as_ptr(), ptr::null(), &callbacks, 0, 1);
        assert!(wrong.is_null());
    }
}

/// The model has defaults for all that its resources say, so that it needs none.
#[test]
fn the_resource_location_may_be_null_or_empty() {
    for location in [None, Some(String::new())] {
        let fmu = Fmu::order(Order { location, ..Order::default() });
        assert!(fmu.is_ok());
    }
}

#[test]
fn resources_shape_the_interface() {
    let folder = tempfile::tempdir().expect("a folder");
    let resources = folder.path().join("with space");
    std::fs::create_dir(&resources).expect("a folder");
    std::fs::write(resources.join("points.txt"), "3").expect("a file");
    let guid = crate::tool::native_in(&resources).guid().to_string();
    assert_ne!(Some(&guid), Order::default().guid.as_ref());

    let location = resources.to_str().expect("UTF-8").replace(' ', "%20");
    for prefix in ["file://", "file:", "file://localhost"] {
        let fmu = Fmu::order(Order {
            guid: Some(guid.clone()),
            location: Some(format!("{prefix}{location}")),
            ..Order::default()
        });
        let fmu = fmu.unwrap_or_else(|messages| panic!("{prefix}: {messages:?}"));
        fmu.begin();
        let last = fmu.reference("point[1].position") + 2;
        assert_eq!(fmu.get_reals(&[last]), (Status::Ok, vec![0.1]));
    }
}

#[test]
fn a_file_that_shapes_the_interface_wrongly_is_named() {
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::write(folder.path().join("points.txt"), "many").expect("a file");
    let location = Some(format!("file://{}", folder.path().display()));
    let message = refusal(Order { location, ..Order::default() });
    assert!(message.contains("points.txt: `many` is no number"), "{message}");
}

#[test]
fn freeing_nothing_is_ignored() {
    // SAFETY: null is allowed.
    unsafe { fmi2FreeInstance(ptr::null_mut()) };
}

#[test]
fn a_call_without_instance_is_an_error() {
    // SAFETY: null is allowed.
    let status = unsafe { fmi2DoStep(ptr::null_mut(), 0.0, 1.0, 1) };
    assert_eq!(status, Status::Error);
}

#[test]
fn the_experiment_must_be_set_up_and_make_sense() {
    let fmu = Fmu::new();
    assert_eq!(fmu.enter_initialization_mode(), Status::Error);
    assert!(fmu.message().contains("fmi2SetupExperiment must be called before"));
    for (start, stop) in [(f64::NAN, None), (1.0, Some(1.0)), (0.0, Some(f64::INFINITY))] {
        assert_eq!(fmu.reset(), Status::Ok);
        assert_eq!(fmu.setup_experiment(start, stop), Status::Error, "{start} {stop:?}");
        assert!(fmu.message().contains("no finite length greater than zero"));
    }
}

#[test]
fn initial_outputs_follow_the_start_values() {
    let fmu = Fmu::new();
    assert_eq!(fmu.set("initial.position", 0.2), Status::Ok);
    fmu.begin();
    assert_eq!(fmu.get("position"), 0.2);
    assert_eq!(fmu.set("initial.position", 0.3), Status::Ok);
    assert_eq!(fmu.get("position"), 0.3);
    assert_eq!(fmu.set("initial.position", 0.4), Status::Ok);
    assert_eq!(fmu.exit_initialization_mode(), Status::Ok);
    assert_eq!(fmu.get("position"), 0.4);
}

/// A tool that iterates the initialisation sets all inputs in each sweep: only new values make a new
/// model. The spring says each time that it is ready.
#[test]
fn the_model_is_built_again_only_for_new_start_values() {
    let fmu = Fmu::initializing();
    let built = |mass: f64, trouble: &str| {
        fmu.messages();
        assert_eq!(fmu.set("mass", mass), Status::Ok);
        assert_eq!(fmu.set_string("trouble", trouble), Status::Ok);
        fmu.get("position");
        fmu.messages().iter().filter(|message| message.text.contains("ready")).count()
    };
    assert_eq!(built(2.0, ""), 1, "the first");
    assert_eq!(built(2.0, ""), 0, "the same");
    assert_eq!(built(3.0, ""), 1, "another mass");
    assert_eq!(built(3.0, "error"), 1, "another text");
    assert_eq!(built(3.0, "error"), 0, "the same");
    assert_eq!(fmu.exit_initialization_mode(), Status::Ok);
    assert!(fmu.messages().is_empty(), "it is built already");
}

#[test]
fn start_values_that_the_model_refuses_end_in_an_error() {
    for (trouble, sentence) in [
        ("start error", "the initialization failed: the spring is too hot"),
        ("start nan", "the output `velocity` became NaN at 0 s"),
        ("start panic", "fmi2ExitInitializationMode met a programming error: the spring snapped"),
    ] {
        let fmu = Fmu::initializing();
        assert_eq!(fmu.set_string("trouble", trouble), Status::Ok);
        assert_eq!(fmu.exit_initialization_mode(), Status::Error, "{trouble}");
        let messages = fmu.messages();
        assert_eq!(messages.last().expect("a reason").text, sentence);
        assert_eq!(fmu.exit_initialization_mode(), Status::Error);
        assert_eq!(fmu.reset(), Status::Ok);
        fmu.begin();
        assert_eq!(fmu.exit_initialization_mode(), Status::Ok);
    }
}

#[test]
fn a_reset_instance_is_as_new() {
    let fmu = Fmu::initializing();
    assert_eq!(fmu.set("mass", 3.0), Status::Ok);
    assert_eq!(fmu.exit_initialization_mode(), Status::Ok);
    assert_eq!(fmu.do_step(0.0, 0.1), Status::Ok);
    assert_eq!(fmu.reset(), Status::Ok);
    fmu.begin();
    assert_eq!(fmu.exit_initialization_mode(), Status::Ok);
    assert_eq!((fmu.get("mass"), fmu.get("position")), (1.0, 0.1));
    assert_eq!(fmu.do_step(0.0, 0.1), Status::Ok);
    let position = fmu.get("position");
    let new = Fmu::running();
    assert_eq!(new.do_step(0.0, 0.1), Status::Ok);
    assert_eq!(position.to_bits(), new.get("position").to_bits());
}

/// From every state but those in which the standard forbids all calls, which this FMU never is in.
#[test]
fn a_reset_leads_out_of_every_state() {
    for letter in "IMCFTE".chars() {
        let fmu = in_state(letter);
        assert_eq!(fmu.reset(), Status::Ok, "{letter}");
        fmu.begin();
        assert_eq!(fmu.exit_initialization_mode(), Status::Ok, "{letter}");
        assert_eq!((fmu.get("position"), fmu.do_step(0.0, 0.1)), (0.1, Status::Ok), "{letter}");
    }
}

/// FMI 2.0.5 §2.1.5: an instance may be freed without `fmi2Terminate`, whatever its state.
#[test]
fn an_instance_may_be_freed_in_every_state() {
    for letter in "IMCFTE".chars() {
        drop(in_state(letter));
    }
}

#[test]
fn a_terminated_instance_shows_its_last_values() {
    let fmu = Fmu::running();
    assert_eq!(fmu.terminate(), Status::Ok);
    assert_eq!(fmu.get("position"), 0.1);
    assert!(fmu.messages().iter().any(|message| message.text == "the spring rests"));
    assert_eq!(fmu.terminate(), Status::Error);
}

#[test]
fn after_an_error_only_a_reset_or_a_state_leads_on() {
    let fmu = Fmu::running();
    let mut state = fmu.save();
    assert_eq!(fmu.do_step(5.0, 0.1), Status::Error);
    assert_eq!(fmu.do_step(0.0, 0.1), Status::Error);
    assert_eq!(fmu.restore(state), Status::Ok);
    assert_eq!(fmu.do_step(0.0, 0.1), Status::Ok);
    assert_eq!(fmu.free_state(&mut state), Status::Ok);
}
