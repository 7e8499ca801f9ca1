package org.mechservice.examples;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonParser;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.idl.LimitExceeded;
import org.mechservice.orb.ServiceOrb;

/** What one client does to a server, as users start both, and what the others notice of it. */
class HostileTenantIT {
  @TempDir private Path folder;

  @Test
  void textOfAClassSilencesNoAudit() throws Exception {
    Files.writeString(folder.resolve("m.xml"), DraggedBob.MODEL);
    DraggedBob.writeSource(
        folder,
        "",
        "",
        "throw new IllegalStateException(\"\\ud800\\ud800 \\u0000 \\u202e \\r\\n\\u001b]0;x\\u0007\");");
    int port = Service.freePort();
    Path audit = folder.resolve("audit.jsonl");
    try (Terminal.Running server =
        Service.startServer(
            folder, port, "--allow-user-code=unconfined", "--audit", audit.toString())) {
      Terminal terminal = new Terminal(folder);
      String url = Service.url(port);
      Terminal.Ended thrown =
          terminal.mech("simulate", "m.xml", "--server", url, "--user-code", ".");
      assertThat(thrown.exitStatus()).as(thrown.toString()).isEqualTo(1);
      assertThat(thrown.stdout() + thrown.stderr()).doesNotContain("\u001b");
      terminal
          .mech("simulate", WorkingTree.PENDULUM.toString(), "--server", url, "--out", "r.csv")
          .orFail();
      server.awaitThat("the end of the other run", () -> read(audit).contains("sim-done"));
    }
    assertThat(Files.readAllLines(audit))
        .allSatisfy(line -> assertThat(JsonParser.parseString(line).isJsonObject()).isTrue())
        .anyMatch(line -> line.contains("sim-failed") && line.contains("\ufffd"));
    assertThat(PosixFilePermissions.toString(Files.getPosixFilePermissions(audit)))
        .isEqualTo("rw-------");
  }

  /**
   * One client that opens all the sessions it can and keeps them: another one still gets in, the
   * operator sees who it is, and ends it.
   */
  @Test
  void clientThatTakesAllSessionsLeavesSomeAndIsEndedByTheOperator() throws Exception {
    int port = Service.freePort();
    String url = Service.url(port);
    Terminal terminal = new Terminal(folder);
    try (Terminal.Running server = Service.startServer(folder, port);
        ServiceOrb orb = ServiceOrb.client()) {
      assertThat(server.stdout()).contains(url);
      int opened = 0;
      Optional<LimitExceeded> refusal = Optional.empty();
      while (refusal.isEmpty() && opened < 1000) {
        try {
          orb.connect(url).createSession("mallory", "", null).sessionId();
          opened++;
        } catch (LimitExceeded e) {
          refusal = Optional.of(e);
        }
      }
      assertThat(opened).isEqualTo(48);
      assertThat(refusal.orElseThrow().limitName).isEqualTo("clientSessions");
      terminal
          .mech("simulate", WorkingTree.PENDULUM.toString(), "--server", url, "--quiet")
          .orFail();

      String listed = terminal.mech("admin", "--server", url, "sessions").orFail().stdout();
      assertThat(listed.lines().filter(line -> line.contains("mallory"))).hasSize(48);
      terminal
          .mech("admin", "--server", url, "end", "--user", "mallory", "--reason", "all of them")
          .orFail();
      assertThat(terminal.mech("admin", "--server", url, "sessions").orFail().stdout())
          .doesNotContain("mallory");
      Terminal.Ended nobody = terminal.mech("admin", "--server", url, "end", "--user", "mallory");
      assertThat(nobody.exitStatus()).as(nobody.toString()).isNotZero();
      assertThat(nobody.stderr()).contains("S-130");
    }
  }

