// Exposure and tone curves.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <vector>

#include "image/adaptation.h"
#include "image/exposure.h"
#include "image/tone.h"

using namespace airlight;

TEST_CASE("a tone curve rises from 0 towards 1") {
    for (const ToneCurve curve : {ToneCurve::exponential, ToneCurve::reinhard, ToneCurve::filmic}) {
        CAPTURE(name_of(curve));
        CHECK(tone(curve, 0.0) == 0.0);
        double before = 0.0;
        for (double x = 1e-9; x < 30.0; x *= 1.01) {  // past 37 the exponential is 1 to the last digit
            const double y = tone(curve, x);
            CHECK(y > before);
            CHECK(y < 1.0);
            before = y;
        }
        CHECK(tone(curve, 1e9) > 1.0 - 1e-8);
        CHECK(tone(curve, 3.4e38) <= 1.0);
    }
    CHECK(tone(ToneCurve::linear, 0.25) == 0.25);
    CHECK(tone(ToneCurve::linear, 7.0) == 1.0);
}

TEST_CASE("tone curves have their published values") {
    CHECK(std::abs(tone(ToneCurve::exponential, 1.0) - 0.6321205588285577) < 1e-15);
    CHECK(tone(ToneCurve::reinhard, 1.0) == 0.5);
    // Hable's published form, f(x) / f(11.2) at f's own argument 2 (an exposure bias of his): here as a ratio of values.
    const auto published = [](double x) { return (x * (0.15 * x + 0.05) + 0.004) / (x * (0.15 * x + 0.5) + 0.06) - 0.02 / 0.3; };
    const double bias = 3.9453724810575306;
    CHECK(std::abs(tone(ToneCurve::filmic, 2.0 / bias) / tone(ToneCurve::filmic, 11.2 / bias) - published(2.0) / published(11.2)) < 1e-13);
    CHECK(std::abs(tone(ToneCurve::filmic, 0.18) - 0.18) < 1e-15);
}

TEST_CASE("a tone curve's name reads back to it") {
    for (const ToneCurve curve : {ToneCurve::linear, ToneCurve::exponential, ToneCurve::reinhard, ToneCurve::filmic})
        CHECK(tone_curve_named(name_of(curve)) == curve);
    CHECK(!tone_curve_named("aces"));
}

TEST_CASE("a developed image is the curve of each value") {
    Image image(2, 1, 3);
    image.values = {0.0f, 1000.0f, 2000.0f, 4000.0f, 1e9f, 1e-3f};
    const Image shown = developed(image, 1.0 / 2000.0, ToneCurve::exponential);
    for (std::size_t i = 0; i < 6; ++i)
        CHECK(shown.values[i] == static_cast<float>(-std::expm1(-static_cast<double>(image.values[i]) / 2000.0)));
}

TEST_CASE("an exposure value brings 1.2 2^EV cd m-2 to white") {
    CHECK(std::abs(exposure_of_ev100(15.0) * 1.2 * 32768.0 - 1.0) < 1e-15);
    CHECK(std::abs(ev100_of_exposure(exposure_of_ev100(12.3)) - 12.3) < 1e-13);
    CHECK(exposure_of_white(5000.0) == 1.0 / 5000.0);
}

TEST_CASE("the log average of a plain image is its grey, whatever its brightness") {
    for (const float luminance : {2e-3f, 1.0f, 8000.0f}) {
        const std::vector<float> plain(100, luminance);
        CHECK(std::abs(*metered_exposure(plain, {}, {}) * static_cast<double>(luminance) - 0.18) < 1e-12);
    }
}

TEST_CASE("what is darker than eyes see colours in is metered as that: a dark night stays dark") {
    for (const auto method : {Metering::Method::log_average, Metering::Method::percentile}) {
        const Metering metering{.method = method};
        const auto metered = [&](float luminance) { return *metered_exposure(std::vector<float>(100, luminance), {}, metering); };
        CHECK(metered(2e-4f) == metered(9e-4f));
        CHECK(metered(2e-3f) < metered(9e-4f));
    }
}

