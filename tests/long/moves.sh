# Measures the worth of each move of evolution.  Scenes are evolved from scratch with one move left out at a time, as many
# evaluations as with all moves.  Fronts are compared by errors on held-out samples that played no part in any choice: at each
# cost, the error of the most expensive member that costs no more.  Prints, for each move, the error without it over the error
# with all moves (geometric mean over costs, scenes and seeds), an interval of two standard errors, the mean of each scene, and
# the processor time likewise.
# MOVES= selects moves; SEEDS=, GENERATIONS=, POPULATION=.  Without them every move is left out of a program, and the seeds'
# worth is measured, two minutes of one processor; for a table of all moves MOVES=all takes half an hour, more for those of
# little worth.
#
# Results with 1,024 samples, two islands of 100 programs, 40 generations, 10,000 held-out samples:
#
#   without                                            runs  error  2 std errors  quad4  quad8  gregory  time
#   seeds                                                 7   1.70  1.17 to 2.45   2.72   0.96     1.47  0.98
#   guided insertion                                     11   1.02  0.98 to 1.07   1.06   0.93     1.05  0.68
#   parents from the front                                7   0.98  0.95 to 1.01   0.98   0.98     0.99  0.86
#   fits of a random fifth of the children                3   0.99  0.96 to 1.02   0.99   0.97     1.02  0.57
#   restarts: other answers for values near the answers (removed)
#                                                        15   1.00  0.98 to 1.01   1.01   1.00     0.98  0.90
#   guided prunes (removed)                              15   1.01  0.98 to 1.04   0.98   0.97     1.08  0.85
#   three of four lines examined for an insertion (removed)
#                                                        15   1.02  1.00 to 1.05   1.02   0.98     1.08  0.87
#   the random fifth fitted: the best tenth instead (now)
#                                                        15   1.00  0.98 to 1.02   1.02   0.99     0.99  0.86
#   the last four together (now)                         15   1.03  0.99 to 1.06   0.99   0.98     1.11  0.62
#
# All rows compare with the engine before the removals.  15 runs are five seeds of each scene; rows with fewer are preliminary.
# Guided prunes and more lines examined gain 8 % on gregory and nothing elsewhere, for an eighth of the time each.  At this length
# fronts change slowly (25 generations instead of 40 cost less than 5 %), so insertions and parents from the front cannot show
# their worth in longer runs.  Stagnating islands are not restarted: neither of two with 50 programs of quad4 went 200
# generations without progress in 740.
. tests/cli/expect.inc
all='insertion parents seeds fits polish crowd images immigrants graft operand shortcut operator term call share'
measured=${MOVES:-seeds} seeds='1 2'
[ "$MOVES" != all ] || measured=$all seeds='1 2 3 4 5'
MOVES=${MOVES:-all}
[ "$MOVES" != all ] || MOVES=$all
SEEDS=${SEEDS:-$seeds} GENERATIONS=${GENERATIONS:-40} POPULATION=${POPULATION:-100}
top=$(pwd)

# A scene of one tier, and the costs that fronts are compared at.
scene() { # scene NAME LEAST MOST TIER
    sed '/^tiers = (/,$d; s/^training .*/training = 1024;/; s/^heldout .*/heldout = 10000;/' "evolve/scenes/$1.scene"
    echo "tiers = ({ name = \"all\"; budget = $3; $4 });"
    echo "$1 $2 $3" >> "$work/costs"
}
scene quad4 200 418 > "$work/quad4.scene"
scene quad8 400 600 'last = "gauss_newton";' > "$work/quad8.scene"
scene gregory 200 505 'last = "place";' > "$work/gregory.scene"

