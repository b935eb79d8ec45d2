# Checks output files: links are followed, devices, pipes and permissions stay unchanged, no files are left beside,
# and no program overwrites its input.
. tests/cli/expect.inc
codegen=$BIN/footpoint-codegen evolve=$BIN/footpoint-evolve
cat > "$work/a.gen" <<'G'
footpoint-genome 1
input x y
genome a
r = * + x y - x y
end
G
cp "$work/a.gen" "$work/kept.gen"
code() { "$codegen" --quiet --prefix a --effort 0 "$work/a.gen" "$@"; } # code -o FILE
code -o "$work/a.h"
holds() { # holds NAME FILE: it has the code, and nothing lies beside it
    cmp "$work/a.h" "$2" && [ -z "$(find "$work" -name '*.tmp*')" ]
    report $((! $?)) "$1"
}
is() { [ "$@" ]; report $((! $?)) "which stays $name"; } # is -TEST FILE

# ---- links ----
mkdir "$work/far"
echo old > "$work/far/real.h"
ln -s far/real.h "$work/link.h"
ln -s link.h "$work/second.h"
ln -s "$work/far/new.h" "$work/dangling.h"
for link in second link dangling; do
    expect "onto $link.h" 0 '' '' code -o "$work/$link.h"
    name='a link'
    is -h "$work/$link.h"
done
holds 'its target is written' "$work/far/real.h"
holds 'and where there was none, made' "$work/far/new.h"
ln -s loop.h "$work/loop.h"
expect 'a link to itself' 3 '' "$work/loop.h: error: cannot write: Too many levels of symbolic links" code -o "$work/loop.h"

# ---- files that are not regular ----
mkfifo "$work/pipe"
timeout 20 cat "$work/pipe" > "$work/through" &
expect 'into a pipe' 0 '' '' code -o "$work/pipe"
wait $!
name='a pipe'
is -p "$work/pipe"
holds 'its reader gets the code' "$work/through"
if mknod "$work/null" c 1 3 2> /dev/null && : 2> /dev/null > "$work/null"; then
    for program in "$codegen --quiet --effort 0 $work/a.gen" "$BIN/footpoint-calibrate"; do
        expect "into a device, ${program%% *}" 0 '' '' $program -o "$work/null"
        name='a device'
        is -c "$work/null"
    done
else
    report 1 'skipped: no devices can be made here'
fi
# Own links, so that a faulty program cannot harm the machine's.
ln -s /proc/self/fd/1 "$work/standard-output"
expect 'to standard output' 0 "$(cat "$work/a.h")" '' code -o "$work/standard-output"
echo before > "$work/appended"
code -o "$work/standard-output" >> "$work/appended"
{ echo before; cat "$work/a.h"; } | cmp - "$work/appended"
report $((! $?)) 'where that is appended to a file, nothing is lost'
expect 'a folder' 3 '' "$work/far: error: cannot write: Is a directory" code -o "$work/far"

# ---- permissions ----
(umask 027 && code -o "$work/mode.h")
[ "$(stat -c %a "$work/mode.h")" = 640 ]; report $((! $?)) 'a new file has those of any new file'
chmod 604 "$work/mode.h"
code -o "$work/mode.h"
[ "$(stat -c %a "$work/mode.h")" = 604 ]; report $((! $?)) 'a file written again keeps its own'

# ---- input files ----
refused() { # refused PROGRAM ONE OTHER COMMAND...: they are one file
    program=$1 one=$2 other=$3
    shift 3
    expect "$program: $one is $other" 2 '' '*' "$@"
    grep -q "^footpoint-$program: error: $one and $other are one file: " "$work/stderr" && [ "$(wc -l < "$work/stderr")" = 1 ]
    report $((! $?)) 'which one line says'
}
ln "$work/a.gen" "$work/hard.gen"
ln -s a.gen "$work/soft.gen"
for path in "$work/a.gen" "$work/far/../a.gen" "$work/hard.gen" "$work/soft.gen"; do
    refused codegen 'the output' 'the genome file' code -o "$path"
done
cmp "$work/a.gen" "$work/kept.gen"; report $((! $?)) 'the genomes are still there'
printf '%s\n' 'footpoint-costs 1' 'mul 1' 'add 1' 'div 1' 'sqrt 1' 'compare 1' 'chain 0' > "$work/costs"
refused codegen 'the output' --cost code --cost "$work/costs" -o "$work/far/../costs"
refused codegen 'the output' --samples code --samples "$work/costs" -o "$work/costs"
cp tests/scenes/small.scene "$work/"
cp "$work/small.scene" "$work/kept.scene"
run="--scene $work/small.scene --from-scratch --generations 1 --population 20 --quiet"
for option in output front log checkpoint; do
    other=$work/other.gen
    [ $option = output ] && other=$work/small.scene
    refused evolve "--$option" 'the scene' "$evolve" $run --output "$other" --$option "$work/small.scene"
done
refused evolve --samples 'the scene' "$evolve" --scene "$work/small.scene" --samples "$work/small.scene"
refused evolve --output --log "$evolve" $run -o "$work/one" --log "$work/far/../one"
refused evolve --output --seeds "$evolve" $run -o "$work/a.gen" --seeds "$work/a.gen"
frame=$(sed -n 's/.*frame *= *"\([a-z0-9_]*\)".*/\1/p' "$work/small.scene" | head -n 1)
mkdir -p "$work/root/evolve" && cp -r evolve/frames "$work/root/evolve"
refused evolve --output 'a frame' "$evolve" $run --root "$work/root" -o "$work/root/evolve/frames/$frame.gen"
cmp evolve/frames/$frame.gen "$work/root/evolve/frames/$frame.gen"; report $((! $?)) 'the frame is still there'
cmp "$work/small.scene" "$work/kept.scene"; report $((! $?)) 'the scene is still there'

# ---- evolve's other files ----
for file in out.gen front.csv run.ckpt run.csv; do
    ln -s "far/$file" "$work/$file"
done
expect 'evolve onto links' 0 '*' '*' "$evolve" $run -o "$work/out.gen" --front "$work/front.csv" \
    --checkpoint "$work/run.ckpt" --checkpoint-every 0 --log "$work/run.csv"
for file in out.gen front.csv run.ckpt run.csv; do
    [ -h "$work/$file" ] && [ -s "$work/far/$file" ]
    report $((! $?)) "$file: the link stays, its target is there"
done
expect 'again, onto its own start' 0 '*' '*' "$evolve" --scene "$work/small.scene" --generations 0 --quiet \
    --start "$work/out.gen" -o "$work/out.gen"
timeout 20 cat "$work/pipe" > "$work/through" &
expect 'evolve into a pipe' 0 '*' '*' "$evolve" $run -o "$work/pipe"
wait $!
grep -q '^genome ' "$work/through"; report $((! $?)) 'its reader gets the genomes'
timeout 20 cat "$work/pipe" > "$work/through" &
expect 'samples into a pipe' 0 '' '' "$evolve" --scene "$work/small.scene" --samples "$work/pipe"
wait $!
[ "$(wc -l < "$work/through")" -gt 200 ]; report $((! $?)) 'its reader gets the samples'
[ -p "$work/pipe" ] && [ -z "$(find "$work" -name '*.tmp*')" ]; report $((! $?)) 'and nothing lies beside'
