/* Random patches for tests. */
#ifndef FOOTPOINT_TESTS_DRAWN_PATCHES_H
#define FOOTPOINT_TESTS_DRAWN_PATCHES_H

#include "patch_judge.h"

#include <stdint.h>

/** Names groups of patches: ordinary; strongly warped; slivers; slave nodes near the border; wild: collapsed, far away,
 *  of any size. */
enum patch_group { PATCH_ORDINARY, PATCH_STRONG, PATCH_SLIVER, PATCH_BORDER, PATCH_WILD, PATCH_GROUPS };

/** Draws corners, normals and slave node of a patch, whose kind must be set. */
void patch_draw(uint64_t *stream, enum patch_group group, struct patch_case *f);

#endif
