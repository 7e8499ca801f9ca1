package org.mechservice.load;

import java.io.InputStream;
import java.io.OutputStream;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.concurrent.atomic.AtomicLong;
import org.mechservice.idl.IMechSimRemote;
import org.mechservice.idl.InvalidModel;
import org.mechservice.idl.MechServer;
import org.mechservice.idl.MechSim;
import org.mechservice.idl.ModelFile;
import org.mechservice.idl.NameValue;
import org.mechservice.idl.SimState;
import org.mechservice.orb.ServiceOrb;
import org.mechservice.orb.tls.TlsIdentity;

/**
 * A client that does to a server all at once what harms others: texts that are dear to build,
 * sources that are dear to compile, runs without end, classes that loop without end or fail with
 * long texts, all sessions, robots that are no robots, damaged messages. Ends with its standard
 * input.
 */
final class HostileNeighbour {
  private static final int BOMBS = 8;
  private static final int LOOPS = 4000;

  /** Time after which the client of such a text goes away. */
  private static final long BOMB_MILLIS = 20_000;

  /** Time that what takes all of her places leaves to her other attacks, which wait behind it. */
  private static final long LEFT_MILLIS = 30_000;

  private static final int SESSIONS = 60;

  /** As many as she may have without those of her other attacks. */
  private static final int RUNS = 56;

  private static final long PAUSE_MILLIS = 50;

  private static final NameValue[] ENDLESS = {
    new NameValue("t-end", "1e8"), new NameValue("t-step", "1e4")
  };

  private final String address;
  private final Path keys;
  private final AtomicLong attempts = new AtomicLong();

  /** Attacks of classes that went as far as they should: each one of these works. */
  private final AtomicLong swollen = new AtomicLong();

  private final AtomicLong ran = new AtomicLong();
  private final AtomicLong failed = new AtomicLong();
  private final AtomicLong hung = new AtomicLong();

  private HostileNeighbour(String address, Path keys) {
    this.address = address;
    this.keys = keys;
  }

  /**
   * Does everything that harms until it is killed.
   *
   * @param arguments address of the server, folder of the client's keys
   */
  @SuppressWarnings("SystemOut") // how the test learns how much it did
  public static void main(String[] arguments) throws Exception {
    HostileNeighbour eve = new HostileNeighbour(arguments[0], Path.of(arguments[1]));
    List<Attack> attacks = new ArrayList<>();
    for (int i = 0; i < BOMBS; i++) {
      attacks.add(eve::bomb);
    }
    attacks.add(eve::swellingSource);
    attacks.add(eve::endlessRuns);
    attacks.add(eve::endlessClass);
    attacks.add(eve::endlessFirstRow);
    attacks.add(eve::longFailures);
    attacks.add(eve::allSessions);
    attacks.add(eve::noRobot);
    attacks.add(eve::damagedMessages);
    for (Attack attack : attacks) {
      Thread thread = new Thread(() -> eve.goOn(attack));
      thread.setDaemon(true);
      thread.start();
    }
    System.in.read();
    System.out.printf("%s %s %s %s %s%n", eve.attempts, eve.swollen, eve.ran, eve.hung, eve.failed);
    Runtime.getRuntime().halt(0);
  }

  private interface Attack {
    void on(MechServer server) throws Exception;
  }

