package org.mechservice.server;

import static org.assertj.core.api.Assertions.assertThat;

/** Waits for what happens by itself. */
final class Eventually {
  private static final int PATIENCE = 600;
  private static final long CHECK_MILLIS = 100;

  /** Something that is to become true. */
  public interface Condition {
    public boolean holds() throws Exception;
  }

  private Eventually() {}

  public static void holds(Condition condition) throws Exception {
    for (int i = 0; i < PATIENCE && !condition.holds(); i++) {
      Thread.sleep(CHECK_MILLIS);
    }
    assertThat(condition.holds()).isTrue();
  }
}
