//! A simulation tool: a thin layer over the C functions.

use std::ffi::{CStr, CString, c_char, c_int, c_void};
use std::path::Path;
use std::ptr;
use std::sync::Mutex;

use fmu::abi::CallbackFunctions;
use fmu::{Declaration, Instance, Kind, Status, Variable};

use crate::fmi2::*;
use crate::spring::Spring;

/// A message that came to the logger.
#[derive(Clone, Debug, PartialEq)]
pub struct Message {
    pub instance: String,
    pub status: c_int,
    pub category: String,
    pub text: String,
}

type Messages = Mutex<Vec<Message>>;

/// Receives the messages of an FMU. A variadic function cannot be written in stable Rust; as all
/// messages have the format "%s", the one argument is as good, since the platforms that this
/// test runs on pass it the same way.
unsafe extern "C" fn logger(
    environment: *mut c_void,
    instance: *const c_char,
    status: c_int,
    category: *const c_char,
    format: *const c_char,
    argument: *const c_char,
) {
    // SAFETY: the FMU gives texts, and the environment is the one of `Callbacks`.
    unsafe {
        let text = |pointer| CStr::from_ptr(pointer).to_str().expect("UTF-8").to_owned();
        let format: String = text(format);
        let argument: String = text(argument);
        let messages = environment.cast::<Messages>().as_ref().expect("untouched");
        messages.lock().expect("nobody panics").push(Message {
            instance: text(instance),
            status,
            category: text(category),
            text: format.replace("%s", &argument),
        });
    }
}

/// The callbacks that the tool hands over.
pub fn callbacks(messages: &Messages) -> CallbackFunctions {
    type Fixed = unsafe extern "C" fn(
        *mut c_void,
        *const c_char,
        c_int,
        *const c_char,
        *const c_char,
        *const c_char,
    );
    type Variadic =
        unsafe extern "C" fn(*mut c_void, *const c_char, c_int, *const c_char, *const c_char, ...);
    CallbackFunctions {
        // SAFETY: see `logger`.
        logger: Some(unsafe { std::mem::transmute::<Fixed, Variadic>(logger) }),
        allocate_memory: None,
        free_memory: None,
        step_finished: None,
        component_environment: ptr::from_ref(messages).cast_mut().cast(),
    }
}

/// What to instantiate; the default succeeds.
pub struct Order {
    pub name: Option<&'static str>,
    pub fmu_type: c_int,
    pub guid: Option<String>,
    pub location: Option<String>,
    pub logging_on: bool,
}

impl Default for Order {
    fn default() -> Self {
        Self {
            name: Some("a spring"),
            fmu_type: 1,
            guid: Some(native().guid().to_string()),
            location: None,
            logging_on: true,
        }
    }
}

/// A spring without the C interface around it.
pub fn native() -> Instance<Spring> {
    native_in(Path::new(""))
}

/// A spring with a resources folder.
pub fn native_in(resources: &Path) -> Instance<Spring> {
    Instance::new(resources, "a spring", Box::new(|_, _| ())).expect("it can be made")
}

/// An FMU that was instantiated.
pub struct Fmu {
    pub component: *mut c_void,
    messages: Box<Messages>,
    declaration: Declaration,
}

// SAFETY: an FMU may be used by any one thread at a time, which is a claim under test.
unsafe impl Send for Fmu {}

impl Fmu {
    /// Instantiates what the order says, or gives the messages that tell why not.
    pub fn order(order: Order) -> Result<Self, Vec<Message>> {
        let messages = Box::new(Messages::default());
        let text = |text: Option<String>| text.map(|text| CString::new(text).expect("no NUL"));
        let (name, guid) = (text(order.name.map(str::to_owned)), text(order.guid));
        let location = text(order.location);
        let pointer = |text: &Option<CString>| text.as_ref().map_or(ptr::null(), |t| t.as_ptr());
        // SAFETY: all pointers are null or valid; the FMU copies what it keeps of the texts.
        let component = unsafe {
            fmi2Instantiate(
                pointer(&name),
                order.fmu_type,
                pointer(&guid),
                pointer(&location),
                &callbacks(&messages),
                0,
                c_int::from(order.logging_on),
            )
        };
        if component.is_null() {
            return Err(messages.into_inner().expect("nobody panics"));
        }
        Ok(Self { component, messages, declaration: native().declaration().clone() })
    }

    /// An instance that was just made.
    pub fn new() -> Self {
        Self::order(Order::default()).unwrap_or_else(|messages| panic!("{messages:?}"))
    }

    /// An instance in initialization mode.
    pub fn initializing() -> Self {
        let fmu = Self::new();
        fmu.begin();
        fmu
    }

    /// An instance that is ready for its first step.
    pub fn running() -> Self {
        let fmu = Self::initializing();
        assert_eq!(fmu.exit_initialization_mode(), Status::Ok);
        fmu
    }

    /// An instance that is ready for its first step and fails when it is asked for a step.
    pub fn troubled(trouble: &str) -> Self {
        let fmu = Self::new();
        assert_eq!(fmu.set_string("trouble", trouble), Status::Ok);
        fmu.begin();
        assert_eq!(fmu.exit_initialization_mode(), Status::Ok);
        fmu
    }

    /// Sets the experiment up and enters initialization mode.
    pub fn begin(&self) {
        assert_eq!(self.setup_experiment(0.0, None), Status::Ok);
        assert_eq!(self.enter_initialization_mode(), Status::Ok);
    }

