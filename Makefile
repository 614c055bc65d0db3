# Daily work. `./bootstrap` is for machines that have nothing installed yet.
JOBS ?= $(shell nproc)
# Tests wait for programs and clocks for a third of their time.
TEST_JOBS ?= $(shell echo $$(($$(nproc) + 1)))
FUZZ_SECONDS ?= 60
CHAOS_SEEDS ?= 20
CHAOS_SEED ?=
LINT_BASE ?= main
PREFIX ?= /usr/local
CXX_FILES = git ls-files --cached --others --exclude-standard -- '*.h' '*.cpp'

# Libraries that parse untrusted input (logs, protocol, JSON and TOML files, replies) or start programs.
INPUT_TESTS = cls_base_tests cls_soccer_tests cls_gamelog_tests cls_analysis_tests \
  cls_mock_server_tests cls_process_tests
INPUT_LABELS = ^(base|soccer|gamelog|analysis|mock-server|process)$$
FUZZERS = protocol rcg rcl session view agent compression user_file training table

.PHONY: help build test slow-test full languages web-test playground npm site pictures bench asan tsan asan-input fuzz chaos same-bytes install package wheel dist format format-check lint clean

help:
	@echo 'make build         release build in build/'
	@echo 'make test          build, run the tests for daily work'
	@echo 'make slow-test     the short forms of the slow suites; ./bootstrap test runs both'
	@echo 'make full          long forms: 20 whole matches, packages, all tests under ASan, UBSan and TSan'
	@echo 'make languages     teams and projects of every language at length: all templates, the tutorial'
	@echo 'make web-test      the replay page in Chromium (needs node 18, npm, chromium)'
	@echo 'make playground    the engine for browsers and Node, and its page, in build-playground/ (needs emscripten)'
	@echo 'make npm           the npm package cls-match, in build-playground/ (needs node, npm)'
	@echo 'make site          the documentation as a site with search, in build/site/ (needs mkdocs)'
	@echo 'make pictures      every picture of README and docs (after make web-test)'
	@echo 'make bench         benchmarks and matches, beside CLS_BENCH_BASE if set (libbenchmark-dev)'
	@echo 'make asan | tsan   all tests under ASan and UBSan, or TSan, in build-asan/ or build-tsan/'
	@echo 'make asan-input    the same for libraries that read untrusted input (Clang, build-fuzz/)'
	@echo 'make fuzz          each fuzzer for FUZZ_SECONDS, default 60 (Clang, build-fuzz/)'
	@echo 'make chaos         CHAOS_SEEDS tournaments under faults, default 20, or the one of CHAOS_SEED'
	@echo 'make same-bytes    play matches with the builds of GCC, Clang and portable math, compare the logs'
	@echo 'make install       everything below PREFIX, default /usr/local (DESTDIR too)'
	@echo 'make package       the one-file program and the Debian package, in build/dist/'
	@echo 'make wheel         the Python packages cls_gym and cls_playmaker for pip, in build/wheels/'
	@echo 'make dist          all that users without a compiler need: the package, the file, the wheels, SHA256SUMS'
	@echo 'make format        clang-format all sources; format-check only compares'
	@echo 'make lint          clang-tidy on sources that differ from LINT_BASE, default main'
	@echo 'make clean         remove all build folders'

build/build.ninja:
	cmake --preset release

build: build/build.ninja
	@cmake --build --preset release -j $(JOBS)

# A folder that `./bootstrap match` configured has no tests yet.
test: build/build.ninja
	@grep -q '^BUILD_TESTING:BOOL=ON' build/CMakeCache.txt || cmake --preset release -DBUILD_TESTING=ON
	@cmake --build --preset release -j $(JOBS)
	@ctest --test-dir build -j $(TEST_JOBS) -LE '[.]slow$$' --output-on-failure

slow-test: build/build.ninja
	@cmake --build --preset release -j $(JOBS)
	@ctest --test-dir build -j $(TEST_JOBS) -L '[.]slow$$' --output-on-failure

full: test slow-test
	@CLS_FULL=1 ctest --test-dir build -L '^(matches[.]slow|packaging)$$' -V
	@CLS_FULL=1 build/bin/cls_soccer_tests --gtest_filter='PortableMath.*'
	@$(MAKE) --no-print-directory asan
	@$(MAKE) --no-print-directory tsan

