package org.mechservice.sim.service.session;

import java.lang.ref.SoftReference;
import java.util.Optional;

/**
 * Texts that are larger than a message may be, and are fetched in parts.
 *
 * <p>The last long one is kept as long as there is memory, so that it is made once for all of its
 * parts and for the request that found it too long.
 */
final class LongTexts {
  /** Characters of a part: at four bytes each, half of what a message may have. */
  static final int PART = 4_000_000;

  private record Kept(Object of, String text) {}

  private volatile SoftReference<Kept> last = new SoftReference<>(new Kept("", ""));

  /**
   * Returns the last long text, if it was made of the same.
   *
   * @param of what it is made of
   */
  Optional<String> of(Object of) {
    return Optional.ofNullable(last.get()).filter(text -> text.of().equals(of)).map(Kept::text);
  }

  /** Keeps a text if it is long, and returns it. */
  String keep(Object of, String text) {
    if (text.length() > PART) {
      last = new SoftReference<>(new Kept(of, text));
    }
    return text;
  }

  /** Returns a part of a text, from 0; empty after the last. No character is split. */
  static String part(String text, int index) {
    return text.substring(border(text, index), border(text, index + 1));
  }

  private static int border(String text, int index) {
    int border = (int) Math.min((long) index * PART, text.length());
    boolean splits =
        border > 0 && border < text.length() && Character.isHighSurrogate(text.charAt(border - 1));
    return splits ? border - 1 : border;
  }
}
