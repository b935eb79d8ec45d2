/* Runs a fuzzer's function without libFuzzer.
 *     replay FILE...            on these files
 *     replay --random N SEED    on N random inputs, the same for the same seed
 *     replay --write SEED FILE  writes the random input of that seed */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST = 4096 };

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static uint64_t draw(uint64_t *state)
{
    uint64_t z = *state += 0x9e3779b97f4a7c15U;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9U;
    z = (z ^ z >> 27) * 0x94d049bb133111ebU;
    return z ^ z >> 31;
}

/* Makes bytes that repeat and are extreme more often than by chance. */
static size_t random_input(uint64_t seed, uint8_t data[MOST])
{
    uint64_t state = seed * 2;
    const size_t size = 8 + draw(&state) % (draw(&state) % 2 ? 100 : 700);
    const uint64_t repeat = draw(&state) % 8;
    for (size_t i = 0; i < size; i++) {
        const uint64_t r = draw(&state);
        data[i] = (uint8_t)(r >> 32);
        if (i > 30 && r % 8 < repeat)
            data[i] = data[i - 24 + r / 8 % 5];
        else if (r / 64 % 16 == 0)
            data[i] = (uint8_t)(r % 2 ? 0xff : r / 2 % 2 ? 0x7f : 0);
    }
    return size;
}

static int run_file(const char *path)
{
    static uint8_t data[MOST];
    FILE *const f = fopen(path, "rb");
    if (!f) {
        perror(path);
        return 1;
    }
    const size_t size = fread(data, 1, MOST, f);
    fclose(f);
    LLVMFuzzerTestOneInput(data, size);
    return 0;
}

int main(int argc, char **argv)
{
    static uint8_t data[MOST];
    int failed = 0;
    if (argc == 4 && strcmp(argv[1], "--write") == 0) {
        FILE *const f = fopen(argv[3], "wb");
        const size_t size = random_input(strtoull(argv[2], NULL, 10), data);
        return !f || fwrite(data, 1, size, f) != size || fclose(f);
    }
    if (argc == 4 && strcmp(argv[1], "--random") == 0) {
        const uint64_t n = strtoull(argv[2], NULL, 10), seed = strtoull(argv[3], NULL, 10);
        for (uint64_t i = 0; i < n; i++)
            LLVMFuzzerTestOneInput(data, random_input(seed + i, data));
        return 0;
    }
    for (int i = 1; i < argc; i++)
        failed |= run_file(argv[i]);
    return failed;
}
