package org.mechservice.guard;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Random;
import java.util.SortedMap;
import java.util.TreeMap;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.mechservice.solver.api.ForceBlocks;
import org.mechservice.solver.api.ForceDeclaration;
import org.mechservice.solver.api.ForceLoads;
import org.mechservice.solver.api.ForceState;
import org.mechservice.solver.api.UserForce;

/** A force behind the walls is the force: every number, every refusal and every exception of it. */
@Tag("slow")
class ForceRelayTest {
  /** Reads and does everything that a force can, with memory of its own. */
  private static final String EVERYTHING =
      "implements UserForce.Derivatives { int p, b, c, m, v, calls; public void"
          + " declare(ForceDeclaration d) { p = d.point(\"body\", \"place\","
          + " ForceDeclaration.Reads.POSITION, ForceDeclaration.Reads.VELOCITY); b ="
          + " d.pointAt(\"other\", 1, 2, 3, ForceDeclaration.Reads.ROTATION,"
          + " ForceDeclaration.Reads.ANGULAR_VELOCITY); c = d.coordinate(\"joint\", 1); m ="
          + " d.parameter(\"k\"); v = d.value(\"calls\", \"1\"); } public void apply(ForceState s,"
          + " ForceLoads l) { double[] x = new double[3], w = new double[3], r = new double[9];"
          + " s.position(p, x); s.velocity(p, w); l.addForce(p, x[0] * w[1], Math.sin(x[1]), 1 /"
          + " x[2]); l.addForce(p, 1e-17, -0.0, s.time()); s.rotation(b, r);"
          + " s.angularVelocity(b, w); l.addTorque(b, r[0] * w[0], r[5] * w[1], r[8] * w[2]);"
          + " l.addJointForce(c, -s.parameter(m) * s.coordinate(c) - s.rate(c)); l.setValue(v,"
          + " ++calls); } public void differentiate(ForceState s, ForceBlocks k) { double[] x ="
          + " new double[3]; s.position(p, x); k.byPoint(ForceBlocks.Load.FORCE, p,"
          + " ForceDeclaration.Reads.POSITION, p, new double[] {x[0], 1, 2, 3, x[1], 5, 6, 7,"
          + " x[2]}); k.byCoordinate(ForceBlocks.Load.JOINT_FORCE, c, c, new double[]"
          + " {-s.parameter(m)}, new double[] {-1}); } }";

  @TempDir private Path folder;

  private UserForce relayed(String name, String body) throws Exception {
    return relayed(CompiledForces.of(folder, name, body), name);
  }

  /** Confined where this machine can, as everywhere. */
  private static UserForce relayed(SortedMap<String, byte[]> files, String name) throws Exception {
    return made(new ForceRelay(files, UserCode.NONE.unconfined()).newLoader(), name);
  }

  private static UserForce made(ClassLoader loader, String name) throws Exception {
    return (UserForce) loader.loadClass(name).getConstructor().newInstance();
  }

  /** A model with one of everything, whose readings are random and whose loads are written down. */
  private static class Recorder implements ForceDeclaration, ForceState, ForceLoads, ForceBlocks {
    private final Random random;
    private final List<String> calls = new ArrayList<>();
    private int points;

    Recorder(long seed) {
      random = new Random(seed);
    }

    @Override
    public int point(String body, String point, Reads... reads) {
      calls.add("point " + body + " " + point + " " + Arrays.toString(reads));
      return points++;
    }

    @Override
    public int pointAt(String body, double x, double y, double z, Reads... reads) {
      calls.add("point " + body + x + y + z + Arrays.toString(reads));
      return points++;
    }

    @Override
    public int coordinate(String joint, int component) {
      calls.add("coordinate " + joint + component);
      return 0;
    }

    @Override
    public int parameter(String name) {
      calls.add("parameter " + name);
      return 0;
    }

    @Override
    public int value(String name, String unit) {
      calls.add("value " + name + unit);
      return 0;
    }

    private double next() {
      return (random.nextDouble() - 0.5) * Math.pow(10, random.nextInt(20) - 10);
    }

    private double time;
    private double parameter;
    private double coordinate;
    private double rate;
    private final double[][] readings = new double[4][9];

    void shuffle() {
      time = next();
      parameter = next();
      coordinate = next();
      rate = next();
      for (double[] reading : readings) {
        Arrays.setAll(reading, i -> next());
      }
    }

    @Override
    public double time() {
      return time;
    }

