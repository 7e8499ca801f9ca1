package org.mechservice.load;

import static org.assertj.core.api.Assertions.assertThat;

import com.google.gson.JsonObject;
import com.google.gson.JsonParser;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.idl.HostRegistryOperations;
import org.mechservice.idl.IMechSimRemote;
import org.mechservice.idl.IMechSimRemoteHelper;
import org.mechservice.idl.IMechSimRemoteOperations;
import org.mechservice.idl.MechAdminOperations;
import org.mechservice.idl.MechServer;
import org.mechservice.idl.MechSim;
import org.mechservice.idl.MechSimHelper;
import org.mechservice.idl.MechSimOperations;
import org.mechservice.idl.ModelFile;
import org.mechservice.idl.NameValue;
import org.mechservice.idl.ResultCursor;
import org.mechservice.idl.ResultCursorHelper;
import org.mechservice.idl.ResultCursorOperations;
import org.mechservice.idl.SimState;
import org.mechservice.orb.ServiceOrb;
import org.mechservice.orb.testing.AnyOperation;
import org.mechservice.orb.testing.Eventually;

/**
 * Two users of a server over TLS, each with all references and ids of the other, try every
 * operation on what belongs to the other, and everything that only administrators and hosts may do.
 */
@Tag("soak")
class TwoUsersTest {
  private static final List<String> USERS = List.of("ann", "eve");
  private static final List<String> HOSTS = List.of("near", "far");
  private static final Pattern REFUSED = Pattern.compile(" was refused (\\w+)\\(");

  /** Goes on for as long as the test needs. */
  private static final NameValue[] ENDLESS = {
    new NameValue("t-end", "1e8"), new NameValue("t-step", "1e4")
  };

  @TempDir Path folder;

  /** What a user has on a host. */
  private record Owned(
      String owner, String host, MechSim session, IMechSimRemote run, ResultCursor rows) {}

  private int calls;

  @Test
  void everyOperationOnAnothersObjectsIsRefusedAndWrittenDown() throws Exception {
    TlsKeys keys = TlsKeys.make(folder.resolve("keys"), "ann", "eve");
    Path audit = folder.resolve("audit.jsonl");
    List<String> lines = new ArrayList<>();
    try (ServiceJvm server =
            ServiceJvm.start(
                List.of(),
                256,
                "server",
                "--name",
                "near",
                "--listen",
                "127.0.0.1:0",
                "--capacity",
                "2",
                "--audit",
                audit.toString(),
                "--tls",
                keys.of("server"));
        ServiceJvm host =
            ServiceJvm.host(
                server.address(), "far", "--capacity", "2", "--tls", keys.of("server"));
        ServiceOrb ann = ServiceOrb.client(keys.identity("ann"));
        ServiceOrb eve = ServiceOrb.client(keys.identity("eve"))) {
      List<Owned> ofAnn = own("ann", ann, server.address());
      List<Owned> ofEve = own("eve", eve, server.address());
      lines.addAll(tryAll("eve", eve, server.address(), ann, ofAnn));
      lines.addAll(tryAll("ann", ann, server.address(), eve, ofEve));
      for (Owned owned : join(ofAnn, ofEve)) {
        assertThat(owned.run().getProgress().state).isEqualTo(SimState.SIM_RUNNING);
        assertThat(owned.rows().channels()).isNotEmpty();
        owned.session().destroy();
      }
      assertThat(host.alive()).isTrue();
      Set<String> tried = new TreeSet<>();
      for (String user : USERS) {
        operations().forEach(operation -> tried.add(user + " " + operation));
      }
      Eventually.holds(() -> writtenDown(audit).containsAll(tried));
    }
    write(lines);
  }

  private static List<Owned> join(List<Owned> first, List<Owned> second) {
    List<Owned> all = new ArrayList<>(first);
    all.addAll(second);
    return all;
  }

  private static List<Owned> own(String user, ServiceOrb orb, String address) throws Exception {
    List<Owned> all = new ArrayList<>();
    for (String host : HOSTS) {
      MechSim session = orb.connect(address).createSession(user, host, null);
      byte[] model = Files.readAllBytes(Runs.PENDULUM);
      session.loadModel(new ModelFile("pendulum.xml", model), new ModelFile[0]);
      IMechSimRemote run = session.createSimulation(ENDLESS, null);
      run.start();
      Eventually.holds(() -> run.getProgress().state == SimState.SIM_RUNNING);
      all.add(new Owned(user, host, session, run, run.openResults(new String[0])));
    }
    return all;
  }

