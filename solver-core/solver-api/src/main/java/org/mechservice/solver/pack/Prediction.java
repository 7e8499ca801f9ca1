package org.mechservice.solver.pack;

import java.util.Arrays;

/**
 * Predicts bits by what followed in like surroundings. Every context keeps, for each bit of the
 * byte to come, how often it was 1; the mixture of what they say, in logits, has weights that grow
 * for the contexts that did well (logistic mixing: Mahoney, "Adaptive weighing of context models
 * for lossless data compression", 2005). All in integers, so that every machine predicts the same.
 */
final class Prediction {
  /** Probabilities of the mixture are of 65536; this is the least. */
  private static final int LEAST = 8;

  /** Logits are told in parts of 1/170, so that the probabilities of a place fit. */
  private static final double LOGIT_UNIT = 170;

  private static final int LARGEST_LOGIT = 2047;
  private static final int ALWAYS_ON = 256;

  /** Logit of a place's probability. */
  private static final int[] LOGIT = new int[4096];

  /** Probability that belongs to a logit. */
  private static final int[] PROBABILITY = new int[2 * LARGEST_LOGIT + 1];

  /**
   * A place keeps a probability of 4096 in its high bits and in its low ones how often it was
   * corrected; it is stored in the form that makes a new one 0.
   */
  private static final int COUNT_BITS = 4;

  private static final int MOST_COUNT = (1 << COUNT_BITS) - 1;
  private static final int NEW = 1 << 15;

  /** By how much of its error a place is corrected. */
  private static final int[] RATE = new int[MOST_COUNT + 1];

  private static final int RATE_BITS = 15;
  private static final int RATE_HALF = 1 << (RATE_BITS - 1);

  /** Places come in lines, one for each half of a byte in a context: a check, then 15 places. */
  private static final int LINE_BITS = 4;

  private static final int LINE = 1 << LINE_BITS;
  private static final int LINES_BITS = 16;
  private static final int LINES_MASK = (1 << LINES_BITS) - 1;

  private static final int WEIGHT_BITS = 12;
  private static final int FIRST_WEIGHT = (1 << WEIGHT_BITS) * 3 / 10;
  private static final int LEARNING_BITS = 17;
  private static final int LEARNING_HALF = 1 << (LEARNING_BITS - 1);

  private static final int CONTEXTS = Surroundings.CONTEXTS;
  private static final int INPUTS = CONTEXTS + 1;

  static {
    // StrictMath gives the same bits everywhere.
    for (int i = 0; i < LOGIT.length; i++) {
      double odds = (i + 0.5) / (LOGIT.length - i - 0.5);
      LOGIT[i] = (int) StrictMath.rint(LOGIT_UNIT * StrictMath.log(odds));
    }
    for (int i = 0; i < PROBABILITY.length; i++) {
      double against = StrictMath.exp((LARGEST_LOGIT - i) / LOGIT_UNIT);
      int one = (int) (65536 / (1 + against));
      PROBABILITY[i] = Math.min(65536 - LEAST, Math.max(LEAST, one));
    }
    for (int i = 0; i < RATE.length; i++) {
      RATE[i] = (10 << RATE_BITS) / (10 * i + 16);
    }
  }

  private final char[] places = new char[CONTEXTS << (LINES_BITS + LINE_BITS)];
  private final int[] weights = new int[Surroundings.WEIGHT_SETS * INPUTS];
  private final int[] line = new int[CONTEXTS];
  private final int[] logit = new int[INPUTS];
  private int[] contexts = new int[0];
  private int firstWeight;
  private int predicted;

  /** Bits of this half of the byte, behind a 1. */
  private int node;

  private boolean secondHalf;

  Prediction() {
    Arrays.fill(weights, FIRST_WEIGHT);
    logit[CONTEXTS] = ALWAYS_ON;
  }

  /**
   * Begins a byte.
   *
   * @param byteContexts what is around it, a hash each; read until its end
   * @param weightSet which weights are to mix
   */
  void begin(int[] byteContexts, int weightSet) {
    contexts = byteContexts;
    firstWeight = weightSet * INPUTS;
    secondHalf = false;
    findLines(0);
  }

  /** Finds the lines of the contexts; the check tells whose a line is, who comes anew takes it. */
  private void findLines(int firstHalf) {
    node = 1;
    for (int i = 0; i < CONTEXTS; i++) {
      int hash = Surroundings.hash(contexts[i], firstHalf);
      char check = (char) (hash >>> Character.SIZE | 1);
      int found = (i << LINES_BITS | (hash & LINES_MASK)) << LINE_BITS;
      if (places[found] != check && places[found ^ LINE] == check) {
        found ^= LINE;
      }
      if (places[found] != check) {
        Arrays.fill(places, found, found + LINE, (char) 0);
        places[found] = check;
      }
      line[i] = found;
    }
  }

  /** Returns how probable it is that the next bit is a 1, of 65536. */
  int one() {
    int mixed = ALWAYS_ON * weights[firstWeight + CONTEXTS];
    for (int i = 0; i < CONTEXTS; i++) {
      logit[i] = LOGIT[(places[line[i] + node] ^ NEW) >>> COUNT_BITS];
      mixed += logit[i] * weights[firstWeight + i];
    }
    int bounded = Math.max(-LARGEST_LOGIT, Math.min(LARGEST_LOGIT, mixed >> WEIGHT_BITS));
    predicted = PROBABILITY[bounded + LARGEST_LOGIT];
    return predicted;
  }

  /** Corrects by what the bit was. */
  void learn(int bit) {
    int error = ((bit << 16) - predicted) >> 1;
    for (int i = 0; i < INPUTS; i++) {
      weights[firstWeight + i] += (logit[i] * error + LEARNING_HALF) >> LEARNING_BITS;
    }
    for (int i = 0; i < CONTEXTS; i++) {
      int at = line[i] + node;
      int place = places[at] ^ NEW;
      int one = place >>> COUNT_BITS;
      int count = place & MOST_COUNT;
      one += (((bit << 12) - bit - one) * RATE[count] + RATE_HALF) >> RATE_BITS;
      places[at] = (char) ((one << COUNT_BITS | Math.min(count + 1, MOST_COUNT)) ^ NEW);
    }
    node = node << 1 | bit;
    if (node >> LINE_BITS != 0 && !secondHalf) {
      secondHalf = true;
      findLines(node);
    }
  }
}
