package org.mechservice.sim.service.setup;

/**
 * What a model may have beside its size.
 *
 * @param loops closed loops at most
 */
public record ReadingBounds(long loops) {
  /** No bounds but those of the language. */
  public static final ReadingBounds NONE = new ReadingBounds(Long.MAX_VALUE);
}
