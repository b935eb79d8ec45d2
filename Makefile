# footpoint: `make help` lists the targets.
SCENE       ?=
RANKS       ?= 2
GENERATIONS ?= 200
SEED        ?= 1
CONFIG      ?= release
CXX         ?= g++
ifeq ($(origin CC),default)
CC  := gcc
CXX := g++
endif

MAKEFLAGS += --no-builtin-rules
.SUFFIXES:
.SECONDARY:
.DELETE_ON_ERROR:
.DEFAULT_GOAL := all

ifeq ($(V),1)
Q :=
else
Q := @
endif

ifeq ($(CONFIG),release)
BIN := build
else
BIN := build/$(CONFIG)/bin
endif
OBJ := build/$(CONFIG)

WARN := -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror
OPT_release := -O3 -DNDEBUG
OPT_debug   := -O0 -g
OPT_asan    := -O1 -g -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer
OPT_fma     := -O3 -mfma -ffp-contract=fast
# OPENMP=1: threads share the batches of the runtime library.
THREADS     := $(if $(filter 1,$(OPENMP)),-fopenmp)
CONTRACT    := -ffp-contract=off
ifeq ($(CONFIG),fma)
CONTRACT :=
endif
CFLAGS = -std=c11 -D_DEFAULT_SOURCE $(WARN) $(CONTRACT) $(OPT_$(CONFIG)) $(THREADS) $(EXTRA_CFLAGS)

