package org.mechservice.solver.text;

import java.math.BigInteger;
import java.nio.charset.StandardCharsets;

/**
 * Writes numbers as the shortest decimal that reads back exactly; if several have that length, the
 * one nearest to the number.
 *
 * <p>The method is Giulietti's Schubfach (R. Giulietti, "The Schubfach way to render doubles",
 * 2020): the decimals of one more digit than needed are compared with the rounding interval of the
 * number in 126-bit arithmetic. {@link Double#toString} does the same only since JDK 19, and
 * results must not depend on the JDK.
 *
 * <p>Numbers from 1e-3 up to 1e17 are written plainly ({@code 0.01}, {@code 3}), others with an
 * exponent ({@code 1.5e-7}).
 */
public final class ShortestDecimal {
  /** Longest text: sign, 17 digits, point, {@code e-308}. */
  static final int MAX_LENGTH = 25;

  private static final int FRACTION_BITS = 52;
  private static final int MIN_EXPONENT = -1074;
  private static final long HIDDEN_BIT = 1L << FRACTION_BITS;
  private static final long LOW_63_BITS = Long.MAX_VALUE;

  private static final int MIN_POWER = -292;
  private static final int MAX_POWER = 324;

  /** Decimal exponents outside this range are written as exponents. */
  private static final int SMALLEST_PLAIN_POINT = -2;

  private static final int LARGEST_PLAIN_POINT = 17;

  /**
   * Scaled powers of ten by {@code power − MIN_POWER}, high and low 63 bits; filled when first
   * needed.
   */
  private final long[] powerHigh = new long[MAX_POWER - MIN_POWER + 1];

  private final long[] powerLow = new long[MAX_POWER - MIN_POWER + 1];

  private final byte[] digits = new byte[20];
  private long significand;
  private int exponent;

  /** Makes a writer with its own workspace; not for use by several threads at once. */
  public ShortestDecimal() {}

  /** Returns the shortest decimal of a finite number. */
  public static String format(double value) {
    byte[] text = new byte[MAX_LENGTH];
    int end = new ShortestDecimal().write(value, text, 0);
    return new String(text, 0, end, StandardCharsets.US_ASCII);
  }

  /**
   * Writes the shortest decimal of a finite number in ASCII.
   *
   * @param value finite
   * @param text overwritten from {@code offset}, at most {@value #MAX_LENGTH} bytes
   * @return the offset after the last byte written
   * @throws IllegalArgumentException if the value is not finite
   */
  public int write(double value, byte[] text, int offset) {
    if (!Double.isFinite(value)) {
      throw new IllegalArgumentException("not a finite number: " + value);
    }
    int at = offset;
    if (Double.doubleToRawLongBits(value) < 0) {
      text[at++] = '-';
    }
    if (value == 0) {
      text[at++] = '0';
      return at;
    }
    shortest(Math.abs(value));
    int count = splitDigits();
    int point = exponent + count;
    if (point >= SMALLEST_PLAIN_POINT && point <= LARGEST_PLAIN_POINT) {
      return writePlain(count, point, text, at);
    }
    return writeScientific(count, point, text, at);
  }

  /** Finds {@code significand · 10^exponent} for a positive number. */
  private void shortest(double value) {
    long bits = Double.doubleToRawLongBits(value);
    long fraction = bits & (HIDDEN_BIT - 1);
    int biased = (int) (bits >>> FRACTION_BITS);
    long c = biased == 0 ? fraction : HIDDEN_BIT | fraction;
    int q = Math.max(biased, 1) + MIN_EXPONENT - 1;
    if (-FRACTION_BITS <= q && q <= 0 && Long.numberOfTrailingZeros(c) >= -q) {
      significand = c >> -q;
      exponent = 0;
      return;
    }
    decide(c, q, fraction != 0 || biased <= 1);
  }

