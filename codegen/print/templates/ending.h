/* The end of a header, which returns to the caller's floating-point options. */

#if FOOTPOINT_ORDERED
#pragma float_control(pop)
#endif
