/* Scenes: the shipped scenes read, malformed scenes are refused with exact diagnostics, and samples are labelled with
 * the certain foot point, within the limits, equal in every call, and in only one part. */
#include "../../evolve/input/scene_print.h"
#include "../support/scene_text.h"

static void shipped_scenes_read(void **state)
{
    static const struct {
        const char *name, *segment;
        enum scene_source source;
        enum corner_order order;
        size_t training, heldout;
        bool open; /* the segments determine frame and tiers */
    } expected[] = {{"paper-quad4", "quad4", SOURCE_LATTICE, CORNERS_NEAREST_SHORTER, 28546, 200000, false},
                    {"quad4", "quad4", SOURCE_RANDOM, CORNERS_ANY, 20000, 1000000, false},
                    {"quad4-float", "quad4", SOURCE_RANDOM, CORNERS_ANY, 20000, 200000, false},
                    {"plane-quad4", "quad4", SOURCE_RANDOM, CORNERS_ANY, 20000, 1000000, true},
                    {"parallelogram-quad4", "quad4", SOURCE_RANDOM, CORNERS_ANY, 20000, 1000000, true},
                    {"rectangle-quad4", "quad4", SOURCE_RANDOM, CORNERS_ANY, 20000, 1000000, true},
                    {"bricks-quad4", "quad4", SOURCE_MESH, CORNERS_ANY, 20000, 1000000, true},
                    {"punch-quad4", "quad4", SOURCE_MESH, CORNERS_ANY, 20000, 1000000, false},
                    {"blocks-quad4", "quad4", SOURCE_MESH, CORNERS_ANY, 20000, 1000000, false},
                    {"tri3", "tri3", SOURCE_RANDOM, CORNERS_ANY, 20000, 1000000, false},
                    {"tri6", "tri6", SOURCE_RANDOM, CORNERS_ANY, 20000, 200000, false},
                    {"quad8", "quad8", SOURCE_RANDOM, CORNERS_ANY, 20000, 200000, false},
                    {"quad9", "quad9", SOURCE_RANDOM, CORNERS_ANY, 20000, 200000, false},
                    {"gregory", "gregory", SOURCE_RANDOM, CORNERS_ANY, 20000, 100000, false},
                    {"bezier", "bezier", SOURCE_RANDOM, CORNERS_ANY, 20000, 100000, false},
                    {"paper-gregory", "gregory", SOURCE_LATTICE, CORNERS_ANY, 28540, 30000, false}};
    (void)state;
    for (size_t i = 0; i < sizeof expected / sizeof *expected; i++) {
        struct scene *s = shipped(expected[i].name);
        assert_string_equal(s->name, expected[i].name);
        assert_string_equal(s->segment->name, expected[i].segment);
        assert_string_equal(s->precision, strstr(s->name, "-float") ? "float" : "double");
        assert_int_equal(s->source, expected[i].source);
        assert_int_equal(s->order, expected[i].order);
        assert_int_equal(s->training, expected[i].training);
        assert_int_equal(s->heldout, expected[i].heldout);
        assert_int_equal(s->norm, NORM_MEAN);
        assert_int_equal(strlen(s->sha256), 64);
        if (expected[i].open)
            assert_true(s->tiers == 0 && isnan(s->reference[0]) && isnan(s->reference[1]));
        else
            assert_true(s->tiers > 0 && fabs(s->reference[0]) <= 1 && fabs(s->reference[1]) <= 1);
        scene_free(s);
    }
}

