#!/bin/sh
# paper.sh FOLDER: repeats the study of Oishi and Yoshimura (2008), run by run, and makes a page of its tables and
# figures.
#
# Every run writes a file to FOLDER/runs and is not repeated. An interrupted study continues there, long runs from their
# checkpoint. FULL=1: the paper's own size, in its own folder (FOLDER/full). All results except times depend only on the
# seeds.
folder=$1
BIN=${BIN:-build} RANKS=${RANKS:-2} MPIRUN=${MPIRUN:-mpirun --oversubscribe --bind-to none -n $RANKS}
if [ "$FULL" = 1 ]; then
    folder=$folder/full
    seeds='1 2 3 4 5 6 7 8 9 10' pga_generations=3000 gp_generations=3000 group_generations=3000
    timed_generations=500 sixteen_generations=3000 sixteen_training=83552
else
    seeds=${SEEDS:-1 2 3 4} pga_generations=${PGA_GENERATIONS:-500} gp_generations=${GP_GENERATIONS:-120}
    group_generations=${GROUP_GENERATIONS:-40} timed_generations=${TIMED_GENERATIONS:-100}
    sixteen_generations=${SIXTEEN_GENERATIONS:-120} sixteen_training=${SIXTEEN_TRAINING:-12000}
fi
runs=$folder/runs
networks=${PERCEPTRONS:?the options of footpoint-perceptron; make paper gives them}
sizes=10,20,40,60,80 lengths='50 100 150 200 250' groups='5 10 15 20' group_lengths='50 100 150'
mkdir -p "$runs" || exit 3
scene=${STUDY_SCENE:-tests/scenes/similarity.scene} timing=$runs/timing.scene
# Sixteen inputs: section 7.2.
sixteen_scene=${SIXTEEN_SCENE:-tests/scenes/gregory-inputs.scene} sixteen_length=${SIXTEEN_LENGTH:-250}

say() { echo "$(date +%H:%M:%S) $*"; }
now() { date +%s.%N; }

# Runs that are there must be of the size that is wanted now; seeds may come on top.
settings="p-GA $pga_generations, pd-LinearGP $gp_generations and $group_generations generations, \
perceptrons $networks, sixteen inputs $sixteen_generations generations on $sixteen_training samples"
if [ -e "$runs/settings" ] && [ "$settings" != "$(cat "$runs/settings")" ]; then
    echo "paper: $runs holds runs of another size ($(cat "$runs/settings")); take another folder, or remove it" >&2
    exit 1
fi
echo "$settings" > "$runs/settings"

# make_once FILE COMMAND...: the command's standard output becomes the file, which is whole or not there.
make_once() {
    file=$1
    shift
    [ ! -e "$file" ] || return 0
    "$@" > "$file.part" && mv "$file.part" "$file" || { echo "paper: $file failed" >&2; exit 3; }
}

# scene_of FILE LENGTHS FUNCTIONS...: the base's inputs, a tier for each function set and length: poly50, ...
scene_of() {
    terminals=$(sed -n 's/.*\(terminals = \[[^]]*\];\).*/\1/p' "${base:-$scene}" | head -n 1)
    sed '/^tiers/,$d' "${base:-$scene}" > "$1.part"
    {
        echo 'tiers = ('
        comma=
        for functions in $3; do
            for length in $2; do
                printf '%s  { name = "%.4s%s"; ' "$comma" "$functions" "$length"
                printf '%s max_length = %s; functions = "%s"; }' "$terminals" "$length" "$functions"
                comma=',
'
            done
        done
        printf '\n);\n'
    } >> "$1.part"
    cmp -s "$1.part" "$1" && rm "$1.part" || mv "$1.part" "$1"
}

# evolve_once NAME OPTIONS...: pd-LinearGP; goes on from its checkpoint.
evolve_once() {
    name=$runs/$1
    shift
    [ ! -e "$name.gen" ] || return 0
    say "pd-LinearGP: $(basename "$name")"
    if [ -e "$name.checkpoint" ]; then
        set -- --resume "$name.checkpoint"
    else
        set -- --from-scratch --checkpoint "$name.checkpoint" --checkpoint-every 60 --log "$name.csv" \
            -o "$name.part.gen" "$@"
    fi
    $MPIRUN "$BIN/footpoint-evolve" --quiet "$@" > "$name.out" 2> "$name.err" && mv "$name.part.gen" "$name.gen" ||
        { cat "$name.err" >&2; exit 3; }
    rm -f "$name.checkpoint"
}

# pga_once NAME OPTIONS...
pga_once() {
    name=$runs/$1
    shift
    [ ! -e "$name.gen" ] || return 0
    say "p-GA: $(basename "$name")"
    $MPIRUN "$BIN/footpoint-pga" --quiet --scene $scene --log "$name.csv" -o "$name.part.gen" "$@" \
        > "$name.out" 2> "$name.err" && mv "$name.part.gen" "$name.gen" || { cat "$name.err" >&2; exit 3; }
}

