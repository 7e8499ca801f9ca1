package org.mechservice.solver.analysis.column;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.capability.MomentumBalance;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.Failure;
import org.mechservice.solver.api.run.RunNotes.Note;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.dynamics.recursion.TotalMomentum;
import org.mechservice.solver.kinematics.TreeMotion;

/**
 * Total linear and angular momentum, and the impulse of the external loads since the start:
 * gravity, external forces and ground reactions. World axes; angular momentum is about the fixed
 * point at which the centre of mass is in the first row.
 */
final class MomentumColumns implements ColumnValues, MomentumBalance {
  /** Relative change that rounding explains: sums over bodies, with rounding errors of each. */
  private static final double ROUNDING = 1000 * 0x1p-52;

  private static final String[] COMPONENTS = {"px", "py", "pz", "lx", "ly", "lz"};
  private static final int LINEAR = 0;
  private static final int ANGULAR = 1;
  private static final int KINDS = 2;

  private final ExplicitModel model;
  private final TreeMotion motion;
  private final TotalMomentum whole;
  private final List<Variable> columns = new ArrayList<>();
  private final double[] yDot;
  private final int nq;
  private boolean started;
  private double rowTime;
  private final double[] start = new double[6];
  private final double[] impulse = new double[6];

  /** Impulse of events at the time {@code jumpTime}, which rows up to then do not include. */
  private final double[] jump = new double[6];

  private double jumpTime;

  /** By kind: drift at the last row and the largest one, scale, and what rounding is a part of. */
  private final double[] latest = new double[KINDS];

  private final double[] drift = new double[KINDS];
  private final double[] scale = new double[KINDS];
  private final double[] acted = new double[KINDS];

  /**
   * @param model gives the accelerations
   * @param motion of the same mechanism; swept here
   */
  MomentumColumns(ExplicitModel model, TreeMotion motion) {
    this.model = model;
    this.motion = motion;
    whole = new TotalMomentum(motion);
    yDot = new double[model.description().stateCount()];
    nq = model.description().positionCount();
    for (String what : List.of("momentum.", "impulse.")) {
      for (int i = 0; i < COMPONENTS.length; i++) {
        columns.add(new Variable(what + COMPONENTS[i], i < 3 ? "N·s" : "N·m·s"));
      }
    }
  }

  @Override
  public void begin() {
    restoreState(new double[stateLength()]);
  }

  @Override
  public List<Variable> columns() {
    return columns;
  }

  /** {@inheritDoc} The motion is swept already. */
  @Override
  public void write(double t, double[] values, int at) {
    rowTime = t;
    if (!started) {
      whole.toCenterOfMass();
    }
    whole.evaluateMomentum();
    if (!started) {
      started = true;
      System.arraycopy(whole.sum, 0, start, 0, start.length);
    }
    System.arraycopy(whole.sum, 0, values, at, 6);
    System.arraycopy(impulse, 0, values, at + 6, 6);
    for (int kind = 0; kind < KINDS; kind++) {
      double square = 0;
      for (int i = 3 * kind; i < 3 * kind + 3; i++) {
        double off = whole.sum[i] - start[i] - impulse[i];
        square += off * off;
      }
      latest[kind] = Math.sqrt(square);
      drift[kind] = Math.max(drift[kind], latest[kind]);
      scale[kind] = Math.max(scale[kind], whole.sizes[kind]);
    }
  }

  @Override
  public void add(double seconds, double t, double[] y) {
    if (t > jumpTime) {
      for (int i = 0; i < impulse.length; i++) {
        impulse[i] += jump[i];
        jump[i] = 0;
      }
    }
    boolean regular = model.derivative(t, y, yDot) == ExplicitModel.REGULAR;
    motion.sweep(t, y);
    motion.accelerationSweep(yDot, nq);
    whole.evaluateRate();
    for (int i = 0; i < impulse.length; i++) {
      impulse[i] += regular ? seconds * whole.sum[i] : Double.NaN;
    }
    for (int kind = 0; kind < KINDS; kind++) {
      acted[kind] += seconds * whole.sizes[kind];
    }
  }

  @Override
  public void jump(double tBefore, double[] before, double t, double[] after) {
    jumpTime = t;
    addMomentum(tBefore, before, -1);
    addMomentum(t, after, 1);
  }

  private void addMomentum(double t, double[] y, int sign) {
    motion.sweep(t, y);
    whole.evaluateMomentum();
    for (int i = 0; i < impulse.length; i++) {
      jump[i] += sign * whole.sum[i];
    }
  }

  private boolean exceeds(int kind, double part) {
    double rounding = ROUNDING * (acted[kind] + scale[kind]);
    return !(latest[kind] <= part * scale[kind] + rounding);
  }

  @Override
  public boolean exceeds(double part) {
    return exceeds(LINEAR, part) || exceeds(ANGULAR, part);
  }

  @Override
  public Failure failure(double part, double t, double stepSize, int order) {
    int kind = exceeds(LINEAR, part) ? LINEAR : ANGULAR;
    return new Failure(
        MessageCode.MOMENTUM_DRIFT,
        String.format(
            Locale.ROOT,
            "The %s momentum of the whole, less the impulse of what acts on it, has drifted by %.4g"
                + " %s, which is %.4g of its scale of %.4g %s; at most %s is allowed.",
            kind == LINEAR ? "linear" : "angular",
            latest[kind],
            unit(kind),
            latest[kind] / scale[kind],
            scale[kind],
            unit(kind),
            Double.toString(part)),
        t,
        stepSize,
        order,
        "",
        "Tighten the tolerances. A force that jumps needs an event, or a smaller largest step.");
  }

  private static String unit(int kind) {
    return kind == LINEAR ? "N·s" : "N·m·s";
  }

  @Override
  public Note note() {
    return new Note(
        MessageCode.MOMENTUM_BALANCE,
        rowTime,
        false,
        String.format(
            Locale.ROOT,
            "Momentum of the whole, less the impulse of what acts on it, was off by at most %.4g"
                + " N·s of %.4g N·s, angular momentum by %.4g N·m·s of %.4g N·m·s.",
            drift[LINEAR],
            scale[LINEAR],
            drift[ANGULAR],
            scale[ANGULAR]));
  }

  /** All numbers that a run carries. */
  private double[][] carried() {
    return new double[][] {
      start,
      impulse,
      jump,
      whole.point,
      latest,
      drift,
      scale,
      acted,
      new double[] {jumpTime, rowTime, started ? 1 : 0}
    };
  }

  @Override
  public int stateLength() {
    int length = 0;
    for (double[] part : carried()) {
      length += part.length;
    }
    return length;
  }

  @Override
  public void saveState(double[] state) {
    int at = 0;
    for (double[] part : carried()) {
      System.arraycopy(part, 0, state, at, part.length);
      at += part.length;
    }
  }

  @Override
  public void restoreState(double[] state) {
    int at = 0;
    for (double[] part : carried()) {
      System.arraycopy(state, at, part, 0, part.length);
      at += part.length;
    }
    jumpTime = state[at - 3];
    rowTime = state[at - 2];
    started = state[at - 1] != 0;
  }
}
