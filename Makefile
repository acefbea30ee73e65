# Two commands do everything on a fresh Debian 12: `make demo` and `make test`. The rest is for those who work on it.

.DEFAULT_GOAL := help
FIGURES := density_profile mean_density sky_columns sky_parameter phase_functions sky_by_altitude sky_from_altitudes scattering_orders \
  rayleigh_coefficient rayleigh_scale_height mie_coefficient mie_scale_height

.PHONY: help setup build demo test truth models models-grounds figures gallery golden bench fuzz check sanitize install clean

help:
	@echo 'make demo      install what is missing, build, and compute a real sky and frames of the real Earth; names the files it wrote'
	@echo 'make test      the same set-up, then every test'
	@echo 'make truth     every row of the independent figures in ../shared/reference, ending in a verdict (about ten minutes)'
	@echo 'make models    every model against the reference: docs/models.md, and out/models/report.html (shows the time left; goes on if stopped)'
	@echo 'make models-grounds  the same for other grounds and turbid air: docs/models-grounds.md (about ten minutes; goes on if stopped)'
	@echo 'make figures   the pictures of docs/gallery.md, in docs/images/figures (three minutes; goes on if stopped)'
	@echo 'make gallery   the other pictures of docs/gallery.md, in docs/images/gallery (three minutes; goes on if stopped)'
	@echo 'make golden    makes the golden pictures of the tests anew (tests/golden), where the new look is meant'
	@echo 'make bench     benchmarks'
	@echo 'make fuzz      fuzz every parser of files from strangers, FUZZ_SECONDS=60 each'
	@echo 'make check     a second compiler, format, clang-tidy, every header alone'
	@echo 'make sanitize  the tests under the address and undefined-behaviour sanitizers'

setup:
	@tools/install-packages packages/debian.txt

build/release/build.ninja: | setup
	cmake --preset release

build: setup build/release/build.ninja
	cmake --build --preset release

# DEMO=small computes everything with tiny tables and pictures.
demo: setup build/release/build.ninja
	@tools/install-packages packages/debian-demo.txt
	cmake --build --preset release --target airlight
	tools/demo build/release/apps/airlight/airlight out/demo $(DEMO)

test: build
	ctest --preset release --parallel $$(nproc)

truth: build
	@failed=0; for t in build/release/tests/truth/truth_*; do [ -x $$t ] && { echo "$$t"; AIRLIGHT_TRUTH=full $$t --minimal || failed=1; }; done; \
	if [ $$failed = 0 ]; then echo 'verdict: agrees with all independent figures that are present'; else echo 'verdict: DISAGREES, see above'; exit 1; fi

models: build
	build/release/apps/airlight/airlight compare --atmosphere earth-clear,earth-hazy --eyes-m 0,2000,10000,30000,400000 \
	  --suns 0,30,60,75,85,90,96 --paths 8192 --table docs/models.md -o out/models

# A second page, of other grounds and turbid air (earth-urban: turbidity 5.8), by day and deep into twilight.
models-grounds: build
	build/release/apps/airlight/airlight compare --atmosphere earth-clear,earth-urban --ground black,grass,snow --eyes-m 0 \
	  --suns 30,60,85,96,102 --paths 2048 --size 0 --cache out/models-grounds/tables --by 'make models-grounds' \
	  --table docs/models-grounds.md -o out/models-grounds

# What is newer than the program and its script is not made again.
figures: setup build/release/build.ninja
	@tools/install-packages packages/debian-figures.txt
	cmake --build --preset release --target airlight_draw_figure
	@$(MAKE) --no-print-directory $(FIGURES:%=docs/images/figures/%.png)

draw_figure := build/release/apps/figures/airlight_draw_figure

.SECONDARY:

out/figures/%.csv: $(draw_figure)
	$(draw_figure) $* -o out/figures

# Two charts share a table; a figure without a script of its own is a sheet of pictures.
docs/images/figures/sky_parameter.png: out/figures/sky_columns.csv tools/figures/sky_parameter.gp tools/figures/style.gp
	tools/figures/draw tools/figures/sky_parameter.gp $< $@

docs/images/figures/%.png: out/figures/%.csv tools/figures/%.gp tools/figures/style.gp
	tools/figures/draw tools/figures/$*.gp $< $@

docs/images/figures/%.png: out/figures/%.csv tools/figures/sheet.gp tools/figures/style.gp
	tools/figures/draw tools/figures/sheet.gp $< $@

# What is newer than the program and its scene is not drawn again.
gallery: setup build/release/build.ninja
	@tools/install-packages packages/debian-demo.txt packages/debian-gallery.txt
	cmake --build --preset release --target airlight
	tools/gallery build/release/apps/airlight/airlight docs/images/gallery out/gallery

golden: setup build/release/build.ninja
	cmake --build --preset release --target airlight
	tests/golden/draw build/release/apps/airlight/airlight out/golden/tables tests/golden

bench: build
	tools/run-benchmarks build/release/benchmarks

check: setup
	@tools/install-packages packages/debian-check.txt
	tools/check

sanitize: setup
	cmake --preset sanitize && cmake --build --preset sanitize && ctest --preset sanitize --parallel $$(nproc)

fuzz: setup
	@tools/install-packages packages/debian-fuzz.txt
	tools/fuzz $${FUZZ_SECONDS:-60}

install: build
	cmake --install build/release

clean:
	rm -rf build out