/* The segments of these scenes have the shapes of their names. */
static void shipped_shapes_are_recognised(void **state)
{
    static const struct {
        const char *name;
        enum variation_kind kind;
    } expected[] = {{"plane-quad4", VARY_PLANE},
                    {"parallelogram-quad4", VARY_PARALLELOGRAMS},
                    {"rectangle-quad4", VARY_RECTANGLES},
                    {"bricks-quad4", VARY_RECTANGLES},
                    {"quad4", VARY_WARPED},
                    {"punch-quad4", VARY_WARPED}};
    (void)state;
    for (size_t i = 0; i < sizeof expected / sizeof *expected; i++) {
        struct scene *s = shipped(expected[i].name);
        struct sample_set set = {0};
        struct diag d;
        s->training = 2000;
        assert_true(scene_samples(s, PART_TRAINING, &set, &d));
        const struct variation v = variation_measure(segment_find("quad4"), &set);
        assert_int_equal(v.kind, expected[i].kind);
        if (s->source == SOURCE_RANDOM) /* measured as in the scene, up to the limits */
            for (int k = 0; k < 3; k++) {
                const double found = (const double[]){v.taper, v.warp, v.skew}[k];
                const double limit = (const double[]){s->shapes.taper, s->shapes.warp, s->shapes.skew}[k];
                assert_true(found > 0.98 * limit && found < limit + v.tolerance);
            }
        sample_set_free(&set);
        scene_free(s);
    }
}

static void every_value_arrives(void **state)
{
    struct diag d;
    struct scene *s = read_from_text(HEAD SHAPES TAIL, &d);
    (void)state;
    assert_non_null(s);
    assert_string_equal(s->path, path);
    assert_int_equal(strlen(s->name), strlen(path) - strlen("/tmp/") - strlen(".scene"));
    assert_int_equal(s->norm, NORM_P99);
    assert_string_equal(s->precision, "double");
    assert_int_equal(s->seed, 5);
    assert_int_equal(s->training, 60);
    assert_int_equal(s->heldout, 40);
    assert_int_equal(s->source, SOURCE_RANDOM);
    assert_true(s->shapes.aspect == 5 && s->shapes.taper == 0.3 && s->shapes.gap == 0.2 && s->shapes.overhang == 0.1);
    assert_true(fabs(s->shapes.skew - M_PI_4) < 1e-15 && fabs(s->shapes.warp - M_PI / 12) < 1e-15);
    assert_int_equal(s->tiers, 2);
    assert_string_equal(s->tier[0].name, "fast");
    assert_string_equal(s->tier[0].frame, "parallelogram");
    assert_int_equal(s->tier[0].terminals, 2);
    assert_string_equal(s->tier[0].terminal[1], "q");
    assert_int_equal(s->tier[0].max_length, 50);
    assert_true(s->tier[0].rational && !s->tier[1].rational);
    assert_string_equal(s->tier[1].frame, "other");
    scene_free(s);

    s = read_from_text(HEAD SHAPES, &d);
    assert_true(s && s->tiers == 0 && s->reference[0] == 0);
    assert_true(scene_default_tiers("", s, VARY_PLANE, &d));
    assert_true(s->tiers == 3 && s->reference[0] == 0);
    scene_free(s);

    s = read_from_text(HEAD LATTICE TAIL, &d);
    assert_non_null(s);
    const struct lattice *l = &s->lattice;
    assert_true(l->xy.most == 1 && l->xy.step == 0.25 && l->z.most == 0.3 && l->z.step == 0.1 && l->newton == 0);
    assert_true(l->xi[0] == -1 && l->xi[1] == 0 && l->eta[0] == -1 && l->eta[1] == 0);
    scene_free(s);
}

/* The text with `find` replaced by `put` is refused with "file:" and `expected`. */
struct malformed {
    const char *text, *find, *put, *expected;
};

