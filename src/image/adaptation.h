// How an exposure follows the light: at once in a picture, over a while in a film.
// Theory: docs/theory.md, section 9.
// Uses nothing; exposure.h meters what is followed.
#pragma once

namespace airlight {

// After its time the distance to what is metered, in stops, has fallen to 1 / e. Eyes, too, take longer to see in the dark. Above 0.
struct Adaptation {
    double to_brighter_s = 0.4;
    double to_darker_s = 1.2;
};

// The share of a distance that is covered within `seconds` >= 0 at a time constant > 0; infinity covers all of it.
// Steps of any lengths cover what one step of their sum does: the rate of frames leaves no trace.
double covered_share(double seconds, double time_constant_s);

// The exposure, now `exposure` and above 0, after `seconds` in light that is metered at `metered`.
double adapted_exposure(double exposure, double metered, double seconds, const Adaptation& adaptation);

}  // namespace airlight
