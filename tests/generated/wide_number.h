/* Numbers that are rounded like double or float (NARROW), with an exponent of four more bits than double: the value of
 * an expression without overflow and underflow. They are stored in 113 binary digits, so that a second rounding of +,
 * -, *, / and roots changes nothing. For GCC's C++. */
#include <math.h>
#include <stddef.h>
#include <string.h>

struct wide_number {
    __float128 value;

    wide_number() = default;
    wide_number(__float128 x) : value(x)
    {
        const int exponent = exponent_of(x);
        if (x != 0)
            value = (__float128)(NARROW)(x * power(-exponent)) * power(exponent);
    }
    static __float128 power(int exponent)
    {
        const unsigned __int128 bits = (unsigned __int128)(exponent + 16383) << 112;
        __float128 x;
        memcpy(&x, &bits, sizeof x);
        return x;
    }
    static int exponent_of(__float128 x)
    {
        unsigned __int128 bits;
        memcpy(&bits, &x, sizeof bits);
        return (int)(bits >> 112 & 0x7fff) - 16383;
    }
    wide_number operator-() const
    {
        return -value;
    }
    wide_number &operator+=(wide_number x)
    {
        return *this = value + x.value;
    }
    wide_number &operator-=(wide_number x)
    {
        return *this = value - x.value;
    }
    wide_number &operator*=(wide_number x)
    {
        return *this = value * x.value;
    }
    wide_number &operator/=(wide_number x)
    {
        return *this = value / x.value;
    }
};

static inline wide_number operator+(wide_number a, wide_number b)
{
    return a.value + b.value;
}
static inline wide_number operator-(wide_number a, wide_number b)
{
    return a.value - b.value;
}
static inline wide_number operator*(wide_number a, wide_number b)
{
    return a.value * b.value;
}
static inline wide_number operator/(wide_number a, wide_number b)
{
    return a.value / b.value;
}
static inline bool operator<(wide_number a, wide_number b)
{
    return a.value < b.value;
}
static inline bool operator>(wide_number a, wide_number b)
{
    return a.value > b.value;
}
static inline bool operator<=(wide_number a, wide_number b)
{
    return a.value <= b.value;
}
static inline bool operator>=(wide_number a, wide_number b)
{
    return a.value >= b.value;
}
static inline bool operator==(wide_number a, wide_number b)
{
    return a.value == b.value;
}
static inline wide_number fabs(wide_number a)
{
    return a.value < 0 ? -a.value : a.value;
}
static inline wide_number copysign(wide_number a, wide_number b)
{
    return (a.value < 0) == (b.value < 0) ? a : -a;
}
static inline wide_number ldexp(wide_number a, int exponent)
{
    return a.value * wide_number::power(exponent);
}
static inline wide_number frexp(wide_number a, int *exponent)
{
    *exponent = wide_number::exponent_of(a.value) + 1;
    return ldexp(a, -*exponent);
}
/* Runs Newton's iteration, from a start that is right to 50 binary digits, for the number divided by an even power of
 * 2. */
static inline wide_number sqrt(wide_number a)
{
    const int half = wide_number::exponent_of(a.value) / 2;
    const __float128 x = a.value * wide_number::power(-2 * half);
    __float128 root = sqrt((double)x);
    for (int i = 0; i < 2 && x != 0; i++)
        root = 0.5 * (root + x / root);
    return root * wide_number::power(half);
}
static inline wide_number atan2(wide_number a, wide_number b)
{
    return atan2((double)a.value, (double)b.value);
}

#define atan2f atan2
#define copysignf copysign
#define fabsf fabs
#define sqrtf sqrt
#define ldexpf ldexp
#define frexpf frexp
#define __builtin_isgreater(a, b) ((a) > (b)) /* the builtin does not accept classes */
#define double wide_number
#define float wide_number