static const struct malformed malformed[] = {
    /* the scene */
    {HEAD SHAPES TAIL, "seed = 5;", "\n@include \"LICENSE\"\nseed = 5;",
     "7: error: a scene must not include other files"},
    {HEAD SHAPES TAIL, "seed = 5;", "seed = ;", "6: error: syntax error"},
    {HEAD SHAPES TAIL, "seed = 5;", "seed = 5; seed = 6;", "6: error: duplicate setting name"},
    {HEAD SHAPES TAIL, "seed = 5;", "seeds = 5;", "6: error: unknown key 'seeds' in scene"},
    {HEAD SHAPES TAIL, "training = 60;\nheldout = 40;\n", "",
     " error: scene lacks 'training' (such as 20000), 'heldout' (such as 50000)"},
    {SHAPES, "gap = 0.2;", "",
     " error: scene lacks 'training' (such as 20000), 'heldout' (such as 50000), 'segment' (such as \"quad4\")"},
    {HEAD SHAPES TAIL, "heldout = 40;\nshapes: { aspect = 5; ", "shapes: {",
     " error: scene lacks 'heldout' (such as 50000); shapes lacks 'aspect' (such as 5.0)"},
    {HEAD SHAPES TAIL, "seed = 5;", "seed = -5;", "6: error: 'seed' must be in 0..9223372036854775807"},
    {HEAD SHAPES TAIL, "seed = 5;", "seed = 5.0;", "6: error: 'seed' must be a whole number"},
    {HEAD SHAPES TAIL, "training = 60;", "training = 0;", "7: error: 'training' must be in 1..100000000"},
    {HEAD SHAPES TAIL, "training = 60;", "training = -60;", "7: error: 'training' must be in 1..100000000"},
    {HEAD SHAPES TAIL, "heldout = 40;", "heldout = \"40\";", "8: error: 'heldout' must be a whole number"},
    {HEAD SHAPES TAIL, "\"quad4\"", "\"hexagon\"", "1: error: unknown segment 'hexagon'"},
    {HEAD SHAPES TAIL, "\"quad4\"", "\"gregory\"", "9: error: unknown key 'aspect' in shapes"},
    {HEAD LATTICE TAIL, "\"quad4\"", "\"gregory\"",
     "9: error: lattice lacks 'normal_sets' (such as 10), 'tilt' (such as 0.3)"},
    {HEAD SHAPES TAIL, "\"quad4\"", "\"quad5\"", "1: error: unknown segment 'quad5'"},
    {HEAD SHAPES TAIL, "\"quad4\"", "\"tri3\"", "9: error: unknown key 'taper' in shapes"},
    {HEAD SHAPES TAIL, "\"quad4\"", "\"quad8\"",
     "9: error: shapes lacks 'curve' (such as 0.05), 'shift' (such as 0.03)"},
    {HEAD LATTICE TAIL, "\"quad4\"", "\"quad9\"", "9: error: a 'lattice' must have segment quad4, gregory or bezier"},
    {HEAD "shapes: { aspect = 5; skew = \"45 deg\"; gap = 0.2; overhang = 0.1; };\n", "\"quad4\";\norder = \"any\"",
     "\"tri3\";\norder = \"nearest\"", "2: error: 'order' must be \"any\" for segment 'tri3'"},
    {HEAD SHAPES TAIL, "\"quad4\"", "4", "1: error: 'segment' must be a text in quotes"},
    {HEAD SHAPES TAIL, "\"any\"", "\"some\"",
     "2: error: 'order' must be \"any\" or \"nearest\" or \"nearest-shorter\""},
    {HEAD SHAPES TAIL, "\"p99\"", "99", "4: error: 'norm' must be \"mean\" or \"p99\" or \"max\""},
    {HEAD SHAPES TAIL, "\"double\"", "\"half\"", "5: error: 'precision' must be \"double\" or \"float\""},
    {HEAD SHAPES TAIL, "[0.0, 0.0]", "[0.0]", "3: error: 'reference' must be two numbers, [a, b]"},
    {HEAD SHAPES TAIL, "[0.0, 0.0]", "0.0", "3: error: 'reference' must be two numbers, [a, b]"},
    {HEAD SHAPES TAIL, "[0.0, 0.0]", "[0.0, -1.5]", "3: error: 'reference' must be in -1..1"},
    {HEAD SHAPES TAIL, "[0.0, 0.0]", "[\"a\", \"b\"]", "3: error: 'reference' must be a number"},
    {HEAD TAIL, "seed", "seed",
     " error: scene lacks 'mesh' (such as mesh: { file = \"contact.inp\"; distance = 0.5; }, or 'shapes')"},
    {HEAD SHAPES LATTICE TAIL, "seed", "seed",
     "9: error: both 'lattice' and 'shapes' are given; a scene must have exactly one of lattice, shapes and mesh"},
    {HEAD TAIL, "frame", "shapes = 3; frame", "9: error: 'shapes' must be a group, { ... }"},
    /* shapes */
    {HEAD SHAPES TAIL, "skew = \"45 deg\"", "skew = 45",
     "9: error: 'skew' must be an angle with its unit, \"45 deg\" or \"0.8 rad\""},
    {HEAD SHAPES TAIL, "\"45 deg\"", "\"45\"", "9: error: 'skew' needs a unit, deg or rad"},
    {HEAD SHAPES TAIL, "\"45 deg\"", "\"45 degrees\"",
     "9: error: 'skew' has the unknown unit 'degrees'; it must be deg or rad"},
    {HEAD SHAPES TAIL, "\"45 deg\"", "\"deg\"",
     "9: error: 'skew' must be an angle with its unit, \"45 deg\" or \"0.8 rad\""},
    {HEAD SHAPES TAIL, "\"45 deg\"", "\"86 deg\"", "9: error: 'skew' must be in 0..85 deg; \"45 deg\" is usual"},
    {HEAD SHAPES TAIL, "\"45 deg\"", "\"nan deg\"", "9: error: 'skew' must be in 0..85 deg; \"45 deg\" is usual"},
    {HEAD SHAPES TAIL, "\"15 deg\"", "\"170 deg\"", "9: error: 'warp' must be in 0..90 deg; \"15 deg\" is usual"},
    {HEAD SHAPES TAIL, "\"15 deg\"", "\"2 rad\"", "9: error: 'warp' must be in 0..90 deg; \"15 deg\" is usual"},
    {HEAD SHAPES TAIL, "aspect = 5", "aspect = 0.5", "9: error: 'aspect' must be in 1..1000; 5.0 is usual"},
    {HEAD SHAPES TAIL, "taper = 0.3", "taper = 1.0", "9: error: 'taper' must be in 0..0.95; 0.3 is usual"},
    {HEAD SHAPES TAIL, "gap = 0.2", "gap = -0.2", "9: error: 'gap' must be in 0..100; 0.2 is usual"},
    {HEAD SHAPES TAIL, "overhang = 0.1", "overhang = true", "9: error: 'overhang' must be a number"},
    {HEAD SHAPES TAIL, "overhang = 0.1; ", "", "9: error: shapes lacks 'overhang' (such as 0.1)"},
    {HEAD SHAPES TAIL, "overhang", "over", "9: error: unknown key 'over' in shapes"},
    /* lattice */
    {HEAD LATTICE TAIL, "[1.0, 0.25]", "[1.0, 0.0]",
     "9: error: 'xy' is [largest, step]; the step must be at least 0.001"},
    {HEAD LATTICE TAIL, "[0.3, 0.1]", "[-0.3, 0.1]", "9: error: 'z' must be in 0..100"},
    {HEAD LATTICE TAIL, "xi = [-1.0, 0.0]", "xi = [0.0, 0.0]",
     "9: error: 'xi' is [lower, upper]; the lower must be below the upper"},
    {HEAD LATTICE TAIL, "eta = [-1.0, 0.0];", "", "9: error: lattice lacks 'eta' (such as [-1.0, 0.0])"},
    {HEAD LATTICE TAIL, "eta = [-1.0, 0.0];", "eta = [-1.0, 0.0]; newton = 0;",
     "9: error: 'newton' must be in 1..1000"},
    {HEAD LATTICE TAIL, "eta = [-1.0, 0.0];", "eta = [-1.0, 0.0]; random = 0;",
     "9: error: 'random' must be in 1..100000000"},
    {HEAD LATTICE TAIL, "xy", "yx", "9: error: unknown key 'yx' in lattice"},
    /* mesh */
    {HEAD MESH TAIL, "MESH", "/nonexistent/m.inp", "9: error: cannot read mesh file '/nonexistent/m.inp'"},
    {HEAD MESH TAIL, "MESH", "nonexistent.inp", "9: error: cannot read mesh file '/tmp/nonexistent.inp'"},
    {HEAD MESH TAIL, "\"MESH\"", "1", "9: error: 'file' must be a text in quotes"},
    {HEAD MESH TAIL, "distance = 0.5", "distance = 0.0", "9: error: 'distance' must be in 1e-300..1e+300"},
    {HEAD MESH TAIL, "file = \"MESH\"; distance = 0.5;", "", "9: error: mesh lacks 'file' (such as \"contact.inp\")"},
    /* tiers */
    {HEAD SHAPES TAIL, "tiers = (", "tiers = ();\ntier = (", "12: error: unknown key 'tier' in scene"},
    {HEAD SHAPES, "heldout", "tiers = (); heldout",
     "8: error: 'tiers' must be a list of groups, ( { name = ...; }, ... )"},
    {HEAD SHAPES, "heldout", "tiers = 1; heldout",
     "8: error: 'tiers' must be a list of groups, ( { name = ...; }, ... )"},
    {HEAD SHAPES, "heldout", "tiers = (1); heldout", "8: error: a tier must be a group, { name = ...; }"},
    {HEAD SHAPES TAIL, "\"slow\"", "\"fast\"", "13: error: tier 'fast' stands twice"},
    {HEAD SHAPES TAIL, "\"fast\"", "\"3d\"", "12: error: tier name '3d' is not a C identifier"},
    {HEAD SHAPES TAIL, "\"fast\"", "\"very fast\"", "12: error: tier name 'very fast' is not a C identifier"},
    {HEAD SHAPES, "heldout", "frame = \"plane\"; heldout",
     "8: error: 'frame' without 'tiers'; a scene names both or leaves both to its segments"},
    {HEAD SHAPES TAIL, "\"other\"", "\"../other\"", "13: error: frame '../other' is not a name"},
    {HEAD SHAPES TAIL, "\"other\"", "3", "13: error: 'frame' must be a text in quotes"},
    {HEAD SHAPES TAIL, "[\"p\", \"q\"]", "\"p\"", "12: error: 'terminals' must be names, [\"p\", \"q\"]"},
    {HEAD SHAPES TAIL, "[\"p\", \"q\"]", "[]", "12: error: 'terminals' must be names, [\"p\", \"q\"]"},
    {HEAD SHAPES TAIL, "[\"p\", \"q\"]", "[\"p\", \"p\"]", "12: error: terminal 'p' stands twice"},
    {HEAD SHAPES TAIL, "[\"p\", \"q\"]", "[\"p\", \"2q\"]", "12: error: terminal '2q' is not a name"},
    {HEAD SHAPES TAIL, "[\"p\", \"q\"]", "[1, 2]", "12: error: 'terminals' must be a text in quotes"},
    {HEAD SHAPES TAIL, "max_length = 50", "max_length = 0", "12: error: 'max_length' must be in 1..100000"},
    {HEAD SHAPES TAIL, "max_length = 50", "max_length = 100001", "12: error: 'max_length' must be in 1..100000"},
    {HEAD SHAPES TAIL, "max_length = 50; ", "", "12: error: tier 1 lacks 'max_length' (such as 30)"},
    {HEAD SHAPES TAIL, "\"rational\"", "\"any\"", "12: error: 'functions' must be \"polynomial\" or \"rational\""},
    {HEAD SHAPES TAIL, "max_length", "reference = [0.0, 2.0]; max_length", "12: error: 'reference' must be in -1..1"},
    {HEAD SHAPES TAIL, "max_length", "last = 3; max_length", "12: error: 'last' must be a text in quotes"},
    {HEAD SHAPES TAIL, "max_length = 50", "last = \"foot\"; max_length = 1",
     "12: error: tier 'fast': 'last' is for programs, of more operations than 1"},
    {HEAD SHAPES TAIL, "max_length", "maximum", "12: error: unknown key 'maximum' in tier 1"},
};

