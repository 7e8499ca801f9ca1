package org.mechservice.client;

import java.nio.charset.StandardCharsets;
import java.security.KeyPair;
import java.util.List;
import java.util.Properties;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.atomic.AtomicInteger;
import org.mechservice.idl.Channel;
import org.mechservice.idl.Diagnostic;
import org.mechservice.idl.IMechClient;
import org.mechservice.idl.IMechSimRemote;
import org.mechservice.idl.IMechSimRemoteHelper;
import org.mechservice.idl.IMechSimRemoteOperations;
import org.mechservice.idl.IMechSimRemotePOATie;
import org.mechservice.idl.InvalidModel;
import org.mechservice.idl.JarInfo;
import org.mechservice.idl.JarInfoHolder;
import org.mechservice.idl.MechServer;
import org.mechservice.idl.MechServerHelper;
import org.mechservice.idl.MechServerOperations;
import org.mechservice.idl.MechServerPOATie;
import org.mechservice.idl.MechSim;
import org.mechservice.idl.MechSimHelper;
import org.mechservice.idl.MechSimOperations;
import org.mechservice.idl.MechSimPOATie;
import org.mechservice.idl.ModelFile;
import org.mechservice.idl.ModelInfo;
import org.mechservice.idl.NameValue;
import org.mechservice.idl.NameValueSeqHolder;
import org.mechservice.idl.NotFound;
import org.mechservice.idl.Progress;
import org.mechservice.idl.ResultBlock;
import org.mechservice.idl.ResultBlockHolder;
import org.mechservice.idl.ResultCursor;
import org.mechservice.idl.ResultCursorHelper;
import org.mechservice.idl.ResultCursorOperations;
import org.mechservice.idl.ResultCursorPOATie;
import org.mechservice.idl.RunSetUp;
import org.mechservice.idl.RuntimeInfo;
import org.mechservice.idl.ServerInfo;
import org.mechservice.idl.Severity;
import org.mechservice.idl.SimState;
import org.mechservice.solver.text.Sha256;
import org.omg.BiDirPolicy.BIDIRECTIONAL_POLICY_TYPE;
import org.omg.BiDirPolicy.BOTH;
import org.omg.BiDirPolicy.BidirectionalPolicyValueHelper;
import org.omg.CORBA.Any;
import org.omg.CORBA.NO_MEMORY;
import org.omg.CORBA.ORB;
import org.omg.CORBA.Policy;
import org.omg.CORBA.UserException;
import org.omg.PortableServer.IdAssignmentPolicyValue;
import org.omg.PortableServer.LifespanPolicyValue;
import org.omg.PortableServer.POA;
import org.omg.PortableServer.POAHelper;
import org.omg.PortableServer.Servant;

/**
 * A MechServer over real CORBA whose answers are written down: a run of {@value #ROWS} rows of two
 * columns, {@code t} and {@code j.q} = t². It speaks the contract and computes nothing.
 */
@SuppressWarnings({"UnusedMethod", "UnusedVariable"}) // operations are called by name
final class ScriptedServer implements AutoCloseable {
  static final int ROWS = 25;
  static final int LEASE_SECONDS = 1;

  final List<String> happened = new CopyOnWriteArrayList<>();
  final AtomicInteger runtimeFetches = new AtomicInteger();
  final AtomicInteger blocksSent = new AtomicInteger();
  volatile String failureCode = "N-001";

  /** What the script may be told to do differently. */
  volatile String apiVersion = "1.1";

  volatile SimState endsAs = SimState.SIM_DONE;
  volatile TestJars jars = TestJars.make();
  volatile boolean sendsWrongRuntime;
  volatile String modelClass = TestJars.MODEL_CLASS;
  volatile String fingerprint = "another";
  final KeyPair key = TestJars.newKey();

  private final ORB orb;
  private final POA poa;
  private final String address;
  private final int diesAtRow;
  private final AtomicInteger objects = new AtomicInteger();

  ScriptedServer() {
    this(Integer.MAX_VALUE);
  }

  private ScriptedServer(int diesAtRow) {
    this.diesAtRow = diesAtRow;
    try {
      Properties settings = new Properties();
      settings.setProperty("OAIAddr", "127.0.0.1");
      settings.setProperty("jacorb.implname", "Scripted");
      settings.setProperty("jacorb.orb.objectKeyMap.MechServer", "Scripted/Answers/MechServer");
      settings.setProperty(
          "org.omg.PortableInterceptor.ORBInitializerClass.bidir_init",
          "org.jacorb.orb.giop.BiDirConnectionInitializer");
      settings.setProperty("jacorb.iiop.enable_loopback", "off");
      settings.setProperty("jacorb.log.default.verbosity", "0");
      orb = ORB.init(new String[0], settings);
      POA root = POAHelper.narrow(orb.resolve_initial_references("RootPOA"));
      Any both = orb.create_any();
      BidirectionalPolicyValueHelper.insert(both, BOTH.value);
      poa =
          root.create_POA(
              "Answers",
              root.the_POAManager(),
              new Policy[] {
                root.create_lifespan_policy(LifespanPolicyValue.PERSISTENT),
                root.create_id_assignment_policy(IdAssignmentPolicyValue.USER_ID),
                orb.create_policy(BIDIRECTIONAL_POLICY_TYPE.value, both)
              });
      root.the_POAManager().activate();
      MechServer server =
          MechServerHelper.narrow(
              serve(
                  "MechServer",
                  new MechServerPOATie(Script.play(MechServerOperations.class, new Server()))));
      address = addressOf(server);
    } catch (UserException e) {
      throw new IllegalStateException(e);
    }
  }

