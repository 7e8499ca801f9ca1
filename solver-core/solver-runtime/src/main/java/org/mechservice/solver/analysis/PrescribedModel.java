package org.mechservice.solver.analysis;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import org.mechservice.solver.analysis.equation.DriveShares;
import org.mechservice.solver.analysis.equation.FreeDirections;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.closure.assembly.Assembly;
import org.mechservice.solver.closure.assembly.LoopFinding;
import org.mechservice.solver.closure.assembly.RankAnalysis;
import org.mechservice.solver.closure.model.LoopContinuation;
import org.mechservice.solver.compact.CompactModel;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.mechanism.MotionJump;

/**
 * A mechanism whose coordinates all follow from prescribed motions, through driven joints and
 * loops. Positions come from Φ(q, t) = 0, followed from one output time to the next ({@link
 * LoopContinuation}); velocities and accelerations from J v = −Φ_t and J a = −γ. The necessary
 * forces are separate columns.
 */
final class PrescribedModel extends AnalysisModel {
  /** Ratio of the smallest to the largest singular value below which a position is singular. */
  private static final double SINGULAR = 1e-8;

  /** Largest number of jumps that are told one by one, as of the events of an integrated run. */
  private static final int MOST_TOLD = 200;

  private final CoordinateNames names;
  private List<MotionJump> jumps = List.of();

  /** Number of jumps up to the present time. */
  private int passed;

  private final List<Note> notes = new ArrayList<>();
  private double[] y = new double[0];
  private boolean started;
  private double reached;

  /** Sign of the determinant of J, whose rows are as many as its columns. */
  private int orientation;

  private final LoopContinuation continuation = new LoopContinuation(new AllPositions());
  private int[] rows = new int[0];
  private long iterations;

  PrescribedModel(CompactModel data, UserForceSource userForces) {
    super(data, userForces);
    names = new CoordinateNames(mechanism);
  }

  @Override
  public void begin(double from, double to) {
    jumps = mechanism.motionJumps(from, to);
  }

  @Override
  public int find(double t, double[] out) {
    Optional<Defect> why = !started ? start(t) : advance(t);
    if (why.isEmpty()) {
      why = jump(t);
    }
    if (why.isPresent()) {
      return fail(why.get());
    }
    System.arraycopy(y, 0, out, 0, y.length);
    return REGULAR;
  }

  /** Tells the jumps of prescribed motions up to a time. */
  private Optional<Defect> jump(double t) {
    while (passed < jumps.size() && jumps.get(passed).time() <= t) {
      MotionJump jump = jumps.get(passed++);
      if (jump.ofPosition()) {
        return Optional.of(positionJumps(jump));
      }
      if (passed <= MOST_TOLD) {
        notes.add(velocityJumps(jump));
      }
    }
    return Optional.empty();
  }

  private static Defect positionJumps(MotionJump jump) {
    return new Defect(
        MessageCode.DRIVEN_POSITION_JUMPS,
        jump.joint(),
        String.format(
            Locale.ROOT,
            "The position that is prescribed for the joint jumps at t=%s s.",
            jump.time()),
        "End the run before, or write a motion that takes time, such as smoothStep((t-1)/0.1).");
  }

  private static Note velocityJumps(MotionJump jump) {
    String text =
        String.format(
            Locale.ROOT,
            "The velocity of driven joint \"%s\" jumps from %.4g to %.4g: its acceleration is not"
                + " finite there, and the drive exerts an impulse, which no row contains.",
            jump.joint(),
            jump.before(),
            jump.after());
    return new Note(MessageCode.DRIVEN_VELOCITY_JUMPED, jump.time(), true, text);
  }

