# Checks inputs of footpoint-evolve: it never overwrites files that it reads, refuses unusable input, and draws samples that do not
# depend on the mesh's orientation.
. tests/cli/expect.inc
evolve=$BIN/footpoint-evolve
scene() { sed "$1" "$2" > "$work/s.scene"; }
run() { "$evolve" --quiet --scene "$work/s.scene" --from-scratch --generations 1 --population 10 --islands 1 "$@"; }
refused() { # refused NAME MESSAGE OPTION...
    name=$1 message=$2
    shift 2
    expect "$name" 1 '' "$message" run -o "$work/o.gen" "$@"
}

# ---- one curved face, and slave nodes over it: the same pairs, facing z or x ----
for axis in z x; do
    awk -v axis=$axis '
        function put(x, y, z) {
            if (axis == "z") printf "%d, %.15g, %.15g, %.15g\n", ++n, x, y, z
            else printf "%d, %.15g, %.15g, %.15g\n", ++n, z, x, y
        }
        function shape(xi, eta, k) {
            if (k <= 4) return (1 + xi * u[k]) * (1 + eta * v[k]) * (xi * u[k] + eta * v[k] - 1) / 4
            return u[k] == 0 ? (1 - xi * xi) * (1 + eta * v[k]) / 2 : (1 + xi * u[k]) * (1 - eta * eta) / 2
        }
        BEGIN {
            split("-1 1 1 -1 0 1 0 -1", u); split("-1 -1 1 1 -1 0 1 0", v)
            print "*NODE"
            for (k = 1; k <= 8; k++) {
                x[k] = 1.25 * u[k]; y[k] = 1.25 * v[k]; z[k] = sqrt(25 - x[k] * x[k] - y[k] * y[k])
                put(x[k], y[k], z[k])
            }
            for (i = 0; i < 11; i++)
                for (j = 0; j < 11; j++) {
                    p = q = r = 0
                    for (k = 1; k <= 8; k++) {
                        s = shape(-0.95 + 0.19 * i, -0.95 + 0.19 * j, k)
                        p += s * x[k]; q += s * y[k]; r += s * z[k]
                    }
                    far = 1 + 0.004 / sqrt(p * p + q * q + r * r)
                    put(p * far, q * far, r * far)
                }
            print "*ELEMENT, TYPE=S8, ELSET=E\n1, 1, 2, 3, 4, 5, 6, 7, 8\n*NSET, NSET=SL, GENERATE\n9, " n ", 1"
            print "*SURFACE, NAME=M\nE, SPOS\n*SURFACE, NAME=S, TYPE=NODE\nSL\n*CONTACT PAIR\nS, M"
        }' > "$work/dome.inp"
    echo 'training = 10; heldout = 10; mesh: { file = "dome.inp"; distance = 0.01; };' > "$work/s.scene"
    "$evolve" --scene "$work/s.scene" --samples "$work/dome.csv"
    expect "half of 121 pairs of a curved face are held out, along $axis" 0 60 '' grep -c '^heldout,' "$work/dome.csv"
done

# ---- inputs stay unchanged ----
sed -n '/^\*ELEMENT/,$p' "$work/dome.inp" > "$work/rest.inp"
sed '/^\*ELEMENT/,$d' "$work/dome.inp" > "$work/nodes.inp"
cp "$work/nodes.inp" "$work/before.inp"
{ echo '*INCLUDE, INPUT=nodes.inp'; cat "$work/rest.inp"; } > "$work/dome.inp"
expect 'an included mesh file' 2 '' "footpoint-evolve: error: --output and the mesh are one file: $work/nodes.inp" \
    run -o "$work/nodes.inp"
cmp "$work/before.inp" "$work/nodes.inp"; report $((! $?)) 'stays'
expect 'the scene of the kind' 2 '' 'footpoint-evolve: error: --output and the scene of the kind are one file: ./evolve/scenes/quad8.scene' \
    run -o ./evolve/scenes/quad8.scene

