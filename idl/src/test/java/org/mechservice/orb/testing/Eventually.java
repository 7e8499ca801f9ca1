package org.mechservice.orb.testing;

import static org.assertj.core.api.Assertions.assertThat;

/** Waits until a condition holds that another thread or process makes true. */
public final class Eventually {
  private static final int MOST_CHECKS = 1200;
  private static final long CHECK_MILLIS = 50;

  /** A condition that is to become true. */
  public interface Condition {
    boolean holds() throws Exception;
  }

  private Eventually() {}

  /** Fails if the condition does not hold within a minute. */
  public static void holds(Condition condition) throws Exception {
    for (int i = 0; i < MOST_CHECKS && !condition.holds(); i++) {
      Thread.sleep(CHECK_MILLIS);
    }
    assertThat(condition.holds()).isTrue();
  }
}
