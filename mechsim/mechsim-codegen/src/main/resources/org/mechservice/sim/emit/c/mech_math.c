/* See mech_math.h. The names of constants are those of the published algorithms of fdlibm. */
#include "mech_math.h"

#include <float.h>
#include <math.h>
#include <stdint.h>
#include <string.h>

#if defined(FLT_EVAL_METHOD) && FLT_EVAL_METHOD != 0
#error "mech_math.c needs double arithmetic without excess precision (x86: -msse2 -mfpmath=sse)"
#endif

static const double HUGE_NUMBER = 1.0e300;
static const double TWO_54 = 1.80143985094819840000e+16;
static const double TWO_POWER_24 = 16777216.0;
/* 2^27 + 1, which parts a double in two halves. */
static const double SPLITTER = 134217729.0;
static const double LN2_HIGH = 6.93147180369123816490e-01;
static const double LN2_LOW = 1.90821492927058770002e-10;
static const double INVERSE_LN2 = 1.44269504088896338700e+00;
static const double PI_NUMBER = 3.1415926535897931160e+00;
static const double PI_LOW = 1.2246467991473531772e-16;
static const double PI_2_HIGH = 1.57079632679489655800e+00;
static const double PI_2_LOW = 6.12323399573676603587e-17;
static const double PI_4_HIGH = 7.85398163397448278999e-01;

static uint64_t bits_of(double x) {
  uint64_t bits;
  memcpy(&bits, &x, sizeof bits);
  return bits;
}

static double of_bits(uint64_t bits) {
  double x;
  memcpy(&x, &bits, sizeof x);
  return x;
}

static double not_a_number(void) {
  return of_bits(0x7ff8000000000000u);
}

/* The upper 32 bits without the sign. */
static uint32_t size_word(double x) {
  return (uint32_t)(bits_of(x) >> 32) & 0x7fffffffu;
}

static uint32_t low_word(double x) {
  return (uint32_t)bits_of(x);
}

static int is_negative(double x) {
  return (int)(bits_of(x) >> 63);
}

static double without_low_word(double x) {
  return of_bits(bits_of(x) & 0xffffffff00000000u);
}

/* x 2^n for results that are normal numbers: adds to the exponent. */
static double add_to_exponent(double x, int n) {
  return of_bits(bits_of(x) + ((uint64_t)(int64_t)n << 52));
}

/* 2^n for a normal result. */
static double power_of_two(int n) {
  return of_bits((uint64_t)(n + 1023) << 52);
}

/* Exact product with 2^n for the sizes of the reduction below, |n| < 1000. */
static double scaled(double x, int n) {
  return x * power_of_two(n);
}

/* Sine on [-pi/4, pi/4]; the angle is x + y. */
static double kernel_sin(double x, double y, int has_tail) {
  static const double S1 = -1.66666666666666324348e-01;
  static const double S2 = 8.33333333332248946124e-03;
  static const double S3 = -1.98412698298579493134e-04;
  static const double S4 = 2.75573137070700676789e-06;
  static const double S5 = -2.50507602534068634195e-08;
  static const double S6 = 1.58969099521155010221e-10;
  double z, v, r;
  if (size_word(x) < 0x3e400000u) {
    return x;
  }
  z = x * x;
  v = z * x;
  r = S2 + z * (S3 + z * (S4 + z * (S5 + z * S6)));
  return has_tail ? x - ((z * (0.5 * y - v * r) - y) - v * S1) : x + v * (S1 + z * r);
}

/* Cosine on [-pi/4, pi/4]; the angle is x + y. */
static double kernel_cos(double x, double y) {
  static const double C1 = 4.16666666666666019037e-02;
  static const double C2 = -1.38888888888741095749e-03;
  static const double C3 = 2.48015872894767294178e-05;
  static const double C4 = -2.75573143513906633035e-07;
  static const double C5 = 2.08757232129817482790e-09;
  static const double C6 = -1.13596475577881948265e-11;
  uint32_t size = size_word(x);
  double z, r, part, half, rest;
  if (size < 0x3e400000u) {
    return 1.0;
  }
  z = x * x;
  r = z * (C1 + z * (C2 + z * (C3 + z * (C4 + z * (C5 + z * C6)))));
  if (size < 0x3fd33333u) {
    return 1.0 - (0.5 * z - (z * r - x * y));
  }
  part = size > 0x3fe90000u ? 0.28125 : of_bits((uint64_t)(size - 0x00200000u) << 32);
  half = 0.5 * z - part;
  rest = 1.0 - part;
  return rest - (half - (z * r - x * y));
}

/*
 * Reduction of large angles (Payne and Hanek): x holds an angle in pieces of 24 bits, x[0] 2^e0
 * being the first; y receives the rest after multiples of pi/2. Returns the last three bits of the
 * multiple.
 */
