package org.mechservice.orb;

import static org.assertj.core.api.Assertions.assertThat;

import ch.qos.logback.classic.Level;
import ch.qos.logback.classic.Logger;
import ch.qos.logback.classic.LoggerContext;
import org.junit.jupiter.api.Test;

/** A program that has not configured its log is not flooded by the ORB. */
class OrbLogTest {
  private static Logger orbAfter(String configured, Level level) {
    LoggerContext context = new LoggerContext();
    context.getLogger(configured).setLevel(level);
    OrbLog.Logback.quieten(context);
    return context.getLogger("org.jacorb.giop");
  }

  @Test
  void logbackWithoutConfigurationTellsWarningsOfTheOrbAlone() {
    Logger orb = orbAfter(Logger.ROOT_LOGGER_NAME, Level.DEBUG);
    assertThat(orb.isInfoEnabled()).isFalse();
    assertThat(orb.isWarnEnabled()).isTrue();
  }

  @Test
  void aLevelThatTheProgramSetStays() {
    assertThat(orbAfter("org.jacorb", Level.DEBUG).isDebugEnabled()).isTrue();
    assertThat(orbAfter(Logger.ROOT_LOGGER_NAME, Level.OFF).isErrorEnabled()).isFalse();
  }
}
