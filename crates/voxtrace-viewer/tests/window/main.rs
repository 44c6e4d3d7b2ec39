//! The window without a screen: what its panels say, what events do, and what it draws. One program, whose code is linked once.
//! `cargo test -p voxtrace-viewer --test window panels::` runs one module; `soak`, which watches the memory of its process, is another program.

mod changing;
mod common;
mod comparing;
mod cutting;
mod devices;
mod dialogs;
mod drawing;
mod editing;
mod editing_films;
mod editing_panels;
mod editing_scene;
mod handles;
mod lenses;
mod limits;
mod lines;
mod losses;
mod measuring;
mod opening;
mod panels;
mod parts;
mod pausing;
mod real_time;
mod scripts;
mod showing;
mod skies;
mod surroundings;
mod timeline;
mod values;
mod walks;
