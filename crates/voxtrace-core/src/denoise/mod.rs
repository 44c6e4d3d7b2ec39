//! A film without its noise: what was seen directly is taken off and albedos are divided out; what is left, the light that falls on
//! surfaces, is filtered by an à-trous wavelet transform whose weights stop at the edges of surfaces (Dammertz, Sewtz, Hanika,
//! Lensch, "Edge-Avoiding À-Trous Wavelet Transform for fast Global Illumination Filtering", HPG 2010; with variances as in Schied
//! et al., "Spatiotemporal Variance-Guided Filtering", HPG 2017). Details that are more than their noise are put back (Chang, Yu,
//! Vetterli, "Adaptive Wavelet Thresholding for Image Denoising and Compression", IEEE TIP 9(9), 2000), so that where the filter
//! knows nothing the picture stays as it was. `docs/decisions/0048-denoising.md` says why it is so.
//!
//! Only + − × ÷ √ and comparisons are used, in an order that threads do not change: every machine gets the same bits.

mod chance;
mod features;
mod filter;
mod surfaces;
#[cfg(test)]
mod tests;
mod variance;
mod wavelet;

pub use features::{FeaturePixel, Features};
pub use filter::{denoise, denoise_while};
// For the filter of real-time light.
#[doc(hidden)]
pub use filter::trust;
#[doc(hidden)]
pub use wavelet::box_mean;
