package org.mechservice.guard;

import java.io.BufferedInputStream;
import java.io.BufferedOutputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.EOFException;
import java.io.FileDescriptor;
import java.io.FileInputStream;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintStream;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumSet;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import org.mechservice.solver.api.ForceBlocks;
import org.mechservice.solver.api.ForceDeclaration;
import org.mechservice.solver.api.ForceDeclaration.Reads;
import org.mechservice.solver.api.ForceLoads;
import org.mechservice.solver.api.ForceState;
import org.mechservice.solver.api.UserForce;

/**
 * Main class of a process that holds the forces of users for another process, and evaluates them
 * when it asks. Ends with that process.
 */
@SuppressWarnings("EnumOrdinal") // both ends are of one build
final class RelayMain {
  private static final long WATCH_MILLIS = 1000;

  private final DataInputStream in;
  private final DataOutputStream out;
  private final Map<Long, ClassLoader> loaders = new HashMap<>();
  private final Map<Integer, HeldForce> forces = new HashMap<>();
  private int made;

  private RelayMain(DataInputStream in, DataOutputStream out) {
    this.in = in;
    this.out = out;
  }

  /** Answers what comes on standard input, until it ends. */
  public static void main(String[] arguments) throws IOException {
    OutputStream out = new FileOutputStream(FileDescriptor.out);
    // Nothing a class prints may get between the messages.
    System.setOut(new PrintStream(OutputStream.nullOutputStream(), false, "US-ASCII"));
    endWithParent();
    RelayMain main =
        new RelayMain(
            new DataInputStream(new BufferedInputStream(new FileInputStream(FileDescriptor.in))),
            new DataOutputStream(new BufferedOutputStream(out)));
    try {
      while (true) {
        main.answer(main.in.readByte());
        main.out.flush();
      }
    } catch (EOFException e) {
      Runtime.getRuntime().halt(0);
    }
  }

  /** A class that does not come back would keep an unconfined process alive. */
  private static void endWithParent() {
    Optional<ProcessHandle> parent = ProcessHandle.current().parent();
    Thread watch =
        new Thread(
            () -> {
              try {
                while (ProcessHandle.current().parent().equals(parent)) {
                  Thread.sleep(WATCH_MILLIS);
                }
              } catch (InterruptedException e) {
                // Ends the process, too.
              }
              Runtime.getRuntime().halt(1);
            },
            "parent");
    watch.setDaemon(true);
    watch.start();
  }

  private void answer(byte kind) throws IOException {
    switch (kind) {
      case RelayMessage.CLASSES -> takeClasses();
      case RelayMessage.CREATE -> create(in.readLong(), in.readUTF());
      case RelayMessage.DECLARE -> force().declare();
      case RelayMessage.APPLY -> force().apply();
      case RelayMessage.DIFFERENTIATE -> force().differentiate();
      case RelayMessage.RELEASE -> forces.remove(in.readInt());
      case RelayMessage.RELEASE_CLASSES -> loaders.remove(in.readLong());
      default -> throw new IOException("a message of the kind " + kind);
    }
  }

  private void takeClasses() throws IOException {
    long id = in.readLong();
    SortedMap<String, byte[]> files = new TreeMap<>();
    int count = in.readInt();
    for (int i = 0; i < count; i++) {
      String name = in.readUTF();
      files.put(name, in.readNBytes(in.readInt()));
    }
    loaders.put(id, new UserClassLoader(files));
  }

  private HeldForce force() throws IOException {
    HeldForce force = forces.get(in.readInt());
    if (force == null) {
      throw new IOException("no such force");
    }
    return force;
  }

  private void create(long loader, String className) throws IOException {
    try {
      ClassLoader from = loaders.get(loader);
      Class<? extends UserForce> type =
          Class.forName(className, true, from).asSubclass(UserForce.class);
      // For a constructor that is called often, reflection would generate a class that needs
      // classes of Java which loaders of user classes do not find.
      UserForce force =
          (UserForce)
              MethodHandles.publicLookup()
                  .findConstructor(type, MethodType.methodType(void.class))
                  .invoke();
      forces.put(made, new HeldForce(force));
      out.writeByte(RelayMessage.DONE);
      out.writeInt(made++);
    } catch (OutOfMemoryError e) {
      throw e; // ends the process with a status of its own
    } catch (Throwable e) {
      tell(e);
    }
  }

  private void tell(Throwable thrown) throws IOException {
    String message;
    String described;
    try {
      message = RelayMessage.clipped(String.valueOf(thrown.getMessage()));
      described = RelayMessage.clipped(thrown.toString());
    } catch (RuntimeException | Error e) {
      message = "";
      described = thrown.getClass().getName();
    }
    out.writeByte(RelayMessage.THROWN);
    out.writeUTF(message);
    out.writeUTF(described);
  }

