# footpoint: `make help` lists the targets.
SCENE       ?=
RANKS       ?= 2
# A scene given by its path is somebody's own, a few minutes on two processors.
is_own = $(if $(filter evolve/scenes/%,$(1)),,$(if $(findstring /,$(1))$(filter %.scene,$(1)),$(1)))
# All scenes at once are measured and emitted rather than bred: less than five minutes on two processors.
GENERATIONS ?= $(if $(SCENE),$(if $(call is_own,$(SCENE)),40,100),1)
ISLANDS     ?= $(if $(SCENE),2,1)
SEED        ?= 1
CONFIG      ?= release
CXX         ?= g++
ifeq ($(origin CC),default)
CC  := $(if $(shell command -v gcc 2> /dev/null),gcc,cc)
CXX := g++
endif

MAKEFLAGS += --no-builtin-rules
# All processors, unless the caller gives -j, or several goals of which some do more than build: these follow one another.
ACTIONS := clean check check-long regenerate front bench bench-record figures calibrate perceptrons report rivals queries paper install \
           install-runtime \
           uninstall dist abi
goals   := $(filter-out deps%,$(MAKECMDGOALS))
given_j := $(filter -j% --jobs%,$(MAKEFLAGS) $(shell echo "$$MAKEFLAGS"))
ifeq ($(MAKELEVEL)$(given_j)$(and $(word 2,$(goals)),$(filter $(ACTIONS),$(goals))),0)
MAKEFLAGS += -j$(or $(JOBS),$(shell nproc))
endif
.SUFFIXES:
.SECONDARY:
.DELETE_ON_ERROR:
.DEFAULT_GOAL := all

# ---- what is given, checked before anything is built ------------------------------------------------------------------

CONFIGS := release debug asan fma
one_of   = $(if $(filter 1,$(words $($(1)))),$(filter $(2),$($(1))))
upper    = $(subst 5,,$(subst 6,,$(subst 7,,$(subst 8,,$(subst 9,,$(1))))))
lower    = $(subst 0,,$(subst 1,,$(subst 2,,$(subst 3,,$(subst 4,,$(1))))))
whole    = $(if $(filter 1,$(words $($(1)))),$(if $(call lower,$(call upper,$($(1)))),,yes))
positive = $(if $(call whole,$(1)),$(subst 0,,$($(1))))
demand   = $(if $(2),,$(error $(1)=$($(1)): $(3)))

$(call demand,CONFIG,$(call one_of,CONFIG,$(CONFIGS)),not a configuration; there are $(CONFIGS))
$(call demand,RANKS,$(call positive,RANKS),not a number of ranks)
$(call demand,GENERATIONS,$(call whole,GENERATIONS),not a number of generations)
$(call demand,SEED,$(call whole,SEED),not a whole number)
scene_file = $(if $(findstring /,$(1))$(filter %.scene,$(1)),$(1),evolve/scenes/$(1).scene)
$(foreach scene,$(SCENE),$(call demand,SCENE,$(wildcard $(call scene_file,$(scene))),there is no $(call scene_file,$(scene))))
ifneq ($(JOBS),)
$(call demand,JOBS,$(call positive,JOBS),not a number of jobs)
endif
ifneq ($(FROM),)
$(call demand,FROM,$(call one_of,FROM,scratch),scratch or nothing)
endif
# The folder for the files of a scene that is given by its path: OUT of the command line, or the scene's own.
out := $(if $(filter command,$(firstword $(origin OUT))),$(OUT))
ifneq ($(OPENMP),)
$(call demand,OPENMP,$(call one_of,OPENMP,0 1),0 or 1)
endif

# What is made is told on stderr in a few words, by `$(call say,CC,file)`; V=1 shows commands, -s neither.
ifeq ($(V),1)
Q :=
else
Q := @
say = $(if $(findstring s,$(firstword -$(MAKEFLAGS))),,@printf '  %-4s %s\n' '$(1)' '$(2)' >&2)
endif

ifeq ($(CONFIG),release)
BIN := build
else
BIN := build/$(CONFIG)/bin
endif
OBJ := build/$(CONFIG)

WARN := -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror
OPT_release := -O3 -DNDEBUG
TOOL_OPT_release := -O2
TEST_OPT_release := -O1
TOOL_OPT_fma := -O2
TEST_OPT_fma := -O1
OPT_debug   := -O0 -g
# Loops of headers take minutes to compile under the sanitizers if they are optimised.
TEST_OPT_asan := -O0
LIBRARY_OPT_asan := -O0
OPT_asan    := -O1 -g -fsanitize=address,undefined -fno-sanitize-recover=all -fno-omit-frame-pointer
OPT_fma     := -O3 -mfma -ffp-contract=fast
# OPENMP=1: threads share the batches of the runtime library.
THREADS     := $(if $(filter 1,$(OPENMP)),-fopenmp)
CONTRACT    := -ffp-contract=off
ifeq ($(CONFIG),fma)
CONTRACT :=
endif
CFLAGS = -std=c11 -D_DEFAULT_SOURCE $(WARN) $(CONTRACT) $(OPT_$(CONFIG)) $(THREADS) $(EXTRA_CFLAGS)

