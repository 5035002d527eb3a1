# `make demo` and `make test` are all that a newcomer needs: both bring in what
# is missing (a C linker, Mesa's software OpenGL) before they begin.

CARGO ?= cargo
DEMO_SCENE  := examples/scenes/molecule.toml
DEMO_METHOD := depth-peeling
DEMO_IMAGE  := out/molecule.png

# The tests that open an OpenGL context. They run once for each backend.
GL_TESTS := $(notdir $(patsubst %/,%,$(dir $(sort $(wildcard tests/gl*/main.rs)))))
EXAMPLES := $(basename $(notdir $(sort $(wildcard examples/*.rs))))

# Cargo is parallel by itself and locks its build folder: -j would only mix the
# output and let a check begin before the set-up has ended.
.NOTPARALLEL:
.DEFAULT_GOAL := help
.PHONY: help demo test setup check lint features unit gl-osmesa docs examples package deny bench clean

help: ## Show this list
	@awk -F ':.*## ' '/^[a-z-]+:.*## / { printf "  make %-8s %s\n", $$1, $$2 }' $(firstword $(MAKEFILE_LIST))

demo: setup ## Install what is missing, build, and render the demo scene into out/
	$(CARGO) build --release --locked
	@mkdir -p $(dir $(DEMO_IMAGE))
	$(CARGO) run --quiet --release --locked -- render $(DEMO_SCENE) -m $(DEMO_METHOD) -o $(DEMO_IMAGE)

# Everything below shares cargo's dev profile, so that dependencies are built once.
test: setup-checks lint unit gl-osmesa docs examples ## Install what is missing and run every check: format, clippy, tests on both backends, docs, examples
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
FEATURES := none formats report cli
features: $(addprefix feature-,$(FEATURES))
$(addprefix feature-,$(FEATURES)): feature-%:
	$(CARGO) clippy --lib --locked --no-default-features $(if $(filter-out none,$*),--features $*) -- -D warnings

# One test at a time: llvmpipe rasterises with every core as it is, and Mesa 22.3 was once seen to crash (SIGSEGV, not
# reproduced in hundreds of runs) while contexts of two test threads drew at once. That several threads may have contexts
# is what tests/gl_context/context.rs tests.
unit gl-osmesa: export RUST_TEST_THREADS = 1

# Unit, integration and doc tests.
unit:
	ONIONSKIN_BACKEND=egl $(CARGO) test --locked

# With no GL test to name, cargo would run all tests again.
gl-osmesa: TEST_ON_OSMESA = ONIONSKIN_BACKEND=osmesa $(CARGO) test --locked $(addprefix --test ,$(GL_TESTS))
gl-osmesa:
ifeq ($(GL_TESTS),)
	@echo "skipped: GL tests on OSMesa (there are no tests/gl*/main.rs)"
else
	@if .ci/setup has-osmesa; then \
	    echo "$(TEST_ON_OSMESA)"; \
	    $(TEST_ON_OSMESA); \
	else \
	    echo "skipped: GL tests on OSMesa (libOSMesa.so.8 is not installed): $(GL_TESTS)"; \
	fi
endif

docs:
	RUSTDOCFLAGS='-D warnings' $(CARGO) doc --no-deps --locked

examples:
	@mkdir -p out/examples
	@set -e; for name in $(EXAMPLES); do \
	    echo "example $$name"; \
	    $(CARGO) run --quiet --locked --example "$$name" -- out/examples; \
	done

package: setup-checks ## Build the crate as it is published, then demo, examples and tests from its archive alone
	.ci/package

deny: ## Check the dependencies' licences, sources and advisories, where cargo-deny is installed
	@.ci/deny

bench: setup ## Run the benchmarks
	$(CARGO) bench --locked

clean: ## Remove everything that was built or rendered
	$(CARGO) clean
	rm -rf out
