/* footpoint-perceptron: trains perceptrons on a scene's training samples and writes them as genomes, with their errors
 * on held-out samples. */
#include "../../../codegen/base/options.h"
#include "../../../evolve/common/data_root.h"
#include "../../../evolve/eval/errors.h"
#include "../../../evolve/eval/frame.h"
#include "../../../evolve/input/scene_files.h"
#include "../../../evolve/region/sampled_region.h"
#include "../../../evolve/samples/samples.h"
#include "perceptron_train.h"

#include <stdlib.h>
#include <string.h>

enum { PERCEPTRONS = 16, PERCEPTRON_INPUTS = 8 };

struct perceptron_options {
    const char *scene, *root, *output; /* not owned; NULL: not given */
    struct perceptron network[PERCEPTRONS];
    size_t networks; /* at least 1 */
    size_t iterations, samples, seed;
    bool quiet;
};

/* ---- command line ---- */

/* Reads another network, such as "16,16". */
static bool read_hidden(const struct option_table *t, const struct option_row *r, const char *text, void *values,
                        struct diag *d)
{
    struct perceptron_options *o = values;
    if (o->networks == PERCEPTRONS)
        return options_refuse(t, d, "error: --%s %s is too much", r->name, text);
    struct perceptron *p = &o->network[o->networks++];
    *p = (struct perceptron){1, {PERCEPTRON_INPUTS}};
    const size_t hidden = option_wholes(t, r, text, p->size + 1, PERCEPTRON_LAYERS - 2, d);
    if (hidden > PERCEPTRON_LAYERS - 2)
        return options_refuse(t, d, "error: --%s %s has too many layers", r->name, text);
    p->layers = hidden + 2;
    p->size[hidden + 1] = 2;
    for (size_t i = 0; hidden > 0 && i + 1 < o->networks; i++)
        if (memcmp(&o->network[i], p, sizeof *p) == 0)
            return options_refuse(t, d, "error: --%s %s is given twice", r->name, text);
    return hidden > 0;
}

#define AT(member) offsetof(struct perceptron_options, member)
static const struct option_row rows[] = {
    {"scene", 0, OPTION_TEXT, AT(scene), "NAME|FILE",
     .help = "evolve/scenes/NAME.scene, or a file; its training samples are used"},
    {"root", 0, OPTION_TEXT, AT(root), "DIR",
     .help = "folder that holds evolve/ (default: ., or else what is installed)"},
    {"output", 'o', OPTION_TEXT, AT(output), "FILE", .help = "genomes to write: hidden_N_... for each network"},
    {"hidden", 0, OPTION_OWN, AT(network), "N[,N...]", 1, PERCEPTRON_WIDTH, .read = read_hidden,
     .help = "neurons of the hidden layers; a network for each time it is given (default: 8)"},
    {"iterations", 0, OPTION_WHOLE, AT(iterations), "N", 0, 1000000,
     .help = "steps of Levenberg and Marquardt's method at most (default: 200)"},
    {"samples", 0, OPTION_WHOLE, AT(samples), "N", 1, OPTION_ANY, .help = "training samples at most (default: all)"},
    {"seed", 0, OPTION_WHOLE, AT(seed), "N", 0, OPTION_ANY, .help = "of the first weights (default: 1)"},
    {"quiet", 0, OPTION_FLAG, AT(quiet), .help = "nothing on stderr"}};

static const struct option_table option_table = {
    .program = "footpoint-perceptron",
    .usage = "usage: footpoint-perceptron --scene NAME -o FILE [options]\n"
             "Train multi-layer perceptrons for xi and eta of a scene, from the eight values of the similarity frame, "
             "as in\n"
             "the neural-network approach of Oishi and Yoshimura (2007), and write them as genomes.\n",
    .notes =
        "Exit status: 0 done; 1 input rejected; 2 wrong usage; 3 out of memory or unreadable or unwritable file.\n",
    .row = rows,
    .rows = sizeof rows / sizeof *rows};