# ---- whole numbers that libconfig would cut ----
for number in 4294967299 0x100000003 2147483648; do
    scene "s/^seed.*/seed = $number;/" tests/scenes/small.scene
    refused "seed $number" "$work/s.scene:7: error: a whole number above 2147483647 must end in L"
done
scene 's|^seed.*|seed = 4294967299L; // 4294967299 /* "|' tests/scenes/small.scene
run --samples "$work/large.csv"; report $((! $?)) 'a large seed, and one in a comment'

# ---- input that programs cannot use ----
scene 's/functions = \["+", "-", "\*", "min", "max"\]/functions = ["+", "*", "sqrt"]/' tests/scenes/steps.scene
refused 'an operator of one value' "$work/s.scene:16: error: tier 'clamped': 'sqrt' is unary; programs take binary operators"
cat > "$work/s.scene" <<'SCENE'
segment = "quad4"; training = 700; heldout = 500; frame = "parallelogram";
shapes: { aspect = 2.0; skew = "20 deg"; taper = 0.1; warp = "5 deg"; gap = 0.1; overhang = 0.1; };
tiers = ( { name = "solve"; terminals = ["e11"]; starts = (["p", "q"]); max_length = 30; functions = "rational"; } );
SCENE
refused 'a start of other values' "$work/s.scene:3: error: tier 'solve': start 'p', 'q' must be made of the tier's terminals"
sed 's/^tiers/starts = (["p", "q"], ["u1", "v1"]);\n&/; s/starts = (\["p", "q"\]); max/max/' "$work/s.scene" > "$work/large.scene"
"$evolve" --quiet --scene "$work/large.scene" --generations 0 --from-scratch -o "$work/o.gen" > "$work/log"
report $((! $?)) 'starts of the scene, for other tiers, are left out'
sed -i 's/"e11"/"p", "q"/; s/30;/30; last = "newton";/' "$work/s.scene" # functions of the frame are called solve_u, solve_v
run -o "$work/o.gen" > "$work/log"; report $((! $?)) 'a tier that is called as functions begin'
refused 'an ending of trees' "$work/s.scene:3: error: tier 'solve': 'last' is for programs, of more operations than 1" --breeding paper
refused 'an ending of one gene' "$work/s.scene:3: error: tier 'solve': 'last' is for programs, of more operations than 1" --max-length 1
cp "$work/o.gen" "$work/kept.gen"
sed -i 's/"p", "q"\]; starts = (\["p", "q"\]);/"e11", "e22"];/' "$work/s.scene"
expect 'a program of other terminals' 1 '' \
    "$work/o.gen:$(grep -n '^genome solve' "$work/o.gen" | cut -d : -f 1): error: genome 'solve' is not a program of the tier's terminals within max_length; --from-scratch starts without it" \
    "$evolve" --quiet --scene "$work/s.scene" --start "$work/o.gen" --generations 0 -o "$work/o.gen"
cmp "$work/o.gen" "$work/kept.gen"; report $((! $?)) 'is kept'

# ---- options that do not go together ----
expect 'members of a list' 2 '' "footpoint-evolve: error: --members is of genomes, not of a list, $work/f.csv" \
    run -o "$work/o.gen" --front "$work/f.csv" --members 1
run -o "$work/o.gen" --front "$work/f.gen" --members 1 --generations 0 > "$work/log"
expect 'members without generations' 0 1 '' grep -c '^genome' "$work/f.gen"
expect 'samples of a checkpoint' 2 '' 'footpoint-evolve: error: --resume and --samples exclude each other' \
    "$evolve" --resume x --samples y.csv

