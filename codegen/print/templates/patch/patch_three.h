/* Vectors of single calls: all coordinates side by side where compilers have vectors of four numbers. */

/* As many of three coordinates and 0, or of four corners, as a register takes: loops over them take THREE or FOUR turns.
 * Each number rounds as it does without vectors. */
#if defined(__GNUC__) && !defined(FOOTPOINT_DEVICE)
#define FOOTPOINT_DETAIL_PACKED
#ifdef __AVX__
enum { FOOTPOINT_DETAIL_PACK = 4, FOOTPOINT_DETAIL_THREE = 1, FOOTPOINT_DETAIL_FOUR = 1 };
#else
enum { FOOTPOINT_DETAIL_PACK = 2, FOOTPOINT_DETAIL_THREE = 2, FOOTPOINT_DETAIL_FOUR = 2 };
#endif
typedef REAL footpoint_detail_pack __attribute__((vector_size(FOOTPOINT_DETAIL_PACK * sizeof(REAL)),
                                                  aligned(sizeof(REAL)), may_alias));
typedef REAL footpoint_detail_pair
    __attribute__((vector_size(2 * sizeof(REAL)), aligned(sizeof(REAL)), may_alias));
typedef REAL_BITS footpoint_detail_pack_bits
    __attribute__((vector_size(FOOTPOINT_DETAIL_PACK * sizeof(REAL))));
#else
enum { FOOTPOINT_DETAIL_THREE = 3, FOOTPOINT_DETAIL_FOUR = 4 };
typedef REAL footpoint_detail_pack;
#endif

FOOTPOINT_PART const footpoint_detail_pack *footpoint_detail_of(const REAL *a)
{
    return (const footpoint_detail_pack *)(const void *)a;
}

FOOTPOINT_PART footpoint_detail_pack *footpoint_detail_into(REAL *a)
{
    return (footpoint_detail_pack *)(void *)a;
}

/* Returns absolute values. */
FOOTPOINT_PART footpoint_detail_pack footpoint_detail_absolute(footpoint_detail_pack a)
{
#ifdef FOOTPOINT_DETAIL_PACKED
    return (footpoint_detail_pack)((footpoint_detail_pack_bits)a & ~(REAL_BITS)0 >> 1);
#else
    return fabs(a);
#endif
}

/* Writes all at once: vectors are read from memory without delay only if they were written as vectors. */
FOOTPOINT_PART void footpoint_detail_join(REAL x, REAL y, REAL z, REAL w, REAL a[4])
{
#if defined(FOOTPOINT_DETAIL_PACKED) && defined(__AVX__)
    const footpoint_detail_pack all = {x, y, z, w};
    footpoint_detail_into(a)[0] = all;
#elif defined(FOOTPOINT_DETAIL_PACKED)
    const footpoint_detail_pack first = {x, y}, second = {z, w};
    footpoint_detail_into(a)[0] = first;
    footpoint_detail_into(a)[1] = second;
#else
    a[0] = x;
    a[1] = y;
    a[2] = z;
    a[3] = w;
#endif
}

/* Copies three coordinates, and adds a 0. */
FOOTPOINT_PART void footpoint_detail_load(const REAL x[3], REAL a[4])
{
#if defined(FOOTPOINT_DETAIL_PACKED)
    const footpoint_detail_pair first = *(const footpoint_detail_pair *)(const void *)x;
    footpoint_detail_join(first[0], first[1], x[2], 0.0, a);
#else
    footpoint_detail_join(x[0], x[1], x[2], 0.0, a);
#endif
}