  /** Writes a reading of a point and returns how many numbers it has. */
  static int read(ForceState state, int point, Reads what, double[] numbers) {
    switch (what) {
      case POSITION -> state.position(point, numbers);
      case VELOCITY -> state.velocity(point, numbers);
      case ANGULAR_VELOCITY -> state.angularVelocity(point, numbers);
      case ROTATION -> state.rotation(point, numbers);
    }
    return what == Reads.ROTATION ? 9 : 3;
  }

  /** A force with what it has declared, its readings and its loads. */
  private final class HeldForce implements ForceDeclaration, ForceState, ForceLoads, ForceBlocks {
    private final UserForce force;
    private final List<Set<Reads>> reads = new ArrayList<>();
    private int coordinates;
    private int parameterCount;
    private int valueCount;
    private boolean declares;

    private double time;
    private double[] parameters = {};
    private double[] position = {};
    private String[] withoutPosition = {};
    private double[] rate = {};

    /** Readings of each point: position, velocity, angular velocity, rotation. */
    private double[][][] points = {};

    private double[][] load = {};
    private double[] jointForce = {};
    private double[] values = {};

    private final ByteArrayOutputStream blocks = new ByteArrayOutputStream();
    private int blockCount;

    HeldForce(UserForce force) {
      this.force = force;
    }

    private interface Call {
      void of(UserForce force);
    }

    /** Returns whether a call came back; if not, what it threw has been told. */
    private boolean calls(Call call) throws IOException {
      try {
        call.of(force);
        return true;
      } catch (Broken e) {
        throw e.cause;
      } catch (OutOfMemoryError e) {
        throw e; // ends the process with a status of its own
      } catch (Throwable e) {
        tell(e);
        return false;
      }
    }

    void declare() throws IOException {
      declares = true;
      boolean back = calls(law -> law.declare(this));
      declares = false;
      if (back) {
        parameters = new double[parameterCount];
        position = new double[coordinates];
        withoutPosition = new String[coordinates];
        rate = new double[coordinates];
        jointForce = new double[coordinates];
        values = new double[valueCount];
        points = new double[reads.size()][Reads.values().length][MOST];
        load = new double[reads.size()][6];
        out.writeByte(RelayMessage.DONE);
      }
    }

    private static final int MOST = 9;

    /** The program has closed its end. */
    private static final class Broken extends RuntimeException {
      private static final long serialVersionUID = 1L;
      private final IOException cause;

      Broken(IOException cause) {
        super(cause);
        this.cause = cause;
      }
    }

    private interface Sending {
      void send() throws IOException;
    }

    private int ask(Sending declaration) {
      if (!declares) {
        throw new IllegalStateException("a force declares in its method declare only");
      }
      try {
        declaration.send();
        out.flush();
        if (in.readByte() == RelayMessage.ACCEPTED) {
          return in.readInt();
        }
        boolean wrong = in.readBoolean();
        String why = in.readUTF();
        throw wrong ? new IllegalArgumentException(why) : new IllegalStateException(why);
      } catch (IOException e) {
        throw new Broken(e);
      }
    }

    private int bits(Reads[] asked) {
      int bits = 0;
      for (Reads one : asked) {
        bits |= 1 << one.ordinal();
      }
      return bits;
    }

    private Set<Reads> set(Reads[] asked) {
      Set<Reads> set = EnumSet.noneOf(Reads.class);
      set.addAll(Arrays.asList(asked));
      return set;
    }

    @Override
    public int point(String body, String point, Reads... asked) {
      int bits = bits(asked);
      String ofBody = RelayMessage.clipped(body);
      String ofPoint = RelayMessage.clipped(point);
      int index =
          ask(
              () -> {
                out.writeByte(RelayMessage.POINT);
                out.writeUTF(ofBody);
                out.writeUTF(ofPoint);
                out.writeInt(bits);
              });
      reads.add(set(asked));
      return index;
    }

    @Override
    public int pointAt(String body, double x, double y, double z, Reads... asked) {
      int bits = bits(asked);
      String ofBody = RelayMessage.clipped(body);
      int index =
          ask(
              () -> {
                out.writeByte(RelayMessage.POINT_AT);
                out.writeUTF(ofBody);
                out.writeDouble(x);
                out.writeDouble(y);
                out.writeDouble(z);
                out.writeInt(bits);
              });
      reads.add(set(asked));
      return index;
    }

    @Override
    public int coordinate(String joint, int component) {
      String ofJoint = RelayMessage.clipped(joint);
      int index =
          ask(
              () -> {
                out.writeByte(RelayMessage.COORDINATE);
                out.writeUTF(ofJoint);
                out.writeInt(component);
              });
      coordinates++;
      return index;
    }

    @Override
    public int parameter(String name) {
      String ofParameter = RelayMessage.clipped(name);
      int index =
          ask(
              () -> {
                out.writeByte(RelayMessage.PARAMETER);
                out.writeUTF(ofParameter);
              });
      parameterCount++;
      return index;
    }