/* Reads the command line.  Returns OPTIONS_WRONG with *d "footpoint-perceptron: error: ...". */
static enum options_outcome read_options(int argc, char **argv, struct perceptron_options *o, struct diag *d)
{
    const struct option_table *t = &option_table;
    *o = (struct perceptron_options){.root = root_default(), .iterations = 200, .samples = SIZE_MAX, .seed = 1};
    const enum options_outcome outcome = options_read(t, argc, argv, o, NULL, d);
    if (outcome != OPTIONS_READ)
        return outcome;
    if (!o->networks)
        o->network[o->networks++] = (struct perceptron){3, {PERCEPTRON_INPUTS, 8, 2}};
    return options_need(t, "scene", o->scene, d) && options_need(t, "output", o->output, d) ? outcome : OPTIONS_WRONG;
}

/* ---- the study ---- */

/* The eight inputs of section 3.1, values of the similarity frame. */
static char *input_name[PERCEPTRON_INPUTS] = {"xc", "yc", "zc", "xd", "yd", "xs", "ys", "zs"};

enum { HELDOUT_STORED = 200000 }; /* samples of a part at most */

struct study {
    const struct perceptron_options *options;
    struct scene *scene;
    struct genome_file *program;
    int input[PERCEPTRON_INPUTS]; /* genes */
    struct columns table;
    size_t target[2]; /* columns of xi and eta; the program gets more lets later */
    struct sample_set training, heldout[2];
};

/* Returns the program of the similarity frame, for the scene's samples, regardless of the frames that its tiers name. */
static struct genome_file *similarity_program(const struct study *s, struct diag *d)
{
    struct tier tier = {
        .name = "perceptron", .frame = "similarity", .terminal = input_name, .terminals = PERCEPTRON_INPUTS};
    struct scene view = *s->scene;
    view.tier = &tier;
    view.tiers = 1;
    return frame_program(s->options->root, &view, s->options->output, d);
}

/* Checks before the training that files can be written and are not read. */
static bool files_suit(const struct study *s, struct diag *d)
{
    const struct perceptron_options *o = s->options;
    const struct file_use output = {"--output", o->output, true, 0};
    return scene_files_apart("footpoint-perceptron", o->root, s->scene, &output, 1, d) && outfile_probe(o->output, d);
}

static bool load(struct study *s, struct diag *d)
{
    const struct perceptron_options *o = s->options;
    if (!(s->scene = scene_read(o->root, o->scene, d)))
        return false;
    if (s->scene->heldout > HELDOUT_STORED)
        s->scene->heldout = HELDOUT_STORED;
    if (!files_suit(s, d) || !(s->program = similarity_program(s, d)) ||
        !scene_samples(s->scene, PART_TRAINING, &s->training, d) ||
        !scene_samples(s->scene, PART_HELDOUT, &s->heldout[0], d) ||
        !scene_samples(s->scene, PART_HELDOUT_RANDOM, &s->heldout[1], d))
        return false;
    s->table = frame_columns(s->program, s->training.s, s->training.n);
    for (size_t i = 0; i < PERCEPTRON_INPUTS; i++)
        s->input[i] = GENE_SYMBOL + (int)genome_find_symbol(s->program, input_name[i]);
    for (int k = 0; k < 2; k++)
        s->target[k] = frame_target(s->program, k);
    return true;
}

static void name_of(const struct perceptron *p, char name[60])
{
    int n = snprintf(name, 60, "hidden");
    for (size_t l = 1; l + 1 < p->layers; l++)
        n += snprintf(name + n, 60 - (size_t)n, "_%zu", p->size[l]);
}