languages: test
	@CLS_LANGUAGES=1 ctest --test-dir build -R Languages -V

# Exit code 77: skipped, the generator is missing.
site:
	@packaging/site/build.py build/site || test $$? -eq 77

pictures: build
	docs/pictures/make

web-test:
	@tests/viewer/web/run
	@CLS_NEED_BROWSER=1 tests/viewer/browser/run
	@tests/playground/browser/run $(CURDIR)/build/bin/cls $(CURDIR)/build-playground/page || test $$? -eq 77

# Quarter of an hour on two cores; later only what has changed.
playground:
	@playground/build -j $(JOBS)

npm: playground
	@playground/pack

bench:
	@cmake --preset release -DCLS_BUILD_BENCH=ON
	@cmake --build --preset release -j $(JOBS) --target cls cls_bench cls_python_package cls_training_shared
	@build/bin/cls_bench --benchmark_filter=-rpc_ceiling
	@bench/training.py
	@bench/commands.py
	@bench/matches.py
	@if command -v node >/dev/null; then bench/engine.mjs; bench/page.mjs; fi

asan tsan:
	@cmake --preset $@
	@cmake --build --preset $@ -j $(JOBS)
	@ctest --test-dir build-$@ -j $(TEST_JOBS) --output-on-failure

asan-input:
	@cmake --preset fuzz
	@cmake --build --preset fuzz -j $(JOBS) --target $(INPUT_TESTS)
	@ctest --test-dir build-fuzz -j $(TEST_JOBS) -L '$(INPUT_LABELS)' --output-on-failure

fuzz:
	@cmake --preset fuzz
	@cmake --build --preset fuzz -j $(JOBS) --target $(FUZZERS:%=%_fuzz)
	@printf '%s\n' $(FUZZERS) | xargs -P $(TEST_JOBS) -I NAME tests/fuzz/run NAME $(FUZZ_SECONDS)

chaos: build
	@tests/chaos/run --seeds $(CHAOS_SEEDS) $(if $(CHAOS_SEED),--seed $(CHAOS_SEED))

# -O2 of GCC, with SLEEF and without, against -O1 of Clang, which also runs whole matches under ASan
# and UBSan.
same-bytes: build
	@cmake --build --preset release -j $(JOBS) --target cls_portable_math
	@cmake --preset fuzz
	@cmake --build --preset fuzz -j $(JOBS) --target cls
	@tests/same_bytes build/bin/cls build/bin/cls_portable_math build-fuzz/bin/cls

install: build/build.ninja
	@cmake --build --preset release -j $(JOBS) \
	  --target cls cls_manual cls_python_package cls_training_shared
	@cmake --install build --prefix $(PREFIX)

package: build/build.ninja
	@cmake --build --preset release -j $(JOBS) \
	  --target cls cls_manual cls_python_package cls_training_shared
	@packaging/build.py

wheel: build/build.ninja
	@cmake --build --preset release -j $(JOBS) --target cls_python_package cls_training_shared
	@packaging/build.py --wheels

dist: build/build.ninja
	@cmake --build --preset release -j $(JOBS) \
	  --target cls cls_manual cls_python_package cls_training_shared
	@packaging/build.py --all

format:
	@files=$$($(CXX_FILES)) && clang-format -i $$files

format-check:
	@files=$$($(CXX_FILES)) && clang-format --dry-run -Werror $$files

# Each file as it is, so that missing includes are found. Benchmarks are not configured here.
lint:
	@cmake --preset lint >/dev/null
	@cmake --build --preset lint -j $(JOBS) --target cls_proto_generated
	@files=$$(git diff --name-only --diff-filter=d $$(git merge-base HEAD $(LINT_BASE)) -- '*.cpp' ':!bench') && \
	  if [ -n "$$files" ]; then printf '%s\n' $$files | \
	    xargs -P $(JOBS) -n 1 clang-tidy -p build-lint --quiet; fi

clean:
	rm -rf build build-debug build-asan build-tsan build-fuzz build-lint build-playground