    @Override
    public double parameter(int index) {
      return parameter;
    }

    @Override
    public double coordinate(int index) {
      return coordinate;
    }

    @Override
    public double rate(int index) {
      return rate;
    }

    @Override
    public void position(int point, double[] out) {
      System.arraycopy(readings[0], 0, out, 0, 3);
    }

    @Override
    public void velocity(int point, double[] out) {
      System.arraycopy(readings[1], 0, out, 0, 3);
    }

    @Override
    public void rotation(int point, double[] out) {
      System.arraycopy(readings[2], 0, out, 0, 9);
    }

    @Override
    public void angularVelocity(int point, double[] out) {
      System.arraycopy(readings[3], 0, out, 0, 3);
    }

    private final double[] loads = new double[14];

    @Override
    public void addForce(int point, double x, double y, double z) {
      add(6 * point, x, y, z);
    }

    @Override
    public void addTorque(int point, double x, double y, double z) {
      add(6 * point + 3, x, y, z);
    }

    private void add(int at, double x, double y, double z) {
      loads[at] += x;
      loads[at + 1] += y;
      loads[at + 2] += z;
    }

    @Override
    public void addJointForce(int index, double force) {
      loads[12] += force;
    }

    @Override
    public void setValue(int value, double x) {
      loads[13] = x;
    }

    @Override
    public void byPoint(Load load, int on, Reads by, int point, double[] block) {
      calls.add("by point " + load + on + by + point + Arrays.toString(block));
    }

    @Override
    public void byCoordinate(Load load, int on, int index, double[] byPosition, double[] byRate) {
      calls.add(
          "by coordinate "
              + load
              + on
              + index
              + Arrays.toString(byPosition)
              + Arrays.toString(byRate));
    }

    /** Does what a run does with a force and returns what comes of it, bit for bit. */
    List<String> of(UserForce force) {
      force.declare(this);
      for (int i = 0; i < 20; i++) {
        shuffle();
        Arrays.fill(loads, 0, 13, 0);
        force.apply(this, this);
        calls.add(
            Arrays.toString(Arrays.stream(loads).mapToLong(Double::doubleToRawLongBits).toArray()));
        if (force instanceof UserForce.Derivatives law) {
          law.differentiate(this, this);
        }
      }
      return calls;
    }
  }

  /** Exact: the same class does the same operations on the same numbers. */
  @ValueSource(longs = {1, 2, 3})
  @ParameterizedTest
  void everythingThatAForceDoesIsTheSameToTheBit(long seed) throws Exception {
    SortedMap<String, byte[]> files = CompiledForces.of(folder, "Everything", EVERYTHING);
    UserForce direct = made(new UserClassLoader(files), "Everything");
    assertThat(BytecodeVerifier.check(files)).isEmpty();

    assertThat(new Recorder(seed).of(relayed(files, "Everything")))
        .isEqualTo(new Recorder(seed).of(direct))
        .hasSize(65);
  }

  /** The class of a user is nowhere in this process, only one of its name. */
  @Test
  void classOfTheUserIsNotLoadedHere() throws Exception {
    UserForce force =
        relayed(
            "Static",
            "implements UserForce { static { System.setProperty(\"loaded.here\", \"yes\"); } public"
                + " void declare(ForceDeclaration d) {} public void apply(ForceState s, ForceLoads"
                + " l) {} }");
    force.declare(new Recorder(1));
    assertThat(System.getProperty("loaded.here")).isNull();
    assertThat(force).isInstanceOf(RelayedForce.class).isNotInstanceOf(UserForce.Derivatives.class);
  }

  @Test
  void derivativesAreInheritedFromAClassOfTheUser() throws Exception {
    UserForce force = relayed("Sub", "extends Base {} abstract class Base " + EVERYTHING);
    assertThat(force).isInstanceOf(UserForce.Derivatives.class);
  }

  private static final String THROWING =
      "implements UserForce { public void declare(ForceDeclaration d) { %s } public void"
          + " apply(ForceState s, ForceLoads l) { %s } }";

  @Test
  void whatAForceThrowsIsToldAsItIs() throws Exception {
    UserForce force =
        relayed(
            "Throwing",
            String.format(
                THROWING, "", "throw new IllegalStateException(\"\\ud800 \\u0000 too fast\");"));
    Recorder model = new Recorder(1);
    force.declare(model);
    for (int i = 0; i < 3; i++) {
      assertThatThrownBy(() -> force.apply(model, model))
          .hasToString("java.lang.IllegalStateException: \ud800 \u0000 too fast")
          .hasMessage("\ud800 \u0000 too fast");
    }
  }