static int reduce_large(const double *x, double *y, int e0, int pieces) {
  /* 2/pi in pieces of 24 bits. */
  static const int32_t TWO_OVER_PI[] = {
    0xA2F983, 0x6E4E44, 0x1529FC, 0x2757D1, 0xF534DD, 0xC0DB62,
    0x95993C, 0x439041, 0xFE5163, 0xABDEBB, 0xC561B7, 0x246E3A,
    0x424DD2, 0xE00649, 0x2EEA09, 0xD1921C, 0xFE1DEB, 0x1CB129,
    0xA73EE8, 0x8235F5, 0x2EBB44, 0x84E99C, 0x7026B4, 0x5F7E41,
    0x3991D6, 0x398353, 0x39F49C, 0x845F8B, 0xBDF928, 0x3B1FF8,
    0x97FFDE, 0x05980F, 0xEF2F11, 0x8B5A0A, 0x6D1F6D, 0x367ECF,
    0x27CB09, 0xB74F46, 0x3F669E, 0x5FEA2D, 0x7527BA, 0xC7EBE5,
    0xF17B3D, 0x0739F7, 0x8A5292, 0xEA6BFB, 0x5FB11F, 0x8D5D08,
    0x560330, 0x46FC7B, 0x6BABF0, 0xCFBC20, 0x9AF436, 0x1DA9E3,
    0x91615E, 0xE61B08, 0x659985, 0x5F14A0, 0x68408D, 0xFFD880,
    0x4D7327, 0x310606, 0x1556CA, 0x73A8C9, 0x60E27B, 0xC08C6B,
  };
  /* pi/2 in pieces of 24 bits. */
  static const double PIO2[] = {
      1.57079625129699707031e+00, 7.54978941586159635336e-08, 5.39030252995776476554e-15,
      3.28200341580791294123e-22, 1.27065575308067607349e-29, 1.22933308981111328932e-36,
      2.73370053816464559624e-44, 2.16741683877804819444e-51};
  enum { TERMS = 4, LONGEST = 20 };
  int32_t iq[LONGEST];
  double f[LONGEST], fq[LONGEST] = {0.0}, q[LONGEST];
  int last = pieces - 1;
  int first = (e0 - 3) / 24;
  int exponent, top, i, j, k, n, half;
  double z, w;
  if (first < 0) {
    first = 0;
  }
  exponent = e0 - 24 * (first + 1);
  for (i = 0, j = first - last; i <= last + TERMS; i++, j++) {
    f[i] = j < 0 ? 0.0 : (double)TWO_OVER_PI[j];
  }
  for (i = 0; i <= TERMS; i++) {
    w = 0.0;
    for (j = 0; j <= last; j++) {
      w += x[j] * f[last + i - j];
    }
    q[i] = w;
  }
  top = TERMS;
  for (;;) {
    int need;
    z = q[top];
    for (i = 0, j = top; j > 0; i++, j--) {
      w = (double)(int32_t)((1.0 / TWO_POWER_24) * z);
      iq[i] = (int32_t)(z - TWO_POWER_24 * w);
      z = q[j - 1] + w;
    }
    z = scaled(z, exponent);
    z -= 8.0 * floor(z * 0.125);
    n = (int)z;
    z -= (double)n;
    half = 0;
    if (exponent > 0) {
      i = iq[top - 1] >> (24 - exponent);
      n += i;
      iq[top - 1] -= i << (24 - exponent);
      half = iq[top - 1] >> (23 - exponent);
    } else if (exponent == 0) {
      half = iq[top - 1] >> 23;
    } else if (z >= 0.5) {
      half = 2;
    }
    if (half > 0) {
      int carry = 0;
      n += 1;
      for (i = 0; i < top; i++) {
        j = iq[i];
        if (carry == 0) {
          if (j != 0) {
            carry = 1;
            iq[i] = 0x1000000 - j;
          }
        } else {
          iq[i] = 0xffffff - j;
        }
      }
      if (exponent == 1) {
        iq[top - 1] &= 0x7fffff;
      } else if (exponent == 2) {
        iq[top - 1] &= 0x3fffff;
      }
      if (half == 2) {
        z = 1.0 - z;
        if (carry != 0) {
          z -= scaled(1.0, exponent);
        }
      }
    }
    need = 0;
    if (z == 0.0) {
      j = 0;
      for (i = top - 1; i >= TERMS; i--) {
        j |= iq[i];
      }
      need = j == 0;
    }
    if (!need) {
      break;
    }
    for (k = 1; iq[TERMS - k] == 0; k++) {
    }
    for (i = top + 1; i <= top + k; i++) {
      f[last + i] = (double)TWO_OVER_PI[first + i];
      w = 0.0;
      for (j = 0; j <= last; j++) {
        w += x[j] * f[last + i - j];
      }
      q[i] = w;
    }
    top += k;
  }
  if (z == 0.0) {
    top -= 1;
    exponent -= 24;
    while (iq[top] == 0) {
      top--;
      exponent -= 24;
    }
  } else {
    z = scaled(z, -exponent);
    if (z >= TWO_POWER_24) {
      w = (double)(int32_t)((1.0 / TWO_POWER_24) * z);
      iq[top] = (int32_t)(z - TWO_POWER_24 * w);
      top += 1;
      exponent += 24;
      iq[top] = (int32_t)w;
    } else {
      iq[top] = (int32_t)z;
    }
  }
  w = scaled(1.0, exponent);
  for (i = top; i >= 0; i--) {
    q[i] = w * (double)iq[i];
    w *= 1.0 / TWO_POWER_24;
  }
  for (i = top; i >= 0; i--) {
    w = 0.0;
    for (k = 0; k <= TERMS && k <= top - i; k++) {
      w += PIO2[k] * q[i + k];
    }
    fq[top - i] = w;
  }
  w = 0.0;
  for (i = top; i >= 0; i--) {
    w += fq[i];
  }
  y[0] = half == 0 ? w : -w;
  w = fq[0] - w;
  for (i = 1; i <= top; i++) {
    w += fq[i];
  }
  y[1] = half == 0 ? w : -w;
  return n & 7;
}

