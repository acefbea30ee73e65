// Densities relative to their reference, by altitude. Theory: docs/theory.md, section 2.

// Exponential: 1 at the ground, 1/e at one scale height.
FN Number exponential_density(Length h, Length scale_height) {
    return exp(-(h / scale_height));
}

// A layer: 1 between its two altitudes, 0 elsewhere.
FN Number layer_density(Length h, Length low, Length high) {
    return h >= low && h <= high ? Number(1.0) : Number(0.0);
}

// A triangle: 0 below `low`, 1 at `peak`, 0 above `high`, straight between; low < peak < high.
FN Number triangle_density(Length h, Length low, Length peak, Length high) {
    Number rising = (h - low) / (peak - low);
    Number falling = (high - h) / (high - peak);
    return clamp(min(rising, falling), Number(0.0), Number(1.0));
}