/* Adds the errors of an output of the genome, on its training samples and on the rest. */
static void add_errors(const struct study *s, struct genome *g, size_t weights, int k)
{
    static const char *const part_name[] = {"training", "heldout", "heldout_random"};
    const struct sample_set *part[] = {&s->training, &s->heldout[0], &s->heldout[1]};
    const struct genes tree = {g->out[k].gene, g->out[k].length};
    char key[40];
    snprintf(key, sizeof key, "terms_%s", frame_output[k]);
    genome_add_note(&g->note, &g->notes, &g->note_room, key, "%zu weights of the network", weights);
    for (int i = 0; i < 3; i++) {
        struct errors e;
        struct measurement m = measurement_open(s->program, &tree, &k, 1, part[i]->n);
        measurement_take(&m, part[i]->s, part[i]->n);
        measurement_close(&m, &e);
        snprintf(key, sizeof key, "%s_%s", part_name[i], frame_output[k]);
        if (i == 0)
            genome_add_note(&g->note, &g->notes, &g->note_room, key, "mean %.4e", e.mean);
        else
            genome_add_note(&g->note, &g->notes, &g->note_room, key, "n %zu mean %.4e p99 %.3e max %.3e", e.n, e.mean,
                            e.p99, e.max);
    }
}

/* Trains a network and appends its genome. */
static void train(const struct study *s, const struct perceptron *p)
{
    const struct perceptron_options *o = s->options;
    size_t column[PERCEPTRON_INPUTS];
    for (size_t i = 0; i < PERCEPTRON_INPUTS; i++)
        column[i] = (size_t)(s->input[i] - GENE_SYMBOL);
    const struct lesson lesson = {.table = &s->table,
                                  .input = column,
                                  .target = {s->target[0], s->target[1]},
                                  .n = o->samples < s->table.n ? o->samples : s->table.n};
    const size_t weights = perceptron_weights(p);
    double *weight = new_array(weights, sizeof *weight);
    char name[60];
    name_of(p, name);
    perceptron_draw(p, o->seed, weight);
    const double error = perceptron_train(p, &lesson, o->iterations, weight);
    if (!o->quiet)
        fprintf(stderr, "%s: %zu weights, root mean square error %.4e\n", name, weights, error);
    struct genome *g = perceptron_add(p, weight, s->input, name, s->program);
    genome_add_note(&g->note, &g->notes, &g->note_room, "trained",
                    "Levenberg-Marquardt iterations %zu samples %zu seed %zu", o->iterations, lesson.n, o->seed);
    free(weight);
}

static bool write_all(const struct study *s, struct diag *d)
{
    struct outfile f;
    if (!outfile_open(&f, s->options->output, d))
        return false;
    for (size_t i = 0; i < s->program->genomes; i++)
        for (int k = 0; k < 2; k++)
            add_errors(s, &s->program->genome[i], perceptron_weights(&s->options->network[i]), k);
    struct region_survey *region = region_survey_new(s->program);
    for (int k = 0; k < 2; k++)
        region_survey_take(region, s->heldout[k].s, s->heldout[k].n);
    region_survey_add(region);
    genome_print_needed(s->program, f.stream);
    return outfile_commit(&f, d);
}

static bool run(const struct perceptron_options *o, struct diag *d)
{
    struct study s = {.options = o};
    bool good = load(&s, d);
    if (good) {
        genome_add_note(&s.program->note, &s.program->notes, &s.program->note_room, "footpoint", "%s",
                        FOOTPOINT_VERSION);
        genome_add_note(&s.program->note, &s.program->notes, &s.program->note_room, "scene", "%s", s.scene->name);
        genome_add_note(&s.program->note, &s.program->notes, &s.program->note_room, "scene_sha256", "%s",
                        s.scene->sha256);
    }
    for (size_t i = 0; good && i < o->networks; i++)
        train(&s, &o->network[i]);
    good = good && write_all(&s, d);
    sample_set_free(&s.training);
    for (int k = 0; k < 2; k++)
        sample_set_free(&s.heldout[k]);
    columns_free(&s.table);
    genome_file_free(s.program);
    scene_free(s.scene);
    return good;
}

int main(int argc, char **argv)
{
    struct perceptron_options o;
    struct diag d = {.code = EXIT_DONE};
    const enum options_outcome outcome = read_options(argc, argv, &o, &d);
    return outcome == OPTIONS_READ ? exit_status(run(&o, &d), &d) : options_end(&option_table, outcome, &d);
}