# ---- self contact: a strip of shells folded onto itself, its layers 1/8 apart; all names of one surface mean the same ----
strip() { # strip TYPE: two elements wide, six long, one element round the bend, six back
    awk -v type="$1" 'BEGIN {
        print "*NODE"
        for (i = 0; i <= 26; i++)
            for (j = 0; j <= 4; j++) {
                x = i <= 12 ? i / 2 : i == 13 ? 6 : 6 - 0.46 * (i - 14); z = i <= 12 ? 0 : i == 13 ? 0.0625 : 0.125
                printf "%d, %.15g, %.15g, %.15g\n", 1 + 5 * i + j, x, j / 2, z
            }
        print "*ELEMENT, TYPE=" type ", ELSET=E"
        for (i = 0; i < 26; i += 2)
            for (j = 0; j < 4; j += 2) {
                a = 1 + 5 * i + j; b = a + 10; c = b + 2; d = a + 2; ab = a + 5; bc = b + 1; cd = d + 5; da = a + 1; m = a + 6
                if (type == "S4") print ++e ", " a ", " b ", " c ", " d
                if (type == "S8") print ++e ", " a ", " b ", " c ", " d ", " ab ", " bc ", " cd ", " da
                if (type == "S9") print ++e ", " a ", " b ", " c ", " d ", " ab ", " bc ", " cd ", " da ", " m
                if (type == "S3") { print ++e ", " a ", " b ", " c; print ++e ", " a ", " c ", " d }
                if (type == "S6") { print ++e ", " a ", " b ", " c ", " ab ", " bc ", " m; print ++e ", " a ", " c ", " d ", " m ", " cd ", " da }
            }
        print "*SURFACE, NAME=M\nE, SPOS\n*SURFACE, NAME=S\nE, SPOS\n*NSET, NSET=N, ELSET=E\n*CONTACT PAIR"
    }'
}
# Prints the number of held-out samples, and whether all slave nodes are 1/8 above the face and are not its nodes.
gaps() {
    awk -F, '/^heldout,/ { n++; z = $4; for (i = 2; i < NF - 4; i += 3) if ($(i + 2) != z || $(NF - 2) == z) bad++ } END { print n, bad + 0 }' "$1"
}
for row in S4 S8 S9 S3 S6; do
    echo 'training = 10; heldout = 10; mesh: { file = "strip.inp"; distance = 0.2; };' > "$work/s.scene"
    for pair in 'M, M' M 'M,' 'S, M'; do
        { strip "$row"; echo "$pair"; } > "$work/strip.inp"
        "$evolve" --scene "$work/s.scene" --samples "$work/strip.csv" || break
        grep '^heldout,' "$work/strip.csv" > "$work/samples.${pair%%,*}"
        [ "$pair" = 'M, M' ] && cp "$work/strip.csv" "$work/first.csv"
        grep '^heldout,' "$work/first.csv" | cmp -s - "$work/samples.${pair%%,*}"; report $((! $?)) "self contact of $row: $pair"
    done
    gaps "$work/first.csv" > "$work/gaps"
    awk -v type=$row '{ exit !((type == "S4" ? $1 == 26 : $1 > 20) && $2 == 0) }' "$work/gaps" # 26: counted by hand
    report $((! $?)) "self contact of $row: across the gap only"
done

# A block one element thick, in contact with itself: nodes of its back are not slave nodes of its front.
{
    awk 'BEGIN {
        print "*NODE"
        for (k = 0; k < 2; k++) for (i = 0; i < 4; i++) for (j = 0; j < 4; j++) print ++n ", " i ", " j ", " 0.125 * k
        print "*ELEMENT, TYPE=C3D8, ELSET=E"
        for (i = 0; i < 3; i++) for (j = 0; j < 3; j++) {
            a = 1 + 4 * i + j; print ++e ", " a ", " a + 4 ", " a + 5 ", " a + 1 ", " a + 16 ", " a + 20 ", " a + 21 ", " a + 17
        }
        print "*SURFACE, NAME=M\nE, S1\nE, S2\n*CONTACT PAIR\nM, M"
    }'
} > "$work/strip.inp"
sed 's/distance = .*;/distance = 0.2; };/' "$work/s.scene" > "$work/thin.scene"
"$evolve" --scene "$work/thin.scene" --generations 0 --from-scratch --quiet -o "$work/thin.gen" > "$work/log" 2> /dev/null
grep -q '^thin: 0 training samples are slave nodes of the mesh' "$work/log"; report $((! $?)) 'a thin block: samples are random nodes alone'