/* Finite x = n pi/2 + y[0] + y[1]; returns n, whose last two bits are exact. */
static int reduce(double x, double *y) {
  /* Upper words of n pi/2, n = 1 to 32. */
  static const uint32_t MULTIPLES[] = {
    0x3FF921FB, 0x400921FB, 0x4012D97C, 0x401921FB,
    0x401F6A7A, 0x4022D97C, 0x4025FDBB, 0x402921FB,
    0x402C463A, 0x402F6A7A, 0x4031475C, 0x4032D97C,
    0x40346B9C, 0x4035FDBB, 0x40378FDB, 0x403921FB,
    0x403AB41B, 0x403C463A, 0x403DD85A, 0x403F6A7A,
    0x40407E4C, 0x4041475C, 0x4042106C, 0x4042D97C,
    0x4043A28C, 0x40446B9C, 0x404534AC, 0x4045FDBB,
    0x4046C6CB, 0x40478FDB, 0x404858EB, 0x404921FB,
  };
  static const double INVERSE_PIO2 = 6.36619772367581382433e-01;
  static const double PIO2_1 = 1.57079632673412561417e+00;
  static const double PIO2_1_TAIL = 6.07710050650619224932e-11;
  static const double PIO2_2 = 6.07710050630396597660e-11;
  static const double PIO2_2_TAIL = 2.02226624879595063154e-21;
  static const double PIO2_3 = 2.02226624871116645580e-21;
  static const double PIO2_3_TAIL = 8.47842766036889956997e-32;
  uint32_t size = size_word(x);
  double z, pieces[3];
  int e0, i, count, n;
  if (size <= 0x3fe921fbu) {
    y[0] = x;
    y[1] = 0.0;
    return 0;
  }
  if (size < 0x4002d97cu) {
    double sign = is_negative(x) ? -1.0 : 1.0;
    z = fabs(x) - PIO2_1;
    if (size != 0x3ff921fbu) {
      y[0] = z - PIO2_1_TAIL;
      y[1] = (z - y[0]) - PIO2_1_TAIL;
    } else {
      z -= PIO2_2;
      y[0] = z - PIO2_2_TAIL;
      y[1] = (z - y[0]) - PIO2_2_TAIL;
    }
    y[0] *= sign;
    y[1] *= sign;
    return sign < 0.0 ? -1 : 1;
  }
  if (size <= 0x413921fbu) {
    double t = fabs(x), fn, r, w;
    n = (int)(t * INVERSE_PIO2 + 0.5);
    fn = (double)n;
    r = t - fn * PIO2_1;
    w = fn * PIO2_1_TAIL;
    y[0] = r - w;
    if (n >= 32 || size == MULTIPLES[n - 1]) {
      int exponent = (int)(size >> 20);
      if (exponent - (int)((size_word(y[0]) >> 20) & 0x7ffu) > 16) {
        t = r;
        w = fn * PIO2_2;
        r = t - w;
        w = fn * PIO2_2_TAIL - ((t - r) - w);
        y[0] = r - w;
        if (exponent - (int)((size_word(y[0]) >> 20) & 0x7ffu) > 49) {
          t = r;
          w = fn * PIO2_3;
          r = t - w;
          w = fn * PIO2_3_TAIL - ((t - r) - w);
          y[0] = r - w;
        }
      }
    }
    y[1] = (r - y[0]) - w;
    if (is_negative(x)) {
      y[0] = -y[0];
      y[1] = -y[1];
      return -n;
    }
    return n;
  }
  e0 = (int)(size >> 20) - 1046;
  z = of_bits((bits_of(x) & 0x7fffffffffffffffu) - ((uint64_t)e0 << 52));
  for (i = 0; i < 2; i++) {
    pieces[i] = (double)(int32_t)z;
    z = (z - pieces[i]) * TWO_POWER_24;
  }
  pieces[2] = z;
  count = 3;
  while (pieces[count - 1] == 0.0) {
    count--;
  }
  n = reduce_large(pieces, y, e0, count);
  if (is_negative(x)) {
    y[0] = -y[0];
    y[1] = -y[1];
    return -n;
  }
  return n;
}

double mech_abs(double x) {
  return fabs(x);
}

double mech_sin(double x) {
  double y[2];
  int n;
  if (size_word(x) <= 0x3fe921fbu) {
    return kernel_sin(x, 0.0, 0);
  }
  if (size_word(x) >= 0x7ff00000u) {
    return x - x;
  }
  n = reduce(x, y) & 3;
  switch (n) {
    case 0:
      return kernel_sin(y[0], y[1], 1);
    case 1:
      return kernel_cos(y[0], y[1]);
    case 2:
      return -kernel_sin(y[0], y[1], 1);
    default:
      return -kernel_cos(y[0], y[1]);
  }
}

double mech_cos(double x) {
  double y[2];
  int n;
  if (size_word(x) <= 0x3fe921fbu) {
    return kernel_cos(x, 0.0);
  }
  if (size_word(x) >= 0x7ff00000u) {
    return x - x;
  }
  n = reduce(x, y) & 3;
  switch (n) {
    case 0:
      return kernel_cos(y[0], y[1]);
    case 1:
      return -kernel_sin(y[0], y[1], 1);
    case 2:
      return -kernel_cos(y[0], y[1]);
    default:
      return kernel_sin(y[0], y[1], 1);
  }
}

/* (asin(x) - x) / x as a quotient of polynomials of t. */
static double asin_quotient(double t) {
  static const double P0 = 1.66666666666666657415e-01;
  static const double P1 = -3.25565818622400915405e-01;
  static const double P2 = 2.01212532134862925881e-01;
  static const double P3 = -4.00555345006794114027e-02;
  static const double P4 = 7.91534994289814532176e-04;
  static const double P5 = 3.47933107596021167570e-05;
  static const double Q1 = -2.40339491173441421878e+00;
  static const double Q2 = 2.02094576023350569471e+00;
  static const double Q3 = -6.88283971605453293030e-01;
  static const double Q4 = 7.70381505559019352791e-02;
  double p = t * (P0 + t * (P1 + t * (P2 + t * (P3 + t * (P4 + t * P5)))));
  double q = 1.0 + t * (Q1 + t * (Q2 + t * (Q3 + t * Q4)));
  return p / q;
}

double mech_asin(double x) {
  uint32_t size = size_word(x);
  double t, w, r, s, c, p, q;
  if (size >= 0x3ff00000u) {
    if (size == 0x3ff00000u && low_word(x) == 0) {
      return x * PI_2_HIGH + x * PI_2_LOW;
    }
    return not_a_number();
  }
  if (size < 0x3fe00000u) {
    return size < 0x3e400000u ? x : x + x * asin_quotient(x * x);
  }
  t = (1.0 - fabs(x)) * 0.5;
  r = asin_quotient(t);
  s = sqrt(t);
  if (size >= 0x3fef3333u) {
    t = PI_2_HIGH - (2.0 * (s + s * r) - PI_2_LOW);
  } else {
    w = without_low_word(s);
    c = (t - w * w) / (s + w);
    p = 2.0 * s * r - (PI_2_LOW - 2.0 * c);
    q = PI_4_HIGH - 2.0 * w;
    t = PI_4_HIGH - (p - q);
  }
  return is_negative(x) ? -t : t;
}

