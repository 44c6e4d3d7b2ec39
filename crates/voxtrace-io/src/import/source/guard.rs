//! The edge to foreign crates: what panics there becomes an error here.

use std::panic::{AssertUnwindSafe, catch_unwind};

/// Runs a reader of another crate. A panic in it becomes the error text of the result; what it was working on is dropped.
pub(crate) fn guarded<T>(read: impl FnOnce() -> Result<T, String>) -> Result<T, String> {
    catch_unwind(AssertUnwindSafe(read)).unwrap_or_else(|panic| {
        let message = panic.downcast_ref::<&str>().map(|text| (*text).to_owned());
        let message = message.or_else(|| panic.downcast_ref::<String>().cloned());
        Err(format!("the decoder failed: {}", message.unwrap_or_else(|| "no reason given".into())))
    })
}

#[cfg(test)]
mod tests {
    use super::guarded;

    #[test]
    fn a_panic_becomes_an_error_and_results_pass() {
        assert_eq!(guarded(|| Ok(5)), Ok(5));
        assert_eq!(guarded::<()>(|| Err("wrong".into())), Err("wrong".into()));
        assert!(guarded::<()>(|| panic!("planted")).unwrap_err().contains("planted"));
    }
}
