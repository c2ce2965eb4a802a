//! Tests of claims on folders.

use super::*;

fn claim(folder: &Path) -> Result<Claim, ClaimError> {
    Claim::of(folder, false)
}

/// What a run leaves that has ended in order.
fn ended_run(folder: &Path) {
    let claim = claim(folder).unwrap();
    fs::write(folder.join("manifest.toml"), "hotfoot_version = \"0\"\n").unwrap();
    fs::create_dir_all(folder.join("series/train.parts")).unwrap();
    claim.release();
}

#[test]
fn of_claims_at_the_same_time_one_gets_the_folder() {
    let temporary = tempfile::tempdir().unwrap();
    for round in 0..20 {
        let folder = temporary.path().join(format!("{round}/results"));
        let claims: Vec<_> = thread::scope(|scope| {
            let threads: Vec<_> = (0..4).map(|_| scope.spawn(|| claim(&folder))).collect();
            threads.into_iter().map(|thread| thread.join().unwrap()).collect()
        });
        let errors: Vec<_> = claims.iter().filter_map(|claim| claim.as_ref().err()).collect();
        assert_eq!(errors.len(), 3, "{errors:?}");
        assert!(errors.iter().all(|error| matches!(error, ClaimError::InUse { .. })), "{errors:?}");
    }
}

#[test]
fn a_folder_in_use_is_refused_and_that_of_a_dead_run_has_results() {
    let temporary = tempfile::tempdir().unwrap();
    let living = claim(temporary.path()).unwrap();
    let overwrite = Claim::of(temporary.path(), true);
    assert!(matches!(overwrite, Err(ClaimError::InUse { .. })), "{overwrite:?}");
    let child = Claim::join(temporary.path()).unwrap();
    drop(living);
    assert_eq!(owner(temporary.path()).unwrap(), Owner::Living, "the child holds it too");
    drop(child);
    assert_eq!(owner(temporary.path()).unwrap(), Owner::Dead);
    let again = claim(temporary.path());
    assert!(matches!(again, Err(ClaimError::HasResults { .. })), "{again:?}");
    Claim::of(temporary.path(), true).unwrap();
}

#[test]
fn results_are_replaced_on_request_only_and_other_files_never() {
    let temporary = tempfile::tempdir().unwrap();
    let folder = temporary.path();
    fs::write(folder.join("notes.txt"), "mine").unwrap();
    ended_run(folder);
    assert!(matches!(claim(folder), Err(ClaimError::HasResults { .. })));
    assert!(folder.join("series").exists());
    let claim = Claim::of(folder, true).unwrap();
    assert!(!folder.join("series").exists() && !folder.join("manifest.toml").exists());
    claim.undo();
    let left: Vec<_> =
        fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().file_name()).collect();
    assert_eq!(left, ["notes.txt"]);
}

/// A folder named `series` that no run has written is not removed, whatever is asked for.
#[test]
fn what_only_looks_like_results_is_left_alone() {
    let temporary = tempfile::tempdir().unwrap();
    fs::create_dir(temporary.path().join("series")).unwrap();
    for overwrite in [false, true] {
        let claim = Claim::of(temporary.path(), overwrite);
        assert!(matches!(&claim, Err(ClaimError::Foreign { name, .. }) if name == "series"));
    }
    assert!(temporary.path().join("series").exists());
}

#[test]
fn a_claim_that_is_undone_leaves_no_folder_that_was_not_there() {
    let temporary = tempfile::tempdir().unwrap();
    let folder = temporary.path().join("a/b");
    let claim = claim(&folder).unwrap();
    fs::create_dir(folder.join("fmus")).unwrap();
    claim.undo();
    assert_eq!(fs::read_dir(temporary.path()).unwrap().count(), 0);
}

#[test]
fn a_file_is_no_folder() {
    let file = tempfile::NamedTempFile::new().unwrap();
    let refused = claim(file.path());
    assert!(matches!(refused, Err(ClaimError::IsFile { .. })), "{refused:?}");
}