  private Optional<Defect> start(double t) {
    double[] start = new double[mechanism.stateCount()];
    mechanism.initialState(start);
    if (!equations.loops.isHolonomic()) {
      return Optional.of(rolls());
    }
    for (LoopFinding finding : new Assembly(equations.tree).assemble(t, start)) {
      if (finding.kind() == LoopFinding.Kind.NOT_CLOSED) {
        return Optional.of(open(finding.part(), finding.amount(), finding.unit()));
      }
      if (finding.kind() == LoopFinding.Kind.START_MOVED) {
        notes.add(finding.note());
      }
    }
    if (new RankAnalysis(equations.tree, t, start).rank() < equations.nv) {
      return Optional.of(free(t, start));
    }
    y = start;
    started = true;
    reached = t;
    equations.place(t, y);
    FreeDirections directions = new FreeDirections(equations);
    rows = directions.kept();
    if (directions.freedom() > 0) {
      return Optional.of(singular(directions));
    }
    orientation = orientation();
    Optional<Defect> why = move(t);
    if (why.isEmpty()) {
      new DriveShares(equations).redundant().ifPresent(text -> notes.add(redundant(t, text)));
    }
    return why;
  }

  private static Note redundant(double t, String drives) {
    String text =
        "The motion does not determine the forces of driven joints "
            + drives
            + ", which others or the loops move as well; they are those of least norm.";
    return new Note(MessageCode.REDUNDANT_CONSTRAINTS, t, false, text);
  }

  private Defect rolls() {
    int row = 0;
    while (equations.loops.isHolonomic(row)) {
      row++;
    }
    return new Defect(
        MessageCode.PRESCRIBED_MOTION_INCOMPLETE,
        equations.loops.name(row),
        "The prescribed motion does not determine positions: this constraint restricts velocities"
            + " alone, and positions follow from the whole motion before them.",
        "Simulate <dynamic>: drives move the mechanism there too, and columns have their forces.");
  }

  private Defect free(double t, double[] start) {
    equations.place(t, start);
    FreeDirections directions = new FreeDirections(equations);
    String free =
        Arrays.stream(directions.independent)
            .mapToObj(names::name)
            .collect(Collectors.joining(", "));
    return new Defect(
        MessageCode.PRESCRIBED_MOTION_INCOMPLETE,
        "",
        "The prescribed motion leaves "
            + directions.freedom()
            + (directions.freedom() == 1 ? " coordinate" : " coordinates")
            + " free, such as "
            + free
            + ".",
        "Drive them, or simulate <dynamic>, where forces move what nothing prescribes.");
  }

  private Optional<Defect> advance(double t) {
    double[] rates = new double[equations.nq];
    equations.coordinates.rates(y, 0, y, equations.nq, rates, 0);
    double[] to = y.clone();
    LoopContinuation.End end = continuation.follow(reached, y, rates, orientation, t, to);
    if (end == LoopContinuation.End.REACHED && equations.closePositions(t, to)) {
      System.arraycopy(to, 0, y, 0, equations.nq);
      reached = t;
      return move(t);
    }
    System.arraycopy(continuation.positions(), 0, y, 0, equations.nq);
    if (end == LoopContinuation.End.LIMIT) {
      return Optional.of(stuck(t, y));
    }
    equations.place(reached + continuation.reached() * (t - reached), y);
    return Optional.of(singular(new FreeDirections(equations)));
  }

  private double unitOf(int position) {
    return equations.unit[equations.coordinates.velocityOf(position)];
  }

  /** Finds velocities and accelerations at the present positions. */
  private Optional<Defect> move(double t) {
    int n = equations.nv;
    Arrays.fill(y, equations.nq, equations.nq + equations.nv, 0);
    equations.place(t, y);
    equations.solveLeast(equations.loops.rate);
    boolean lost = equations.rank() < n || (n > 0 && equations.jacobian.relative(n - 1) < SINGULAR);
    if (lost || orientation() != orientation) {
      return Optional.of(singular(new FreeDirections(equations)));
    }
    System.arraycopy(equations.step, 0, y, equations.nq, n);
    equations.place(t, y);
    Arrays.fill(acceleration, 0);
    equations.motion.accelerationSweep(acceleration);
    equations.loops.accelerate(equations.motion, t);
    equations.solveLeast(equations.loops.acceleration);
    System.arraycopy(equations.step, 0, acceleration, 0, n);
    return Optional.empty();
  }

