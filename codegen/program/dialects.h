/* The dialects of C; see dialect.h. */
#ifndef FOOTPOINT_DIALECTS_H
#define FOOTPOINT_DIALECTS_H

#include "dialect.h"

/** The words of the proved text; in float; in float, of coordinates yA, yB, ... relative to the segment. */
extern const struct dialect c_double, c_float, c_relative;

#endif