# What each program is made of.  Files whose name ends in _main hold main(); MPI stops at evolve/.
codegen_lib := $(filter-out %_main.c,$(wildcard codegen/*.c))
evolve_mpi  := $(wildcard evolve/migrate*.c) $(addprefix evolve/evolve_,grow.c keeper.c loop.c resume.c run.c)
evolve_lib  := $(filter-out %_main.c $(evolve_mpi),$(wildcard evolve/*.c)) \
               $(addprefix runtime/,bezier.c gregory.c normals.c)
pga_mpi     := evolve/pga_main.c evolve/migrate.c
genome_lib  := codegen/base.c codegen/genome.c codegen/genome_parse.c codegen/segment.c
runtime_lib := $(wildcard runtime/*.c)
# Geometry of segments, which scenes are made of, too.
geometry    := $(filter-out runtime/quad4.c,$(wildcard runtime/quad*.c runtime/tri*.c))
test_main   := $(wildcard tests/test_*.c)
bench_parts := tests/bench_main.c $(addprefix tests/bench_,isa.c map.c measure.c tune.c)
test_lib    := $(filter-out $(test_main) tests/bench_%.c tests/headers_long.c %_main.c,$(wildcard tests/*.c))

# Instruction sets that the methods of the bench are compiled for; the bench takes the best that its machine has.
ISAS := $(if $(filter x86_64%,$(shell $(CC) -dumpmachine)),x86-64 x86-64-v3 x86-64-v4,portable)

object = $(patsubst %.c,$(OBJ)/%.o,$(1))
pkg     = $(shell pkg-config $(1) 2>/dev/null)
include_dirs = $(filter -I%,$(1))

# Vectorising a checked loop needs leave to compare without traps; no result changes.
CFLAGS_batch_lanes := -fno-math-errno -fno-trapping-math
# Costs of operations are those of optimised code, in any configuration.
CFLAGS_calibrate_main := -O3 -fno-math-errno -fno-trapping-math -fopenmp-simd

LIBS_codegen  = $(call pkg,--libs libmd) -lflint-arb -lflint -lmpfr -lgmp -lm
LIBS_calibrate = $(call pkg,--libs libmd) -lm
LIBS_evolve   = $(call pkg,--libs gsl libconfig libmd) -lm
LIBS_mpi      = $(call pkg,--libs ompi-c)
LIBS_test     = $(call pkg,--libs cmocka gsl libconfig libmd) -lflint-arb -lflint -lmpfr -lgmp -lm
CFLAGS_mpi    = $(call pkg,--cflags ompi-c)

$(OBJ)/%.o: %.c $(OBJ)/flags
	@mkdir -p $(@D)
	$(Q)$(CC) $(CFLAGS) $(CFLAGS_$(basename $(notdir $<))) -MMD -MP -c $< -o $@

$(call object,evolve/evolve_main.c evolve/pga_main.c $(evolve_mpi)): CFLAGS += $(CFLAGS_mpi)

# New flags rebuild everything.
$(OBJ)/flags: FORCE
	@mkdir -p $(@D)
	@echo '$(CC) $(CFLAGS)' | cmp -s - $@ || echo '$(CC) $(CFLAGS)' > $@
FORCE:

-include $(shell find $(OBJ) -name '*.d' 2>/dev/null)

# ---- programs and libraries -------------------------------------------------------------------------------------------

LIB := $(BIN)/libfootpoint
# The Fortran module in gfortran's own format, where there is one; other compilers take the source.
ifeq ($(origin FC),default)
FC := gfortran
endif
MODULE := $(if $(findstring gfortran,$(FC)),$(if $(shell command -v $(FC)),$(BIN)/footpoint.mod))
GENERATED := $(sort $(wildcard generated/*.h))
# Those in double, which the bench and its tests call.
DOUBLES := $(if $(GENERATED),$(shell grep -l '^ . precision: double' $(GENERATED)))

all: codegen runtime evolve calibrate-program bench-program ## build the tools and the runtime library
codegen: $(BIN)/footpoint-codegen
evolve: $(BIN)/footpoint-evolve $(BIN)/footpoint-pga $(BIN)/footpoint-perceptron
runtime: $(LIB).a $(LIB).so $(MODULE)
calibrate-program: $(BIN)/footpoint-calibrate
bench-program: $(BIN)/footpoint-bench

$(BIN)/footpoint-codegen: $(call object,codegen/codegen_main.c $(codegen_lib))
	@mkdir -p $(@D)
	$(Q)$(CC) $(CFLAGS) $^ -o $@ $(LIBS_codegen)

$(BIN)/footpoint-calibrate: $(call object,codegen/calibrate_main.c codegen/base.c)
	@mkdir -p $(@D)
	$(Q)$(CC) $(CFLAGS) $^ -o $@ $(LIBS_calibrate)

$(BIN)/footpoint-evolve: $(call object,evolve/evolve_main.c $(evolve_mpi) $(evolve_lib) $(genome_lib) $(geometry))
	@mkdir -p $(@D)
	$(Q)$(CC) $(CFLAGS) $^ -o $@ $(LIBS_mpi) $(LIBS_evolve)

$(BIN)/footpoint-pga: $(call object,$(pga_mpi) $(evolve_lib) $(genome_lib) $(geometry))
	@mkdir -p $(@D)
	$(Q)$(CC) $(CFLAGS) $^ -o $@ $(LIBS_mpi) $(LIBS_evolve)

$(BIN)/footpoint-perceptron: $(call object,evolve/perceptron_main.c $(evolve_lib) $(genome_lib) $(geometry))
	@mkdir -p $(@D)
	$(Q)$(CC) $(CFLAGS) $^ -o $@ $(LIBS_evolve)

$(BIN)/footpoint-bench: $(call object,$(bench_parts) $(test_lib) $(evolve_lib) $(genome_lib) $(geometry)) \
                        $(foreach isa,$(ISAS),$(OBJ)/tests/bench_methods-$(isa).o)
	@mkdir -p $(@D)
	$(Q)$(CC) $(CFLAGS) $^ -o $@ $(LIBS_evolve)

$(LIB).a: $(call object,$(runtime_lib))
	@mkdir -p $(@D) && rm -f $@
	$(Q)ar rcs $@ $^

# The number of the binary interface: raised when a program built before would no longer run.
ABI := 0
SONAME := libfootpoint.so.$(ABI)

$(LIB).so: $(patsubst %.c,$(OBJ)/pic/%.o,$(runtime_lib)) runtime/footpoint.map
	@mkdir -p $(@D)
	$(Q)$(CC) $(CFLAGS) -shared -Wl,-soname,$(SONAME) -Wl,--version-script,runtime/footpoint.map $(filter %.o,$^) -o $@ -lm
	@ln -sf libfootpoint.so $(@D)/$(SONAME)

$(BIN)/footpoint.mod: runtime/footpoint.f90
	@mkdir -p $(@D)
	$(Q)$(FC) -std=f2003 -Wall -Wextra -pedantic -Werror -fsyntax-only -J$(@D) $<
	@touch $@

$(OBJ)/pic/%.o: %.c $(OBJ)/flags
	@mkdir -p $(@D)
	$(Q)$(CC) $(CFLAGS) $(CFLAGS_$(basename $(notdir $<))) -fPIC -MMD -MP -c $< -o $@

# What the bench and the tests know of the generated headers is read from the headers: scene, function, operations.
$(OBJ)/methods.h: $(DOUBLES) Makefile
	@mkdir -p $(@D)
	$(Q)for h in $(DOUBLES); do echo "#include \"$$PWD/$$h\""; done > $@

$(OBJ)/methods.inc: $(DOUBLES) tests/methods.awk Makefile
	@mkdir -p $(@D)
	$(Q)awk -f tests/methods.awk $(DOUBLES) > $@

# The perceptrons that it compares with, trained by `make perceptrons`; no header of ours.
$(OBJ)/footpoint_perceptron.h: tests/paper/perceptron.gen $(BIN)/footpoint-codegen
	$(Q)$(BIN)/footpoint-codegen --allow-poles $< -o $@

$(OBJ)/footpoint_perceptron.inc: $(OBJ)/footpoint_perceptron.h tests/methods.awk
	$(Q)awk -f tests/methods.awk $< > $@

$(OBJ)/rival_counts.inc: tests/count_rivals.cpp $(wildcard tests/rivals*.h) tests/trust_region.h tests/pinball.h
	@mkdir -p $(@D)
	$(Q)$(CXX) -std=c++17 -O1 -Wall -Wextra $< -o $(OBJ)/count_rivals && $(OBJ)/count_rivals > $@

of_headers := $(addprefix $(OBJ)/tests/,test_headers.o test_digits.o headers_long.o)
$(of_headers): CFLAGS += -I$(OBJ)
$(of_headers): $(OBJ)/methods.h $(OBJ)/methods.inc

# The methods of the bench, as code that is built for its machine: once for each instruction set, all alike, and
# optimised in any configuration.
# Without signed zeros and not-a-numbers, minima and maxima are instructions.
FAST := -ffp-contract=fast -fno-math-errno -fno-trapping-math -fno-signed-zeros -ffinite-math-only
ISA_x86-64    := -march=x86-64
ISA_x86-64-v3 := -march=x86-64-v3
ISA_x86-64-v4 := -march=x86-64-v4 -mprefer-vector-width=512
isa_id = $(subst -,_,$(1))

$(OBJ)/tests/bench_methods-%.o: tests/bench_methods.c $(OBJ)/methods.h $(OBJ)/methods.inc $(OBJ)/rival_counts.inc \
                                $(OBJ)/footpoint_perceptron.h $(OBJ)/footpoint_perceptron.inc $(OBJ)/flags Makefile
	@mkdir -p $(@D)
	$(Q)$(CC) $(filter-out $(OPT_$(CONFIG)),$(CFLAGS)) $(OPT_release) $(FAST) $(ISA_$*) -I$(OBJ) \
	    -DBENCH_ISA=$(call isa_id,$*) -DBENCH_ISA_NAME='"$*"' \
	    -DBENCH_FLAGS='"$(strip $(OPT_release) $(FAST) $(ISA_$*))"' -MMD -MP -c $< -o $@

# ---- the main job -----------------------------------------------------------------------------------------------------

SCENES := $(patsubst evolve/scenes/%.scene,%,$(sort $(wildcard evolve/scenes/*.scene)))
MPIRUN ?= mpirun -q $(if $(filter 0,$(shell id -u)),--allow-run-as-root) --oversubscribe \
          --mca odls_base_sigkill_timeout 5 -n $(RANKS)

regenerate: codegen evolve ## evolve from the committed genomes, then emit the headers: SCENE= RANKS= GENERATIONS= SEED= FROM=scratch
	$(Q)for scene in $(or $(SCENE),$(SCENES)); do \
	    $(MPIRUN) $(BIN)/footpoint-evolve --scene $$scene --generations $(GENERATIONS) --seed $(SEED) \
	        $(if $(filter scratch,$(FROM)),--from-scratch) || exit $$?; \
	    name=$$(basename $$scene .scene); \
	    header=generated/footpoint_$$(echo $$name | tr - _).h; \
	    genomes=evolve/genomes/$$name.gen samples=; \
	    if grep -q '^note precision float' $$genomes; then \
	        samples="--samples $(BIN)/$$name.samples"; \
	        $(BIN)/footpoint-evolve --scene $$scene $$samples || exit $$?; \
	    fi; \
	    $(BIN)/footpoint-codegen --allow-poles $$samples $$genomes -o $$header || exit $$?; \
	    rm -f $(BIN)/$$name.samples; \
	    echo "$$header"; \
	done

# ---- tests ------------------------------------------------------------------------------------------------------------

TESTS := $(patsubst tests/%.c,$(BIN)/tests/%,$(test_main))

$(BIN)/tests/test_digits: $(OBJ)/tests/headers_long.o
$(BIN)/tests/%: $(OBJ)/tests/%.o $(call object,$(test_lib) $(evolve_lib) $(codegen_lib) $(runtime_lib))
	@mkdir -p $(@D)
	$(Q)$(CC) $(CFLAGS) $^ -o $@ $(LIBS_test)

JOBS ?= $(shell nproc)

build-tests: all $(TESTS)

check: ## run the tests (some minutes; JOBS= at a time)
	$(Q)$(MAKE) --no-print-directory $(if $(filter -j%,$(MAKEFLAGS)),,-j$(JOBS)) build-tests
	$(Q)JOBS=$(JOBS) BIN=$(BIN) CC=$(CC) CXX=$(CXX) tests/run.sh $(TESTS) tests/cli/*.sh

check-long: build-tests ## the tests and the long ones, one after the other
	$(Q)FOOTPOINT_LONG=1 JOBS=1 BIN=$(BIN) CC=$(CC) CXX=$(CXX) tests/run.sh $(TESTS) tests/cli/*.sh tests/long/*.sh

bench: bench-program ## speed against error of every method on held-out samples: SCENE=
	$(Q)$(BIN)/footpoint-bench $(if $(SCENE),--scene $(SCENE))

PERCEPTRONS := --scene paper-quad4 --hidden 8 --hidden 16 --hidden 16,16 --iterations 100

perceptrons: evolve ## train the perceptrons of the bench again, tests/paper/perceptron.gen
	$(Q)$(BIN)/footpoint-perceptron $(PERCEPTRONS) -o tests/paper/perceptron.gen

calibrate: calibrate-program ## measure this machine's operation costs, build/machine.costs
	$(Q)$(BIN)/footpoint-calibrate -o $(BIN)/machine.costs && cat $(BIN)/machine.costs

report: bench-program ## pictures of time against error, build/report/index.html
	$(Q)BIN=$(BIN) sh tests/report.sh build/report

paper: codegen evolve bench-program $(BIN)/tests/test_calibration ## the paper's tables and figures, build/paper/index.html (half an hour; goes on if interrupted): RANKS= FULL=1 (the paper's size)
	$(Q)BIN=$(BIN) RANKS=$(RANKS) MPIRUN='$(MPIRUN)' FULL=$(FULL) \
	    PERCEPTRONS='$(PERCEPTRONS)' sh tests/paper.sh build/paper

# ---- housekeeping -----------------------------------------------------------------------------------------------------

PACKAGES := gcc g++ clang make pkg-config libopenmpi-dev openmpi-bin libgsl-dev libflint-dev libflint-arb-dev libmpfr-dev libgmp-dev \
            libcmocka-dev libconfig-dev libmd-dev gnuplot-nox
# What `make check-long` compares with and fuzzes with; without them it skips those checks.
PACKAGES_LONG := form maxima python3-sympy gappa gfortran libclang-rt-14-dev libomp-14-dev valgrind cmake mandoc

deps-long: PACKAGES += $(PACKAGES_LONG)
deps deps-long: ## install the packages that are missing (Debian; deps-long: for check-long, too); needs no privileges when all are there
	$(Q)missing=; for p in $(PACKAGES); do \
	    dpkg-query -W -f '$${Status}' $$p 2>/dev/null | grep -q 'install ok installed' || missing="$$missing $$p"; \
	done; \
	if [ -n "$$missing" ]; then \
	    sudo=; [ "$$(id -u)" = 0 ] || sudo=sudo; \
	    $$sudo apt-get update -qq && DEBIAN_FRONTEND=noninteractive $$sudo apt-get install -y -qq $$missing; \
	fi

# ---- installation -----------------------------------------------------------------------------------------------------

PREFIX     ?= /usr/local
BINDIR     ?= $(PREFIX)/bin
LIBDIR     ?= $(PREFIX)/lib
INCLUDEDIR ?= $(PREFIX)/include
MANDIR     ?= $(PREFIX)/share/man
# Programs look for it in ../share/footpoint from where they are.
DATADIR    := $(BINDIR)/../share/footpoint

VERSION := $(shell sed -n 's/^.define FOOTPOINT_VERSION "\(.*\)"/\1/p' codegen/base.h)
# What C++ may include is meant for others.
PUBLIC  := $(shell grep -l 'extern "C"' runtime/*.h)
LIBRARY := runtime/footpoint.h runtime/footpoint_batch.h
PROGRAMS := $(addprefix $(BIN)/footpoint-,codegen calibrate evolve pga perceptron bench)
PAGES_1 := $(addprefix evolve/footpoint-,evolve.1 pga.1 perceptron.1) \
           $(addprefix codegen/footpoint-,codegen.1 calibrate.1) tests/footpoint-bench.1
PAGES_3 := runtime/footpoint.3
# Packages name their folders from their own, so that an installation may be staged and moved.
from = $$(realpath -m --relative-to=$(1) $(2))
fill = sed -e "s|@VERSION@|$(VERSION)|; s|@ABI@|$(ABI)|" -e "s|@PREFIX@|$(call from,$(1),$(PREFIX))|" \
    -e "s|@LIB@|$(call from,$(PREFIX),$(LIBDIR))|; s|@INCLUDE@|$(call from,$(PREFIX),$(INCLUDEDIR))|"
put = install -d $(DESTDIR)$(2) && install -m $(or $(3),644) $(1) $(DESTDIR)$(2)

install: runtime codegen evolve calibrate-program bench-program ## install everything: PREFIX= DESTDIR= BINDIR= LIBDIR= INCLUDEDIR=
	$(Q)$(call put,$(PROGRAMS),$(BINDIR),755)
	$(Q)$(call put,$(LIBRARY) $(MODULE),$(INCLUDEDIR))
	$(Q)$(call put,$(GENERATED) $(filter-out $(LIBRARY),$(PUBLIC)) runtime/footpoint.f90,$(INCLUDEDIR)/footpoint)
	$(Q)$(call put,$(LIB).a,$(LIBDIR))
	$(Q)install -m 644 $(LIB).so $(DESTDIR)$(LIBDIR)/libfootpoint.so.$(VERSION)
	$(Q)ln -sf libfootpoint.so.$(VERSION) $(DESTDIR)$(LIBDIR)/$(SONAME)
	$(Q)ln -sf $(SONAME) $(DESTDIR)$(LIBDIR)/libfootpoint.so
	$(Q)install -d $(DESTDIR)$(LIBDIR)/pkgconfig $(DESTDIR)$(LIBDIR)/cmake/footpoint
	$(Q)$(call fill,$(LIBDIR)/pkgconfig) runtime/footpoint.pc.in > $(DESTDIR)$(LIBDIR)/pkgconfig/footpoint.pc
	$(Q)for f in footpoint-config footpoint-config-version; do \
	    $(call fill,$(LIBDIR)/cmake/footpoint) runtime/$$f.cmake.in > $(DESTDIR)$(LIBDIR)/cmake/footpoint/$$f.cmake; \
	done
	$(Q)for d in frames scenes genomes; do $(call put,evolve/$$d/*,$(DATADIR)/evolve/$$d) || exit $$?; done
	$(Q)$(call put,tests/meshes/*.inp,$(DATADIR)/tests/meshes)
	$(Q)$(call put,$(PAGES_1),$(MANDIR)/man1)
	$(Q)$(call put,$(PAGES_3),$(MANDIR)/man3)

uninstall: ## remove what install put there: the same variables
	$(Q)rm -rf $(addprefix $(DESTDIR),$(INCLUDEDIR)/footpoint $(LIBDIR)/cmake/footpoint $(DATADIR)) \
	    $(addprefix $(DESTDIR)$(BINDIR)/,$(notdir $(PROGRAMS))) \
	    $(addprefix $(DESTDIR)$(INCLUDEDIR)/,$(notdir $(LIBRARY)) footpoint.mod) \
	    $(addprefix $(DESTDIR)$(LIBDIR)/libfootpoint.,a so so.$(ABI) so.$(VERSION)) \
	    $(DESTDIR)$(LIBDIR)/pkgconfig/footpoint.pc $(addprefix $(DESTDIR)$(MANDIR)/man1/,$(notdir $(PAGES_1))) \
	    $(addprefix $(DESTDIR)$(MANDIR)/man3/,$(notdir $(PAGES_3)))

clean: ## remove everything that was built
	rm -rf build

help: ## this list
	@awk -F ':.*## ' '/^[a-z -]+:.*## / { printf "  %-14s %s\n", $$1, $$2 }' $(firstword $(MAKEFILE_LIST))

.PHONY: all codegen evolve runtime calibrate-program bench-program regenerate check check-long bench calibrate report \
        perceptrons paper build-tests deps deps-long install uninstall clean help FORCE