static void malformed_scenes_are_refused(void **state)
{
    int bad = 0;
    (void)state;
    for (size_t i = 0; i < sizeof malformed / sizeof *malformed; i++) {
        const struct malformed *m = &malformed[i];
        char *text = replaced(m->text, m->find, m->put), expected[600];
        struct diag d = {0};
        struct scene *s = read_from_text(text, &d);
        snprintf(expected, sizeof expected, "%s:%s", path, m->expected);
        if (s || strcmp(d.text, expected) != 0 || d.code != EXIT_INPUT) {
            print_error("'%s' -> '%s'\n  gives    %s\n  expected %s\n", m->find, m->put, s ? "a scene" : d.text,
                        expected);
            bad++;
        }
        free(text);
    }
    assert_int_equal(bad, 0);
}

/* A scene of any kind needs only its segments, their limits and the number of samples; the rest has defaults. */
static void usual_values(void **state)
{
    static const char *const kind[] = {"quad4", "tri3", "tri6", "quad8", "quad9", "gregory", "bezier"};
    struct diag d = {0};
    (void)state;
    for (size_t i = 0; i < sizeof kind / sizeof *kind; i++) {
        char text[400];
        const bool patch = i > 4, middles = i > 1 && i < 5, triangle = i == 1 || i == 2;
        snprintf(text, sizeof text, "segment = \"%s\"; training = 9; heldout = 8; shapes: { gap = 0.2; %s %s %s };\n",
                 kind[i], patch ? "" : "aspect = 5; skew = \"45 deg\"; overhang = 0.1;",
                 middles ? "curve = 0.05; shift = 0.03;" : "",
                 triangle || patch ? "" : "taper = 0.3; warp = \"9 deg\";");
        struct scene *s = read_from_text(text, &d), *usual = shipped(kind[i]);
        if (!s)
            fail_msg("%s: %s", kind[i], d.text);
        assert_true(s->order == CORNERS_ANY && s->norm == NORM_MEAN && s->seed == 1 && !s->warnings);
        assert_string_equal(s->precision, "double");
        assert_true(s->tiers == 0 && scene_default_tiers("", s, VARY_WARPED, &d));
        assert_int_equal(s->tiers, usual->tiers);
        for (size_t k = 0; k < s->tiers; k++) {
            assert_string_equal(s->tier[k].name, usual->tier[k].name);
            assert_string_equal(s->tier[k].frame, usual->tier[k].frame);
            assert_string_equal(s->tier[k].terminal[0], usual->tier[k].terminal[0]);
        }
        if (i != 1) /* whose frame needs no reference point */
            for (int k = 0; k < 2; k++)
                assert_true(fabs(s->reference[k] - usual->reference[k]) < 1e-15);
        scene_free(usual);
        scene_free(s);
    }
    char *text = replaced(HEAD SHAPES TAIL, "reference = [0.0, 0.0];\n", ""),
         *bare = replaced(text, "frame = \"parallelogram\";\n", "");
    struct scene *s = read_from_text(bare, &d);
    assert_non_null(s);
    assert_true(s->reference[0] == 0 && s->reference[1] == 0);
    assert_string_equal(s->tier[0].frame, "parallelogram");
    assert_string_equal(s->tier[1].frame, "other");
    scene_free(s);
    free(bare);
    free(text);
    s = shipped("quad4");
    assert_null(scene_of_kind("", s, &d));
    assert_string_equal(d.text, "evolve/scenes/quad4.scene: error: frame and tiers are missing; other scenes of "
                                "segment quad4 take them from here");
    scene_free(s);
}

