# Daily work; `./bootstrap` is for machines that have nothing yet.
JOBS ?= $(shell nproc)
TEST_JOBS ?= 2
CXX_FILES = git ls-files --cached --others --exclude-standard -- '*.h' '*.cpp'

.PHONY: help build test full bench asan tsan format format-check lint clean

help:
	@echo 'make build         release build in build/'
	@echo 'make test          build, then all tests'
	@echo 'make full          whole matches: 20 of 6000 cycles, and one twice'
	@echo 'make bench         how fast the parts are'
	@echo 'make asan | tsan   the same tests with sanitizers, in build-asan/ or build-tsan/'
	@echo 'make format        clang-format every source; format-check only looks'
	@echo 'make lint          clang-tidy on the sources that differ from main'
	@echo 'make clean         remove all build folders'

build/build.ninja:
	cmake --preset release

build: build/build.ninja
	@cmake --build --preset release -j $(JOBS)

test: build
	@ctest --test-dir build -j $(TEST_JOBS) --output-on-failure

full: build
	@CLS_FULL=1 ctest --test-dir build -L '^matches$$' -V

bench: build
	@build/bin/cls_bench

asan tsan:
	@cmake --preset $@
	@cmake --build --preset $@ -j $(JOBS)
	@ctest --test-dir build-$@ -j $(TEST_JOBS) --output-on-failure

format:
	@files=$$($(CXX_FILES)) && clang-format -i $$files

format-check:
	@files=$$($(CXX_FILES)) && clang-format --dry-run -Werror $$files

lint: build
	@files=$$(git diff --name-only --diff-filter=d $$(git merge-base HEAD main) -- '*.cpp') && \
	  if [ -n "$$files" ]; then clang-tidy -p build --quiet $$files; fi

clean:
	rm -rf build build-debug build-asan build-tsan