TEST_CASE("the sun's disk and black pixels do not change what is metered") {
    const std::vector<float> sky{1000.0f, 2000.0f, 4000.0f};
    const std::vector<float> sky_sun_and_black{1000.0f, 0.0f, 2000.0f, 1.6e9f, 4000.0f, 0.0f};
    for (const auto method : {Metering::Method::log_average, Metering::Method::percentile}) {
        Metering metering;
        metering.method = method;
        CHECK(*metered_exposure(sky, {}, metering) == *metered_exposure(sky_sun_and_black, {}, metering));
    }
    CHECK(std::abs(*metered_exposure(sky, {}, {}) - 0.18 / 2000.0) < 1e-15);
}

TEST_CASE("the percentile's luminance becomes white") {
    std::vector<float> ramp;
    for (int i = 1; i <= 100; ++i) ramp.push_back(static_cast<float>(101 - i));
    Metering metering;
    metering.method = Metering::Method::percentile;
    CHECK(*metered_exposure(ramp, {}, metering) == 1.0 / 99.0);
    metering.share = 0.5;
    CHECK(*metered_exposure(ramp, {}, metering) == 1.0 / 50.0);
    metering.share = 1.0;
    CHECK(*metered_exposure(ramp, {}, metering) == 1.0 / 100.0);
}

TEST_CASE("a pixel counts by its weight, one outside of the circle not at all") {
    const std::vector<float> luminance{100.0f, 400.0f, 9000.0f}, weight{1.0f, 3.0f, 0.0f};
    const double mean = std::pow(100.0 * 400.0 * 400.0 * 400.0, 0.25);
    CHECK(std::abs(*metered_exposure(luminance, weight, {}) * mean - 0.18) < 1e-12);
}

TEST_CASE("without light there is nothing to meter") {
    const std::vector<float> black(10, 0.0f), wrong{1.0f, std::numeric_limits<float>::quiet_NaN()};
    REQUIRE(!metered_exposure(black, {}, {}));
    CHECK(metered_exposure(black, {}, {}).error().message().starts_with("there is no light to meter"));
    CHECK(!metered_exposure(wrong, {}, {}));
    CHECK(!metered_exposure({}, {}, {}));
}

TEST_CASE("an exposure covers all but 1 / e of its way, in stops, in its time constant: the faster one towards the bright") {
    const Adaptation adaptation{.to_brighter_s = 0.5, .to_darker_s = 2.0};
    for (const auto& [before, metered, constant_s] : {std::tuple{1.0, 1.0 / 64.0, 0.5}, {1.0, 64.0, 2.0}}) {
        const double left = std::log2(metered / adapted_exposure(before, metered, constant_s, adaptation));
        CHECK(left / std::log2(metered / before) == doctest::Approx(std::exp(-1.0)).epsilon(1e-12));
    }
}

TEST_CASE("adaptation: many frames do what one does, none overshoots, and at last it is there") {
    const Adaptation adaptation;
    for (const double metered : {1e-6, 0.9, 1e6}) {
        const double once = adapted_exposure(1.0, metered, 1.5, adaptation);
        for (const std::vector<double>& frames : {std::vector<double>(150, 0.01), {0.4, 0.1, 1.0}, {0.0, 1.5}}) {
            double exposure = 1.0;
            for (const double seconds : frames) exposure = adapted_exposure(exposure, metered, seconds, adaptation);
            CHECK(exposure == doctest::Approx(once).epsilon(1e-12));
        }
        CHECK(std::min(1.0, metered) <= once);
        CHECK(once <= std::max(1.0, metered));
        CHECK(adapted_exposure(1.0, metered, std::numeric_limits<double>::infinity(), adaptation) ==
              doctest::Approx(metered).epsilon(1e-12));
    }
}
