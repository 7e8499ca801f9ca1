package org.mechservice.cli.shell;

import static org.assertj.core.api.Assertions.assertThat;

import ch.qos.logback.classic.LoggerContext;
import ch.qos.logback.classic.util.LogbackMDCAdapter;
import ch.qos.logback.core.status.Status;
import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class LogSetupTest {
  @TempDir private Path folder;

  private List<String> logged(String name) throws IOException {
    Path file = folder.resolve(name);
    LoggerContext context = new LoggerContext();
    context.setMDCAdapter(new LogbackMDCAdapter());
    new LogSetup().configure(context, file.toString());
    context.getLogger("org.mechservice.test").warn("S-019 host \"{}\" dropped", "a");
    context.stop();
    return Files.readAllLines(file);
  }

  @Test
  void fileOfJsonLinesHasOneObjectForEachMessage() throws IOException {
    List<String> lines = logged("mech.jsonl");
    assertThat(lines).hasSize(1);
    JsonObject line = JsonParser.parseString(lines.get(0)).getAsJsonObject();
    assertThat(line.get("level").getAsString()).isEqualTo("WARN");
    assertThat(line.get("loggerName").getAsString()).isEqualTo("org.mechservice.test");
    assertThat(line.get("formattedMessage").getAsString()).isEqualTo("S-019 host \"a\" dropped");
    assertThat(line.has("timestamp")).isTrue();
  }

  @Test
  void otherFilesAreForPeople() throws IOException {
    assertThat(logged("mech.log").get(0))
        .matches(".*Z? WARN  \\[main\\] org.mechservice.test: S-019 host \"a\" dropped");
  }

  @Test
  void messagesSteerNoTerminal() throws IOException {
    Path file = folder.resolve("colours.log");
    LoggerContext context = new LoggerContext();
    context.setMDCAdapter(new LogbackMDCAdapter());
    new LogSetup().configure(context, file.toString());
    context.getLogger("org.mechservice.test").warn("S-068 threw \u001b[31mred\u0007");
    context.stop();
    assertThat(Files.readString(file)).endsWith("S-068 threw ?[31mred?\n");
  }

  @Test
  void configurationOfTheReleaseWritesFilesThatTurn() throws IOException {
    LoggerContext context = new LoggerContext();
    context.setMDCAdapter(new LogbackMDCAdapter());
    context.putProperty("MECH_LOG_FOLDER", folder.toString());
    new LogSetup().configure(context, "../dist/conf/logback.xml");
    context.getLogger("org.mechservice.test").info("S-016 host \"a\" registered");
    context.stop();
    assertThat(folder.resolve("mech.log")).content().contains("S-016 host \"a\" registered");
    assertThat(context.getStatusManager().getCopyOfStatusList())
        .allMatch(status -> status.getLevel() == Status.INFO);
  }

  @Test
  void configurationThatCannotBeReadIsNamedOnTheConsole() {
    assertThat(console(false, folder.resolve("missing.xml").toString()))
        .anyMatch(line -> line.contains("MECH_LOG=") && line.contains("missing.xml"))
        .contains("S-001 incident 1");
  }

  @Test
  void requestsOfStrangersFillNoFile() throws IOException {
    Path file = folder.resolve("strangers.log");
    LoggerContext context = new LoggerContext();
    context.setMDCAdapter(new LogbackMDCAdapter());
    new LogSetup().configure(context, file.toString());
    context.getLogger("org.jacorb.orb.iiop.ServerIIOPConnection").info("opened");
    context
        .getLogger("org.jacorb.poa.controller")
        .error("rid: 5 invocation: throwable was thrown", new ArrayIndexOutOfBoundsException());
    context.stop();
    assertThat(file).isEmptyFile();
  }

  private static List<String> console(boolean serving, String file) {
    PrintStream before = System.err;
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    System.setErr(new PrintStream(bytes, true, StandardCharsets.UTF_8));
    try {
      LoggerContext context = new LoggerContext();
      context.setMDCAdapter(new LogbackMDCAdapter());
      new LogSetup().configure(context, file);
      if (serving) {
        LogSetup.showCauses(context);
      }
      context.getLogger("org.mechservice.sim.service.embedded").warn("N-013 told by the command");
      context
          .getLogger("org.mechservice.orb.GuardedServant")
          .error("S-001 incident 1", new IllegalStateException("cause"));
      context.stop();
    } finally {
      System.setErr(before);
    }
    return bytes.toString(StandardCharsets.UTF_8).lines().toList();
  }

  @Test
  void consoleOfACommandHasOneLineForEachFailureAndLeavesThoseOfRunsToTheCommand() {
    assertThat(console(false, "")).containsExactly("S-001 incident 1");
  }

  @Test
  void consoleOfAServerTellsCausesOfFailures() {
    assertThat(console(true, ""))
        .startsWith("S-001 incident 1", "java.lang.IllegalStateException: cause");
  }
}
