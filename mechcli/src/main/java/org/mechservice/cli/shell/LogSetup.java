package org.mechservice.cli.shell;

import ch.qos.logback.classic.Level;
import ch.qos.logback.classic.Logger;
import ch.qos.logback.classic.LoggerContext;
import ch.qos.logback.classic.encoder.JsonEncoder;
import ch.qos.logback.classic.encoder.PatternLayoutEncoder;
import ch.qos.logback.classic.joran.JoranConfigurator;
import ch.qos.logback.classic.spi.Configurator;
import ch.qos.logback.classic.spi.ILoggingEvent;
import ch.qos.logback.core.Appender;
import ch.qos.logback.core.ConsoleAppender;
import ch.qos.logback.core.FileAppender;
import ch.qos.logback.core.OutputStreamAppender;
import ch.qos.logback.core.encoder.Encoder;
import ch.qos.logback.core.joran.spi.JoranException;
import ch.qos.logback.core.spi.ContextAwareBase;
import java.nio.charset.StandardCharsets;
import org.mechservice.sim.service.contract.Journal;
import org.mechservice.solver.catalogue.MessageCode;
import org.slf4j.LoggerFactory;

/**
 * Logging of the command line: the product's warnings on standard error, one line each; everything,
 * with details, in the file that MECH_LOG names, as one JSON object per line if its name ends in
 * {@code .jsonl}; as MECH_LOG says if it names a configuration of logback ({@code .xml}). What the
 * service within a command tells its only client is left to the command, which tells its user once.
 * A process that serves tells causes, too. Found by logback as a service.
 */
public final class LogSetup extends ContextAwareBase implements Configurator {
  private static final String PRODUCT = "org.mechservice";
  private static final String ORB = "org.jacorb";
  private static final String UNREADABLE_REQUESTS = "org.jacorb.poa.controller";
  private static final String CONSOLE = "console";
  private static final String EMBEDDED = Journal.LOGGER + "." + ServiceConnection.EMBEDDED_NAME;
  private static final String SHORT = "%msg%n%nopex";
  private static final String DETAILED = "%msg%n%ex";
  private static final String LONG = "%d{ISO8601,UTC} %-5level [%thread] %logger: %msg%n%ex";

  @Override
  public ExecutionStatus configure(LoggerContext context) {
    return configure(context, System.getenv().getOrDefault("MECH_LOG", ""));
  }

  ExecutionStatus configure(LoggerContext context, String file) {
    if (file.endsWith(".xml")) {
      configureAsWritten(context, file);
      return ExecutionStatus.DO_NOT_INVOKE_NEXT_IF_ANY;
    }
    Logger root = context.getLogger(Logger.ROOT_LOGGER_NAME);
    root.setLevel(Level.OFF);
    if (!file.isEmpty()) {
      FileAppender<ILoggingEvent> log = new FileAppender<>();
      log.setFile(file);
      root.addAppender(started(log, context, file.endsWith(".jsonl") ? json() : pattern(LONG)));
      root.setLevel(Level.INFO);
      context.getLogger(PRODUCT).setLevel(Level.DEBUG);
      // Whoever reaches the port must not be able to fill the disk: no line for each connection,
      // and
      // no stack trace for each request that cannot be read.
      context.getLogger(ORB).setLevel(Level.WARN);
      context.getLogger(UNREADABLE_REQUESTS).setLevel(Level.OFF);
      return ExecutionStatus.DO_NOT_INVOKE_NEXT_IF_ANY;
    }
    ConsoleAppender<ILoggingEvent> console = new ConsoleAppender<>();
    console.setName(CONSOLE);
    console.setTarget("System.err");
    Logger product = context.getLogger(PRODUCT);
    product.addAppender(started(console, context, pattern(SHORT)));
    product.setLevel(Level.WARN);
    context.getLogger(EMBEDDED).setLevel(Level.OFF);
    return ExecutionStatus.DO_NOT_INVOKE_NEXT_IF_ANY;
  }

  /** Logs as a file of logback's own configuration says, on the console if it cannot be read. */
  private void configureAsWritten(LoggerContext context, String file) {
    JoranConfigurator configurator = new JoranConfigurator();
    configurator.setContext(context);
    try {
      configurator.doConfigure(file);
    } catch (JoranException e) {
      context.reset();
      configure(context, "");
      context
          .getLogger(PRODUCT)
          .warn(
              MessageCode.OPTION_UNUSABLE + " MECH_LOG={} is no configuration of logback: {}",
              file,
              e.getMessage());
    }
  }

  /**
   * Prints the causes of failures as well: the operator of a serving process cannot repeat the
   * call.
   */
  public static void showCauses() {
    if (LoggerFactory.getILoggerFactory() instanceof LoggerContext context) {
      showCauses(context);
    }
  }

  static void showCauses(LoggerContext context) {
    Appender<ILoggingEvent> console = context.getLogger(PRODUCT).getAppender(CONSOLE);
    if (console instanceof OutputStreamAppender<ILoggingEvent> stream) {
      Encoder<ILoggingEvent> encoder = pattern(DETAILED);
      encoder.setContext(context);
      encoder.start();
      stream.setEncoder(encoder);
    }
  }

  /** The message as people read it, not its parts. */
  private static JsonEncoder json() {
    JsonEncoder encoder = new JsonEncoder();
    encoder.setWithFormattedMessage(true);
    encoder.setWithMessage(false);
    encoder.setWithArguments(false);
    return encoder;
  }

  private static PatternLayoutEncoder pattern(String pattern) {
    PatternLayoutEncoder encoder =
        new PatternLayoutEncoder() {
          @Override
          public byte[] encode(ILoggingEvent event) {
            String text = getLayout().doLayout(event);
            return SafeWriter.withoutColours(text).getBytes(StandardCharsets.UTF_8);
          }
        };
    encoder.setPattern(pattern);
    return encoder;
  }

  private static OutputStreamAppender<ILoggingEvent> started(
      OutputStreamAppender<ILoggingEvent> appender,
      LoggerContext context,
      Encoder<ILoggingEvent> encoder) {
    encoder.setContext(context);
    encoder.start();
    appender.setContext(context);
    appender.setEncoder(encoder);
    appender.start();
    return appender;
  }
}