# What the programs are made of, by room: archives, of which the linker takes what a program needs.  Files whose name ends
# in _main hold main().
sources      = $(filter-out %_main.c,$(foreach room,$(1),$(wildcard $(room)/*.c)))
codegen_lib := $(call sources,codegen codegen/* codegen/*/*)
evolve_lib  := $(call sources,evolve/*)
evolve_mpi  := $(call sources,evolve/mpi evolve/run) evolve/evolve_main.c tests/paper/rivals/pga_main.c
ccx_lib     := $(call sources,runtime/calculix)
runtime_lib := $(filter-out $(ccx_lib) runtime/replace/%,$(call sources,runtime/*))
test_main   := $(wildcard tests/*/test_*.c tests/*/*/test_*.c)
test_lib    := $(filter-out $(test_main),$(call sources,tests/support tests/rivals))
paper_lib   := $(filter-out $(test_main),$(call sources,tests/paper/rivals))
bench_isa   := bench_methods bench_calls
bench_lib   := $(filter-out tests/bench/bench_gregory.c $(bench_isa:%=tests/bench/%.c),$(call sources,tests/bench))

# Instruction sets that the methods of the bench are compiled for: this machine's, or those that ISAS= names, of which the
# bench uses the best that its machine has.
ALL_ISAS := $(if $(filter x86_64%,$(shell $(CC) -dumpmachine 2> /dev/null)),x86-64 x86-64-v3 x86-64-v4,portable)
best_isa  = $(if $(filter __AVX512VL__,$(1)),x86-64-v4,$(if $(filter __AVX2__,$(1)),x86-64-v3,x86-64))
ifndef ISAS
ISAS := $(or $(filter portable,$(ALL_ISAS)),$(call best_isa,$(shell $(CC) -march=native -dM -E -x c /dev/null)))
endif
$(call demand,ISAS,$(if $(filter-out $(ALL_ISAS) quick,$(ISAS)),,$(ISAS)),not instruction sets of the bench; there are $(ALL_ISAS))

object = $(patsubst %.c,$(OBJ)/%.o,$(1))
isa_parts = $(foreach part,$(bench_isa),$(ISAS:%=$(OBJ)/tests/bench/$(part)-%.o))
pkg     = $(shell pkg-config $(1) 2>/dev/null)
# $(call once,NAME,VALUE): the value of a variable that is computed if it is needed, and only then.
once    = $(eval $(1) := $(2))$($(1))
include_dirs = $(filter -I%,$(1))

# Vectorising a checked loop needs leave to compare without traps; no result changes.
CFLAGS_batch_lanes := -fno-math-errno -fno-trapping-math
$(foreach kind,tri3 tri6 quad4 quad8 quad9 edge2 edge3,$(eval CFLAGS_face_$(kind) := $(CFLAGS_batch_lanes)))
$(foreach kind,bezier gregory,$(eval CFLAGS_patch_$(kind) := $(CFLAGS_batch_lanes)))
# Square roots are instructions.
CFLAGS_fit_lines := -fno-math-errno
# Protected quotients become vectors; a loop over a block ends without a wrong guess.
CFLAGS_lines_run := -fno-trapping-math -funroll-loops
# Costs of operations are those of optimised code, in any configuration.
CFLAGS_calibrate_main := -O3 -fno-math-errno -fno-trapping-math -fopenmp-simd

LIBS_codegen  = $(call pkg,--libs libmd) -lflint-arb -lflint -lmpfr -lgmp -lm
LIBS_calibrate = $(call pkg,--libs libmd) -lm
LIBS_evolve   = $(call pkg,--libs gsl libconfig libmd) -lm
LIBS_mpi      = $(call pkg,--libs ompi-c)
# There are a hundred tests to link, which gold does in a third of the time.
LIBS_test     = $(call once,LIBS_test,$(if $(shell command -v ld.gold),-fuse-ld=gold) $(call pkg,--libs cmocka gsl libconfig libmd) \
                -lflint-arb -lflint -lmpfr -lgmp -lm)
CFLAGS_mpi    = $(call once,CFLAGS_mpi,$(call pkg,--cflags ompi-c))

$(OBJ)/%.o: %.c $(OBJ)/flags
	@mkdir -p $(@D)
	$(call say,CC,$<)
	$(Q)$(CC) $(CFLAGS) $(CFLAGS_$(basename $(notdir $<))) -MMD -MP -c $< -o $@

$(call object,$(evolve_mpi)): private CFLAGS += $(CFLAGS_mpi)
# Only evaluation and fits gain by more: the rest is built in two thirds of the time.
$(call object,$(filter-out evolve/eval/% evolve/fit/% %/evaluate_lanes.c %/sampled_errors.c,$(codegen_lib) $(evolve_lib))): private CFLAGS += $(TOOL_OPT_$(CONFIG))
# One object for the archive and the shared library.
$(call object,$(runtime_lib)): private CFLAGS += -fPIC -fno-semantic-interposition $(LIBRARY_OPT_$(CONFIG))
# Proofs need sums and quotients as they stand. certain/ieee.h refuses flags that compilers announce; clang hides these.
$(call object,$(filter runtime/certain/%,$(runtime_lib)) $(ccx_lib)): private CFLAGS += -fno-associative-math -fno-reciprocal-math
# Tests call what is optimised; they themselves need not be.
$(call object,$(test_main)): private CFLAGS += $(TEST_OPT_$(CONFIG))

# $(call line,FILE,VARIABLE,CHECK): a file that contains the value of a variable, out of date if it contains another.
define line
ifneq ($$(file < $(1)),$$(strip $$($(2))))
$(1): FORCE
endif
$(1):
	$(Q)mkdir -p $$(@D)$(if $(3), && $(3)) && echo '$$(strip $$($(2)))' > $$@
endef
FORCE:

# Templates of headers, as a table that codegen is compiled with.
CFLAGS_templates := -I$(OBJ)
$(foreach test,closest curved edges tri3,$(eval CFLAGS_test_single_$(test) := -I$(OBJ)/float))
$(OBJ)/codegen/print/templates.o: $(OBJ)/templates.inc
$(OBJ)/templates.inc: codegen/print/templates.awk $(wildcard codegen/print/templates/*.h codegen/print/templates/*/*.h)
	@mkdir -p $(@D)
	$(call say,GEN,$@)
	$(Q)awk -f $< $(filter %.h,$^) > $@

# New flags rebuild everything, if the compiler takes them.
flags = $(CC) $(CFLAGS)
$(eval $(call line,$(OBJ)/flags,flags,echo 'int footpoint;' | $$(flags) -fsyntax-only -x c -))
$(OBJ)/flags check check-long: | $(filter deps%,$(MAKECMDGOALS))

-include $(wildcard $(addprefix $(OBJ)/,*/*.d */*/*.d */*/*/*.d))

# ---- programs and libraries -------------------------------------------------------------------------------------------

LIB := $(BIN)/libfootpoint
# The Fortran module in gfortran's own format, where there is one; other compilers take the source.
ifeq ($(origin FC),default)
FC := gfortran
endif
MODULE := $(if $(findstring gfortran,$(FC)),$(if $(shell command -v $(FC) 2> /dev/null),$(BIN)/footpoint.mod))

# The scenes and frames that footpoint comes with; those of one's own, beside them, are neither installed nor measured.
SHIPPED := bezier blocks-quad4 bricks-quad4 gregory paper-gregory paper-quad4 parallelogram-quad4 plane-quad4 punch-quad4 \
           quad4 quad4-float quad8 quad9 rectangle-quad4 tri3 tri6 whole-quad4
FRAMES  := affine bezier gregory parallelogram plane quad8 quad9 similarity similarity_gregory steps tri3 tri6
header_of = generated/footpoint_$(subst -,_,$(1)).h
GENERATED := $(foreach scene,$(SHIPPED),$(call header_of,$(scene)))
# Templates of C++, a header for each kind of face, which `make install` takes if they have been made.
GENERIC := $(patsubst %,build/c++/footpoint_%.hpp,quad4 quad8 quad9 tri3 tri6)
# Single precision of kinds beside quad4.
SINGLES := $(patsubst %,build/float/footpoint_%_float.h,edge2 edge3 quad8 quad9 tri3 tri6)
# Derivatives at a foot point, by kind of face and patch.
FACES   := bezier gregory quad4 quad8 quad9 tri3 tri6
DERIVATIVES := $(FACES:%=generated/footpoint_%_derivatives.h)
# Edges, for contact in the plane: templates, nothing is evolved.
EDGES   := edge2 edge3
PLANE   := $(EDGES:%=generated/footpoint_%.h)
# Those in double, and one's own where SCENE names it, are what the bench and its tests call.
beside  = $(or $(out),$(patsubst %/,%,$(dir $(1))))/$(notdir $(call header_of,$(basename $(notdir $(1)))))
header_for = $(if $(call is_own,$(1)),$(call beside,$(1)),$(call header_of,$(basename $(notdir $(1)))))
METHODS := $(wildcard $(sort $(GENERATED) $(foreach scene,$(SCENE),$(call header_for,$(scene)))))
DOUBLES := $(if $(METHODS),$(shell awk '/^ . precision: / { if (/double/) print FILENAME; nextfile }' $(METHODS)))

all: codegen runtime evolve calibrate-program ## build the tools and the runtime library
codegen: $(BIN)/footpoint-codegen
evolve: $(BIN)/footpoint-evolve
runtime: $(LIB).a $(LIB)_ccx.a $(LIB).so $(MODULE) ## build the runtime library alone
calibrate-program: $(BIN)/footpoint-calibrate
bench-program: $(BIN)/footpoint-bench ## build the bench: ISAS= of x86-64 x86-64-v3 x86-64-v4, else this machine's
paper-programs: $(BIN)/footpoint-pga $(BIN)/footpoint-perceptron

$(OBJ)/codegen.a: $(call object,$(codegen_lib))
$(OBJ)/evolve.a: $(call object,$(evolve_lib))
$(OBJ)/support.a: $(call object,$(test_lib))
$(OBJ)/paper.a: $(call object,$(paper_lib))
$(LIB).a: $(call object,$(runtime_lib))
# The search for CalculiX, by the name that CalculiX gives it: for nobody else's programs.
$(LIB)_ccx.a: $(call object,$(ccx_lib))
$(addprefix $(OBJ)/,codegen.a evolve.a support.a paper.a) $(LIB).a $(LIB)_ccx.a: Makefile
	@mkdir -p $(@D) && rm -f $@
	$(call say,AR,$@)
	$(Q)$(AR) rcs $@ $(filter %.o,$^)

evolve_parts := $(OBJ)/evolve.a $(OBJ)/codegen.a $(LIB).a
link = $(CC) $(CFLAGS) $(filter %.o,$^) $(filter %.a,$^) -o $@

$(BIN)/footpoint-codegen: $(call object,codegen/codegen_main.c) $(OBJ)/codegen.a
	@mkdir -p $(@D)
	$(call say,LD,$@)
	$(Q)$(link) $(LIBS_codegen)

$(BIN)/footpoint-calibrate: $(call object,codegen/calibrate_main.c) $(OBJ)/codegen.a
	@mkdir -p $(@D)
	$(call say,LD,$@)
	$(Q)$(link) $(LIBS_calibrate)

$(BIN)/footpoint-evolve: $(call object,evolve/evolve_main.c) $(evolve_parts)
	@mkdir -p $(@D)
	$(call say,LD,$@)
	$(Q)$(link) $(LIBS_mpi) $(LIBS_evolve)

$(BIN)/footpoint-pga: $(call object,tests/paper/rivals/pga_main.c) $(OBJ)/paper.a $(evolve_parts)
	@mkdir -p $(@D)
	$(call say,LD,$@)
	$(Q)$(link) $(LIBS_mpi) $(LIBS_evolve)

$(BIN)/footpoint-perceptron: $(call object,tests/paper/rivals/perceptron_main.c) $(OBJ)/paper.a $(evolve_parts)
	@mkdir -p $(@D)
	$(call say,LD,$@)
	$(Q)$(link) $(LIBS_evolve)

$(BIN)/footpoint-bench: $(call object,tests/bench/bench_main.c $(bench_lib)) \
                        $(isa_parts) $(OBJ)/isas $(OBJ)/support.a $(LIB)_ccx.a $(evolve_parts)
	@mkdir -p $(@D)
	$(call say,LD,$@)
	$(Q)$(link) $(LIBS_evolve)

# The number of the binary interface: raised when a program built before would no longer run.
ABI := $(shell sed -n 's/^FOOTPOINT_\([0-9]*\) {/\1/p' runtime/package/footpoint.map)
SONAME := libfootpoint.so.$(ABI)

$(LIB).so: $(call object,$(runtime_lib)) runtime/package/footpoint.map
	@mkdir -p $(@D)
	$(call say,LD,$@)
	$(Q)$(CC) $(CFLAGS) -shared -Wl,-soname,$(SONAME) -Wl,--version-script,runtime/package/footpoint.map $(filter %.o,$^) -o $@ -lm
	@ln -sf libfootpoint.so $(@D)/$(SONAME)

$(BIN)/footpoint.mod: runtime/package/footpoint.f90
	@mkdir -p $(@D)
	$(call say,FC,$<)
	$(Q)$(FC) -std=f2003 -Wall -Wextra -pedantic -Werror -fsyntax-only -J$(@D) $<
	@touch $@

$(eval $(call line,$(OBJ)/isas,ISAS))

c++: $(GENERIC) ## the searches as function templates for numbers of any type, build/c++/ (minutes)
build/c++/footpoint_%.hpp: evolve/genomes/%.gen $(BIN)/footpoint-codegen
	@mkdir -p $(@D)
	$(call say,GEN,$@)
	$(Q)$(BIN)/footpoint-codegen --quiet --allow-poles --language c++ $< -o $@

float: $(SINGLES) ## headers in single precision beside quad4's, build/float/ (minutes)
build/float/footpoint_edge%_float.h $(OBJ)/float/footpoint_edge%_float.h: $(BIN)/footpoint-codegen
	@mkdir -p $(@D)
	$(call say,GEN,$@)
	$(Q)$< --quiet --edge edge$* --precision float -o $@

# Tiers that promise more than single precision reaches are left out.
build/float/footpoint_%_float.h: evolve/genomes/%.gen $(BIN)/footpoint-codegen $(BIN)/footpoint-evolve
	@mkdir -p $(@D)
	$(call say,GEN,$@)
	$(Q)awk '/^genome / { out = $$2 ~ /^(precise|accurate|sharp|full)$$/ } !out' $< > $(@:.h=.gen)
	$(Q)$(BIN)/footpoint-evolve --scene evolve/scenes/$*.scene --start $(@:.h=.gen) --samples $(@:.h=.samples)
	$(Q)$(BIN)/footpoint-codegen --quiet --allow-poles --precision float --samples $(@:.h=.samples) $(@:.h=.gen) -o $@
	$(Q)rm -f $(@:.h=.gen) $(@:.h=.samples)

# For tests of promises, which go by the tier's name: the first program under several names, quickly made.
$(OBJ)/float/footpoint_%_float.h: evolve/genomes/%.gen $(BIN)/footpoint-codegen
	@mkdir -p $(@D)
	$(call say,GEN,$@)
	$(Q)awk -f tests/single/tiers.awk $< > $(@:.h=.gen)
	$(Q)$(BIN)/footpoint-codegen --quiet --allow-poles --effort 0 --precision float $(@:.h=.gen) -o $@

# What the bench and the tests know of the generated headers is read from the headers: scene, function, operations.
$(eval $(call line,$(OBJ)/methods,DOUBLES))

$(OBJ)/methods.h: $(DOUBLES) $(OBJ)/methods Makefile
	$(Q)for h in $(abspath $(DOUBLES)); do echo "#include \"$$h\""; done > $@

$(OBJ)/methods.inc: $(DOUBLES) $(OBJ)/methods tests/bench/methods.awk Makefile
	$(Q)awk -f tests/bench/methods.awk $(DOUBLES) > $@

# What callers get is measured of the headers named as their kinds, of the exact ones, and of one's own.
CALLED := $(filter-out $(foreach scene,$(filter blocks-% bricks-% paper-% punch-% whole-%,$(SHIPPED)),$(call header_of,$(scene))),$(DOUBLES))

$(OBJ)/calls.h: $(CALLED) $(OBJ)/methods Makefile
	$(Q)for h in $(abspath $(CALLED) $(DERIVATIVES)); do echo "#include \"$$h\""; done > $@

$(OBJ)/calls.inc: $(CALLED) $(OBJ)/methods tests/bench/calls.awk Makefile
	$(Q)awk -f tests/bench/calls.awk $(CALLED) > $@

# The perceptrons that it compares with, trained by `make perceptrons`; no header of ours.  A search for cheaper forms
# finds none.  tests/cli/bench.sh compares the text with what codegen writes.
emit_perceptrons = $(BIN)/footpoint-codegen --allow-poles --effort 0 --quiet tests/paper/perceptron.gen \
                   -o tests/bench/footpoint_perceptron.h

$(OBJ)/footpoint_perceptron.inc: tests/bench/footpoint_perceptron.h tests/bench/methods.awk
	@mkdir -p $(@D)
	$(Q)awk -f tests/bench/methods.awk $< > $@

$(OBJ)/rival_counts.inc: tests/rivals/count_rivals.cpp $(wildcard tests/rivals/rivals*.h) tests/rivals/trust_region.h tests/rivals/pinball.h
	@mkdir -p $(@D)
	$(call say,CXX,$<)
	$(Q)$(CXX) -std=c++17 -O0 -Wall -Wextra $< -o $(OBJ)/count_rivals && $(OBJ)/count_rivals > $@

# The headers' functions for the tests, all of them in one file each: no optimisation changes a result of theirs, but for
# fused multiply-add, which takes one.
of_headers := test_headers test_digits test_promise test_promise_curved test_promise_patches header_functions headers_long
$(foreach file,$(of_headers),$(eval CFLAGS_$(file) := -I$(OBJ)))
# Without optimisation even functions that nobody calls are compiled, if they are not inline.
CALLED_ALONE := $(patsubst %,-DFOOTPOINT_%=FOOTPOINT_FN,LOOP APART COLD)
unoptimised := $(patsubst %,test_%,along_gradients along_hessian batch closest closest_curved closest_patches closest_promise curved exceptions \
               face_sides float from from_patches joined patch_place place place_arrays promise_float promise_tri3 sides)
HEADERS_OPT := $(if $(filter fma,$(CONFIG)),-O1,-O0)
called_alone = $(if $(filter -O0,$(HEADERS_OPT)),$(CALLED_ALONE))
$(foreach file,header_functions headers_long $(unoptimised),$(eval CFLAGS_$(file) += $(HEADERS_OPT) $(called_alone)))
$(foreach test,closest curved,$(eval CFLAGS_test_single_$(test) += $(HEADERS_OPT)))
$(of_headers:%=$(OBJ)/tests/generated/%.o): $(OBJ)/methods.h $(OBJ)/methods.inc

# The methods of the bench, as code that is built for its machine: once for each instruction set, all alike, and
# optimised in any configuration.
# Without signed zeros and not-a-numbers, minima and maxima are instructions.
FAST := -ffp-contract=fast -fno-math-errno -fno-trapping-math -fno-signed-zeros -ffinite-math-only
ISA_x86-64    := -march=x86-64
ISA_x86-64-v3 := -march=x86-64-v3
ISA_x86-64-v4 := -march=x86-64-v4 -mprefer-vector-width=512
# What the tests take where none of these has been built: soon compiled, as nothing is inlined.
OPT_quick := -O0 -DNDEBUG $(CALLED_ALONE)
isa_opt = $(or $(OPT_$*),$(OPT_release))
isa_id = $(subst -,_,$(1))

compile_isa = $(CC) $(filter-out $(OPT_$(CONFIG)),$(CFLAGS)) $(isa_opt) $(FAST) $(ISA_$*) -I$(OBJ) \
              -DBENCH_ISA=$(call isa_id,$*) -DBENCH_ISA_NAME='"$*"' \
              -DBENCH_FLAGS='"$(strip $(isa_opt) $(FAST) $(ISA_$*))"' -MMD -MP -c $< -o $@

$(OBJ)/tests/bench/bench_methods-%.o: tests/bench/bench_methods.c $(OBJ)/methods.h $(OBJ)/methods.inc $(OBJ)/rival_counts.inc \
                                tests/bench/footpoint_perceptron.h $(OBJ)/footpoint_perceptron.inc $(OBJ)/flags Makefile
	@mkdir -p $(@D)
	$(call say,CC,$< ($*))
	$(Q)$(compile_isa)

$(OBJ)/tests/bench/bench_calls-%.o: tests/bench/bench_calls.c $(OBJ)/calls.h $(OBJ)/calls.inc $(OBJ)/flags Makefile
	@mkdir -p $(@D)
	$(call say,CC,$< ($*))
	$(Q)$(compile_isa)

# Members of a scene's fronts, beside what ships, as the methods of a bench of their own.
FRONT   := $(BIN)/front/$(basename $(notdir $(SCENE)))
MEMBERS ?= 6
ifneq ($(SCENE),)
$(FRONT)/bench_methods.o: tests/bench/bench_methods.c $(FRONT)/methods.h $(FRONT)/methods.inc $(OBJ)/rival_counts.inc \
                          tests/bench/footpoint_perceptron.h $(OBJ)/footpoint_perceptron.inc
	$(call say,CC,$< (front))
	$(Q)$(CC) $(filter-out $(OPT_$(CONFIG)),$(CFLAGS)) $(OPT_release) $(FAST) -march=native -I$(FRONT) -I$(OBJ) \
	    -DBENCH_BARE -DBENCH_ISA=quick -DBENCH_ISA_NAME='"native"' -DBENCH_FLAGS='"$(OPT_release) $(FAST) -march=native"' -c $< -o $@

$(FRONT)/footpoint-bench: $(FRONT)/bench_methods.o $(call object,tests/bench/bench_main.c $(bench_lib)) \
                          $(OBJ)/support.a $(evolve_parts)
	$(call say,LD,$@)
	$(Q)$(link) $(LIBS_evolve)
endif

# ---- the main job -----------------------------------------------------------------------------------------------------

SCENES := $(patsubst evolve/scenes/%.scene,%,$(sort $(wildcard evolve/scenes/*.scene)))
MPIRUN ?= mpirun -q $(if $(filter 0,$(shell id -u)),--allow-run-as-root) --oversubscribe --bind-to none \
          --mca odls_base_sigkill_timeout 5

regenerate: codegen evolve ## evolve from the committed genomes, then emit the headers: SCENE= (a path: one's own, beside it or in OUT=) RANKS= GENERATIONS= SEED= FROM=scratch
	$(Q)BIN=$(BIN) MPIRUN='$(MPIRUN)' RANKS=$(RANKS) GENERATIONS=$(GENERATIONS) ISLANDS=$(ISLANDS) SEED=$(SEED) FROM=$(FROM) OUT='$(out)' \
	    sh evolve/regenerate.sh $(or $(SCENE),$(SCENES))
	$(if $(SCENE),,$(Q)BIN=$(BIN) GENERATIONS=$(GENERATIONS) sh evolve/regenerate.sh --derivatives $(FACES))
	$(if $(SCENE),,$(Q)$(foreach edge,$(EDGES),$(BIN)/footpoint-codegen --edge $(edge) -o $(edge:%=generated/footpoint_%.h) &&) :)
	$(if $(SCENE),,$(Q)$(emit_perceptrons))
	$(if $(SCENE),,$(Q)BIN=$(BIN) sh evolve/regenerate.sh --table)

front: codegen evolve ## which members of the fronts to ship as tiers, measured on validation samples: SCENE= MEMBERS= of each tier
	$(call demand,SCENE,$(SCENE),no scene)
	$(Q)BIN=$(BIN) MPIRUN='$(MPIRUN)' RANKS=$(RANKS) GENERATIONS=$(GENERATIONS) SEED=$(SEED) MEMBERS=$(MEMBERS) \
	    sh evolve/emit_front.sh $(SCENE) $(FRONT)
	$(Q)$(MAKE) --no-print-directory SCENE=$(SCENE) $(FRONT)/footpoint-bench
	$(Q)$(FRONT)/footpoint-bench --quiet --validation --csv --scene $(SCENE) > $(FRONT)/times.csv
	$(Q)awk -v id=$(subst -,_,$(basename $(notdir $(SCENE)))) -f evolve/which_ship.awk $(FRONT)/times.csv

# ---- tests ------------------------------------------------------------------------------------------------------------

TESTS := $(patsubst %.c,$(BIN)/tests/%,$(notdir $(test_main)))

$(BIN)/tests/test_digits: $(OBJ)/tests/generated/headers_long.o $(OBJ)/tests/generated/header_functions.o
$(BIN)/tests/test_headers: $(OBJ)/tests/generated/header_functions.o
$(BIN)/tests/test_promise: $(OBJ)/tests/generated/header_functions.o
$(foreach test,promise closest_promise,$(eval $(BIN)/tests/test_$(test): $(patsubst %,$(OBJ)/tests/hard/%.o,draw hard wild)))
$(foreach test,curved patches,$(eval $(BIN)/tests/test_promise_$(test): $(OBJ)/tests/generated/header_functions.o $(OBJ)/tests/hard/draw.o))
$(foreach test,promise_patches from_patches closest_patches,$(eval $(BIN)/tests/test_$(test): $(patsubst %,$(OBJ)/tests/%.o,patches/patch_judge patches/drawn_patches hard/draw)))
$(BIN)/tests/test_closest_patches: $(OBJ)/tests/patches/patch_nearest.o
$(foreach test,promise_curved closest_curved from,$(eval $(BIN)/tests/test_$(test): $(patsubst %,$(OBJ)/tests/%.o,generated/curved_cases hard/draw)))
$(BIN)/tests/test_promise_curved $(BIN)/tests/test_from: $(OBJ)/tests/generated/judged_faces.o
$(foreach test,edge edge_place edge_faces edge_along,$(eval $(BIN)/tests/test_$(test): $(patsubst %,$(OBJ)/tests/%.o,plane/edge_judge hard/draw)))
$(foreach test,along_gradients along_hessian along_normals place_arrays,$(eval $(BIN)/tests/test_$(test): $(OBJ)/tests/along/along_judge.o))
$(BIN)/tests/test_promise_tri3: $(patsubst %,$(OBJ)/tests/hard/%.o,draw hard wild)
$(BIN)/tests/test_promise_float: $(patsubst %,$(OBJ)/tests/hard/%.o,draw hard wild)
$(BIN)/tests/test_single_curved: $(patsubst %,$(OBJ)/tests/%.o,single/single_cases generated/curved_cases generated/judged_faces hard/draw)
$(BIN)/tests/test_single_closest: $(patsubst %,$(OBJ)/tests/%.o,single/single_cases generated/curved_cases hard/draw)
$(BIN)/tests/test_single_tri3: $(patsubst %,$(OBJ)/tests/%.o,single/single_cases generated/curved_cases hard/draw)
$(BIN)/tests/test_single_edges: $(patsubst %,$(OBJ)/tests/%.o,plane/edge_judge hard/draw)
$(OBJ)/tests/single/test_single_curved.o $(OBJ)/tests/single/test_single_closest.o: $(patsubst %,$(OBJ)/float/footpoint_%_float.h,quad8 quad9 tri6)
$(OBJ)/tests/single/test_single_tri3.o: $(OBJ)/float/footpoint_tri3_float.h
$(OBJ)/tests/single/test_single_edges.o: $(patsubst %,$(OBJ)/float/footpoint_%_float.h,edge2 edge3)
$(BIN)/tests/test_queries: $(OBJ)/tests/queries/query_text.o
$(foreach test,$(test_main),$(eval $(BIN)/tests/$(basename $(notdir $(test))): $(call object,$(test))))
$(TESTS): $(OBJ)/support.a $(OBJ)/paper.a $(OBJ)/evolve.a $(OBJ)/codegen.a $(LIB)_ccx.a $(LIB).a
	@mkdir -p $(@D)
	$(call say,LD,$@)
	$(Q)$(link) $(LIBS_test)

# A make of its own, as packages that `make deps check` installs change what there is to build.
build_tests = $(MAKE) --no-print-directory build-tests
build-tests: $(TESTS) all bench-program paper-programs

# A line at once, then the longest first, so that processors are busy to the end.
LONGEST := header statuses languages evolve programs bench make example templates checkpoint install own hard libraries counts
LONGEST := $(BIN)/tests/test_decimal $(LONGEST:%=tests/cli/%.sh) tests/generic/generic.sh $(BIN)/tests/test_calibration
other_tests := tests/paper/rivals/pga.sh tests/paper/rivals/perceptron.sh tests/queries/queries.sh tests/generic/generic.sh tests/generic/lanes.sh
in_order = $(LONGEST) $(filter-out $(LONGEST),$(TESTS) $(wildcard tests/cli/*.sh tests/tree/*.sh) $(other_tests))
LONGEST_CLI := $(patsubst %,tests/cli/%.sh,languages counts operations)
LONGEST_LONG := $(patsubst %,tests/long/%.sh,configurations calculix debian valgrind study hard_cases moves vector kill fuzz_search regenerated hostile front_timed projects)
LONGEST_TESTS := $(patsubst %,$(BIN)/tests/test_%,header_bounds promise_patches closest_curved closest_patches closest_promise promise calibration promise_curved)
long_first = $(BIN)/tests/test_decimal tests/cli/statuses.sh tests/cli/header.sh $(LONGEST_LONG) $(LONGEST_TESTS) $(LONGEST_CLI) $(filter-out $(LONGEST_LONG),$(wildcard tests/long/*.sh))
long_in_order = $(long_first) $(filter-out $(long_first),$(in_order))
run_tests = BIN=$(BIN) CC=$(CC) CXX=$(CXX) tests/run.sh

# The tests take the bench's methods that have been built before, or those that compile soonest.
isa_objects = $(wildcard $(ALL_ISAS:%=$(OBJ)/tests/bench/bench_methods-%.o))
check: export ISAS := $(or $(isa_objects:$(OBJ)/tests/bench/bench_methods-%.o=%),quick)
check: ## run the tests, less those that take long (some minutes; JOBS= at a time)
	$(Q)+$(build_tests)
	$(Q)JOBS=$(JOBS) $(run_tests) $(in_order)

# The bench for AVX2, and for this machine's best instruction set, which tests/timed/calls.sh asks.
check-long: export ISAS := $(filter x86-64-v3 $(ISAS),$(ALL_ISAS))
check-long: ## all tests on more cases, and the long ones; what compares times by itself (over an hour; JOBS= at a time)
	$(Q)+$(build_tests)
	$(Q)FOOTPOINT_LONG=0.01 JOBS=$(JOBS) $(run_tests) $(long_in_order) --alone $(wildcard tests/timed/*.sh)

bench: bench-program ## speed against error of every method on held-out samples: SCENE=
	$(Q)$(BIN)/footpoint-bench $(if $(SCENE),--scene $(SCENE))

bench-record: bench-program ## measure this machine into tests/report/machines, for the READMEs (minutes): ISAS=
	$(Q)sh tests/report/record.sh $(BIN)/footpoint-bench $(ISAS)

PERCEPTRONS := --scene paper-quad4 --hidden 8 --hidden 16 --hidden 16,16 --iterations 100

perceptrons: paper-programs codegen ## train the perceptrons of the bench again, tests/paper/perceptron.gen, and emit them
	$(Q)$(BIN)/footpoint-perceptron $(PERCEPTRONS) -o tests/paper/perceptron.gen
	$(Q)$(emit_perceptrons)

calibrate: calibrate-program ## measure this machine's operation costs, build/machine.costs; beside codegen/costs/
	$(Q)$(BIN)/footpoint-calibrate -o $(BIN)/machine.costs
	$(Q)awk -f codegen/costs/beside.awk \
	    $(BIN)/machine.costs codegen/costs/sse2.costs codegen/costs/avx2.costs codegen/costs/avx512.costs

rivals: runtime ## beside other libraries: table, and pictures in build/rivals/index.html: CASES= of each family (some minutes)
	$(Q)BIN=$(BIN) CC=$(CC) CXX=$(CXX) CASES=$(CASES) sh tests/libraries/rivals.sh build/rivals

# The committed set and its scores, or with COUNT= another set.
queries: runtime ## the public set of queries and the scores on it; with SEED= COUNT= another set, build/queries/queries.txt
	$(Q)BIN=$(BIN) CC=$(CC) sh tests/queries/set.sh $(if $(COUNT),set $(SEED) $(COUNT),fill)

figures: $(if $(RECORD),runtime) ## the figures of READMEs, between markers, from headers and recorded tables: RECORD=1 records the hard cases first
	$(Q)BIN=$(BIN) CC=$(CC) sh tests/report/figures.sh $(if $(RECORD),--record)

report: bench-program ## pictures of time against error, build/report/index.html
	$(Q)BIN=$(BIN) sh tests/report/report.sh build/report

paper: codegen evolve paper-programs bench-program $(BIN)/tests/test_calibration ## the paper's tables and figures, build/paper/index.html (half an hour; goes on if interrupted): RANKS= FULL=1 (the paper's size)
	$(Q)BIN=$(BIN) RANKS=$(RANKS) MPIRUN='$(MPIRUN) -n $(RANKS)' FULL=$(FULL) \
	    PERCEPTRONS='$(PERCEPTRONS)' sh tests/paper/paper.sh build/paper

# ---- housekeeping -----------------------------------------------------------------------------------------------------

# By name all that is needed: what packages merely recommend is not installed.
PACKAGES := gcc g++ gfortran clang libc6-dev make pkg-config libopenmpi-dev openmpi-bin libgsl-dev libflint-dev \
            libflint-arb-dev libmpfr-dev libgmp-dev libcmocka-dev libconfig-dev libmd-dev gnuplot-nox codespell
# What `make check-long` compares with, fuzzes with and unpacks with; without them it skips those checks.
PACKAGES_LONG := form maxima maxima-share python3-sympy gappa libclang-rt-14-dev libomp-14-dev valgrind cmake mandoc bzip2 chromium \
                 debhelper lintian abigail-tools

# Libraries that `make rivals` compares with.  deal.II is not among them: it would take 1.3 GB more.
PACKAGES_RIVALS := libdune-geometry-dev libvtk9-dev libgetfem-dev libgmsh-dev libsisl-dev libocct-modeling-algorithms-dev \
                   libocct-modeling-data-dev libtrilinos-intrepid2-dev libtrilinos-kokkos-dev libtrilinos-kokkos-kernels-dev \
                   libtrilinos-shards-dev libtrilinos-teuchos-dev libtrilinos-sacado-dev libcgal-dev libembree-dev libadolc-dev

deps-long: PACKAGES += $(PACKAGES_LONG)
deps-rivals: PACKAGES += $(PACKAGES_RIVALS)
deps deps-long deps-rivals: ## install the packages that are missing (Debian; deps-long: for check-long, deps-rivals: for rivals, too); needs no privileges when all are there
	$(Q)missing=; for p in $(PACKAGES); do \
	    dpkg-query -W -f '$${Status}' $$p 2>/dev/null | grep -q 'install ok installed' || missing="$$missing $$p"; \
	done; \
	if [ -n "$$missing" ]; then \
	    sudo=; [ "$$(id -u)" = 0 ] || sudo=sudo; \
	    $$sudo apt-get update -qq && \
	    DEBIAN_FRONTEND=noninteractive $$sudo apt-get install -y -qq --no-install-recommends $$missing; \
	fi

# ---- installation -----------------------------------------------------------------------------------------------------

PREFIX     ?= /usr/local
BINDIR     ?= $(PREFIX)/bin
LIBDIR     ?= $(PREFIX)/lib
INCLUDEDIR ?= $(PREFIX)/include
MANDIR     ?= $(PREFIX)/share/man
# Programs look for it in ../share/footpoint from where they are.
DATADIR    := $(BINDIR)/../share/footpoint

VERSION := $(shell sed -n 's/^.define FOOTPOINT_VERSION "\(.*\)"/\1/p' codegen/base/base.h)
LIBRARY := runtime/footpoint.h runtime/footpoint_batch.h runtime/footpoint_face.h runtime/footpoint_patch.h
HEADERS := $(GENERATED) $(DERIVATIVES) $(PLANE) $(sort $(wildcard runtime/geometry/footpoint-*.h)) runtime/package/footpoint.f90
PROGRAMS := $(addprefix $(BIN)/footpoint-,codegen calibrate evolve)
PAGES_1 := evolve/man/footpoint-evolve.1 $(addprefix codegen/man/footpoint-,codegen.1 calibrate.1)
PAGES_3 := runtime/package/footpoint.3
DATA_frames  := $(FRAMES:%=evolve/frames/%.gen)
DATA_scenes  := $(SHIPPED:%=evolve/scenes/%.scene)
DATA_genomes := $(SHIPPED:%=evolve/genomes/%.gen)
MESHES  := $(addprefix tests/meshes/,blocks.inp blocks-nodes.inp bricks.inp punch.inp)
PC      := footpoint.pc footpoint_ccx.pc
CMAKE   := footpoint-config.cmake footpoint-config-version.cmake
SHARED  := libfootpoint.so.$(VERSION)

# Folders are absolute and may have blanks in their names, but nothing that scripts and packages give a meaning.
ifneq ($(filter install install-runtime uninstall,$(MAKECMDGOALS)),)
blank :=
blank := $(blank) $(blank)
tab   := $(shell printf '\t')
define newline


endef
FOLDERS := PREFIX BINDIR LIBDIR INCLUDEDIR MANDIR
hash  := \#
strange = $(strip $(foreach c," ' ` \ | & ; $$ $(hash),$(findstring $(c),$($(1)))) \
              $(if $(findstring $(tab),$($(1))),tab) $(if $(findstring $(newline),$($(1))),newline))
$(foreach v,$(FOLDERS),$(call demand,$(v),$(filter /%,$(firstword $(subst $(blank),_,$($(v))))),no absolute path))
$(foreach v,$(FOLDERS) DESTDIR,$(call demand,$(v),$(if $(call strange,$(v)),,yes),no folder to install in: $(call strange,$(v))))
endif

# A folder below DESTDIR, as one word of the shell.
to  = '$(DESTDIR)$(1)'
put = install -d $(call to,$(2)) && install -m $(or $(3),644) $(1) $(call to,$(2))
# Packages name their folders from their own, so that an installation may be staged and moved.
from = $$(realpath -m --relative-to='$(1)' '$(2)')
# What is linked statically asks for OpenMP itself.
fill = sed -e "s|@VERSION@|$(VERSION)|; s|@ABI@|$(ABI)|; s|@THREADS@|$(THREADS)|" -e "s|@PREFIX@|$(call from,$(1),$(PREFIX))|" \
    -e "s|@LIB@|$(call from,$(PREFIX),$(LIBDIR))|; s|@INCLUDE@|$(call from,$(PREFIX),$(INCLUDEDIR))|"
remove = rm -f $(foreach file,$(notdir $(1)),$(call to,$(2)/$(file)))
# A folder of ours, unless there is something else in it.
close = rmdir $(call to,$(1)) 2> /dev/null || :

install: install-runtime codegen evolve calibrate-program ## install everything: PREFIX= DESTDIR= BINDIR= LIBDIR= INCLUDEDIR= MANDIR=
	$(Q)$(call put,$(PROGRAMS),$(BINDIR),755)
	$(Q)$(foreach d,frames scenes genomes,$(call put,$(DATA_$(d)),$(DATADIR)/evolve/$(d)) &&) :
	$(Q)$(call put,$(MESHES),$(DATADIR)/tests/meshes)
	$(Q)$(call put,$(PAGES_1),$(MANDIR)/man1)

install-runtime: runtime ## the library and the headers alone, which take a C compiler: the same variables
	$(Q)$(call put,$(LIBRARY) $(MODULE),$(INCLUDEDIR))
	$(Q)$(call put,$(HEADERS) $(shell ls $(GENERIC) 2> /dev/null),$(INCLUDEDIR)/footpoint)
	$(Q)$(call put,$(LIB).a $(LIB)_ccx.a,$(LIBDIR))
	$(Q)install -m 644 $(LIB).so $(call to,$(LIBDIR)/$(SHARED))
	$(Q)ln -sf $(SHARED) $(call to,$(LIBDIR)/$(SONAME))
	$(Q)ln -sf $(SONAME) $(call to,$(LIBDIR)/libfootpoint.so)
	$(Q)install -d $(call to,$(LIBDIR)/pkgconfig) $(call to,$(LIBDIR)/cmake/footpoint)
	$(Q)$(foreach f,$(PC),$(call fill,$(LIBDIR)/pkgconfig) runtime/package/$(f).in | \
	    sed '/=/s/ /\\ /g' > $(call to,$(LIBDIR)/pkgconfig/$(f)) &&) :
	$(Q)$(foreach f,$(CMAKE),$(call fill,$(LIBDIR)/cmake/footpoint) runtime/package/$(f).in \
	    > $(call to,$(LIBDIR)/cmake/footpoint/$(f)) &&) :
	$(Q)$(call put,$(PAGES_3),$(MANDIR)/man3)

uninstall: ## remove what install put there, and nothing else: the same variables
	$(Q)$(foreach d,frames scenes genomes,$(call remove,$(DATA_$(d)),$(DATADIR)/evolve/$(d)) &&) :
	$(Q)$(call remove,$(MESHES),$(DATADIR)/tests/meshes)
	$(Q)$(call remove,$(PROGRAMS),$(BINDIR))
	$(Q)$(call remove,$(LIBRARY) footpoint.mod,$(INCLUDEDIR))
	$(Q)$(call remove,$(HEADERS) $(GENERIC),$(INCLUDEDIR)/footpoint)
	$(Q)$(call remove,libfootpoint.a libfootpoint_ccx.a libfootpoint.so $(SONAME) $(SHARED),$(LIBDIR))
	$(Q)$(call remove,$(PC),$(LIBDIR)/pkgconfig)
	$(Q)$(call remove,$(CMAKE),$(LIBDIR)/cmake/footpoint)
	$(Q)$(call remove,$(PAGES_1),$(MANDIR)/man1)
	$(Q)$(call remove,$(PAGES_3),$(MANDIR)/man3)
	$(Q)$(foreach d,frames scenes genomes,$(call close,$(DATADIR)/evolve/$(d));) $(call close,$(DATADIR)/evolve); \
	    $(call close,$(DATADIR)/tests/meshes); $(call close,$(DATADIR)/tests); $(call close,$(DATADIR)); \
	    $(call close,$(INCLUDEDIR)/footpoint); $(call close,$(LIBDIR)/cmake/footpoint)

# The archive has what is committed; its bytes depend on nothing else.
dist: ## the sources as build/footpoint-VERSION.tar.gz
	$(Q)mkdir -p build
	$(Q)git -c tar.umask=0022 archive --prefix=footpoint-$(VERSION)/ -o build/footpoint-$(VERSION).tar HEAD
	$(Q)gzip -9nf build/footpoint-$(VERSION).tar

# Calls that are new are no change.  Types are compared where both libraries were built with EXTRA_CFLAGS=-g.
BEFORE = $(LIBDIR)/$(SONAME)
abi: runtime ## whether programs run on that were built with the library in LIBDIR: BEFORE= another one (abidiff)
	$(Q)abidiff --no-added-syms $(BEFORE) $(LIB).so

clean: ## remove everything that was built
	rm -rf build

help: ## this list
	@awk -F ':.*## ' '/^[a-z+ -]+:.*## / { printf "  %-15s %s\n", $$1, $$2 }' $(firstword $(MAKEFILE_LIST))

.PHONY: all c++ float codegen evolve runtime calibrate-program bench-program paper-programs regenerate front check check-long bench bench-record figures calibrate report \
        perceptrons paper rivals queries build-tests deps deps-long deps-rivals install install-runtime uninstall \
        dist abi clean help FORCE
