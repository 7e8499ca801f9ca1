package org.mechservice.solver.pack;

import java.io.IOException;

/**
 * Carries symbols, a byte each, to or from the packed classes. Each is coded bit by bit, in as much
 * room as it is a surprise (arithmetic coding): what is predicted well costs next to nothing. Both
 * ways make the same predictions, from the symbols that were carried before.
 */
abstract class Symbols {
  private static final int MORE = 0x80;
  private static final int SEVEN_BITS = 0x7f;
  private static final int BYTE = 0xff;

  private final Surroundings surroundings = new Surroundings();
  private final Prediction prediction = new Prediction();

  /**
   * Carries one bit.
   *
   * @param one how probable a 1 is, of 65536
   * @param bit the bit; of no meaning where symbols are read
   * @return the bit
   */
  abstract int bit(int one, int bit) throws IOException;

  /** Returns where what the next symbols mean can be told. */
  Surroundings surroundings() {
    return surroundings;
  }

  /**
   * Carries a byte.
   *
   * @param band what it means: one of {@link BandNumbers}
   * @param value the byte; of no meaning where symbols are read
   * @return the byte
   */
  int symbol(int band, int value) throws IOException {
    prediction.begin(surroundings.contexts(band), surroundings.weightSet(band));
    int read = 0;
    for (int i = Byte.SIZE - 1; i >= 0; i--) {
      int bit = bit(prediction.one(), (value >> i) & 1);
      prediction.learn(bit);
      read = (read << 1) | bit;
    }
    surroundings.follow(band, read);
    return read;
  }

  /** Carries a number of two bytes: the high one, then the low one. */
  int pair(int band, int value) throws IOException {
    int high = symbol(band, (value >> Byte.SIZE) & BYTE);
    return (high << Byte.SIZE) | symbol(band + 1, value & BYTE);
  }

  /** Carries a number that is small as a rule, seven bits a byte. */
  int small(int band, int value) throws IOException {
    int rest = value;
    int carried = 0;
    for (int shift = 0; shift < Integer.SIZE; shift += 7) {
      int more = (rest & ~SEVEN_BITS) == 0 ? 0 : MORE;
      int symbol = symbol(band, (rest & SEVEN_BITS) | more);
      carried |= (symbol & SEVEN_BITS) << shift;
      if ((symbol & MORE) == 0) {
        return carried;
      }
      rest >>>= 7;
    }
    throw new IOException("the packed classes are damaged (band " + band + ")");
  }

  /** Carries a number of either sign that is near zero as a rule. */
  int signed(int band, int value) throws IOException {
    int folded = small(band, (value << 1) ^ (value >> (Integer.SIZE - 1)));
    return (folded >>> 1) ^ -(folded & 1);
  }
}