  private static String addressOf(org.omg.CORBA.Object object) {
    var delegate =
        (org.jacorb.orb.Delegate) ((org.omg.CORBA.portable.ObjectImpl) object)._get_delegate();
    var profile = (org.jacorb.orb.iiop.IIOPProfile) delegate.getParsedIOR().getEffectiveProfile();
    return "127.0.0.1:" + ((org.jacorb.orb.iiop.IIOPAddress) profile.getAddress()).getPort();
  }

  private org.omg.CORBA.Object serve(String id, Servant servant) throws UserException {
    poa.activate_object_with_id(id.getBytes(StandardCharsets.US_ASCII), servant);
    return poa.id_to_reference(id.getBytes(StandardCharsets.US_ASCII));
  }

  private void forget(String id) {
    try {
      poa.deactivate_object(id.getBytes(StandardCharsets.US_ASCII));
    } catch (UserException e) {
      throw new IllegalStateException(e);
    }
  }

  String address() {
    return address;
  }

  /** Serves in a process of its own, prints its address, and halts when row 10 is asked for. */
  @SuppressWarnings("SystemOut") // how the test learns the address
  public static void main(String[] arguments) {
    ScriptedServer server = new ScriptedServer(10);
    System.out.println(server.address());
    server.orb.run();
  }

  @Override
  public void close() {
    orb.shutdown(false);
    orb.destroy();
  }

  /** Files of classes that models need, asked for one after the other. */
  volatile List<String> missing = List.of();

  private final class Server {
    ServerInfo getInfo() {
      return new ServerInfo("scripted", apiVersion, "0.0", 0, new String[0]);
    }

    IMechSimRemote findSimulation(String simId) throws UserException {
      happened.add("findSimulation " + simId);
      throw new NotFound("S-011", "there is no simulation " + simId);
    }

    MechSim createSession(String clientName, String hostName, IMechClient client)
        throws UserException {
      happened.add("createSession " + hostName);
      return MechSimHelper.narrow(
          serve("session", new MechSimPOATie(Script.play(MechSimOperations.class, new Session()))));
    }
  }

  private final class Session {
    String sessionId() {
      return "session";
    }

    String hostName() {
      return "here";
    }

    int renewLease() {
      happened.add("renew session");
      return LEASE_SECONDS;
    }

    void destroy() {
      happened.add("destroy session");
      forget("session");
    }

    Diagnostic[] loadModel(ModelFile model, ModelFile[] userFiles) throws InvalidModel {
      Diagnostic said =
          new Diagnostic(
              Severity.SEV_ERROR, "M-014", "no such joint", model.fileName, "MechML", 3, 5);
      if (new String(model.content, StandardCharsets.UTF_8).contains("bad")) {
        throw new InvalidModel("M-014", "1 error", new Diagnostic[] {said});
      }
      for (ModelFile file : userFiles) {
        happened.add("user file " + file.fileName);
      }
      if (userFiles.length < missing.size()) {
        said.code = "S-121";
        said.fileName = missing.get(userFiles.length);
        throw new InvalidModel("S-016", "1 error", new Diagnostic[] {said});
      }
      said.level = Severity.SEV_WARNING;
      return new Diagnostic[] {said};
    }

    ModelInfo getModelInfo() {
      return new ModelInfo(
          "square", "abc", new NameValue[0], "DTR", "a tree", new Channel[0], new Diagnostic[0]);
    }

    /** As the ORB says of an answer that no message holds. */
    @SuppressWarnings("DoNotCallSuggester") // the dispatch calls it by its name
    String checkReport(boolean asJson) {
      throw new NO_MEMORY();
    }

    String checkReportWith(NameValue[] options, boolean asJson) {
      for (NameValue option : options) {
        happened.add(option.key + "=" + option.text);
      }
      return switch (options[0].text) {
        case "0" -> "{\"a\"";
        case "1" -> ":1}";
        default -> "";
      };
    }

    NameValue[] timings() {
      return new NameValue[] {
        new NameValue("t1s", "0.001"), new NameValue("t2s", "0"), new NameValue("tcc", "0")
      };
    }