double mech_acos(double x) {
  uint32_t size = size_word(x);
  double z, r, s, w, df, c;
  if (size >= 0x3ff00000u) {
    if (size == 0x3ff00000u && low_word(x) == 0) {
      return is_negative(x) ? PI_NUMBER + 2.0 * PI_2_LOW : 0.0;
    }
    return not_a_number();
  }
  if (size < 0x3fe00000u) {
    if (size <= 0x3c600000u) {
      return PI_2_HIGH + PI_2_LOW;
    }
    r = asin_quotient(x * x);
    return PI_2_HIGH - (x - (PI_2_LOW - x * r));
  }
  if (is_negative(x)) {
    z = (1.0 + x) * 0.5;
    s = sqrt(z);
    w = asin_quotient(z) * s - PI_2_LOW;
    return PI_NUMBER - 2.0 * (s + w);
  }
  z = (1.0 - x) * 0.5;
  s = sqrt(z);
  df = without_low_word(s);
  c = (z - df * df) / (s + df);
  w = asin_quotient(z) * s + c;
  return 2.0 * (df + w);
}

double mech_atan(double x) {
  static const double HIGH[] = {
      4.63647609000806093515e-01, 7.85398163397448278999e-01, 9.82793723247329054082e-01,
      1.57079632679489655800e+00};
  static const double LOW[] = {
      2.26987774529616870924e-17, 3.06161699786838301793e-17, 1.39033110312309984516e-17,
      6.12323399573676603587e-17};
  static const double T[] = {
      3.33333333333329318027e-01, -1.99999999998764832476e-01, 1.42857142725034663711e-01,
      -1.11111104054623557880e-01, 9.09088713343650656196e-02, -7.69187620504482999495e-02,
      6.66107313738753120669e-02, -5.83357013379057348645e-02, 4.97687799461593236017e-02,
      -3.65315727442169155270e-02, 1.62858201153657823623e-02};
  uint32_t size = size_word(x);
  double z, w, s1, s2, result;
  int id;
  if (size >= 0x44100000u) {
    if (size > 0x7ff00000u || (size == 0x7ff00000u && low_word(x) != 0)) {
      return x + x;
    }
    return is_negative(x) ? -HIGH[3] - LOW[3] : HIGH[3] + LOW[3];
  }
  if (size < 0x3fdc0000u) {
    if (size < 0x3e200000u) {
      return x;
    }
    id = -1;
    z = x;
  } else {
    double a = fabs(x);
    if (size < 0x3fe60000u) {
      id = 0;
      z = (2.0 * a - 1.0) / (2.0 + a);
    } else if (size < 0x3ff30000u) {
      id = 1;
      z = (a - 1.0) / (a + 1.0);
    } else if (size < 0x40038000u) {
      id = 2;
      z = (a - 1.5) / (1.0 + 1.5 * a);
    } else {
      id = 3;
      z = -1.0 / a;
    }
  }
  {
    double square = z * z;
    w = square * square;
    s1 = square * (T[0] + w * (T[2] + w * (T[4] + w * (T[6] + w * (T[8] + w * T[10])))));
    s2 = w * (T[1] + w * (T[3] + w * (T[5] + w * (T[7] + w * T[9]))));
  }
  if (id < 0) {
    return z - z * (s1 + s2);
  }
  result = HIGH[id] - ((z * (s1 + s2) - LOW[id]) - z);
  return is_negative(x) ? -result : result;
}

double mech_atan2(double y, double x) {
  static const double TINY = 1.0e-300;
  uint32_t size_x = size_word(x), size_y = size_word(y);
  double z;
  int m, k;
  if (x != x || y != y) {
    return x + y;
  }
  if (x == 1.0) {
    return mech_atan(y);
  }
  m = is_negative(y) | (is_negative(x) << 1);
  if (y == 0.0) {
    switch (m) {
      case 0:
      case 1:
        return y;
      case 2:
        return PI_NUMBER + TINY;
      default:
        return -PI_NUMBER - TINY;
    }
  }
  if (x == 0.0) {
    return is_negative(y) ? -PI_2_HIGH - TINY : PI_2_HIGH + TINY;
  }
  if (size_x == 0x7ff00000u) {
    if (size_y == 0x7ff00000u) {
      switch (m) {
        case 0:
          return PI_4_HIGH + TINY;
        case 1:
          return -PI_4_HIGH - TINY;
        case 2:
          return 3.0 * PI_4_HIGH + TINY;
        default:
          return -3.0 * PI_4_HIGH - TINY;
      }
    }
    switch (m) {
      case 0:
        return 0.0;
      case 1:
        return -0.0;
      case 2:
        return PI_NUMBER + TINY;
      default:
        return -PI_NUMBER - TINY;
    }
  }
  if (size_y == 0x7ff00000u) {
    return is_negative(y) ? -PI_2_HIGH - TINY : PI_2_HIGH + TINY;
  }
  k = ((int)size_y - (int)size_x) >> 20;
  if (k > 60) {
    z = PI_2_HIGH + 0.5 * PI_LOW;
  } else if (is_negative(x) && k < -60) {
    z = 0.0;
  } else {
    z = mech_atan(fabs(y / x));
  }
  switch (m) {
    case 0:
      return z;
    case 1:
      return -z;
    case 2:
      return PI_NUMBER - (z - PI_LOW);
    default:
      return (z - PI_LOW) - PI_NUMBER;
  }
}