  private void goOn(Attack attack) {
    try (ServiceOrb orb = ServiceOrb.client(Optional.of(TlsIdentity.load(keys)))) {
      MechServer server = orb.connect(address);
      while (true) {
        attempts.incrementAndGet();
        try {
          attack.on(server);
        } catch (Exception refused) {
          // Refused, or lost with what it has destroyed: again.
        }
        Thread.sleep(PAUSE_MILLIS);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private void bomb(MechServer server) throws Exception {
    MechSim session = server.createSession("eve", "", null);
    Thread loader =
        new Thread(
            () -> {
              try {
                session.loadModel(new ModelFile("loops.xml", loops()), new ModelFile[0]);
              } catch (org.omg.CORBA.UserException | org.omg.CORBA.SystemException e) {
                // Refused, or ended with its session.
              }
            });
    loader.setDaemon(true);
    loader.start();
    loader.join(BOMB_MILLIS);
    session.destroy();
    Thread.sleep(LEFT_MILLIS); // for set-ups of the other attacks
  }

  private static byte[] loops() {
    StringBuilder bodies = new StringBuilder();
    StringBuilder joints = new StringBuilder();
    for (int i = 0; i < LOOPS; i++) {
      String before = i == 0 ? "Ground" : "b" + (i - 1);
      bodies.append("<body name=\"b%d\"><sphere radius=\"0.1\" mass=\"1\"/></body>".formatted(i));
      joints.append(
          ("<joint name=\"k%1$d\" type=\"F\" body1=\"%2$s\" body2=\"b%1$d\"/>"
                  + "<joint name=\"l%1$d\" type=\"S\" body1=\"Ground\" body2=\"b%1$d\"/>")
              .formatted(i, before));
    }
    return ("<MechML><MBSsimulation><dynamic><timeSet tini=\"0\" tend=\"1\" tstep=\"0.1\"/>"
            + "</dynamic></MBSsimulation><MBSmodel name=\"big\" massUnits=\"kg\""
            + " lengthUnits=\"m\" silence=\"no-gravity\"><Bodies><body name=\"Ground\"/>"
            + bodies
            + "</Bodies><Joints>"
            + joints
            + "</Joints><topology><root name=\"Ground\"/></topology></MBSmodel></MechML>")
        .getBytes(StandardCharsets.UTF_8);
  }

  private static final String DRAGGED =
      "<MechML><MBSsimulation><dynamic><timeSet tini=\"0\" tend=\"1e6\" tstep=\"1e3\"/>"
          + "</dynamic></MBSsimulation><MBSmodel name=\"m\" massUnits=\"kg\" lengthUnits=\"m\""
          + " silence=\"no-gravity\"><Bodies><body name=\"Ground\"/><body name=\"a\"><sphere"
          + " radius=\"0.1\" mass=\"1\"/></body></Bodies><Joints><joint name=\"j\" type=\"P\""
          + " body1=\"Ground\" body2=\"a\" axis=\"1;0;0\"/></Joints><Forces><force name=\"f\""
          + " fileName=\"Drag.class\"/></Forces><topology><root"
          + " name=\"Ground\"/></topology></MBSmodel></MechML>";

  private static ModelFile source(String members, String body) {
    return new ModelFile(
        "Drag.java",
        ("import org.mechservice.solver.api.*; public final class Drag implements UserForce {"
                + members
                + " public void declare(ForceDeclaration d) {} public void apply(ForceState s,"
                + " ForceLoads l) {"
                + body
                + "} }")
            .getBytes(StandardCharsets.UTF_8));
  }

  private void swellingSource(MechServer server) throws Exception {
    StringBuilder constants =
        new StringBuilder("static final String a0=\"" + "x".repeat(60) + "\";");
    for (int i = 1; i < 34; i++) {
      constants.append("static final String a%d=a%d+a%d;".formatted(i, i - 1, i - 1));
    }
    try {
      dragged(server, source(constants.toString(), "int n=a33.length();"), session -> {});
    } catch (InvalidModel e) {
      if (e.diagnostics[0].code.equals("S-123")) {
        swollen.incrementAndGet();
      }
    }
  }

  private void endlessClass(MechServer server) throws Exception {
    dragged(
        server,
        source("", "while (s.time() < 1e9) {}"),
        session -> {
          IMechSimRemote run = session.createSimulation(ENDLESS, null);
          run.start();
          for (int i = 0; i < 10; ) {
            Thread.sleep(1000);
            if (run.getProgress().state == SimState.SIM_RUNNING) { // it may wait for a place before
              ran.incrementAndGet();
              i++;
            }
          }
        });
  }

  /** The host wants to know the columns of its values; the client goes meanwhile. */
  private void endlessFirstRow(MechServer server) throws Exception {
    NameValue[] forces = {new NameValue("columns", "joints,forces")};
    dragged(
        server,
        source("", "while (s.time() < 1e9) {}"),
        session -> {
          Thread caller =
              new Thread(
                  () -> {
                    try {
                      session.createSimulation(forces, null);
                    } catch (org.omg.CORBA.UserException | org.omg.CORBA.SystemException e) {
                      hung.incrementAndGet(); // until the session has ended
                    }
                  });
          caller.setDaemon(true);
          caller.start();
          Thread.sleep(10_000);
        });
  }

  /** Runs that say as much as they may when they fail. */
  private void longFailures(MechServer server) throws Exception {
    dragged(
        server,
        source("", "throw new IllegalStateException(\"\\ud800 long \".repeat(100_000));"),
        session -> {
          for (int i = 0; i < 50; i++) {
            IMechSimRemote run = session.createSimulation(ENDLESS, null);
            run.start();
            while (run.getProgress().state.value() < SimState._SIM_DONE) {
              Thread.sleep(10);
            }
            failed.incrementAndGet();
          }
        });
  }

  private interface Use {
    void of(MechSim session) throws Exception;
  }

  private static void dragged(MechServer server, ModelFile source, Use use) throws Exception {
    MechSim session = server.createSession("eve", "", null);
    try {
      session.loadModel(
          new ModelFile("m.xml", DRAGGED.getBytes(StandardCharsets.UTF_8)),
          new ModelFile[] {source});
      use.of(session);
    } finally {
      session.destroy();
    }
  }

  private void endlessRuns(MechServer server) throws Exception {
    MechSim session = server.createSession("eve", "", null);
    try {
      byte[] model = Files.readAllBytes(Runs.PENDULUM);
      session.loadModel(new ModelFile("pendulum.xml", model), new ModelFile[0]);
      for (int i = 0; i < RUNS; i++) {
        session.createSimulation(ENDLESS, null).start();
        session.renewLease();
      }
      for (int i = 0; i < 30; i++) {
        Thread.sleep(1000);
        session.renewLease();
      }
    } finally {
      session.destroy();
    }
    Thread.sleep(LEFT_MILLIS); // for runs of the other attacks
  }

  private void allSessions(MechServer server) throws Exception {
    List<MechSim> held = new ArrayList<>();
    try {
      for (int i = 0; i < SESSIONS; i++) {
        held.add(server.createSession("eve", "", null));
      }
    } finally {
      Thread.sleep(2000);
      held.forEach(MechSim::destroy);
    }
  }

  private void noRobot(MechServer server) throws Exception {
    String links = "<link name='x'/>".repeat(50_000);
    server.importModel(
        new ModelFile(
            "r.urdf", ("<robot name='r'>" + links + "</robot>").getBytes(StandardCharsets.UTF_8)),
        new org.mechservice.idl.DiagnosticSeqHolder());
  }

  private void damagedMessages(MechServer server) throws Exception {
    Random random = new Random();
    int port = Integer.parseInt(address.replaceAll(".*:(\\d+)(/.*)?$", "$1"));
    byte[] bytes = new byte[200];
    try (Socket socket =
        new TlsKeys(keys.resolveSibling("."))
            .context(keys.getFileName().toString(), true)
            .getSocketFactory()
            .createSocket("127.0.0.1", port)) {
      socket.setSoTimeout(1000);
      OutputStream out = socket.getOutputStream();
      InputStream in = socket.getInputStream();
      for (int i = 0; i < 20; i++) {
        random.nextBytes(bytes);
        System.arraycopy(new byte[] {'G', 'I', 'O', 'P', 1, 2, 0, 0}, 0, bytes, 0, 8);
        out.write(bytes);
        out.flush();
        if (in.read(bytes) < 0) {
          return;
        }
      }
    }
  }
}