  /** A host that has more to tell than a message may have would be silent for everybody. */
  @Test
  void nameOfAnyLengthSilencesNoHost() throws Exception {
    int port = Service.freePort();
    String url = Service.url(port);
    Terminal terminal = new Terminal(folder);
    try (Terminal.Running server = Service.startServer(folder, port, "--capacity", "0");
        Terminal.Running host = Service.startHost(folder, port, "a");
        ServiceOrb orb = ServiceOrb.client()) {
      assertThat(server.stdout() + host.stdout()).isNotEmpty();
      for (int i = 0; i < 10; i++) {
        String name = i + "\n\u001b]0;x\u0007" + "x".repeat(5_000_000);
        assertThat(orb.connect(url).createSession(name, "", null).sessionId()).isNotEmpty();
      }
      terminal
          .mech("simulate", WorkingTree.PENDULUM.toString(), "--server", url, "--quiet")
          .orFail();
      String listed = terminal.mech("admin", "--server", url, "sessions").orFail().stdout();
      assertThat(listed.lines().filter(line -> line.contains("??]0;x?xxx"))).hasSize(10);
      assertThat(terminal.mech("admin", "--server", url, "hosts").orFail().stdout())
          .doesNotContain("no answer");
    }
  }

  /** Bodies in a chain of free joints, each also tied to the ground: as many loops as bodies. */
  static String loops(int count) {
    StringBuilder bodies = new StringBuilder();
    StringBuilder joints = new StringBuilder();
    for (int i = 0; i < count; i++) {
      String before = i == 0 ? "Ground" : "b" + (i - 1);
      bodies.append("<body name=\"b%d\"><sphere radius=\"0.1\" mass=\"1\"/></body>".formatted(i));
      joints.append(
          ("<joint name=\"k%1$d\" type=\"F\" body1=\"%2$s\" body2=\"b%1$d\"/>"
                  + "<joint name=\"l%1$d\" type=\"S\" body1=\"Ground\" body2=\"b%1$d\"/>")
              .formatted(i, before));
    }
    return "<MechML><MBSsimulation><dynamic><timeSet tini=\"0\" tend=\"1\" tstep=\"0.1\"/>"
        + "</dynamic></MBSsimulation><MBSmodel name=\"big\" massUnits=\"kg\" lengthUnits=\"m\""
        + " silence=\"no-gravity\"><Bodies><body name=\"Ground\"/>"
        + bodies
        + "</Bodies><Joints>"
        + joints
        + "</Joints><topology><root name=\"Ground\"/></topology></MBSmodel></MechML>";
  }

  /**
   * A text of 0.7 MB whose set-up takes minutes and gigabytes; the operator gives it 20 s, in which
   * a pendulum is set up on a busy machine, too.
   */
  @Test
  void setUpWithoutEndIsRefusedByNameAndOthersGoOn() throws Exception {
    Files.writeString(folder.resolve("loops.xml"), loops(4000));
    int port = Service.freePort();
    String url = Service.url(port);
    Terminal terminal = new Terminal(folder);
    // so much memory that the time is over first, also on a fast machine
    String[] limits = {"--limit", "setUpTime=20", "--limit", "setUpMemory=8589934592"};
    try (Terminal.Running server = Service.startServer(folder, port, limits);
        Terminal.Running bomb = terminal.startMech("check", "loops.xml", "--server", url)) {
      assertThat(server.stdout()).contains(url);
      terminal
          .mech("simulate", WorkingTree.PENDULUM.toString(), "--server", url, "--quiet")
          .orFail();
      Terminal.Ended ended = bomb.awaitEnd();
      assertThat(ended.exitStatus()).as(ended.toString()).isNotZero();
      assertThat(ended.stderr()).contains("S-230", "within the 20 s");
      terminal
          .mech("simulate", WorkingTree.PENDULUM.toString(), "--server", url, "--quiet")
          .orFail();
    }
  }