/* Uncomments the keys of a printed scene, except for sources other than shapes. */
static void open_comments(const char *printed, char *text)
{
    bool other = false;
    for (const char *line = printed, *end; *line; line = end) {
        end = strchr(line, '\n') + 1;
        other = other || strncmp(line, "// mesh: {", 10) == 0 || strncmp(line, "// lattice: {", 13) == 0;
        const char *equals = strstr(line, " = ");
        const bool key = (equals && equals < end) || strncmp(line, "// });", 6) == 0;
        if (!other)
            text += sprintf(text, "%.*s", (int)(end - line - (key && *line == '/' ? 3 : 0)),
                            line + (key && *line == '/' ? 3 : 0));
        other = other && strncmp(line, "// };", 5) != 0;
    }
}

/* Printed scenes read back, unchanged and with every key of scene and tiers. */
static void printed_scenes_read(void **state)
{
    static const char *const kind[] = {"quad4", "tri3", "tri6", "quad8", "quad9", "gregory", "bezier"};
    (void)state;
    for (size_t i = 0; i < sizeof kind / sizeof *kind; i++) {
        char printed[8000] = "", open[8000] = "";
        struct diag d;
        FILE *f = fmemopen(printed, sizeof printed, "w");
        scene_print(segment_find(kind[i]), f);
        fclose(f);
        struct scene *s = read_from_text(printed, &d);
        if (!s)
            fail_msg("%s: %s", kind[i], d.text);
        assert_string_equal(s->segment->name, kind[i]);
        assert_true(s->tiers == 0 && s->training == 20000 && s->seed == 1 && s->shapes.gap == 0.2 && !s->warnings);
        scene_free(s);
        open_comments(printed, open);
        s = read_from_text(open, &d);
        if (!s)
            fail_msg("%s: %s", kind[i], d.text);
        assert_true(s->tiers == 1 && s->reference[0] == 0 && s->tier[0].program && s->tier[0].budget == 131);
        assert_string_equal(s->tier[0].last, "newton_at1");
        scene_free(s);
    }
}

