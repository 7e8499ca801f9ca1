package org.mechservice.library.proof;

import static org.mechservice.library.proof.SceneText.ends;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Random;
import java.util.concurrent.atomic.AtomicBoolean;
import org.mechservice.library.MechModel;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.solver.api.program.RunFailedException;
import org.mechservice.solver.api.program.Trajectory;

/**
 * Scenes with several one-sided elements on a table that swings: stops, backlash, slack ropes,
 * buffers, couplings of one side, balls on plates, wheels that lift, friction that sticks. The
 * reference is the same model in ten thousand steps at 1e-12, a thousand times more than a run
 * takes over such an interval where nothing happens. In half of the scenes the table and what is on
 * it are on springs, so that something always moves; in the others all is calm between two hits. It
 * runs a second time from a start that is moved by 1e-6, and a scene that is moved by much more is
 * dropped.
 *
 * <pre>
 *   Ground --- table (P along x, on a spring) --- module --- ...
 *                                             --- module --- ...
 *          --- module, beside the table
 * </pre>
 */
final class OneSided implements ProofSet {
  private static final int STEPS = 10_000;
  private static final double MOVED = 1e-6;

  /** Largest change of an end by the moved start, beside that of the start. */
  private static final double MOST_SENSITIVE = 300;

  private enum Module {
    STOPS,
    BACKLASH,
    SLACK_ROPE,
    ELASTIC_ROPE,
    BUFFER,
    COUPLING,
    BALL_ON_PLATE,
    WHEEL,
    STICKING_BLOCK
  }

  private record Start(String joint, double q, double v) {}

  private record Parts(
      SceneText text, List<Start> starts, List<String> joints, boolean calm, AtomicBoolean sticks) {
    /** Returns the attributes of a spring of a slider, if there are springs. */
    String spring(double stiffness) {
      return calm ? "" : "stiffness='" + stiffness + "' damping='1'";
    }
  }

  @Override
  public String title() {
    return "one-sided elements";
  }

  @Override
  public int size() {
    return 500;
  }

  @Override
  public String before() {
    return "not measured";
  }

  @Override
  public Optional<Scene> scene(long seed) {
    double end = Spread.even(new Random(seed), 0.4, 1.5);
    Method method = Method.any(new Random(seed + 1), 1e-5);
    Parts parts = parts(seed, 0);
    Method fine =
        new Method(
            "auto",
            parts.sticks().get() ? "ode15s" : "ode113",
            1e-12,
            1e-14,
            OptionalDouble.of(end / STEPS),
            false);
    try {
      Trajectory right = run(parts.text().with(end, end / 20, fine));
      Trajectory moved = run(parts(seed, MOVED).text().with(end, end / 20, fine));
      List<Expected> expected = new ArrayList<>();
      int last = right.rows() - 1;
      for (String joint : parts.joints()) {
        double q = right.column(joint + ".q")[last];
        double v = right.column(joint + ".v")[last];
        double way = range(right.column(joint + ".q"));
        double speed = range(right.column(joint + ".v"));
        double dq = Math.abs(moved.column(joint + ".q")[last] - q) / MOVED;
        double dv = Math.abs(moved.column(joint + ".v")[last] - v) / MOVED;
        if (dq > MOST_SENSITIVE || dv > 10 * MOST_SENSITIVE) {
          return Optional.empty();
        }
        double allowedQ = method.allowed(Math.abs(q) + way);
        double allowedV = method.allowed(Math.abs(v) + speed);
        double unit = method.allowed(1);
        expected.add(
            new Expected(joint + ".q", q, allowedQ + end * allowedV + dq * unit, way).known(1e-6));
        expected.add(
            new Expected(joint + ".v", v, allowedV + 10 * allowedQ + dv * unit, speed).known(1e-5));
      }
      double row = Spread.rounded(end / Spread.one(new Random(seed + 2), 1, 5, 20, 100));
      String kind = parts.calm() ? "calm between hits" : "always in motion";
      return Optional.of(
          new Scene(
              kind, "", method, parts.text().with(end, row, method), 10 * end / STEPS, expected));
    } catch (MechmlException e) {
      throw new IllegalStateException(e);
    } catch (RunFailedException e) {
      // no reference, no verdict
      return Optional.empty();
    }
  }