mkdir "$work/tree" "$work/bin"
tar cf - --exclude=./.git --exclude='./build/[!r]*' --exclude=./build/release/tests . | tar xf - -C "$work/tree"
build() { make -s -C "$work/tree" evolve > "$work/log" 2>&1 && cp "$work/tree/build/footpoint-evolve" "$work/bin/$1"; }
build all
report $((! $?)) 'evolution with all moves is built'
without() { # without MOVE FILE SED: a program that lacks the move
    case " $MOVES " in *" $1 "*) ;; *) return ;; esac
    sed -i "$3" "$work/tree/$2"
    ! cmp -s "$2" "$work/tree/$2" && build "$1"
    report $((! $?)) "evolution without $1 is built"
    cp "$2" "$work/tree/$2"
}
fits=evolve/fit/fits.c plan=evolve/island/plan.c breed=evolve/island/breed_front.c edit=evolve/genotype/lines_edit.c
without insertion $fits 's/guided_insertions = 0.08/guided_insertions = 0/'
without parents $plan 's/front_parents = 0.3/front_parents = 0/'
without seeds evolve/run/run.c 's/^        compose_seeds(p)/        (void)compose_seeds/'
without fits $plan 's/tune = 0.1/tune = 0/'
without polish $plan 's/polish_every = 10/polish_every = 0/'
without crowd $plan 's/crowd = 10/crowd = 1000/'
without images $edit 's/if (both \&\&/if (0 \&\& both \&\&/'
without immigrants $breed 's/immigrants = 0.02/immigrants = 0/'
rates='{0.25, 0.25, 0.2, 0.05, 0.15, 0.07, 0.03}' drawn='double at = '
change() { # change MOVE RATES SUM: without one of the changes of programs, the others in its place
    without "$1" $edit "s/$rates/{$2}/; s/${drawn}gsl/$drawn$3 * gsl/"
}
change graft '0, 0.25, 0.2, 0.05, 0.15, 0.07, 0.03' 0.75
change operand '0.25, 0, 0.2, 0.05, 0.15, 0.07, 0.03' 0.75
change shortcut '0.25, 0.25, 0, 0.05, 0.15, 0.07, 0.03' 0.8
change operator '0.25, 0.25, 0.2, 0, 0.15, 0.07, 0.03' 0.95
change term '0.25, 0.25, 0.2, 0.05, 0, 0.07, 0.03' 0.85
change call '0.25, 0.25, 0.2, 0.05, 0.15, 0, 0.03' 0.93
change share '0.25, 0.25, 0.2, 0.05, 0.15, 0.07, 0' 0.97

spend() { # the processor time of the children so far, to $spent
    times > "$work/times"
    spent=$(awk 'NR == 2 { split($0, t, /[ms ]+/); print 60 * t[1] + t[2] + 60 * t[3] + t[4] }' "$work/times")
}
evolve() { # evolve MOVE SCENE SEED
    spend
    before=$spent
    "$work/bin/$1" --root "$top" --scene "$work/$2.scene" --from-scratch --generations "$GENERATIONS" --quiet \
        --population "$POPULATION" --seed "$3" --front "$work/front.csv" -o "$work/found.gen" > "$work/log" 2>&1 ||
        echo "# $1 $2 $3: $(tail -n 1 "$work/log")"
    spend
    echo "run $1 $2 $3 $(echo "$spent $before" | awk '{ print $1 - $2 }')" >> "$work/runs"
    awk -F, 'NR > 1 { print "member", $3, $11 }' "$work/front.csv" >> "$work/runs"
}
for move in all $measured; do
    for seed in $SEEDS; do
        for scene in quad4 quad8 gregory; do evolve "$move" $scene "$seed"; done
    done
done

awk '
    function close_run(cost, sum, n, k) {
        if (!run) return
        for (cost = least[scene]; cost <= most[scene]; cost += 2) {
            while (k < members && at[k + 1] <= cost) k++
            sum += log(k > 0 ? error[k] : 10); n++
        }
        score[move, scene, seed] = sum / n
    }
    NR == FNR { least[$1] = $2; most[$1] = $3; next }
    $1 == "run" {
        close_run(); run = 1; move = $2; scene = $3; seed = $4; members = 0
        time[move] += $5; if (!(move in known)) { known[move]; order[++moves] = move }
        seeds[seed]; next
    }
    { at[++members] = $2; error[members] = $3 > 1e-16 ? $3 : 1e-16 }
    END {
        close_run()
        for (m = 2; m <= moves; m++) {
            move = order[m]; n = sum = square = 0; each = ""
            for (scene in least) {
                own = own_n = 0
                for (seed in seeds) {
                    d = score[move, scene, seed] - score["all", scene, seed]
                    own += d; own_n++; sum += d; square += d * d; n++
                }
                each = each sprintf("  %s %.2f", scene, exp(own / own_n))
            }
            mean = sum / n; off = n > 1 ? 2 * sqrt((square - n * mean * mean) / (n - 1) / n) : 0
            printf "%s %.2f %.2f %.2f%s  time %.2f\n", move, exp(mean), exp(mean - off), exp(mean + off), each,
                time[move] / time["all"]
        }
    }' "$work/costs" "$work/runs" > "$work/table"
sed 's/^/# without /' "$work/table"

# Nothing is worth as much as seeds.
case " $measured " in *" seeds "*)
    awk '$1 == "seeds" { worth = $3 > 1 } END { exit !worth }' "$work/table"
    report $((! $?)) 'errors are larger without seeds'
esac
