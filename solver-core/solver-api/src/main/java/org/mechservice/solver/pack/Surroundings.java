package org.mechservice.solver.pack;

import java.util.Arrays;

/** What is around a symbol that is carried: contexts in which like symbols are to be expected. */
final class Surroundings {
  /** How many contexts there are. */
  static final int CONTEXTS = 7;

  /** How many sets of weights there are: for every band, opcode and length of a repetition. */
  static final int WEIGHT_SETS = BandNumbers.COUNT + 256 + RepeatedSymbols.MOST_LENGTH + 1;

  private static final int BYTE = 0xff;

  private final int[] contexts = new int[CONTEXTS];
  private final long[] ofBand = new long[BandNumbers.COUNT];
  private final RepeatedSymbols repeated = new RepeatedSymbols();

  /** Hashes of the last instructions with their operands, the newest first. */
  private final int[] instructions = new int[4];

  /** What was carried last: of any kind, and opcodes; the newest in the lowest byte. */
  private long recent;

  private long opcodes;
  private int classNumber;
  private int methodNumber;
  private int expected;
  private int word;
  private int wordBefore;
  private int added;

  /** Tells that what follows is of the next class. */
  void nextClass() {
    classNumber++;
  }

  /** Tells that what follows is of the next method. */
  void nextMethod() {
    methodNumber++;
    Arrays.fill(instructions, 0);
  }

  /** Tells what the next symbol may have to do with, by any number. */
  void expect(int number) {
    expected = number;
  }

  /** Returns the contexts of the next symbol. */
  int[] contexts(int band) {
    long same = ofBand[band];
    added = 0;
    if (band == BandNumbers.TEXT) {
      textContexts();
    } else if (band == BandNumbers.OPCODE) {
      opcodeContexts();
    } else {
      add(band, expected, 0);
      add(band, same & BYTE, expected);
      add(band, recent & 0xffffff, 0);
      add(band, recent & BYTE, instructions[0]);
      add(band, recent & BYTE, hash(classNumber, expected));
      add(band, (recent & BYTE) | (opcodes & BYTE) << Byte.SIZE, methodNumber);
    }
    add(band, repeated.expected(band), repeated.length());
    return contexts;
  }

  private void textContexts() {
    int band = BandNumbers.TEXT;
    add(band, recent & BYTE, expected);
    add(band, recent & 0xffff, classNumber);
    add(band, recent & 0xffffff, 0);
    add(band, recent & 0xffffffffffL, 0);
    add(band, word, 0);
    add(band, word, wordBefore);
  }

  private void opcodeContexts() {
    int band = BandNumbers.OPCODE;
    add(band, opcodes & BYTE, 0);
    add(band, opcodes & 0xffff, classNumber);
    add(band, opcodes & 0xffffff, 0);
    add(band, opcodes & 0xffffffffffffL, 0);
    add(band, instructions[0], instructions[1]);
    add(band, instructions[0], hash(instructions[1], instructions[2]));
  }

  private void add(int band, long around, int place) {
    int hash = hash(band * CONTEXTS + added, (int) around);
    contexts[added++] = hash(hash, (int) (around >>> 32) + 0x10001 * place);
  }

  /** Returns which weights are to be used for the next symbol. */
  int weightSet(int band) {
    return switch (band) {
      case BandNumbers.OPCODE -> BandNumbers.COUNT + (int) (opcodes & BYTE);
      case BandNumbers.TEXT -> BandNumbers.COUNT + BYTE + 1 + repeated.length();
      default -> band;
    };
  }

  /** Takes note of what was carried. */
  void follow(int band, int symbol) {
    ofBand[band] = ofBand[band] << Byte.SIZE | symbol;
    recent = recent << Byte.SIZE | symbol;
    if (band == BandNumbers.OPCODE) {
      opcodes = opcodes << Byte.SIZE | symbol;
      System.arraycopy(instructions, 0, instructions, 1, instructions.length - 1);
      instructions[0] = symbol;
    } else if (band == BandNumbers.TEXT) {
      followText(symbol);
    } else {
      instructions[0] = hash(instructions[0], symbol);
    }
    repeated.follow(band, symbol);
    expected = 0;
  }

  private void followText(int symbol) {
    boolean inWord = symbol >= 'a' && symbol <= 'z';
    if (inWord) {
      word = hash(word, symbol);
    } else {
      wordBefore = word;
      word = symbol;
    }
  }

  /** Returns a number that depends on every bit of two. */
  static int hash(int a, int b) {
    int hash = a * 0x2c1b3c6d + b * 0x297a2d39 + 0x5bd1e995;
    hash = (hash ^ hash >>> 15) * 0x85ebca6b;
    return hash ^ hash >>> 13;
  }
}