double mech_exp(double x) {
  static const double P1 = 1.66666666666666019037e-01;
  static const double P2 = -2.77777777770155933842e-03;
  static const double P3 = 6.61375632143793436117e-05;
  static const double P4 = -1.65339022054652515390e-06;
  static const double P5 = 4.13813679705723846039e-08;
  uint32_t size = size_word(x);
  double high = 0.0, low = 0.0, c, t, y;
  int k = 0;
  if (size >= 0x40862e42u) {
    if (x != x) {
      return x + x;
    }
    if (size >= 0x7ff00000u) {
      return is_negative(x) ? 0.0 : x;
    }
    if (x > 7.09782712893383973096e+02) {
      return HUGE_NUMBER * HUGE_NUMBER;
    }
    if (x < -7.45133219101941108420e+02) {
      return 0.0;
    }
  }
  if (size > 0x3fd62e42u) {
    if (size < 0x3ff0a2b2u) {
      high = is_negative(x) ? x + LN2_HIGH : x - LN2_HIGH;
      low = is_negative(x) ? -LN2_LOW : LN2_LOW;
      k = is_negative(x) ? -1 : 1;
    } else {
      k = (int)(INVERSE_LN2 * x + (is_negative(x) ? -0.5 : 0.5));
      t = (double)k;
      high = x - t * LN2_HIGH;
      low = t * LN2_LOW;
    }
    x = high - low;
  } else if (size < 0x3e300000u) {
    return 1.0 + x;
  }
  t = x * x;
  c = x - t * (P1 + t * (P2 + t * (P3 + t * (P4 + t * P5))));
  if (k == 0) {
    return 1.0 - ((x * c) / (c - 2.0) - x);
  }
  y = 1.0 - ((low - (x * c) / (2.0 - c)) - high);
  return k >= -1021 ? add_to_exponent(y, k)
                    : add_to_exponent(y, k + 1000) * 9.33263618503218878990e-302;
}

static double expm1_of(double x) {
  static const double Q1 = -3.33333333333331316428e-02;
  static const double Q2 = 1.58730158725481460165e-03;
  static const double Q3 = -7.93650757867487942473e-05;
  static const double Q4 = 4.00821782732936239552e-06;
  static const double Q5 = -2.01099218183624371326e-07;
  uint32_t size = size_word(x);
  double c = 0.0, high, low, t, half, square, r, e, y;
  int k;
  if (size >= 0x4043687au) {
    if (size >= 0x40862e42u) {
      if (x != x) {
        return x + x;
      }
      if (size >= 0x7ff00000u) {
        return is_negative(x) ? -1.0 : x;
      }
      if (x > 7.09782712893383973096e+02) {
        return HUGE_NUMBER * HUGE_NUMBER;
      }
    }
    if (is_negative(x)) {
      return 1.0e-300 - 1.0;
    }
  }
  if (size > 0x3fd62e42u) {
    if (size < 0x3ff0a2b2u) {
      high = is_negative(x) ? x + LN2_HIGH : x - LN2_HIGH;
      low = is_negative(x) ? -LN2_LOW : LN2_LOW;
      k = is_negative(x) ? -1 : 1;
    } else {
      k = (int)(INVERSE_LN2 * x + (is_negative(x) ? -0.5 : 0.5));
      t = (double)k;
      high = x - t * LN2_HIGH;
      low = t * LN2_LOW;
    }
    x = high - low;
    c = (high - x) - low;
  } else if (size < 0x3c900000u) {
    return x;
  } else {
    k = 0;
  }
  half = 0.5 * x;
  square = x * half;
  r = 1.0 + square * (Q1 + square * (Q2 + square * (Q3 + square * (Q4 + square * Q5))));
  t = 3.0 - r * half;
  e = square * ((r - t) / (6.0 - x * t));
  if (k == 0) {
    return x - (x * e - square);
  }
  e = x * (e - c) - c;
  e -= square;
  if (k == -1) {
    return 0.5 * (x - e) - 0.5;
  }
  if (k == 1) {
    return x < -0.25 ? -2.0 * (e - (x + 0.5)) : 1.0 + 2.0 * (x - e);
  }
  if (k <= -2 || k > 56) {
    y = add_to_exponent(1.0 - (e - x), k);
    return y - 1.0;
  }
  if (k < 20) {
    y = (1.0 - power_of_two(-k)) - (e - x);
  } else {
    y = (x - (e + power_of_two(-k))) + 1.0;
  }
  return add_to_exponent(y, k);
}

double mech_log(double x) {
  static const double L1 = 6.666666666666735130e-01;
  static const double L2 = 3.999999999940941908e-01;
  static const double L3 = 2.857142874366239149e-01;
  static const double L4 = 2.222219843214978396e-01;
  static const double L5 = 1.818357216161805012e-01;
  static const double L6 = 1.531383769920937332e-01;
  static const double L7 = 1.479819860510658591e-01;
  int32_t word, i, j;
  int k = 0;
  double f, dk, s, z, w, t1, t2, r, square;
  if (x != x) {
    return x + x;
  }
  if (x == 0.0) {
    return -HUGE_VAL;
  }
  if (is_negative(x)) {
    return not_a_number();
  }
  if (size_word(x) < 0x00100000u) {
    k -= 54;
    x *= TWO_54;
  }
  word = (int32_t)size_word(x);
  if (word >= 0x7ff00000) {
    return x + x;
  }
  k += (word >> 20) - 1023;
  word &= 0x000fffff;
  i = (word + 0x95f64) & 0x100000;
  x = of_bits(((uint64_t)(uint32_t)(word | (i ^ 0x3ff00000)) << 32) | low_word(x));
  k += i >> 20;
  f = x - 1.0;
  dk = (double)k;
  if ((0x000fffff & (2 + word)) < 3) {
    if (f == 0.0) {
      return k == 0 ? 0.0 : dk * LN2_HIGH + dk * LN2_LOW;
    }
    r = f * f * (0.5 - 0.33333333333333333 * f);
    return k == 0 ? f - r : dk * LN2_HIGH - ((r - dk * LN2_LOW) - f);
  }
  s = f / (2.0 + f);
  z = s * s;
  i = word - 0x6147a;
  w = z * z;
  j = 0x6b851 - word;
  t1 = w * (L2 + w * (L4 + w * L6));
  t2 = z * (L1 + w * (L3 + w * (L5 + w * L7)));
  i |= j;
  r = t2 + t1;
  if (i > 0) {
    square = 0.5 * f * f;
    return k == 0 ? f - (square - s * (square + r))
                  : dk * LN2_HIGH - ((square - (s * (square + r) + dk * LN2_LOW)) - f);
  }
  return k == 0 ? f - s * (f - r) : dk * LN2_HIGH - ((s * (f - r) - dk * LN2_LOW) - f);
}