  private static Trajectory run(String text) throws MechmlException {
    return MechModel.of("m.xml", text).simulate();
  }

  private static double range(double[] column) {
    double low = Double.POSITIVE_INFINITY;
    double high = Double.NEGATIVE_INFINITY;
    for (double value : column) {
      low = Math.min(low, value);
      high = Math.max(high, value);
    }
    return Math.max(1e-3, high - low);
  }

  /** Returns the parts of a scene whose start is moved in every coordinate and velocity. */
  private static Parts parts(long seed, double moved) {
    Random random = new Random(49979687 * seed);
    Parts parts =
        new Parts(
            new SceneText(),
            new ArrayList<>(),
            new ArrayList<>(),
            random.nextBoolean(),
            new AtomicBoolean());
    parts.text().gravity("0", "0", "-9.81");
    parts.text().body("table", 20, 1);
    parts
        .text()
        .joint(
            "table", "P", "Ground", "o", "table", "x", parts.spring(Spread.log(random, 500, 5000)));
    start(
        parts,
        "table",
        parts.calm() ? 0 : Spread.even(random, -0.1, 0.1),
        parts.calm() ? 0 : Spread.even(random, -1, 1));
    int count = 2 + random.nextInt(4);
    for (int i = 0; i < count; i++) {
      add(parts, Module.values()[random.nextInt(Module.values().length)], i, random);
    }
    for (Start start : parts.starts()) {
      // signs by the name, so that not all goes one way
      double sign = start.joint().hashCode() % 2 == 0 ? 1 : -1;
      parts.text().start(start.joint(), start.q() + sign * moved, start.v() - sign * moved);
    }
    return parts;
  }

  private static void start(Parts parts, String joint, double q, double v) {
    parts.starts().add(new Start(joint, q, v));
    parts.joints().add(joint);
  }

  private static String slider(
      Parts parts, int i, String of, String axis, double mass, String more) {
    String name = "m" + i + of;
    parts.text().body(name, mass, 0.01 * mass);
    parts.text().joint(name, "P", "table", "o", name, axis, more);
    return name;
  }