/* Unusual limits of meshes are accepted with a note. */
static void unusual_limits_are_noted(void **state)
{
    static const struct {
        const char *find, *put, *told;
    } limit[] = {{"gap = 0.2", "gap = 100", "'gap' is 100; 0.2 is usual"},
                 {"aspect = 5", "aspect = 900", "'aspect' is 900; 5.0 is usual"},
                 {"15 deg", "80 deg", "'warp' is 80 deg; \"15 deg\" is usual"},
                 {"45 deg", "1.4 rad", "'skew' is 80.2141 deg; \"45 deg\" is usual"},
                 {"taper = 0.3", "taper = 0.9", "'taper' is 0.9; 0.3 is usual"},
                 {"overhang = 0.1", "overhang = 1", "'overhang' is 1; 0.1 is usual"}};
    struct diag d = {0};
    (void)state;
    for (size_t i = 0; i < sizeof limit / sizeof *limit; i++) {
        char *text = replaced(HEAD SHAPES TAIL, limit[i].find, limit[i].put), expected[200];
        struct scene *s = read_from_text(text, &d);
        assert_non_null(s);
        snprintf(expected, sizeof expected, "%s:9: warning: %s\n", path, limit[i].told);
        assert_string_equal(s->warnings, expected);
        scene_free(s);
        free(text);
    }
}