    @Override
    public int value(String name, String unit) {
      String ofValue = RelayMessage.clipped(name);
      String ofUnit = RelayMessage.clipped(unit);
      int index =
          ask(
              () -> {
                out.writeByte(RelayMessage.VALUE);
                out.writeUTF(ofValue);
                out.writeUTF(ofUnit);
              });
      valueCount++;
      return index;
    }

    private void receive() throws IOException {
      time = in.readDouble();
      for (int p = 0; p < parameters.length; p++) {
        parameters[p] = in.readDouble();
      }
      for (int c = 0; c < position.length; c++) {
        withoutPosition[c] = in.readUTF();
        position[c] = in.readDouble();
        rate[c] = in.readDouble();
      }
      for (int p = 0; p < points.length; p++) {
        for (Reads one : reads.get(p)) {
          int count = one == Reads.ROTATION ? MOST : 3;
          for (int i = 0; i < count; i++) {
            points[p][one.ordinal()][i] = in.readDouble();
          }
        }
      }
    }

    void apply() throws IOException {
      receive();
      for (double[] one : load) {
        Arrays.fill(one, 0);
      }
      Arrays.fill(jointForce, 0);
      if (calls(law -> law.apply(this, this))) {
        out.writeByte(RelayMessage.DONE);
        for (double[] one : load) {
          send(one);
        }
        send(jointForce);
        send(values);
      }
    }

    private void send(double[] numbers) throws IOException {
      for (double number : numbers) {
        out.writeDouble(number);
      }
    }

    void differentiate() throws IOException {
      receive();
      blocks.reset();
      blockCount = 0;
      if (calls(law -> ((UserForce.Derivatives) law).differentiate(this, this))) {
        out.writeByte(RelayMessage.DONE);
        out.writeInt(blockCount);
        blocks.writeTo(out);
      }
    }

    @Override
    public void byPoint(Load of, int on, Reads by, int point, double[] block) {
      add(
          data -> {
            data.writeByte(RelayMessage.BY_POINT);
            data.writeByte(of.ordinal());
            data.writeInt(on);
            data.writeByte(by.ordinal());
            data.writeInt(point);
            add(data, block);
          });
    }

    @Override
    public void byCoordinate(
        Load of, int on, int coordinate, double[] byPosition, double[] byRate) {
      add(
          data -> {
            data.writeByte(RelayMessage.BY_COORDINATE);
            data.writeByte(of.ordinal());
            data.writeInt(on);
            data.writeInt(coordinate);
            add(data, byPosition);
            add(data, byRate);
          });
    }

    private void add(DataOutputStream data, double[] block) throws IOException {
      int count = Math.min(block.length, MOST);
      data.writeInt(count);
      for (int i = 0; i < count; i++) {
        data.writeDouble(block[i]);
      }
    }

    private interface Block {
      void to(DataOutputStream data) throws IOException;
    }

    private void add(Block block) {
      ByteArrayOutputStream one = new ByteArrayOutputStream();
      try {
        block.to(new DataOutputStream(one));
      } catch (IOException e) {
        throw new IllegalStateException("memory is written", e);
      }
      blocks.writeBytes(one.toByteArray());
      blockCount++;
    }

    @Override
    public double time() {
      return time;
    }

    @Override
    public double parameter(int parameter) {
      return parameters[parameter];
    }

    @Override
    public double coordinate(int coordinate) {
      String none = withoutPosition[coordinate];
      if (none != null && !none.isEmpty()) {
        throw new IllegalStateException(none);
      }
      return position[coordinate];
    }

    @Override
    public double rate(int coordinate) {
      return rate[coordinate];
    }

    private double[] reading(int point, Reads what) {
      double[] numbers = points[point][what.ordinal()];
      if (!reads.get(point).contains(what)) {
        throw new IllegalStateException(
            "point " + point + " was not declared to be read for its " + what);
      }
      return numbers;
    }

    @Override
    public void position(int point, double[] to) {
      System.arraycopy(reading(point, Reads.POSITION), 0, to, 0, 3);
    }

    @Override
    public void velocity(int point, double[] to) {
      System.arraycopy(reading(point, Reads.VELOCITY), 0, to, 0, 3);
    }

    @Override
    public void rotation(int point, double[] to) {
      System.arraycopy(reading(point, Reads.ROTATION), 0, to, 0, MOST);
    }

    @Override
    public void angularVelocity(int point, double[] to) {
      System.arraycopy(reading(point, Reads.ANGULAR_VELOCITY), 0, to, 0, 3);
    }

    @Override
    public void addForce(int point, double x, double y, double z) {
      add(load[point], 0, x, y, z);
    }

    @Override
    public void addTorque(int point, double x, double y, double z) {
      add(load[point], 3, x, y, z);
    }

    private void add(double[] to, int at, double x, double y, double z) {
      to[at] += x;
      to[at + 1] += y;
      to[at + 2] += z;
    }

    @Override
    public void addJointForce(int coordinate, double force) {
      jointForce[coordinate] += force;
    }

    @Override
    public void setValue(int value, double x) {
      values[value] = x;
    }
  }
}
