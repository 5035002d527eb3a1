# `make demo` and `make test` are all that a newcomer needs: both bring in what
# is missing (a C linker, Mesa's software OpenGL) before they begin.

CARGO ?= cargo
DEMO_SCENE  := examples/scenes/molecule.toml
DEMO_METHOD := verified-painter
DEMO_IMAGE  := out/molecule.png

# Cargo is parallel by itself and locks its build folder: -j would only mix the
# output and let a check begin before the set-up has ended.
.NOTPARALLEL:
.DEFAULT_GOAL := help
.PHONY: help demo test setup check lint features tests unit examples docs package deny bench clean

help: ## Show this list
	@awk -F ':.*## ' '/^[a-z-]+:.*## / { printf "  make %-8s %s\n", $$1, $$2 }' $(firstword $(MAKEFILE_LIST))

demo: setup ## Install what is missing, build, and render the demo scene into out/
	$(CARGO) build --release --locked
	@mkdir -p $(dir $(DEMO_IMAGE))
	$(CARGO) run --quiet --release --locked -- render $(DEMO_SCENE) -m $(DEMO_METHOD) -o $(DEMO_IMAGE)

# Everything below shares cargo's dev profile, so that dependencies are built once.
test: setup-checks lint docs tests ## Install what is missing and run every check: format, clippy, tests on both backends, docs, examples
	@echo "all checks passed"

setup: ## Install what is missing and nothing else
	@.ci/setup

.PHONY: setup-checks
setup-checks:
	@.ci/setup checks

check: setup-checks lint ## Format and clippy only

lint: features
	$(CARGO) fmt --check
# The registry makes modules of the methods' files, and the index of the papers', where cargo fmt does not look for them.
	rustfmt --check --edition 2024 src/methods/*.rs src/methods/*/mod.rs src/papers/*.rs src/papers/*/mod.rs
	$(CARGO) clippy --all-targets --locked -- -D warnings

# The library with none of its features, and with each of them alone.
FEATURES := none formats report edition cli
features: $(addprefix feature-,$(FEATURES))
$(addprefix feature-,$(FEATURES)): feature-%:
	$(CARGO) clippy --lib --locked --no-default-features $(if $(filter-out none,$*),--features $*) -- -D warnings

# Tests and examples, one module of them on each core. See .ci/tests, whose parts these are. PARTS='unit' runs some of them.
tests:
	.ci/tests $(PARTS)
unit:
	.ci/tests unit doc
examples:
	.ci/tests examples

docs:
	RUSTDOCFLAGS='-D warnings' $(CARGO) doc --no-deps --locked

package: setup-checks ## Build the crate as it is published, then demo, examples and tests from its archive alone
	.ci/package

deny: ## Check the dependencies' licences, sources and advisories, where cargo-deny is installed
	@.ci/deny

BENCH_SIZE   := 640x480
BENCH_SCENES := sheets64 quads teapot knots molecule slices soup
ONIONSKIN := $(CARGO) run --quiet --release --locked --

# What the papers' own comparisons cost is measured by `cargo bench`, which takes longer.
bench: setup ## Measure what methods cost on the bundled scenes, and on scenes of growing depth and disorder, into out/
	$(CARGO) build --release --locked
	@mkdir -p out
	$(ONIONSKIN) bench $(BENCH_SCENES:%=examples/scenes/%.toml) --size $(BENCH_SIZE) --frames 5 --csv out/bench.csv --plot out/bench.svg
	$(ONIONSKIN) bench --sweep depth -o out/sweep --size 256x192 --frames 3 --no-vtk
	$(ONIONSKIN) bench --sweep disorder -o out/sweep --size 256x192 --frames 3 --no-vtk

clean: ## Remove everything that was built or rendered
	$(CARGO) clean
	rm -rf out