# The perceptrons of the bench, trained anew; the bench itself has those that are committed.
perceptron_once() {
    [ ! -e "$runs/perceptron.gen" ] || return 0
    say "perceptrons"
    # shellcheck disable=SC2086
    "$BIN/footpoint-perceptron" $networks -o "$runs/perceptron.gen" > "$runs/perceptron.out" 2>&1 ||
        { cat "$runs/perceptron.out" >&2; exit 3; }
}

# ---- times: on ordinary segments drawn at random, which are made fast; as many samples as the paper's ---------------

make_timing_scene() {
    shapes='shapes: { aspect = 2.0; skew = "20 deg"; taper = 0.2; warp = "10 deg"; gap = 0.2; overhang = 0.1; };'
    sed "s/^lattice.*/$shapes/; s/^heldout.*/heldout = 100;/; s/^order.*/order = \"nearest\";/" $scene \
        > "$runs/timing.base"
    base=$runs/timing.base scene_of "$timing" "$lengths" 'polynomial rational'
    base=$runs/timing.base scene_of "$runs/timing50.scene" 50 polynomial
    base=
}

# The second study's scenes: of the lengths, of the front, of times, and of the methods that it is compared with.
make_sixteen_scenes() {
    sed "s/^training.*/training = $sixteen_training;/" $sixteen_scene > "$runs/sixteen.base"
    base=$runs/sixteen.base scene_of "$runs/sixteen.scene" "$lengths" 'polynomial rational'
    base=$runs/sixteen.base scene_of "$runs/sixteen-front.scene" "$sixteen_length" 'polynomial rational'
    # For times: a coarse lattice, which is made fast.
    sed 's/xy = \[2.0, [0-9.]*\]/xy = [2.0, 0.4]/; s/^training.*/training = 6000;/; s/^heldout.*/heldout = 100;/' \
        "$runs/sixteen.base" > "$runs/sixteen-timed.base"
    base=$runs/sixteen-timed.base scene_of "$runs/sixteen-timed.scene" 50 polynomial
    base=
    {
        sed '/^tiers/,$d' "$runs/sixteen.base"
        echo 'tiers = ('
        echo '  { name = "area"; max_length = 1000; functions = "rational";'
        echo '    terminals = ["xc", "yc", "zc", "xd", "yd", "xs", "ys", "zs"]; },'
        echo '  { name = "facet"; frame = "gregory"; terminals = ["x_f", "y_f"]; max_length = 1;'
        echo '    functions = "polynomial"; }'
        echo ');'
    } > "$runs/sixteen-known.scene"
}

# Seconds of a command, less those of the same with 1 generation: elapsed SCENE GENERATIONS RANKS OPTIONS...
elapsed() {
    timed_scene=$1 timed=$2 ranks=$3
    shift 3
    for generations in 1 "$timed"; do
        start=$(now)
        ${MPIRUN% -n *} -n "$ranks" "$BIN/footpoint-evolve" --preset paper --quiet --scene "$timed_scene" \
            --from-scratch --generations "$generations" -o "$runs/timed.gen" "$@" > /dev/null 2>&1 || exit 3
        echo "$start $(now)"
    done | awk '{ s = $2 - $1 - s } END { printf "%.3f", s }'
}

# Processor time of a command: seconds.
cpu_seconds() {
    ("$@" > /dev/null || exit 3; times) | awk 'NR == 2 { split($1, t, "[ms]"); print 60 * t[1] + t[2] }'
}

# p-GA: seconds of a generation on 1, 2, ... ranks, both outputs.
time_pga() {
    echo ranks,seconds_per_generation
    for ranks in $(seq 1 "$RANKS"); do
        ${MPIRUN% -n *} -n "$ranks" "$BIN/footpoint-pga" --scene "$timing" --generations "$timed_generations" \
            -o "$runs/timed.gen" 2>&1 > /dev/null |
            awk -v r="$ranks" -v g="$timed_generations" '
                / generations of / { s += $7 }
                END { printf "%d,%.5f\n", r, s / g }'
    done
}

# pd-LinearGP: elapsed time against groups, xi and eta; a group for each rank, then all ranks for the paper's numbers.
time_groups() {
    echo groups,ranks,seconds
    for count in $(seq 1 "$RANKS") $groups; do
        ranks=$((count < RANKS ? count : RANKS))
        echo "$count,$ranks,$(elapsed "$runs/timing50.scene" "$timed_generations" "$ranks" --islands "$count")"
    done
}

# pd-LinearGP: processor time of a generation of a group of 200 for xi and one for eta against the length, of a SCENE.
time_lengths() {
    echo functions,length,seconds_per_generation
    for functions in polynomial rational; do
        for length in $lengths; do
            s=$(for generations in 1 "$timed_generations"; do
                cpu_seconds "$BIN/footpoint-evolve" --preset paper --quiet --scene "$1" \
                    --from-scratch --generations "$generations" -o "$runs/timed.gen" --islands 1 \
                    --functions $functions --max-length "$length"
            done | awk '{ s = $1 - s } END { if (NR < 2) exit 3; print s < 0 ? 0 : s }') || return 3
            echo "$functions,$length,$(echo "$s $timed_generations" | awk '{ printf "%.5f", $1 / ($2 - 1) }')"
        done
    done
}