  /** With the limits of the product: eight of them at once, and the other client is served. */
  @Test
  void eightTextsThatAreDearToBuildHurtNobodyElse() throws Exception {
    Files.writeString(folder.resolve("loops.xml"), loops(4000));
    int port = Service.freePort();
    String url = Service.url(port);
    Terminal terminal = new Terminal(folder);
    String[] pendulum = {
      "simulate", WorkingTree.PENDULUM.toString(), "--server", url, "--out", "r.csv", "--quiet"
    };
    try (Terminal.Running server = Service.startServer(folder, port)) {
      assertThat(server.stdout()).contains(url);
      terminal.mech(pendulum).orFail();
      byte[] right = Files.readAllBytes(folder.resolve("r.csv"));
      List<Terminal.Running> bombs = new ArrayList<>();
      try {
        for (int i = 0; i < 8; i++) {
          bombs.add(
              terminal.start(
                  "env",
                  "JDK_JAVA_OPTIONS=-Duser.name=mallory",
                  WorkingTree.MECH.toString(),
                  "check",
                  "loops.xml",
                  "--server",
                  url));
        }
        for (int i = 0; i < 3; i++) {
          terminal.mech(pendulum).orFail();
          assertThat(Files.readAllBytes(folder.resolve("r.csv"))).isEqualTo(right);
        }
        Terminal.Ended first = bombs.get(0).awaitEnd();
        assertThat(first.exitStatus()).as(first.toString()).isNotZero();
        assertThat(first.stderr()).containsAnyOf("S-110", "S-230");
      } finally {
        bombs.forEach(Terminal.Running::close);
      }
      terminal.mech(pendulum).orFail();
    }
  }

  /** A client that goes away in the middle of a build that would take minutes. */
  @Test
  void buildEndsWithItsClient() throws Exception {
    Files.writeString(folder.resolve("loops.xml"), loops(4000));
    int port = Service.freePort();
    String url = Service.url(port);
    Terminal terminal = new Terminal(folder);
    try (Terminal.Running server = Service.startServer(folder, port)) {
      try (Terminal.Running bomb = terminal.startMech("check", "loops.xml", "--server", url)) {
        server.awaitThat("the process that builds", () -> busiestSeconds(port) > 3);
        bomb.terminate();
        bomb.awaitEnd();
      }
      server.awaitThat("its end", () -> busiestSeconds(port) <= 3);
    }
  }

  /** Returns the processor time of the child of a server that has most of it, s. */
  private static long busiestSeconds(int port) {
    return ProcessHandle.current()
        .descendants()
        .filter(p -> p.info().commandLine().orElse("").contains("server --port " + port))
        .flatMap(ProcessHandle::descendants)
        .filter(ProcessHandle::isAlive)
        .mapToLong(p -> p.info().totalCpuDuration().orElse(Duration.ZERO).toSeconds())
        .max()
        .orElse(0);
  }

  /** With what is free on a disk far below what the operator wants to stay free. */
  @Test
  void fullDiskIsToldAsSuch() throws Exception {
    int port = Service.freePort();
    String url = Service.url(port);
    Terminal terminal = new Terminal(folder);
    String[] asked = {
      "simulate",
      WorkingTree.PENDULUM.toString(),
      "--server",
      url,
      "--t-end",
      "100",
      "--t-step",
      "1e-3",
      "--out",
      "r.csv"
    };
    try (Terminal.Running server =
        Service.startServer(
            folder, port, "--spool", "spool", "--limit", "freeDisk=100000000000000000")) {
      assertThat(server.stdout()).contains(url);
      Terminal.Ended refused = terminal.mech(asked);
      assertThat(refused.exitStatus()).as(refused.toString()).isNotZero();
      assertThat(refused.stderr()).contains("S-174").doesNotContain("t-step", "\tat ");
    }
  }

