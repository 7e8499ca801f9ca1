package org.mechservice.orb;

import ch.qos.logback.classic.Level;
import ch.qos.logback.classic.Logger;
import ch.qos.logback.classic.LoggerContext;
import org.slf4j.LoggerFactory;

/**
 * The level of messages of the ORB in the log of a program. Logback without configuration prints
 * everything: a hundred lines for each connection.
 */
final class OrbLog {
  private static final String ORB = "org.jacorb";
  private static final String LOGBACK = "ch.qos.logback.classic.LoggerContext";

  private OrbLog() {}

  /** Leaves the ORB its warnings alone, unless the program says what it wants of the ORB. */
  static void quieten() {
    Object factory = LoggerFactory.getILoggerFactory();
    if (factory.getClass().getName().equals(LOGBACK)) {
      Logback.quieten(factory);
    }
  }

  /** Apart, so that nothing of logback is needed where there is none. */
  static final class Logback {
    private Logback() {}

    /**
     * @param factory the logger factory in use
     */
    static void quieten(Object factory) {
      Logger orb = ((LoggerContext) factory).getLogger(ORB);
      if (orb.getLevel() == null && !orb.getEffectiveLevel().isGreaterOrEqual(Level.WARN)) {
        orb.setLevel(Level.WARN);
      }
    }
  }
}
