# Checks the runtime library on 64-bit Arm: it compiles without a warning, and under emulation batches return the bits
# of single searches. Skipped without gcc-aarch64-linux-gnu, libc6-dev-arm64-cross, qemu-user.
. tests/cli/expect.inc
command -v aarch64-linux-gnu-gcc > /dev/null || { report 1 'skipped: no compiler for Arm'; exit 0; }
aarch64-linux-gnu-gcc -std=c11 -D_DEFAULT_SOURCE -O3 -Wall -Wextra -Wpedantic -Wshadow -Wconversion -Werror \
    -ffp-contract=off -fno-math-errno -fno-trapping-math -static tests/fuzz/fuzz_search.c tests/fuzz/replay_main.c \
    $(ls runtime/*/*.c | grep -v /replace/) -lm -o "$work/replay" > "$work/log" 2>&1
good=$((! $?))
[ "$good" = 1 ] || sed 's/^/# /' "$work/log"
report "$good" 'compiles for Arm'
command -v qemu-aarch64 > /dev/null || { report 1 'skipped: no emulator of Arm'; exit 0; }
qemu-aarch64 "$work/replay" tests/fuzz/search/*.bin > "$work/log" 2>&1 &&
    qemu-aarch64 "$work/replay" --random 10000 1 > "$work/log" 2>&1
good=$((! $?))
[ "$good" = 1 ] || sed 's/^/# /' "$work/log"
report "$good" 'searches on Arm'
