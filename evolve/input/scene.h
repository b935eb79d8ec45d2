/* A scene: the text file that describes the purpose of the generated code; see evolve/scenes/ and evolve/README.md. */
#ifndef FOOTPOINT_SCENE_H
#define FOOTPOINT_SCENE_H

#include "../../codegen/genome/genome.h"

#include <stdint.h>

enum scene_source { SOURCE_LATTICE, SOURCE_RANDOM, SOURCE_MESH };
enum scene_norm { NORM_MEAN, NORM_P99, NORM_MAX };

/** Values from -most to most. */
struct grid_range {
    double most, step;
};

/** The paper's lattice (section 6.1): A = 0, B = (1,0,0), D in the x-y plane. */
struct lattice {
    struct grid_range xy; /* x, y of C, D, S */
    struct grid_range z;  /* z of C, S */
    double xi[2], eta[2]; /* contact points kept: strictly above the lower bound, up to and with the upper one */
    int newton;           /* > 0: kept only if so many Newton steps from (0,0) find the contact point; 0: all */
    size_t random;        /* training samples off the lattice, besides */
    int normal_sets;      /* of segments with normals: random sets for each configuration */
    double tilt;          /* tangent of the largest angle of a normal off the facet's own at the corner */
};

/** Ordinary segments: drawn at random. */
struct shapes {
    double aspect;   /* longest over shortest mid-line, 1..aspect */
    double skew;     /* radians: angle of the mid-lines off 90 degrees, -skew..skew */
    double taper;    /* |in-plane part of c3| / half mid-line, 0..taper in each direction */
    double warp;     /* radians: angle between the normals at opposite corners, 0..warp */
    double gap;      /* |gap| over the shortest edge, 0..gap */
    double curve;    /* rise of an edge along a body of the largest curvature, over the longest edge, 0..curve */
    double shift;    /* mid-side nodes off their place on it, in each direction, over the shortest edge, 0..shift */
    double overhang; /* contact points up to this fraction of the segment outside it: -1-2*overhang.. on squares */
    bool evenly;     /* aspect, angle of warp and curvature uniform; see PART_HELDOUT_EVEN */
};

/** The margin outside the segment in which contact points of mesh pairs are kept: this fraction of it. */
#define MESH_OVERHANG 0.1

/** Slave-node and master-segment pairs of a mesh file. */
struct mesh_pairs {
    char *file;      /* owned; path as resolved from the scene's folder */
    double distance; /* largest |gap|; mesh length */
    char **read;     /* owned: paths of that file and those that it includes */
    size_t reads;
};

/** A header function to make: the values that its expressions may use, and their largest length. */
struct tier {
    char *name;                   /* owned */
    char *frame;                  /* owned: file evolve/frames/<frame>.gen */
    int frame_line, frame_column; /* place in the scene that names it; 0: not named */
    char **terminal;              /* owned: names of inputs or lets of the frame, with the suffix of tier_suffix() */
    size_t terminals;
    size_t max_length; /* operations of a program, or genes of an expression */
    bool rational;     /* quotients beside + - *, if no functions are listed */
    char **function;   /* owned: names of operators and of functions of the frame */
    size_t functions;  /* 0: not listed */
    bool calls;        /* a listed function belongs to the frame */
    bool program;      /* bred as programs that make xi and eta (line_program.h) */
    double budget;     /* operations of an expression or a program, in the plan's cost model; 0: unset */
    char *last;        /* owned: function of the frame that programs end in; or NULL */
    char *(*start)[2]; /* owned: pairs of values of the frame from which programs are first made */
    size_t starts;
    bool starts_at_large; /* the scene's, for other terminals than the tier's own: suitable pairs serve */
    double reference[2];
    int at;   /* index of the tier's own reference point, from 1; 0: the scene's */
    int line; /* line in the scene; 0: it follows from another */
};

/** Returns the genes of a tier's longest expression; a program has two and then three for each operation (line_program.h). */
static inline size_t tier_genes(const struct tier *t)
{
    return t->program ? 2 + 3 * t->max_length : t->max_length;
}
/** Returns true if its expressions are a gene each, chosen among the terminals: nothing to evolve. */
static inline bool tier_is_chosen(const struct tier *t)
{
    return !t->program && t->max_length == 1;
}

/** Outputs: 0 is xi, 1 eta, and 2 both, of programs. */
enum { TIER_BOTH = 2, TIER_OUTPUTS };

struct scene {
    char *name, *path; /* owned; name is the file's base name without .scene */
    char sha256[65];   /* of the scene text and, after it, of its mesh's nodes and pairs */
    const struct segment_kind *segment;
    double reference[2]; /* NAN: left to the segments */
    enum corner_order order;
    enum scene_norm norm;
    const char *precision; /* of the generated code, "double" or "float" */
    size_t training, heldout;
    size_t seed; /* of the samples, not of the evolution */
    size_t run;  /* seed of the run, which also determines held-out samples; 1 unless set */
    enum scene_source source;
    struct lattice lattice;
    struct shapes shapes;
    struct mesh_pairs mesh;
    struct tier *tier;
    size_t tiers;   /* 0: left to the segments, see default_tiers.h */
    char *warnings; /* owned: warnings, "file:line: warning: ..."; or NULL */
};

/** Reads a scene by name (evolve/scenes/<name>.scene under `root`) or path.  Returns NULL with *d filled
 *  ("file:line: error: ..."). */
struct scene *scene_read(const char *root, const char *name_or_path, struct diag *d);
void scene_free(struct scene *s);

/** Gives all tiers another max_length. */
void scene_set_lengths(struct scene *s, size_t max_length);
/** Returns false with *d filled if a tier that is not of programs ends in a function. */
bool scene_check_last(const struct scene *s, struct diag *d);
/** Gives tiers the paper's trees of a single output instead of programs.  Returns false with *d filled if a tier uses functions of
 *  a frame, or ends in a function. */
bool scene_take_trees(struct scene *s, struct diag *d);

/** Reads the scene with the name of s->segment, evolve/scenes/<kind>.scene.  Returns NULL with *d filled if it does not exist, has no
 *  tiers of its own, or is `s` itself. */
struct scene *scene_of_kind(const char *root, const struct scene *s, struct diag *d);

/** Returns the path of a scene given by name or path.  The caller frees it. */
char *scene_path(const char *root, const char *name_or_path);

/** Writes the suffix of the names of a tier's values: "", or "_at1" if the frame expands about the first of the tiers' own
 * reference points. */
void tier_suffix(const struct tier *t, char text[16]);

/** Computes the box of the scene's contact points: lo < xi,eta <= hi, dimensionless; on triangles also xi + eta <= hi[0]. */
void scene_box(const struct scene *s, double lo[2], double hi[2]);

/** Chooses as reference corner A, or the middle of the contact points' box; on triangles their centre. */
void scene_choose_reference(struct scene *s, bool from_corner);

/** Writes the path of a tier's frame file. */
enum { FRAME_PATH = 1024 };
void tier_frame_path(const char *root, const struct tier *t, char path[FRAME_PATH]);

#endif
