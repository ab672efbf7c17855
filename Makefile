# The everyday commands. Each works on a brand-new Debian 12 or Ubuntu 24.04 machine.
.DEFAULT_GOAL := help
.PHONY: help demo test python bench bench-prevention prevention-table bench-out-of-core bench-scale compare compare-python compare-spark test-spark check-exports docs format lint clean install install-lib

PREFIX ?= /usr/local

help: ## this list
	@echo "make demo     build beespace, check swarms of 1,000 and 1,000,000 bees, fly one, show them"
	@echo "make test     build everything and run all tests"
	@echo "make python   build the Python package in build/wheel, and install it in build/python"
	@echo "make bench    build and run the benchmarks"
	@echo "make bench-prevention  fly whole missions with and without advice (takes long)"
	@echo "make prevention-table  fly fleets that are not exact (takes long)"
	@echo "make bench-out-of-core  search 300 million points with 4 GB (needs 16 GB of disk)"
	@echo "make bench-scale  all figures of docs/benchmarks/scale.md: bench-out-of-core and compare-spark"
	@echo "make compare  compare with other libraries and the paper's methods (about 25 minutes)"
	@echo "make compare-python  compare the Python package with others (about 25 minutes)"
	@echo "make compare-spark  compare beespace.spark with other ways on a cluster of processes (about 15 minutes)"
	@echo "make test-spark  test beespace.spark on clusters of processes (about 8 minutes)"
	@echo "make check-exports  open exports with Cesium and the schemas of KML (fetches 60 MB from npm and PyPI)"
	@echo "make docs     build the site of the documents in build/docs/site"
	@echo "make format   format the sources with clang-format 14"
	@echo "make lint     format, include and header checks, clang-tidy"
	@echo "make install  install under PREFIX ($(PREFIX)); DESTDIR is honoured"
	@echo "make install-lib  the library alone, static and shared, without the command's packages"
	@echo "make clean    remove what was built"
	@echo "After make demo or make test the command is build/release/beespace."

demo:
	@scripts/install-packages build
	@scripts/demo

test:
	@scripts/install-packages build test
	@scripts/build release -DBEESPACE_BUILD_TESTS=ON
	@ctest --preset release --parallel "$$(nproc)"

python:
	@scripts/install-packages python
	@scripts/build-wheel

bench:
	@scripts/install-packages build bench
	@scripts/bench

bench-prevention:
	@scripts/install-packages build bench
	@scripts/build release -DBEESPACE_BUILD_BENCHMARKS=ON
	@build/release/prevention_missions

prevention-table:
	@scripts/install-packages build bench
	@scripts/build release -DBEESPACE_BUILD_BENCHMARKS=ON
	@build/release/prevention_table

bench-out-of-core:
	@scripts/install-packages build bench
	@scripts/build release -DBEESPACE_BUILD_BENCHMARKS=ON
	@build/release/out_of_core_benchmark
	@build/release/recording_out_of_core_benchmark

bench-scale: bench-out-of-core compare-spark

compare:
	@scripts/install-packages build compare
	@scripts/compare

compare-python:
	@scripts/install-packages build bench python
	@scripts/compare-python

compare-spark:
	@scripts/install-packages build spark
	@scripts/build-command beespace_c
	@scripts/compare-spark

test-spark:
	@scripts/install-packages build spark
	@scripts/build-command beespace_c beespace_c_io
	@scripts/test-spark

check-exports:
	@scripts/install-packages build test python
	@scripts/check-exports

docs:
	@scripts/install-packages build docs
	@scripts/build-docs
	@echo "The site: build/docs/site/index.html"

format:
	@scripts/install-packages ci
	@scripts/format

lint:
	@scripts/install-packages build test bench ci
	@scripts/lint

install:
	@scripts/install-packages build
	@scripts/build-command beespace_c beespace_c_io
	@cmake --install build/release --prefix "$(PREFIX)"

install-lib:
	@scripts/install-packages library
	@scripts/install-library "$(PREFIX)"

clean:
	rm -rf build demo