  private static void add(Parts parts, Module module, int i, Random random) {
    SceneText text = parts.text();
    double mass = Spread.log(random, 0.3, 3);
    double k = Spread.log(random, 3e3, 3e5);
    double c = random.nextBoolean() ? 0 : Spread.rounded(0.1 * Math.sqrt(k * mass));
    String spring = " k='" + k + "' c='" + c + "'";
    double v = Spread.even(random, 0.3, 3);
    switch (module) {
      case STOPS -> {
        double free = Spread.log(random, 0.02, 0.3);
        String more =
            "lower='"
                + -free
                + "' upper='"
                + free
                + "' stopStiffness='"
                + k
                + "' stopDamping='"
                + c
                + "'";
        start(parts, slider(parts, i, "a", "x", mass, more), 0, v);
      }
      case BACKLASH -> {
        String one = slider(parts, i, "a", "x", mass, "");
        String other = slider(parts, i, "b", "x", 2 * mass, parts.spring(300));
        text.force(
            "<couplingSpringDamper name='f"
                + i
                + "' expression='"
                + one
                + ".q - 0.5*"
                + other
                + ".q' backlash='"
                + Spread.log(random, 0.01, 0.2)
                + "'"
                + spring
                + "/>");
        start(parts, one, 0, v);
        start(parts, other, 0, 0);
      }
      case SLACK_ROPE, ELASTIC_ROPE -> {
        String one = slider(parts, i, "a", "z", mass, "");
        double length = Spread.log(random, 0.1, 0.6);
        text.force(
            module == Module.SLACK_ROPE
                ? "<springDamper name='f"
                    + i
                    + "' side='tension' length0='"
                    + length
                    + "'"
                    + spring
                    + ">"
                    + ends("table", "o", "", one, "o")
                    + "</springDamper>"
                : "<elasticRope name='f"
                    + i
                    + "' length0='"
                    + length
                    + "'"
                    + spring
                    + "><via name='table' point='o'/><via name='"
                    + one
                    + "' point='o'/></elasticRope>");
        start(parts, one, Spread.rounded(-0.3 * length), 0);
      }
      case BUFFER -> {
        String one = slider(parts, i, "a", "x", mass, parts.spring(20));
        String other = slider(parts, i, "b", "x", 2 * mass, parts.spring(50));
        text.force(
            "<springDamper name='f"
                + i
                + "' side='compression' length0='0.1'"
                + spring
                + ">"
                + ends(one, "o", "", other, "o")
                + "</springDamper>");
        start(parts, one, 0, 0);
        start(parts, other, Spread.even(random, 0.15, 0.6), -v);
      }
      case COUPLING -> {
        String one = slider(parts, i, "a", "x", mass, parts.spring(100));
        String name = "m" + i + "b";
        text.body(name, 1, 0.05).joint(name, "R", "table", "o", name, "y", "");
        text.force(
            "<couplingSpringDamper name='f"
                + i
                + "' side='compression' expression='"
                + one
                + ".q - 0.1*"
                + name
                + ".q' rest='"
                + Spread.even(random, -0.2, -0.02)
                + "'"
                + spring
                + "/>");
        start(parts, one, 0, -v);
        start(parts, name, 0, 1);
      }
      case BALL_ON_PLATE -> {
        String one = slider(parts, i, "a", "z", mass, "");
        double size = Spread.log(random, 0.01, 0.05);
        text.force(
            "<sphereContact name='f"
                + i
                + "' box1='2;2;0.04' radius2='"
                + size
                + "' stiffness='"
                + 10 * k
                + "' damping='"
                + c
                + "' exponent='1.5'>"
                + ends("table", "o", " vector='z'", one, "o")
                + "</sphereContact>");
        start(parts, one, Spread.even(random, 0.1, 0.8), 0);
      }
      case WHEEL -> {
        String one = slider(parts, i, "a", "x", mass, "");
        String up = "m" + i + "b";
        text.body(up, mass, 0.01).joint(up, "P", one, "o", up, "z", "");
        text.force(
            "<contact name='f"
                + i
                + "' stiffness='"
                + k
                + "' damping='"
                + c
                + "' height='"
                + Spread.even(random, 0.01, 0.05)
                + "*sin("
                + Spread.even(random, 3, 10)
                + "*s)'>"
                + ends("Ground", "o", " vector='z' vector2='x'", up, "o")
                + "</contact>");
        start(parts, one, 0, v);
        start(parts, up, Spread.even(random, 0.02, 0.2), 0);
      }
      default -> {
        String one = slider(parts, i, "a", "x", mass, parts.spring(40));
        parts.sticks().set(true);
        String up = "m" + i + "b";
        text.body(up, mass, 0.01).joint(up, "P", one, "o", up, "z", "");
        text.force(
            "<boxContact name='f"
                + i
                + "' box='0.2;0.2;0.1' stiffness='"
                + Spread.rounded(k / 4)
                + "' damping='"
                + Spread.rounded(0.1 * Math.sqrt(k * mass) / 4)
                + "' friction='"
                + Spread.even(random, 0.2, 0.8)
                + "' stickLength='1e-3'>"
                + ends("table", "o", " vector='z' vector2='x'", up, "o")
                + "</boxContact>");
        start(parts, one, 0, v);
        start(parts, up, 0.05, 0);
      }
    }
  }
}