    IMechSimRemote createSimulation(NameValue[] options, IMechClient client) throws UserException {
      for (NameValue option : options) {
        happened.add(option.key + "=" + option.text);
      }
      return new Run(client).reference();
    }

    byte[] compileToJar(NameValue[] options, JarInfoHolder info) {
      info.value =
          new JarInfo(
              "square.jar",
              modelClass,
              Sha256.of(jars.model()),
              jars.model().length,
              1,
              new byte[0],
              Sha256.of(jars.runtime()),
              new NameValue[] {new NameValue("Mech-Solver-Fingerprint", fingerprint)});
      return jars.model();
    }

    RunSetUp prepareSimulation(NameValue[] options, IMechClient client) throws UserException {
      happened.add("in one call");
      return new RunSetUp(
          createSimulation(options, client),
          new Cursor().reference(),
          new Cursor().channels(),
          facts());
    }

    private NameValue[] facts() {
      return new NameValue[] {
        new NameValue("hostName", "here"),
        new NameValue("modelSha256", "abc"),
        new NameValue("formulationReason", "a tree"),
        new NameValue("t1s", "0.001"),
        new NameValue("t2s", "0"),
        new NameValue("tcc", "0")
      };
    }

    byte[] prepareJar(NameValue[] options, JarInfoHolder info, NameValueSeqHolder facts) {
      happened.add("in one call");
      facts.value = facts();
      return compileToJar(options, info);
    }

    RuntimeInfo getRuntimeInfo() {
      return new RuntimeInfo(
          Sha256.of(jars.runtime()),
          jars.runtime().length,
          TestJars.signed(key, jars.runtime()),
          "another");
    }

    byte[] fetchRuntime(String sha256) {
      runtimeFetches.incrementAndGet();
      return sendsWrongRuntime ? jars.model() : jars.runtime();
    }
  }

  private final class Run {
    private final String id = "run" + objects.incrementAndGet();
    private final IMechClient client;

    Run(IMechClient client) {
      this.client = client;
    }

    IMechSimRemote reference() throws UserException {
      IMechSimRemoteOperations answers = Script.play(IMechSimRemoteOperations.class, this);
      return IMechSimRemoteHelper.narrow(serve(id, new IMechSimRemotePOATie(answers)));
    }

    int renewLease() {
      return LEASE_SECONDS;
    }

    void destroy() {
      happened.add("destroy run");
      forget(id);
    }

    void start() {
      happened.add("start");
      if (client != null) {
        client.onProgress(getProgress());
        client.onStatus("run", SimState.SIM_RUNNING, "off we go");
        client.onMessages(
            "run",
            new Diagnostic[] {new Diagnostic(Severity.SEV_INFO, "N-000", "easy", "", "", 0, 0)});
      }
    }

    void cancel() {
      happened.add("cancel");
      endsAs = SimState.SIM_CANCELLED;
    }

    Progress getProgress() {
      return new Progress("run", endsAs, 0, 1, 0, 2, 7, 0.1, 3, 1000, ROWS);
    }

    String report() {
      return "{\"scene\": \"square\", \"steps\": 7, \"energyDrift\": 1.5e-7, \"t1s\": 0.5}";
    }

    org.mechservice.idl.FailureRecord failure() {
      return new org.mechservice.idl.FailureRecord(
          failureCode,
          "too stiff.",
          0.5,
          1e-9,
          3,
          "joint j",
          "Try less.",
          new org.mechservice.idl.StepTried[0]);
    }

    ResultCursor openResults(String[] names) throws UserException {
      return new Cursor().reference();
    }
  }

  private final class Cursor {
    private final String id = "cursor" + objects.incrementAndGet();
    private int next;

    ResultCursor reference() throws UserException {
      ResultCursorOperations answers = Script.play(ResultCursorOperations.class, this);
      return ResultCursorHelper.narrow(serve(id, new ResultCursorPOATie(answers)));
    }

    int renewLease() {
      return LEASE_SECONDS;
    }

    void destroy() {
      forget(id);
    }

    Channel[] channels() {
      return new Channel[] {new Channel("t", "s"), new Channel("j.q", "rad")};
    }

    boolean nextBlock(int maxRows, int waitMillis, ResultBlockHolder block) {
      if (next >= diesAtRow) {
        Runtime.getRuntime().halt(9);
      }
      blocksSent.incrementAndGet();
      int first = next;
      next = Math.min(ROWS, first + Math.min(maxRows, 10));
      double[] values = new double[2 * (next - first)];
      for (int row = first; row < next; row++) {
        values[2 * (row - first)] = row;
        values[2 * (row - first) + 1] = (double) row * row;
      }
      block.value = new ResultBlock(first, next - first, 2, values, next == ROWS);
      return next > first;
    }
  }
}
