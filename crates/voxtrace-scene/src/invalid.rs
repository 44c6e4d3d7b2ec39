//! What the checks named `validate` answer.

/// A structure does not hold together: one sentence about the first fault that was found.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{0}")]
pub struct Invalid(String);

impl From<String> for Invalid {
    fn from(fault: String) -> Self {
        Self(fault)
    }
}

impl From<&str> for Invalid {
    fn from(fault: &str) -> Self {
        Self(fault.into())
    }
}

impl From<Invalid> for String {
    fn from(invalid: Invalid) -> Self {
        invalid.0
    }
}