    pub fn variable(&self, name: &str) -> &Variable {
        let variables = self.declaration.variables().iter();
        let mut found = variables.filter(|variable| variable.name == name);
        found.next().unwrap_or_else(|| panic!("no variable {name}"))
    }

    pub fn reference(&self, name: &str) -> u32 {
        self.variable(name).reference
    }

    /// The messages since this was asked last.
    pub fn messages(&self) -> Vec<Message> {
        std::mem::take(&mut self.messages.lock().expect("nobody panics"))
    }

    /// The text of the one message since this was asked last.
    pub fn message(&self) -> String {
        let messages = self.messages();
        assert_eq!(messages.len(), 1, "{messages:?}");
        messages[0].text.clone()
    }

    pub fn setup_experiment(&self, start: f64, stop: Option<f64>) -> Status {
        let defined = c_int::from(stop.is_some());
        // SAFETY: the component lives.
        unsafe { fmi2SetupExperiment(self.component, 0, 0.0, start, defined, stop.unwrap_or(0.0)) }
    }

    pub fn enter_initialization_mode(&self) -> Status {
        // SAFETY: the component lives.
        unsafe { fmi2EnterInitializationMode(self.component) }
    }

    pub fn exit_initialization_mode(&self) -> Status {
        // SAFETY: the component lives.
        unsafe { fmi2ExitInitializationMode(self.component) }
    }

    pub fn do_step(&self, start: f64, length: f64) -> Status {
        // SAFETY: the component lives.
        unsafe { fmi2DoStep(self.component, start, length, 1) }
    }

    pub fn terminate(&self) -> Status {
        // SAFETY: the component lives.
        unsafe { fmi2Terminate(self.component) }
    }

    pub fn reset(&self) -> Status {
        // SAFETY: the component lives.
        unsafe { fmi2Reset(self.component) }
    }

    pub fn set_debug_logging(&self, on: bool, categories: &[&CStr]) -> Status {
        let categories: Vec<_> = categories.iter().map(|text| text.as_ptr()).collect();
        let (count, categories) = (categories.len(), categories.as_ptr());
        // SAFETY: the component lives, and the categories do so during the call.
        unsafe { fmi2SetDebugLogging(self.component, c_int::from(on), count, categories) }
    }

    pub fn get_reals(&self, references: &[u32]) -> (Status, Vec<f64>) {
        let mut values = vec![f64::NAN; references.len()];
        let (count, target) = (references.len(), values.as_mut_ptr());
        // SAFETY: the component lives, and there is room for the values.
        let status = unsafe { fmi2GetReal(self.component, references.as_ptr(), count, target) };
        (status, values)
    }

    /// The value of a Real variable, which must be readable.
    pub fn get(&self, name: &str) -> f64 {
        let (status, values) = self.get_reals(&[self.reference(name)]);
        assert_eq!(status, Status::Ok, "{name}: {:?}", self.messages());
        values[0]
    }

    pub fn set(&self, name: &str, value: f64) -> Status {
        assert!(matches!(self.variable(name).kind, Kind::Real { .. }), "{name}");
        // SAFETY: the component lives, and there is one value.
        unsafe { fmi2SetReal(self.component, &self.reference(name), 1, &value) }
    }

    pub fn set_string(&self, name: &str, value: &str) -> Status {
        let value = CString::new(value).expect("no NUL");
        // SAFETY: the component lives, and there is one value.
        unsafe { fmi2SetString(self.component, &self.reference(name), 1, &value.as_ptr()) }
    }

    /// Saves into `state`, which is null or a state.
    pub fn save_into(&self, state: &mut *mut c_void) -> Status {
        // SAFETY: the component and the state live.
        unsafe { fmi2GetFMUstate(self.component, state) }
    }

    /// A new state.
    pub fn save(&self) -> *mut c_void {
        let mut state = ptr::null_mut();
        assert_eq!(self.save_into(&mut state), Status::Ok);
        state
    }

    pub fn restore(&self, state: *mut c_void) -> Status {
        // SAFETY: the component and the state live.
        unsafe { fmi2SetFMUstate(self.component, state) }
    }

    pub fn free_state(&self, state: &mut *mut c_void) -> Status {
        // SAFETY: the component lives; the state does, or is null.
        unsafe { fmi2FreeFMUstate(self.component, state) }
    }

    /// The bytes of a state.
    pub fn serialize(&self, state: *mut c_void) -> Vec<u8> {
        let mut size = 0;
        // SAFETY: the component and the state live, and there is room for the bytes.
        unsafe {
            let status = fmi2SerializedFMUstateSize(self.component, state, &mut size);
            assert_eq!(status, Status::Ok);
            let mut bytes = vec![0; size];
            let status = fmi2SerializeFMUstate(self.component, state, bytes.as_mut_ptr(), size);
            assert_eq!(status, Status::Ok);
            bytes
        }
    }

    /// The state that bytes mean; null if there is none.
    pub fn deserialize(&self, bytes: &[u8]) -> (Status, *mut c_void) {
        let mut state = ptr::null_mut();
        let (source, size) = (bytes.as_ptr(), bytes.len());
        // SAFETY: the component lives.
        let status = unsafe { fmi2DeSerializeFMUstate(self.component, source, size, &mut state) };
        (status, state)
    }
}

impl Drop for Fmu {
    fn drop(&mut self) {
        // SAFETY: nobody uses the component afterwards.
        unsafe { fmi2FreeInstance(self.component) };
    }
}
