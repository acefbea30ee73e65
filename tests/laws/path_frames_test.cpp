// The pictures of a camera path: their moments, and the folder that keeps them.

#include <doctest/doctest.h>

#include "core/files.h"
#include "scene/path_frames.h"
#include "tools/temporary_folder.h"

using namespace airlight;

namespace {

CameraPath lasting(double begin_s, double end_s) { return {{CameraKey{begin_s, {}}, CameraKey{end_s, {}}}}; }

// The next picture of a folder, as a renderer leaves it.
void take(FrameFolder& folder, double exposure) {
    REQUIRE(write_file(folder.picture(folder.exposures().size()), "a picture"));
    REQUIRE(folder.add(exposure));
}

}  // namespace

TEST_CASE("pictures are taken from the beginning of a path to its end, both of them too") {
    const std::vector<double> times = picture_times(lasting(2.0, 3.0), 10.0);
    REQUIRE(times.size() == 11);
    CHECK(times.front() == 2.0);
    CHECK(times[3] == doctest::Approx(2.3));
    CHECK(times.back() == 3.0);
    CHECK(picture_times(lasting(0.0, 0.99), 10.0).size() == 10);
    CHECK(picture_times(lasting(0.0, 20.0), 30.0).size() == 601);
    const CameraPath still{{CameraKey{5.0, {}}}};
    CHECK(picture_times(still, 25.0) == std::vector<double>{5.0});
}

TEST_CASE("a folder of frames knows on its next opening what it has") {
    const test::TemporaryFolder work;
    const auto path = work.path / "flight" / "frames";
    {
        Result<FrameFolder> folder = FrameFolder::open(path, "a scene");
        if (!folder) FAIL(folder.error().message());
        CHECK(folder->exposures().empty());
        CHECK(folder->picture(42).filename() == "00042.png");
        for (const double exposure : {0.1, 1.0 / 3.0, 2e-5}) take(*folder, exposure);
    }
    CHECK(FrameFolder::open(path, "a scene")->exposures() == std::vector<double>{0.1, 1.0 / 3.0, 2e-5});
    std::filesystem::remove(path / "00001.png");
    CHECK(FrameFolder::open(path, "a scene")->exposures() == std::vector<double>{0.1});
}

TEST_CASE("a folder of frames that is discarded goes, but for what others have put there") {
    const test::TemporaryFolder work;
    for (const bool others : {false, true}) {
        FrameFolder folder = *FrameFolder::open(work.path / "frames", "a scene");
        for (int i = 0; i < 3; ++i) take(folder, 0.5);
        if (others) REQUIRE(write_file(work.path / "frames/notes.txt", "mine"));
        REQUIRE(folder.discard());
        CHECK(std::filesystem::exists(work.path / "frames") == others);
        CHECK(!std::filesystem::exists(work.path / "frames/00000.png"));
        CHECK(!std::filesystem::exists(work.path / "frames/frames.csv"));
        CHECK(folder.exposures().empty());
    }
}

TEST_CASE("frames of something else, and a list that is none, are told and left alone") {
    const test::TemporaryFolder work;
    Result<FrameFolder> folder = FrameFolder::open(work.path, "a scene");
    REQUIRE(folder);
    take(*folder, 0.5);
    const Result<FrameFolder> other = FrameFolder::open(work.path, "another scene");
    REQUIRE(!other);
    CHECK(other.error().message().find("another scene, path, size or option") != std::string::npos);
    const std::string list = *read_file(work.path / "frames.csv");
    for (const char* row : {"1,bright\n", "2,0.5\n", "1,-0.5\n", "1,0.5"}) {
        CAPTURE(row);
        REQUIRE(write_file(work.path / "frames.csv", list + row));
        CHECK(!FrameFolder::open(work.path, "a scene"));
        CHECK(*read_file(work.path / "frames.csv") == list + row);
    }
}