double mech_sinh(double x) {
  uint32_t size = size_word(x);
  double half = is_negative(x) ? -0.5 : 0.5;
  double t, w;
  if (size >= 0x7ff00000u) {
    return x + x;
  }
  if (size < 0x40360000u) {
    if (size < 0x3e300000u) {
      return x;
    }
    t = expm1_of(fabs(x));
    return size < 0x3ff00000u ? half * (2.0 * t - t * t / (t + 1.0)) : half * (t + t / (t + 1.0));
  }
  if (size < 0x40862e42u) {
    return half * mech_exp(fabs(x));
  }
  if (size < 0x408633ceu || (size == 0x408633ceu && low_word(x) <= 0x8fb9f87du)) {
    w = mech_exp(0.5 * fabs(x));
    t = half * w;
    return t * w;
  }
  return x * 1.0e307 * HUGE_NUMBER;
}

double mech_cosh(double x) {
  uint32_t size = size_word(x);
  double t, w;
  if (size >= 0x7ff00000u) {
    return x * x;
  }
  if (size < 0x3fd62e43u) {
    t = expm1_of(fabs(x));
    w = 1.0 + t;
    return size < 0x3c800000u ? w : 1.0 + (t * t) / (w + w);
  }
  if (size < 0x40360000u) {
    t = mech_exp(fabs(x));
    return 0.5 * t + 0.5 / t;
  }
  if (size < 0x40862e42u) {
    return 0.5 * mech_exp(fabs(x));
  }
  if (size < 0x408633ceu || (size == 0x408633ceu && low_word(x) <= 0x8fb9f87du)) {
    w = mech_exp(0.5 * fabs(x));
    t = 0.5 * w;
    return t * w;
  }
  return HUGE_NUMBER * HUGE_NUMBER;
}

double mech_tanh(double x) {
  uint32_t size = size_word(x);
  double t, z;
  if (size >= 0x7ff00000u) {
    return is_negative(x) ? 1.0 / x - 1.0 : 1.0 / x + 1.0;
  }
  if (size >= 0x40360000u) {
    z = 1.0;
  } else if (size < 0x3c800000u) {
    return x * (1.0 + x);
  } else if (size >= 0x3ff00000u) {
    t = expm1_of(2.0 * fabs(x));
    z = 1.0 - 2.0 / (t + 2.0);
  } else {
    t = expm1_of(-2.0 * fabs(x));
    z = -t / (t + 2.0);
  }
  return is_negative(x) ? -z : z;
}

double mech_hypot(double x, double y) {
  double a = fabs(x), b = fabs(y), w, t1, t2, y1, y2;
  uint32_t size_a, size_b;
  int k = 0;
  if (a > DBL_MAX || b > DBL_MAX) {
    return HUGE_VAL;
  }
  if (x != x || y != y) {
    return x + y;
  }
  if (b > a) {
    w = a;
    a = b;
    b = w;
  }
  size_a = size_word(a);
  size_b = size_word(b);
  if (size_a - size_b > 0x3c00000u) {
    return a + b;
  }
  if (size_a > 0x5f300000u) {
    k = 600;
    a *= power_of_two(-600);
    b *= power_of_two(-600);
    size_a -= 600u << 20;
    size_b -= 600u << 20;
  }
  if (size_b < 0x20b00000u) {
    if (size_b <= 0x000fffffu) {
      if (b == 0.0) {
        return a;
      }
      /* The published algorithm splits with the words from before this scaling. */
      b *= power_of_two(1022);
      a *= power_of_two(1022);
      k -= 1022;
    } else {
      a *= power_of_two(600);
      b *= power_of_two(600);
      size_a += 600u << 20;
      size_b += 600u << 20;
      k -= 600;
    }
  }
  w = a - b;
  if (w > b) {
    t1 = of_bits((uint64_t)size_a << 32);
    t2 = a - t1;
    w = sqrt(t1 * t1 - (b * (-b) - t2 * (a + t1)));
  } else {
    double doubled = a + a;
    y1 = of_bits((uint64_t)size_b << 32);
    y2 = b - y1;
    t1 = of_bits((uint64_t)(size_a + 0x00100000u) << 32);
    t2 = doubled - t1;
    w = sqrt(t1 * y1 - (w * (-w) - (t1 * y2 + t2 * b)));
  }
  return k == 0 ? w : power_of_two(k) * w;
}

double mech_min(double a, double b) {
  if (a != a) {
    return a;
  }
  if (a == 0.0 && b == 0.0 && is_negative(b)) {
    return b;
  }
  return a <= b ? a : b;
}

double mech_max(double a, double b) {
  if (a != a) {
    return a;
  }
  if (a == 0.0 && b == 0.0 && is_negative(a)) {
    return b;
  }
  return a >= b ? a : b;
}

double mech_signum(double x) {
  if (x > 0.0) {
    return 1.0;
  }
  return x < 0.0 ? -1.0 : x;
}

double mech_floor(double x) {
  return floor(x);
}

static double whole_power(double a, int n) {
  double product = 1.0;
  double square = a;
  int k;
  for (k = n < 0 ? -n : n; k > 0; k >>= 1) {
    if ((k & 1) == 1) {
      product *= square;
    }
    square *= square;
  }
  return n >= 0 ? product : 1.0 / product;
}

static int is_finite(double x) {
  return fabs(x) <= DBL_MAX;
}

/* What rounding took from a product of normal size (Dekker 1971): exact, and without fma, which
 * not every C library has. */
static double rounded_off(double a, double b, double product) {
  double a_high = SPLITTER * a - (SPLITTER * a - a);
  double b_high = SPLITTER * b - (SPLITTER * b - b);
  double a_low = a - a_high;
  double b_low = b - b_high;
  return ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low;
}