  /**
   * Chooses the decimal for c · 2^q.
   *
   * @param regular whether the neighbours below and above are equally far away
   */
  private void decide(long c, int q, boolean regular) {
    int k = regular ? floorLog10Of2To(q) : floorLog10Of3QuartersOf2To(q);
    int h = q + floorLog2Of10To(-k) + 2;
    int slot = -k - MIN_POWER;
    if (powerHigh[slot] == 0) {
      computePower(slot);
    }
    long high = powerHigh[slot];
    long low = powerLow[slot];
    long odd = c & 1;
    long middle = c << 2;
    long value = scaled(high, low, middle << h);
    long lower = scaled(high, low, (regular ? middle - 2 : middle - 1) << h) + odd;
    long upper = scaled(high, low, (middle + 2) << h) - odd;

    long s = value >> 2;
    exponent = k;
    if (s >= 10) {
      long tens = s / 10 * 10;
      boolean lowerTenFits = lower <= tens << 2;
      boolean upperTenFits = (tens + 10) << 2 <= upper;
      if (lowerTenFits != upperTenFits) {
        significand = lowerTenFits ? tens : tens + 10;
        return;
      }
    }
    boolean belowFits = lower <= s << 2;
    boolean aboveFits = (s + 1) << 2 <= upper;
    if (belowFits != aboveFits) {
      significand = belowFits ? s : s + 1;
      return;
    }
    long fromMiddle = value - ((2 * s + 1) << 1);
    significand = fromMiddle < 0 || (fromMiddle == 0 && (s & 1) == 0) ? s : s + 1;
  }

  /** Returns the product of a power of ten and {@code factor} over 2^126, rounded to odd. */
  private static long scaled(long high, long low, long factor) {
    long lowProduct = Math.multiplyHigh(low, factor);
    long middle = ((high * factor) >>> 1) + lowProduct;
    long top = Math.multiplyHigh(high, factor) + (middle >>> 63);
    return top | (((middle & LOW_63_BITS) + LOW_63_BITS) >>> 63);
  }

  /** Computes ⌊10^power · 2^r⌋ + 1 with r such that the result has 126 bits. */
  private void computePower(int slot) {
    int power = slot + MIN_POWER;
    int shift = 125 - floorLog2Of10To(power);
    BigInteger numerator = power >= 0 ? BigInteger.TEN.pow(power) : BigInteger.ONE;
    BigInteger denominator = power >= 0 ? BigInteger.ONE : BigInteger.TEN.pow(-power);
    numerator = shift >= 0 ? numerator.shiftLeft(shift) : numerator;
    denominator = shift >= 0 ? denominator : denominator.shiftLeft(-shift);
    BigInteger scaled = numerator.divide(denominator).add(BigInteger.ONE);
    powerHigh[slot] = scaled.shiftRight(63).longValue();
    powerLow[slot] = scaled.longValue() & LOW_63_BITS;
  }

  // The three logarithms are exact for every exponent of a double: the constants hold 41, 41 and 38
  // bits of log10(2), its
  // value at 3/4, and log2(10).
  private static int floorLog10Of2To(int e) {
    return (int) ((e * 661_971_961_083L) >> 41);
  }

  private static int floorLog10Of3QuartersOf2To(int e) {
    return (int) ((e * 661_971_961_083L - 274_743_187_321L) >> 41);
  }

  private static int floorLog2Of10To(int e) {
    return (int) ((e * 913_124_641_741L) >> 38);
  }

  /** Splits the significand into digits without trailing zeros; returns their number. */
  private int splitDigits() {
    long rest = significand;
    while (rest % 10 == 0) {
      rest /= 10;
      exponent++;
    }
    int count = 1;
    for (long power = 10; count < 19 && rest >= power; power *= 10) {
      count++;
    }
    for (int i = count - 1; i >= 0; i--) {
      digits[i] = (byte) ('0' + rest % 10);
      rest /= 10;
    }
    return count;
  }

  private int writePlain(int count, int point, byte[] text, int offset) {
    int at = offset;
    if (point <= 0) {
      text[at++] = '0';
      text[at++] = '.';
      for (int i = point; i < 0; i++) {
        text[at++] = '0';
      }
    }
    for (int i = 0; i < Math.max(count, point); i++) {
      if (i == point && point > 0) {
        text[at++] = '.';
      }
      text[at++] = i < count ? digits[i] : (byte) '0';
    }
    return at;
  }

  private int writeScientific(int count, int point, byte[] text, int offset) {
    int at = offset;
    text[at++] = digits[0];
    if (count > 1) {
      text[at++] = '.';
      for (int i = 1; i < count; i++) {
        text[at++] = digits[i];
      }
    }
    text[at++] = 'e';
    int power = point - 1;
    if (power < 0) {
      text[at++] = '-';
      power = -power;
    }
    if (power >= 100) {
      text[at++] = (byte) ('0' + power / 100);
    }
    if (power >= 10) {
      text[at++] = (byte) ('0' + power / 10 % 10);
    }
    text[at++] = (byte) ('0' + power % 10);
    return at;
  }
}
