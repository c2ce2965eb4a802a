//! What the packer asks for.

use std::ffi::{CStr, CString, c_char, c_int};
use std::path::Path;
use std::ptr;

use crate::fmi2::*;
use crate::tool::native_in;

/// Asks the exported function for its text.
fn ask(
    function: unsafe extern "C" fn(*const c_char, *mut *mut c_char) -> c_int,
    resources: &Path,
) -> (c_int, String) {
    let resources = CString::new(resources.to_str().expect("UTF-8")).expect("no NUL");
    let mut text = ptr::null_mut();
    // SAFETY: the text comes from the function and is freed once.
    unsafe {
        let code = function(resources.as_ptr(), &mut text);
        let answer = CStr::from_ptr(text).to_str().expect("UTF-8").to_owned();
        hotfoot_free_text(text);
        (code, answer)
    }
}

#[test]
fn golden_model_description_of_the_spring() {
    let (code, text) = ask(hotfoot_model_description, Path::new(""));
    assert_eq!(code, 0, "{text}");
    let expected = include_str!("spring.xml");
    // The version is that of the package.
    let expected = expected.replace("VERSION", env!("CARGO_PKG_VERSION"));
    assert_eq!(text, expected);
}

/// The spring's points along it are declared as terminals; that a model without any has no file is
/// tested where the file is written.
#[test]
fn terminals_come_with_the_variables_that_belong_to_them() {
    let (code, text) = ask(hotfoot_terminals, Path::new(""));
    assert_eq!(code, 0, "{text}");
    let member = "variableName=\"point[1].position\" memberName=\"position\"";
    assert!(text.contains("<Terminal name=\"point[1]\"") && text.contains(member), "{text}");
}

#[test]
fn the_description_follows_the_resources() {
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::write(folder.path().join("points.txt"), "3").expect("a file");
    let (code, text) = ask(hotfoot_model_description, folder.path());
    assert_eq!(code, 0, "{text}");
    assert!(text.contains("name=\"point[3].position\""), "{text}");
    let guid = native_in(folder.path()).guid().to_string();
    assert!(text.contains(&guid), "{text}");
    let (code, page) = ask(hotfoot_documentation, folder.path());
    assert_eq!(code, 0, "{page}");
    assert!(page.contains("<td>point[3].position</td>"), "{page}");
}

#[test]
fn a_wrong_resource_is_answered_with_its_name() {
    let folder = tempfile::tempdir().expect("a folder");
    std::fs::write(folder.path().join("points.txt"), "many").expect("a file");
    for function in [hotfoot_model_description, hotfoot_documentation, hotfoot_terminals] {
        let (code, text) = ask(function, folder.path());
        assert_eq!(code, 1);
        assert!(text.contains("points.txt: `many` is no number"), "{text}");
    }
}

#[test]
fn null_pointers_are_answered() {
    let mut text = ptr::null_mut();
    // SAFETY: null is allowed, and the text is freed once.
    unsafe {
        assert_eq!(hotfoot_model_description(c"".as_ptr(), ptr::null_mut()), 1);
        assert_eq!(hotfoot_model_description(ptr::null(), &mut text), 1);
        let reason = CStr::from_ptr(text).to_str();
        assert_eq!(reason, Ok("the argument `resources` is a null pointer"));
        hotfoot_free_text(text);
        hotfoot_free_text(ptr::null_mut());
    }
}