/* exp(b ln a), the product carried to twice the precision. Where it is too large or too small to be
 * carried so, the power is 0, 1 or infinite. */
static double positive_power(double a, double b) {
  double logarithm = mech_log(a);
  double high = b * logarithm;
  double low = rounded_off(b, logarithm, high);
  double power = mech_exp(high);
  return is_finite(power) && is_finite(low) ? power + power * low : power;
}

double mech_power(double a, double b) {
  int whole, odd;
  double size;
  if (fabs(b) <= 64.0) {
    if (b == (double)(int)b) {
      return whole_power(a, (int)b);
    }
    if (a > 0.0 && 2.0 * b == (double)(int)(2.0 * b)) {
      double root = sqrt(a) * whole_power(a, b < 0.0 ? -(int)b : (int)b);
      return b > 0.0 ? root : 1.0 / root;
    }
  }
  if (a > 0.0) {
    return positive_power(a, b);
  }
  whole = b == floor(b);
  odd = whole && fabs(b) < 9007199254740992.0 && 0.5 * b != floor(0.5 * b);
  if (a == 0.0) {
    size = b > 0.0 ? 0.0 : HUGE_VAL;
    return odd && is_negative(a) ? -size : size;
  }
  if (!whole || a != a) {
    return not_a_number();
  }
  size = positive_power(-a, b);
  return odd ? -size : size;
}

double mech_choose(double a, double b, double x, double y) {
  return a <= b ? x : y;
}

double mech_product(double a, double b) {
  return a == 0.0 || b == 0.0 ? 0.0 : a * b;
}

double mech_interval(const double *row, int count, double x) {
  int low = 0;
  int high = count;
  while (low < high) {
    int middle = low + (high - low) / 2;
    if (row[middle] <= x) {
      low = middle + 1;
    } else {
      high = middle;
    }
  }
  return low;
}

double mech_element(const double *row, int count, double index) {
  (void)count;
  return row[(int)index];
}

double mech_pick(double a, double b, double x, double y) {
  return a <= b ? x : y;
}

double mech_held(double x) {
  return x;
}

enum { TOUCH_STEPS = 100 };

double mech_touch(double l1, double l2, double psi, double radius, double tolerance) {
  double a = radius / l1;
  double b = radius / l2;
  double u = 0.5 * 3.141592653589793;
  int i;
  for (i = 0; i < TOUCH_STEPS; i++) {
    double sine = mech_sin(u);
    double cosine = mech_cos(u);
    double f = psi - 2.0 * u + mech_asin(a * sine) + mech_asin(b * sine);
    double slope = -2.0 + a * cosine / sqrt(1.0 - a * a * sine * sine)
        + b * cosine / sqrt(1.0 - b * b * sine * sine);
    double next = u - f / slope;
    if (fabs(f) <= tolerance || !(next < u)) {
      break;
    }
    u = next;
  }
  return u - mech_asin(a * mech_sin(u));
}

enum { CURVE_PARTS = 8, CURVE_STEPS = 1100 };

static double curve_value(const double *table, int n, int place, double x) {
  double d = x - table[place];
  double inner = table[3 * (n + 1) + place] + d * table[4 * (n + 1) + place];
  return table[n + 1 + place] + d * (table[2 * (n + 1) + place] + d * inner);
}

static double curve_square(const double *table, int n, int place, double s, double x, double z) {
  double above = curve_value(table, n, place, s) - z;
  return (s - x) * (s - x) + above * above;
}

/* Returns where g rises through zero; an end of the interval if g has one sign. */
static double curve_zero(
    const double *table, int n, int place, double from, double to, double x, double z) {
  double c0 = table[n + 1 + place];
  double c1 = table[2 * (n + 1) + place];
  double c2 = table[3 * (n + 1) + place];
  double c3 = table[4 * (n + 1) + place];
  double origin = table[place];
  double low = from;
  double high = to;
  double s = x < from ? from : x > to ? to : x;
  for (int i = 0; i < CURVE_STEPS; i++) {
    double d = s - origin;
    double above = c0 + d * (c1 + d * (c2 + d * c3)) - z;
    double slope = c1 + d * (2 * c2 + d * (3 * c3));
    double bend = 2 * c2 + d * (6 * c3);
    double g = s - x + above * slope;
    double rise = 1 + slope * slope + above * bend;
    if (g > 0) {
      high = s;
    } else {
      low = s;
    }
    double next = s - g / rise;
    if (!(rise > 0) || !(next > low && next < high)) {
      /* The first step may leave the interval for good: to its end. */
      int to_end = rise > 0 && i == 0;
      next = to_end && next >= to ? to : to_end && next <= from ? from : 0.5 * (low + high);
      if (!to_end && (next <= low || next >= high)) {
        break;
      }
    }
    if (next == s) {
      break;
    }
    s = next;
  }
  return s;
}