  private static Set<String> operations() {
    Set<String> all = new TreeSet<>(Set.of("findSession", "findSimulation"));
    for (Class<?> operations :
        List.of(
            MechSimOperations.class,
            IMechSimRemoteOperations.class,
            ResultCursorOperations.class,
            MechAdminOperations.class,
            HostRegistryOperations.class)) {
      Arrays.stream(operations.getMethods()).map(Method::getName).forEach(all::add);
    }
    return all;
  }

  /** Returns a line of the page for each kind of object. */
  private List<String> tryAll(
      String user, ServiceOrb orb, String address, ServiceOrb other, List<Owned> owned)
      throws Exception {
    List<String> lines = new ArrayList<>();
    MechServer server = orb.connect(address);
    for (Owned of : owned) {
      String whose = of.owner() + " on " + of.host();
      MechSim session = MechSimHelper.unchecked_narrow(handed(orb, other, of.session()));
      IMechSimRemote run = IMechSimRemoteHelper.unchecked_narrow(handed(orb, other, of.run()));
      ResultCursor rows = ResultCursorHelper.unchecked_narrow(handed(orb, other, of.rows()));
      lines.add(line(user, "session of " + whose, refusals(MechSimOperations.class, session)));
      lines.add(
          line(user, "simulation of " + whose, refusals(IMechSimRemoteOperations.class, run)));
      lines.add(line(user, "cursor of " + whose, refusals(ResultCursorOperations.class, rows)));
      String sessionId = of.session().sessionId();
      String simId = of.run().simId();
      int found =
          refused("findSession", () -> server.findSession(sessionId))
              + refused("findSimulation", () -> server.findSimulation(simId));
      lines.add(line(user, "ids of " + whose, found));
    }
    lines.add(
        line(
            user,
            "administration",
            refusals(MechAdminOperations.class, orb.connectAdmin(address))));
    lines.add(
        line(
            user,
            "registry of hosts",
            refusals(HostRegistryOperations.class, orb.connectRegistry(address))));
    return lines;
  }

  private static org.omg.CORBA.Object handed(
      ServiceOrb to, ServiceOrb from, org.omg.CORBA.Object object) {
    return to.fromIor(from.toIor(object));
  }

  private static String line(String user, String what, int refused) {
    return "| " + user + " | " + what + " | " + refused + " | " + refused + " |";
  }

  private interface Call {
    void run() throws Exception;
  }

  /** Returns 1, the number of refusals. */
  private int refused(String name, Call call) {
    calls++;
    Throwable thrown = null;
    try {
      call.run();
    } catch (InvocationTargetException e) {
      thrown = e.getCause();
    } catch (Exception e) {
      thrown = e;
    }
    assertThat(AnyOperation.isRefusal(thrown)).as(name + ": " + thrown).isTrue();
    return 1;
  }

  private int refusals(Class<?> operations, Object object) {
    int count = 0;
    for (Method operation : operations.getMethods()) {
      Object[] arguments = AnyOperation.arguments(operation);
      count += refused(operation.getName(), () -> operation.invoke(object, arguments));
    }
    return count;
  }

  /** Returns who was refused what, as the audit file has it. */
  private static Set<String> writtenDown(Path audit) throws Exception {
    Set<String> all = new TreeSet<>();
    for (String line : Files.readAllLines(audit)) {
      JsonObject event = JsonParser.parseString(line).getAsJsonObject();
      Matcher what = REFUSED.matcher(event.get("text").getAsString());
      if (event.get("kind").getAsString().equals("denied") && what.find()) {
        assertThat(event.get("code").getAsString()).isIn("S-153", "S-167");
        all.add(event.get("owner").getAsString() + " " + what.group(1));
      }
    }
    return all;
  }

  private void write(List<String> lines) throws Exception {
    SoakPage page =
        new SoakPage(
            "Two users over TLS",
            "A server and a host, each a process of its own, over TLS. Ann and Eve have a session,"
                + " a running simulation and a cursor on both, and hold all references and ids of"
                + " each other. Each calls every operation of the interfaces on what belongs to the"
                + " other, and every operation of the administration and of the registry of hosts."
                + " Each call was refused, the other's simulations went on, and the server's"
                + " `--audit` file names user and operation of each (the same question to several"
                + " objects of one process within a minute is one entry).",
            0);
    page.line("| user | tries | calls | refused |").line("|---|---|---|---|");
    lines.forEach(line -> page.line("%s", line));
    page.line(
        "%n%d calls of %d operations: all refused, all written down.", calls, operations().size());
    page.write("service-two-users.md");
  }
}