  /** A server of a source build finds the wall that the machine has, and says which. */
  @Test
  void serverConfinesClassesOfUsersOrRunsNone() throws Exception {
    Files.writeString(folder.resolve("m.xml"), DraggedBob.MODEL);
    DraggedBob.writeSource(folder, "", "", "");
    Path fake = Files.createDirectories(folder.resolve("bin")).resolve("bwrap");
    Files.writeString(fake, "#!/bin/sh\nexit 1\n");
    Files.setPosixFilePermissions(fake, PosixFilePermissions.fromString("rwxr-xr-x"));
    Terminal terminal = new Terminal(folder);
    for (String consent : List.of("confined", "unconfined")) {
      for (boolean wall : new boolean[] {true, false}) {
        int port = Service.freePort();
        String url = Service.url(port);
        String start =
            (wall ? "" : "PATH=\"$PWD/bin:$PATH\" ")
                + "exec "
                + WorkingTree.MECH
                + " server --port "
                + port
                + " --allow-user-code="
                + consent;
        try (Terminal.Running server = terminal.start("sh", "-c", start)) {
          server.awaitThat("its URL", () -> server.stdout().contains(url));
          Terminal.Ended run =
              terminal.mech(
                  "simulate", "m.xml", "--server", url, "--user-code", ".", "--out", "r.csv");
          if (wall && ForeignCodeIT.confines()) {
            assertThat(run.exitStatus()).as(run.toString()).isZero();
            assertThat(run.stdout() + run.stderr()).doesNotContain("S-175");
          } else if (consent.equals("unconfined")) {
            assertThat(run.exitStatus()).as(run.toString()).isZero();
            assertThat(run.stdout() + run.stderr()).contains("S-175");
          } else {
            assertThat(run.exitStatus()).as(run.toString()).isNotZero();
            assertThat(run.stderr()).contains("S-168");
          }
        }
      }
    }
  }

  /** Three thousand parts, one in the other. */
  @Test
  void chainOfIncludedPartsIsRefusedByName() throws Exception {
    StringBuilder parts = new StringBuilder();
    for (int i = 0; i < 3001; i++) {
      parts.append(
          ("<included file=\"p%d\"><![CDATA[<subsystem massUnits=\"kg\" lengthUnits=\"m\">"
                  + "<include file=\"p%d\" prefix=\"x\"/></subsystem>]]></included>")
              .formatted(i, i + 1));
    }
    Files.writeString(
        folder.resolve("parts.xml"),
        "<MechML><MBSsimulation><dynamic><timeSet tini=\"0\" tend=\"1\" tstep=\"0.1\"/></dynamic>"
            + "</MBSsimulation><MBSmodel name=\"m\" massUnits=\"kg\" lengthUnits=\"m\""
            + " silence=\"no-gravity\"><include file=\"p0\" prefix=\"z\"/><Bodies><body"
            + " name=\"Ground\"/></Bodies><Joints/><topology><root name=\"Ground\"/></topology>"
            + "</MBSmodel>"
            + parts
            + "</MechML>");
    Terminal.Ended ended = new Terminal(folder).mech("check", "parts.xml");
    assertThat(ended.exitStatus()).as(ended.toString()).isEqualTo(2);
    assertThat(ended.stderr()).contains("M-004", "it may include 1000");
  }

  /** Two kilobytes of source that the compiler turns into a text of half a terabyte. */
  @Test
  void sourceThatSwellsIsRefusedByNameAndTheServerGoesOn() throws Exception {
    StringBuilder constants =
        new StringBuilder("static final String a0=\"" + "x".repeat(60) + "\";");
    for (int i = 1; i < 34; i++) {
      constants.append("static final String a%d=a%d+a%d;".formatted(i, i - 1, i - 1));
    }
    Files.writeString(folder.resolve("m.xml"), DraggedBob.MODEL);
    DraggedBob.writeSource(folder, constants.toString(), "", "int n=a33.length();");
    int port = Service.freePort();
    String url = Service.url(port);
    Terminal terminal = new Terminal(folder);
    try (Terminal.Running server =
        Service.startServer(folder, port, "--allow-user-code=unconfined")) {
      assertThat(server.stdout()).contains(url);
      Terminal.Ended ended =
          terminal.mech("simulate", "m.xml", "--server", url, "--user-code", ".");
      assertThat(ended.exitStatus()).as(ended.toString()).isEqualTo(2);
      assertThat(ended.stderr()).contains("S-123", "the compiler gives up", "MB of memory");
      terminal
          .mech("simulate", WorkingTree.PENDULUM.toString(), "--server", url, "--quiet")
          .orFail();
    }
  }

  private static String read(Path file) {
    try {
      return Files.readString(file);
    } catch (IOException e) {
      return "";
    }
  }
}