/* Tiers about one point share the frame's values there; tiers about the scene's point keep their names. */
static void tiers_expand_about_points_of_their_own(void **state)
{
#define TIER(name, point)                                                                                              \
    "    { name = \"" name "\"; terminals = [\"p\"]; max_length = 1; functions = \"polynomial\"; " point " }"
    static const char text[] =
        HEAD SHAPES "frame = \"parallelogram\";\n"
                    "tiers = (\n" TIER("a", "") ",\n" TIER("b", "reference = [-0.25, 0.0];") ",\n" TIER(
                        "c", "reference = [0.5, 0.5];") ",\n" TIER("d", "reference = [-0.25, 0.0];") "\n);\n";
    static const struct {
        const char *terminal;
        double xi0;
    } expected[] = {{"p", 0}, {"p_at1", -0.25}, {"p_at2", 0.5}, {"p_at1", -0.25}};
    struct diag d;
    struct scene *s = read_from_text(text, &d);
    (void)state;
    if (!s)
        fail_msg("%s", d.text);
    struct genome_file *program = frame_program(".", s, "program", &d), *frame = NULL;
    assert_non_null(program);
    frame = genome_read("evolve/frames/parallelogram.gen", &d);
    assert_non_null(frame);
    assert_int_equal(program->lets, 3 * frame->lets);
    for (size_t i = 0; i < 4; i++) {
        char name[16];
        assert_string_equal(s->tier[i].terminal[0], expected[i].terminal);
        assert_true(genome_find_symbol(program, s->tier[i].terminal[0]) >= 0);
        snprintf(name, sizeof name, "xi0%s", expected[i].terminal + 1);
        const long k = genome_find_symbol(program, name);
        assert_true(k >= 0);
        const struct genome_expr *xi0 = &program->let[(size_t)k - program->inputs];
        assert_true(program->constant[-1 - xi0->gene[0]].value == expected[i].xi0);
    }
    genome_file_free(frame);
    genome_file_free(program);
    scene_free(s);
#undef TIER
}