  @Test
  void whatTheModelRefusesIsRefusedInTheClassAndHere() throws Exception {
    UserForce force =
        relayed(
            "Refused",
            String.format(THROWING, "d.point(\"nowhere\", \"p\");", "/* not reached */"));
    Recorder model =
        new Recorder(1) {
          @Override
          public int point(String body, String point, Reads... reads) {
            throw new IllegalArgumentException("S-068 there is no " + body);
          }
        };
    assertThatThrownBy(() -> force.declare(model)).hasMessage("S-068 there is no nowhere");
  }

  @Test
  void quantityThatWasNotDeclaredIsNotRead() throws Exception {
    UserForce force =
        relayed(
            "Reader",
            String.format(THROWING, "d.point(\"body\", \"p\");", "s.position(0, new double[3]);"));
    Recorder model = new Recorder(1);
    force.declare(model);
    assertThatThrownBy(() -> force.apply(model, model))
        .hasMessage("point 0 was not declared to be read for its POSITION");
  }

  /** The caller's memory is his own; the next force has a new process. */
  @Test
  void memoryOfAForceEndsItsProcessAndNothingElse() throws Exception {
    SortedMap<String, byte[]> files =
        CompiledForces.of(
            folder,
            "Hungry",
            String.format(
                THROWING,
                "",
                "List<long[]> all = new ArrayList<>(); while (s.time() < 9) { all.add(new"
                    + " long[1 << 20]); }"));
    ClassLoader loader = new ForceRelay(files, UserCode.NONE.unconfined()).newLoader();
    UserForce force = made(loader, "Hungry");
    Recorder model = new Recorder(1);
    force.declare(model);
    assertThatThrownBy(() -> force.apply(model, model))
        .hasMessageContaining("OutOfMemoryError: its process may use 1074 MB");
    made(loader, "Hungry").declare(model);
  }

  /** The thread stays interrupted; the next force has a new process. */
  @Test
  void interruptEndsAForceThatNeverReturns() throws Exception {
    SortedMap<String, byte[]> files =
        CompiledForces.of(
            folder,
            "Endless",
            String.format(
                THROWING,
                "",
                "double x = 0; while (s.time() < 9 && x >= 0) { x = Math.abs(Math.sin(x + 1)); }"));
    ClassLoader loader = new ForceRelay(files, UserCode.NONE.unconfined()).newLoader();
    UserForce force = made(loader, "Endless");
    Recorder model = new Recorder(1);
    force.declare(model);
    Thread.currentThread().interrupt();
    assertThatThrownBy(() -> force.apply(model, model))
        .hasMessageContaining("the thread that waited for a class of the user was interrupted");
    assertThat(Thread.interrupted()).isTrue();
    made(loader, "Endless").declare(model);
  }

  @Test
  void printingAndForcesOfManyThreadsDoNotDisturbEachOther() throws Exception {
    SortedMap<String, byte[]> files = CompiledForces.of(folder, "Everything", EVERYTHING);
    ForceRelay relay = new ForceRelay(files, UserCode.NONE.unconfined());
    List<String> expected = new Recorder(7).of(made(new UserClassLoader(files), "Everything"));
    List<Thread> threads = new ArrayList<>();
    List<List<String>> found = new ArrayList<>();
    for (int i = 0; i < 6; i++) {
      Thread thread =
          new Thread(
              () -> {
                try {
                  List<String> one = new Recorder(7).of(made(relay.newLoader(), "Everything"));
                  synchronized (found) {
                    found.add(one);
                  }
                } catch (Exception e) {
                  throw new IllegalStateException(e);
                }
              });
      thread.start();
      threads.add(thread);
    }
    for (Thread thread : threads) {
      thread.join();
    }
    assertThat(found).hasSize(6).allMatch(expected::equals);
  }

  @Test
  void machineWithoutWallRunsNothingUnlessAsked() {
    assumeFalse(Confinement.ofThisMachine().stands(), "this machine confines");
    ForceRelay relay = new ForceRelay(new TreeMap<>(), UserCode.NONE);
    assertThatThrownBy(relay::newLoader)
        .hasMessageStartingWith("S-168")
        .hasMessageContaining("--unconfined");
  }
}