static double curve_piece(
    const double *table, int n, int place, double from, double to, double x, double z,
    double known, double least_known) {
  double c1 = table[2 * (n + 1) + place];
  double c2 = table[3 * (n + 1) + place];
  double c3 = table[4 * (n + 1) + place];
  double origin = table[place];
  double third = (to - from) / 3;
  double at_from = curve_value(table, n, place, from);
  double at_to = curve_value(table, n, place, to);
  double slope_from = c1 + (from - origin) * (2 * c2 + (from - origin) * (3 * c3));
  double slope_to = c1 + (to - origin) * (2 * c2 + (to - origin) * (3 * c3));
  double one = at_from + third * slope_from;
  double two = at_to - third * slope_to;
  /* The cubic lies between the least and the largest of its Bernstein coefficients. */
  double lowest = mech_min(mech_min(at_from, at_to), mech_min(one, two));
  double highest = mech_max(mech_max(at_from, at_to), mech_max(one, two));
  double off = mech_max(0, mech_max(z - highest, lowest - z));
  double aside = mech_max(0, mech_max(from - x, x - to));
  if (off * off + aside * aside >= least_known) {
    return known;
  }
  double bend_from = 2 * c2 + (from - origin) * (6 * c3);
  double bend_to = 2 * c2 + (to - origin) * (6 * c3);
  double most = mech_max(mech_abs(bend_from), mech_abs(bend_to));
  double farthest = mech_max(highest - z, z - lowest);
  int parts = most * farthest < 1 ? 1 : CURVE_PARTS;
  if (parts == 1 && from <= x && x < to) {
    /* At least as close as what is known, the point at x, even if rounding hides it. */
    return curve_zero(table, n, place, from, to, x, z);
  }
  double best = known;
  double least = least_known;
  double start = from;
  for (int i = 1; i <= parts; i++) {
    double end = i == parts ? to : from + (to - from) * i / parts;
    double s = curve_zero(table, n, place, start, end, x, z);
    double square = curve_square(table, n, place, s, x, z);
    if (square < least) {
      least = square;
      best = s;
    }
    start = end;
  }
  return best;
}

double mech_closest(const double *row, int count, double x, double z) {
  int n = (count - 5) / 6;
  int here = (int)mech_interval(row, n, x);
  double above = curve_value(row + n, n, here, x) - z;
  double least = above * above;
  if (!(least < INFINITY)) {
    return x;
  }
  double best = x;
  double width = mech_abs(above);
  double low = x - width;
  double high = x + width;
  for (int turn = 0; turn < 2; turn++) {
    int place = turn == 0 ? here : here - 1;
    while (turn == 0 ? place <= n : place >= 0) {
      double from = place == 0 ? low : mech_max(low, row[place - 1]);
      double to = place == n ? high : mech_min(high, row[place]);
      double aside = turn == 0 ? from - x : x - to;
      if (from > to || (aside > 0 && aside * aside >= least)) {
        break;
      }
      double found = curve_piece(row + n, n, place, from, to, x, z, best, least);
      if (found != best) {
        best = found;
        least = curve_square(row + n, n, place, best, x, z);
      }
      place += turn == 0 ? 1 : -1;
    }
  }
  return best;
}

/*
 * Reduction by the nearest multiple of pi/2 in three parts (Cody and Waite), exact to twice the
 * working precision up to 1e4 rad, and two minimax polynomials on [-pi/4, pi/4].
 */
/* Angle less n quarters of a turn, with the tail that rounding leaves. */
static double turned_back(double angle, double n, double *tail) {
  static const double PI_HALF_1 = 0x1.921fb544p0;
  static const double PI_HALF_2 = 0x1.0b4611a6p-34;
  static const double PI_HALF_3 = 0x1.3198a2e037073p-69;
  double first = angle - n * PI_HALF_1;
  double second = n * PI_HALF_2;
  double partial = first - second;
  double third = n * PI_HALF_3 - ((first - partial) - second);
  double x = partial - third;
  *tail = (partial - x) - third;
  return x;
}

static double sine_of(double x, double tail) {
  static const double S1 = -0.16666666666666632;
  static const double S2 = 0.008333333333322398;
  static const double S3 = -0.0001984126982979409;
  static const double S4 = 2.755731368695442e-06;
  static const double S5 = -2.5050757308207942e-08;
  static const double S6 = 1.5896747244048834e-10;
  double z = x * x;
  double part = S1 + z * (S2 + z * (S3 + z * (S4 + z * (S5 + z * S6))));
  return x + (z * x * part + tail * (1.0 - 0.5 * z));
}

static double cosine_of(double x, double tail) {
  static const double C1 = 0.0416666666666666;
  static const double C2 = -0.00138888888888741;
  static const double C3 = 2.4801587289467676e-05;
  static const double C4 = -2.755731434795667e-07;
  static const double C5 = 2.0875722654805672e-09;
  static const double C6 = -1.1359614629226544e-11;
  double z = x * x;
  double half = 0.5 * z;
  double part = C1 + z * (C2 + z * (C3 + z * (C4 + z * (C5 + z * C6))));
  double leading = 1.0 - half;
  return leading + (((1.0 - leading) - half) + (z * z * part - x * tail));
}

static const double TWO_OVER_PI = 0x1.45f306dc9c883p-1;
static const double LARGEST_ANGLE = 1.0e4;

void mech_sin_cos(double angle, double *out) {
  double n, x, tail, s, c;
  int quadrant;
  if (!(fabs(angle) <= LARGEST_ANGLE)) {
    out[0] = mech_sin(angle);
    out[1] = mech_cos(angle);
    return;
  }
  n = rint(angle * TWO_OVER_PI);
  x = turned_back(angle, n, &tail);
  s = sine_of(x, tail);
  c = cosine_of(x, tail);
  quadrant = (int)n & 3;
  if ((quadrant & 1) != 0) {
    double exchanged = s;
    s = c;
    c = exchanged;
  }
  out[0] = quadrant >= 2 ? -s : s;
  out[1] = quadrant == 1 || quadrant == 2 ? -c : c;
}

/* Sine of an angle to which some quarters of a turn are added. */
static double wave(double angle, int quarters) {
  double n = rint(angle * TWO_OVER_PI);
  double tail, x = turned_back(angle, n, &tail), size;
  int quadrant = ((int)n + quarters) & 3;
  size = (quadrant & 1) == 0 ? sine_of(x, tail) : cosine_of(x, tail);
  return quadrant >= 2 ? -size : size;
}

double mech_sine(double angle) {
  return fabs(angle) <= LARGEST_ANGLE ? wave(angle, 0) : mech_sin(angle);
}

double mech_cosine(double angle) {
  return fabs(angle) <= LARGEST_ANGLE ? wave(angle, 1) : mech_cos(angle);
}

void mech_normalize(double *e) {
  double norm = sqrt(e[0] * e[0] + e[1] * e[1] + e[2] * e[2] + e[3] * e[3]);
  int i;
  for (i = 0; i < 4; i++) {
    e[i] /= norm;
  }
}
