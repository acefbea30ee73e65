// A function known at samples: linear between them; a single sample is a constant.
// Uses core (errors) and quantities; knows nothing of what the function means.
#pragma once

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

#include "core/result.h"
#include "units/quantity.h"
#include "units/units.h"

namespace airlight {

// Y (a quantity) as a function of X (a quantity): a cross-section of wavelength, a density of altitude.
template <class X, class Y>
class Curve {
public:
    struct Sample {
        X x;
        Y y;
        friend bool operator==(const Sample&, const Sample&) = default;
    };

    // The same value everywhere.
    static Curve constant(Y y) { return Curve({{X::of(0.0), y}}); }

    // Fails if there is no sample, if x does not strictly increase, or if a value is not finite.
    static Result<Curve> of(std::vector<Sample> samples) {
        if (samples.empty()) return Error{"", "a curve needs at least one sample", ""};
        for (std::size_t i = 0; i < samples.size(); ++i) {
            if (!std::isfinite(samples[i].x.value) || !std::isfinite(samples[i].y.value))
                return Error{"", "sample " + std::to_string(i + 1) + " is not finite", ""};
            if (i > 0 && !(samples[i - 1].x < samples[i].x))
                return Error{"", "sample " + std::to_string(i + 1) + " does not lie above the one before it",
                             "Sort the samples and remove doubles."};
        }
        return Curve(std::move(samples));
    }

    bool is_constant() const { return samples_.size() == 1; }
    const std::vector<Sample>& samples() const { return samples_; }

    // Whether the curve has data over the whole of [first, last].
    bool covers(X first, X last) const { return is_constant() || (samples_.front().x <= first && last <= samples_.back().x); }

    // The value at x; outside the samples, the value at the nearest end.
    Y at(X x) const {
        if (is_constant() || x <= samples_.front().x) return samples_.front().y;
        if (x >= samples_.back().x) return samples_.back().y;
        const auto above = std::upper_bound(samples_.begin(), samples_.end(), x, [](X value, const Sample& s) { return value < s.x; });
        const Sample& b = *above;
        const Sample& a = *(above - 1);
        const double t = (x.value - a.x.value) / (b.x.value - a.x.value);
        return Y::of(a.y.value * (1.0 - t) + b.y.value * t);
    }

    // The mean over [first, last], exact for the linear pieces; first <= last.
    Y mean(X first, X last) const {
        assert(first <= last);
        if (is_constant() || first == last) return at(first);
        double sum = 0.0;
        X previous = first;
        for (const Sample& sample : samples_) {
            if (sample.x <= first) continue;
            if (sample.x >= last) break;
            sum += 0.5 * (at(previous).value + sample.y.value) * (sample.x.value - previous.value);
            previous = sample.x;
        }
        sum += 0.5 * (at(previous).value + at(last).value) * (last.value - previous.value);
        return Y::of(sum / (last.value - first.value));
    }

    // The same curve with every value multiplied.
    Curve scaled(double factor) const {
        Curve result = *this;
        for (Sample& sample : result.samples_) sample.y = sample.y * factor;
        return result;
    }

    friend bool operator==(const Curve&, const Curve&) = default;

private:
    explicit Curve(std::vector<Sample> samples) : samples_(std::move(samples)) {}
    std::vector<Sample> samples_;
};

// A quantity as a function of wavelength.
template <class Y>
using SpectrumOf = Curve<Wavelength, Y>;

}  // namespace airlight