/* Programs may have their own reference point, with the frame's values, functions, starts and exchanges there. */
static void programs_have_reference_points(void **state)
{
    struct diag d;
    struct scene *s = read_from_text(HEAD SHAPES "frame = \"parallelogram\";\n"
                                                 "tiers = (\n"
                                                 "    { name = \"a\"; terminals = [\"e11\"]; max_length = 9; "
                                                 "functions = [\"+\", \"*\", \"solve_u\"];\n"
                                                 "      starts = ([\"p\", \"q\"]); reference = [0.5, 0.25]; }\n"
                                                 ");\n",
                                     &d);
    (void)state;
    if (!s)
        fail_msg("%s", d.text);
    assert_string_equal(s->tier[0].function[1], "*");
    assert_string_equal(s->tier[0].function[2], "solve_u_at1");
    assert_string_equal(s->tier[0].start[0][1], "q_at1");
    struct genome_file *program = frame_program(".", s, "program", &d);
    if (!program)
        fail_msg("%s", d.text);
    assert_true(genome_find_function(program, "solve_u_at1") >= 0 && genome_find_function(program, "solve_u") < 0);
    assert_int_equal(program->exchanges, 3);
    assert_int_equal(program->exchange[2][0], genome_find_symbol(program, "e11_at1"));
    assert_int_equal(program->exchange[2][1], genome_find_symbol(program, "e22_at1"));
    genome_file_free(program);
    scene_free(s);
}

/* Two frames in one scene share equal definitions; different definitions of a name are refused. */
static void frames_share_what_is_alike(void **state)
{
#define TIERS(one, value, other)                                                                                       \
    "tiers = (\n    { name = \"a\"; frame = \"" one "\"; terminals = [\"" value                                        \
    "\"]; max_length = 1; functions = \"rational\"; },\n"                                                              \
    "    { name = \"b\"; frame = \"" other                                                                             \
    "\"; terminals = [\"p\"]; max_length = 1; functions = \"rational\"; }\n);\n"
    struct diag d;
    struct scene *s = read_from_text(HEAD SHAPES TIERS("similarity", "xs", "steps"), &d);
    (void)state;
    assert_non_null(s);
    struct genome_file *program = frame_program(".", s, "program", &d);
    struct genome_file *other = genome_read("evolve/frames/similarity.gen", &d);
    struct genome_file *steps = genome_read("evolve/frames/steps.gen", &d);
    assert_non_null(program);
    size_t common = 0;
    for (size_t i = 0; i < steps->lets; i++)
        common += genome_find_symbol(other, steps->let[i].name) >= 0;
    assert_int_equal(common, 9);
    assert_int_equal(program->lets, other->lets + steps->lets - common);
    assert_int_equal(program->functions, steps->functions);
    genome_file_free(steps);
    genome_file_free(other);
    genome_file_free(program);
    scene_free(s);
    s = read_from_text(HEAD SHAPES TIERS("steps", "p", "parallelogram"), &d);
    assert_non_null(s);
    assert_null(frame_program(".", s, "program", &d));
    assert_non_null(strstr(d.text, "' has another value in another frame of the scene"));
    scene_free(s);
#undef TIERS
}

static void missing_scenes_are_refused(void **state)
{
    struct diag d;
    (void)state;
    assert_null(scene_read("", "nonexistent", &d));
    assert_string_equal(d.text, "evolve/scenes/nonexistent.scene: error: cannot open: No such file or directory");
    assert_null(scene_read("/nonexistent", "nonexistent", &d));
    assert_string_equal(d.text,
                        "/nonexistent/evolve/scenes/nonexistent.scene: error: cannot open: No such file or directory");
    assert_null(scene_read("/nonexistent", "./nonexistent", &d));
    assert_string_equal(d.text, "./nonexistent: error: cannot open: No such file or directory");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(shipped_scenes_read),
        cmocka_unit_test(shipped_shapes_are_recognised),
        cmocka_unit_test(every_value_arrives),
        cmocka_unit_test(malformed_scenes_are_refused),
        cmocka_unit_test(usual_values),
        cmocka_unit_test(printed_scenes_read),
        cmocka_unit_test(unusual_limits_are_noted),
        cmocka_unit_test(tiers_expand_about_points_of_their_own),
        cmocka_unit_test(programs_have_reference_points),
        cmocka_unit_test(frames_share_what_is_alike),
        cmocka_unit_test(missing_scenes_are_refused),
    };
    return cmocka_run_group_tests(tests, make_path, remove_path);
}