  /** Returns the sign of the determinant of J's independent rows: it changes at a dead centre. */
  private int orientation() {
    int n = equations.nv;
    double[] a = new double[n * n];
    equations.jacobian.decompose();
    for (int i = 0; i < n && rows.length == n; i++) {
      System.arraycopy(equations.jacobian.elements(), rows[i] * n, a, i * n, n);
    }
    int sign = 1;
    for (int k = 0; k < n; k++) {
      int pivot = k;
      for (int i = k + 1; i < n; i++) {
        pivot = Math.abs(a[i * n + k]) > Math.abs(a[pivot * n + k]) ? i : pivot;
      }
      for (int j = 0; j < n; j++) {
        double element = a[k * n + j];
        a[k * n + j] = a[pivot * n + j];
        a[pivot * n + j] = element;
      }
      sign *= (pivot == k ? 1 : -1) * (int) Math.signum(a[k * n + k]);
      for (int i = k + 1; i < n && a[k * n + k] != 0; i++) {
        double factor = a[i * n + k] / a[k * n + k];
        for (int j = k; j < n; j++) {
          a[i * n + j] -= factor * a[k * n + j];
        }
      }
    }
    return sign;
  }

  private Defect singular(FreeDirections directions) {
    String where = directions.freedom() == 0 ? "" : names.part(directions.independent[0]);
    return new Defect(
        MessageCode.PRESCRIBED_MOTION_SINGULAR,
        where,
        "The mechanism comes to a singular position: the prescribed motion does not determine how"
            + " it goes on.",
        "Drive another joint, or end the run before this position; a second run can start beyond"
            + " it.");
  }

  private Defect stuck(double t, double[] predicted) {
    double[] ended = predicted.clone();
    equations.closePositions(t, ended);
    int worst = equations.loops.worst();
    return worst < 0
        ? singular(new FreeDirections(equations))
        : open(
            equations.loops.name(worst),
            Math.abs(equations.loops.value[worst]),
            equations.loops.unit(worst));
  }

  private static Defect open(String part, double amount, String unit) {
    return new Defect(
        MessageCode.PRESCRIBED_MOTION_IMPOSSIBLE,
        part,
        String.format(
            Locale.ROOT,
            "No position fits the prescribed motion: this constraint stays open by %.1e %s.",
            amount,
            unit),
        "Check the range of the motion: the mechanism is fully stretched there, or drives of joints"
            + " contradict each other.");
  }

  @Override
  public long iterations() {
    return iterations;
  }

  @Override
  public List<Note> notes() {
    List<Note> all = new ArrayList<>(notes);
    if (passed > MOST_TOLD) {
      String text = (passed - MOST_TOLD) + " more jumps of driven velocities after this time.";
      double last = jumps.get(MOST_TOLD - 1).time();
      all.add(new Note(MessageCode.DRIVEN_VELOCITY_JUMPED, last, true, text));
    }
    return all;
  }

  /** The equations of all positions, by least changes where some of them are redundant. */
  private final class AllPositions implements LoopContinuation.Equations {
    /** {@inheritDoc} No motion is free here. */
    @Override
    public boolean crosses(double t, double[] q) {
      return false;
    }

    @Override
    public int positionCount() {
      return equations.nq;
    }

    @Override
    public boolean isGiven(int position) {
      return false;
    }

    @Override
    public double unit(int position) {
      return equations.coordinates.velocityOf(position) < 0 ? 1 : unitOf(position);
    }

    @Override
    public double correct(double t, double[] q) {
      iterations++;
      double[] state = Arrays.copyOf(q, equations.nq + equations.nv);
      equations.coordinates.normalize(state, 0);
      equations.place(t, state);
      equations.solveLeast(equations.loops.value);
      int n = equations.nv;
      if (n > 0 && !(equations.jacobian.relative(n - 1) >= SINGULAR)) {
        return Double.NaN;
      }
      double largest = 0;
      for (int j = 0; j < n; j++) {
        largest = Math.max(largest, Math.abs(equations.step[j]) / equations.unit[j]);
      }
      equations.coordinates.move(state, 0, equations.step, 0, 1);
      System.arraycopy(state, 0, q, 0, equations.nq);
      return largest;
    }

    @Override
    public int orientation() {
      return PrescribedModel.this.orientation();
    }
  }
}
