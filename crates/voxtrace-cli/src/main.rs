//! The command line of voxtrace.
fn main() {}