# What the runs will take, from the times of their parts: minutes.
estimate() {
    awk -F, -v seeds="$(echo "$seeds" | wc -w)" -v p="$pga_generations" -v g="$gp_generations" \
        -v q="$group_generations" -v n="$sixteen_generations" -v training="$sixteen_training" -v ranks="$RANKS" '
        FILENAME ~ /pga/ && $1 == ranks { pga = $2 }
        FILENAME ~ /lengths/ && FNR > 1 { all += $3; if ($1 == "polynomial" && $2 <= 150) short += $3 }
        FILENAME ~ /sixteen/ { sixteen += $3 * training / 6000 }
        END { s = seeds * (3.5 * pga * p + 6.3 * all * g / ranks + 50 * short * q / ranks + 8 * 10 + 20) + 360
              s += seeds * (5 * sixteen * n / ranks + 12) + 30 + 200 / ranks
              printf "%.0f", s / 60 }' "$runs/time-pga.csv" "$runs/time-lengths.csv" "$runs/time-sixteen.csv"
}

say "times"
make_timing_scene
make_sixteen_scenes
make_once "$runs/time-pga.csv" time_pga
make_once "$runs/time-lengths.csv" time_lengths "$runs/timing50.scene"
make_once "$runs/time-sixteen.csv" time_lengths "$runs/sixteen-timed.scene"
say "this will take about $(estimate) minutes on $RANKS ranks, less what is there; interrupt it whenever you like"

# judge SCENE NAME: the errors of the programs in NAME.members on the samples held out, NAME.judged.csv
judge() {
    "$BIN/footpoint-evolve" --quiet --scene "$1" --from-scratch --seeds "$2.members" --generations 0 \
        --front "$2.judged.csv" -o "$2.judged.gen"
}

# ---- the runs -------------------------------------------------------------------------------------------------------

make_once "$runs/time-groups.csv" time_groups
make_once "$runs/calibration.tap" env CMOCKA_MESSAGE_OUTPUT=TAP "$BIN/tests/test_calibration"
pga_once ten --terms tests/paper/ten-terms.txt --name ten_terms
perceptron_once
say "footpoint-bench"
make_once "$runs/bench.csv" "$BIN/footpoint-bench" --scene paper-quad4 --csv
make_once "$runs/contact.csv" "$BIN/footpoint-bench" --scene paper-quad4 --contact
scene_of "$runs/lengths.scene" "$lengths" 'polynomial rational'
scene_of "$runs/groups.scene" "$group_lengths" polynomial
scene_of "$runs/front.scene" 100 polynomial
for seed in $seeds; do
    pga_once "pga-$seed" --restrict "$sizes,0" --seed "$seed" --generations "$pga_generations"
    pga_once "beyond-$seed" --restrict "$sizes,124" --seed "$seed" --generations $((pga_generations / 5)) \
        --exchange --coefficients mean
    evolve_once "lengths-$seed" --preset paper --scene "$runs/lengths.scene" --seed "$seed" \
        --generations "$gp_generations"
    for count in $groups; do
        evolve_once "groups-$count-$seed" --preset paper --scene "$runs/groups.scene" --seed "$seed" \
            --islands "$count" --generations "$group_generations"
    done
    evolve_once "front-$seed" --scene "$runs/front.scene" --cost paper --seed "$seed" --generations "$gp_generations" \
        --front "$runs/front-$seed.members"
    make_once "$runs/front-$seed.out2" judge "$runs/front.scene" "$runs/front-$seed"
done

# Sixteen inputs: what expressions are compared with, the lengths, and the front of either kind of expressions.
make_once "$runs/sixteen-known.out" "$BIN/footpoint-evolve" --quiet --scene "$runs/sixteen-known.scene" \
    --start tests/paper/sixteen.gen --breeding paper --generations 0 -o "$runs/sixteen-known.gen"
for seed in $seeds; do
    evolve_once "sixteen-$seed" --preset paper --scene "$runs/sixteen.scene" --seed "$seed" \
        --generations "$sixteen_generations"
done
evolve_once sixteen-front --scene "$runs/sixteen-front.scene" --cost paper --seed "${seeds%% *}" \
    --generations $((sixteen_generations / 4)) --front "$runs/sixteen-front.members"
make_once "$runs/sixteen-front.out2" judge "$runs/sixteen-front.scene" "$runs/sixteen-front"
export folder runs seeds groups BIN RANKS pga_generations gp_generations group_generations timed_generations
export sixteen_generations sixteen_training sixteen_length
sh tests/paper/page.sh && say "$folder/index.html"
