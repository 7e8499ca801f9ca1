package org.mechservice.solver.step;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import org.mechservice.solver.kinematics.LinkKind;
import org.mechservice.solver.step.LinkStep.Added;
import org.mechservice.solver.step.LinkStep.Elimination;
import org.mechservice.solver.symbol.Expressions;
import org.mechservice.solver.symbol.Program;
import org.mechservice.solver.symbol.Scalar;
import org.mechservice.solver.symbol.ScalarMatrix;
import org.mechservice.solver.symbol.ScalarVector;

/**
 * The sweeps of which {@link StepKernel} has a method each, as programs: inputs and outputs are
 * numbers of the link's block, and of its parent's from {@link #PARENT} on.
 */
public enum StepSweep {
  MOTION("Motion: omega, alpha and a of the computing frame; the wrench that it takes.") {
    @Override
    void derive(Derivation d) {
      d.motion();
    }
  },
  INERTIA("I - U U' / D and p + U u / D for each degree of freedom, added to the parent.") {
    @Override
    void derive(Derivation d) {
      d.eliminate(true);
      d.passOn();
      d.clear();
    }
  },
  INERTIA_ON_ROOT("u / D of each degree of freedom.") {
    @Override
    void derive(Derivation d) {
      d.eliminate(false);
      d.clear();
    }
  },
  PASS("I and p, added to the parent.") {
    @Override
    void derive(Derivation d) {
      d.passOn();
      if (!d.kind.isJoint()) {
        d.clear();
      }
    }
  },
  ACCELERATION("q'' = u / D - k.A of each degree of freedom, A = X' A_p + q'' z.") {
    @Override
    void derive(Derivation d) {
      d.accelerate();
    }
  },
  CARRY("A = X' A_p.") {
    @Override
    void derive(Derivation d) {
      d.putAdded(d.step.fromParent(d.added(PARENT)));
    }
  },
  DRIVING("U.A + p.z - tau of each degree of freedom.") {
    @Override
    void derive(Derivation d) {
      d.drive();
      d.clear();
    }
  },
  FORCE("p.z - tau of each degree of freedom; p added to the parent.") {
    @Override
    void derive(Derivation d) {
      d.force();
      d.passWrench();
    }
  },
  FORCE_ON_ROOT("p.z - tau of each degree of freedom.") {
    @Override
    void derive(Derivation d) {
      d.force();
    }
  },
  PUSH("u / D of each degree of freedom, with its D and U / D; p added to the parent.") {
    @Override
    void derive(Derivation d) {
      d.push();
      d.passWrench();
    }
  },
  PUSH_ON_ROOT("u / D of each degree of freedom, with its D and U / D.") {
    @Override
    void derive(Derivation d) {
      d.push();
    }
  },
  COUPLE("kappa + K.z of each degree of freedom; K - (U / D) kappa as the parent feels it.") {
    @Override
    void derive(Derivation d) {
      d.transfer(d.couple());
    }
  },
  COUPLE_ON_ROOT("kappa + K.z of each degree of freedom.") {
    @Override
    void derive(Derivation d) {
      d.couple();
    }
  },
  TRANSFER("K as the parent feels it.") {
    @Override
    void derive(Derivation d) {
      d.transfer(d.carried());
    }
  };

  /** First input and output of the parent's block. */
  public static final int PARENT = 1000;

  private static final int[][] SYMMETRIC = {{0, 0}, {1, 1}, {2, 2}, {0, 1}, {0, 2}, {1, 2}};

  private final String title;

  StepSweep(String title) {
    this.title = title;
  }

  abstract void derive(Derivation derivation);

  /** Returns the name of its method. */
  public String method() {
    StringBuilder name = new StringBuilder();
    for (String word : name().split("_", -1)) {
      String lower = word.toLowerCase(Locale.ROOT);
      name.append(
          name.isEmpty() ? lower : Character.toUpperCase(lower.charAt(0)) + lower.substring(1));
    }
    return name.toString();
  }

  /** Derives the program for a kind of step. */
  public Program program(StepKind kind) {
    Program program = new Program();
    program.section(title, method());
    Derivation derivation = new Derivation(program, kind);
    derive(derivation);
    return program;
  }

  /** The equations of a step over numbers of its block. */
  private static final class Derivation implements JointTerms {
    private final Program program;
    private final Expressions expressions;
    private final StepKind kind;
    private final LinkNumbers numbers;
    private final LinkStep step;
    private ArticulatedInertia inertia;
    private Wrench wrench;

    Derivation(Program program, StepKind kind) {
      this.program = program;
      this.kind = kind;
      expressions = program.expressions();
      numbers = numbers();
      step = new LinkStep(expressions, numbers, this);
      int at = StepBlock.INERTIA;
      ArticulatedInertia beyond =
          new ArticulatedInertia(symmetric(at), matrix(at + 6), symmetric(at + 15));
      inertia = step.inertia().plus(beyond);
      program.named("J", inertia.rotational());
      program.named("H", inertia.coupling());
      program.named("M", inertia.translational());
      wrench = wrench(StepBlock.WRENCH);
      program.named("n", wrench.moment());
      program.named("f", wrench.force());
    }

    private LinkNumbers numbers() {
      if (!kind.isJoint()) {
        return LinkNumbers.ofTurn(kind.turnAxis(), expressions, expressions::input);
      }
      LinkNumbers all =
          LinkNumbers.of(kind.link(), kind.inverse(), expressions, expressions::input);
      program.named("E", all.axes());
      program.named("r", all.offset());
      program.named("m", all.body().mass());
      program.named("c", all.body().center());
      program.named("I", all.body().inertia());
      return kind.armed() ? all.armed(in("A", StepBlock.ARMATURE)) : all;
    }

    private Scalar in(String name, int at) {
      return program.named(name, expressions.input(at));
    }

    private ScalarVector vector(int at) {
      return new ScalarVector(
          expressions.input(at), expressions.input(at + 1), expressions.input(at + 2));
    }

    private ScalarMatrix matrix(int at) {
      return ScalarMatrix.of((i, j) -> expressions.input(at + 3 * i + j));
    }

    private ScalarMatrix symmetric(int at) {
      return ScalarMatrix.of((i, j) -> expressions.input(at + (i == j ? i : i + j + 2)));
    }

    private Wrench wrench(int at) {
      return new Wrench(vector(at), vector(at + 3));
    }

    Added added(int block) {
      return new Added(vector(block + StepBlock.ADDED), vector(block + StepBlock.ADDED + 3));
    }

    /** Outputs what is not the same for all links. */
    private void put(int at, ScalarVector value) {
      for (int i = 0; i < 3; i++) {
        if (!value.at(i).isConstant()) {
          program.output(at + i, value.at(i));
        }
      }
    }

    /** Adds to a number of the parent's block. */
    private void add(int at, Scalar value) {
      if (!value.isZero()) {
        program.output(PARENT + at, expressions.input(PARENT + at).plus(value));
      }
    }

    void motion() {
      int of = PARENT + StepBlock.MOTION;
      Motion parent =
          new Motion(
              program.named("omega_p", vector(of)),
              program.named("alpha_p", vector(of + 3)),
              program.named("a_p", vector(of + 6)));
      Motion motion = step.motion(parent, program.named("W_p", parent.spread()));
      ScalarMatrix spread = motion.spread();
      put(StepBlock.MOTION, program.named("omega", motion.omega()));
      put(StepBlock.MOTION + 3, program.named("alpha", motion.alpha()));
      put(StepBlock.MOTION + 6, program.named("a", motion.acceleration()));
      if (!kind.isJoint()) {
        // it has no mass, and no load acts on it
        for (int k = 0; k < 6; k++) {
          program.output(StepBlock.WRENCH + k, expressions.zero());
        }
        return;
      }
      program.named("W", spread);
      ScalarVector force = step.inertiaForce(motion, spread);
      ScalarVector moment = step.inertiaMoment(motion, spread, force);
      Wrench load = wrench(StepBlock.LOAD);
      put(StepBlock.WRENCH, moment.minus(load.moment()));
      put(StepBlock.WRENCH + 3, force.minus(load.force()));
    }

    void eliminate(boolean passedOn) {
      List<DegreeOfFreedom> freedoms = step.freedoms();
      for (int k = 0; k < freedoms.size(); k++) {
        String label = freedoms.size() == 1 ? "" : "_" + "xyz".charAt(k);
        boolean needed = passedOn || k + 1 < freedoms.size();
        DegreeOfFreedom freedom = freedoms.get(k);
        Elimination of = step.eliminate(freedom, inertia, wrench, tau(k), needed);
        int at = StepBlock.freedom(k);
        program.output(at, program.named("D" + label, of.pivot()));
        program.named("one_over_D" + label, of.reciprocal());
        program.output(at + 1, program.named("u_over_D" + label, of.rate()));
        put(at + 2, program.named("kn" + label, of.share().moment()));
        put(at + 5, program.named("kf" + label, of.share().force()));
        inertia = of.inertia();
        wrench = of.wrench();
      }
    }

    /** Leaves the inertia of the links beyond as zero. */
    void clear() {
      for (int k = 0; k < StepBlock.INERTIA_COUNT; k++) {
        program.output(StepBlock.INERTIA + k, expressions.zero());
      }
    }

    private Scalar tau(int k) {
      return isBall()
          ? in("tau_" + "xyz".charAt(k), StepBlock.BALL_TAU + k)
          : in("tau", StepBlock.TAU);
    }

    private boolean isBall() {
      return kind.link() == LinkKind.BALL;
    }

    void passOn() {
      ArticulatedInertia seen = step.toParent(inertia);
      int at = StepBlock.INERTIA;
      for (int k = 0; k < 6; k++) {
        int[] element = SYMMETRIC[k];
        add(at + k, seen.rotational().at(element[0], element[1]));
      }
      for (int k = 0; k < 9; k++) {
        add(at + 6 + k, seen.coupling().at(k / 3, k % 3));
      }
      for (int k = 0; k < 6; k++) {
        int[] element = SYMMETRIC[k];
        add(at + 15 + k, seen.translational().at(element[0], element[1]));
      }
      passWrench();
    }

    void passWrench() {
      Wrench seen = step.toParent(wrench);
      for (int k = 0; k < 3; k++) {
        add(StepBlock.WRENCH + k, seen.moment().at(k));
        add(StepBlock.WRENCH + 3 + k, seen.force().at(k));
      }
    }

    void push() {
      List<DegreeOfFreedom> freedoms = step.freedoms();
      for (int k = 0; k < freedoms.size(); k++) {
        DegreeOfFreedom freedom = freedoms.get(k);
        int at = StepBlock.freedom(k);
        LinkStep.Pushed of =
            LinkStep.push(freedom, expressions.input(at), share(freedom, at), wrench, tau(k));
        program.output(at + 1, of.rate());
        wrench = of.rest();
      }
    }

    private Wrench share(DegreeOfFreedom freedom, int at) {
      return freedom.with(wrench(at + 2), expressions.one());
    }

    Wrench carried() {
      Wrench carried = wrench(PARENT + CarriedWrench.BEFORE);
      program.named("Kn", carried.moment());
      program.named("Kf", carried.force());
      return carried;
    }

    Wrench couple() {
      Wrench carried = carried();
      List<DegreeOfFreedom> freedoms = step.freedoms();
      for (int k = 0; k < freedoms.size(); k++) {
        int along = PARENT + CarriedWrench.ALONG + k;
        DegreeOfFreedom freedom = freedoms.get(k);
        LinkStep.Coupled of =
            LinkStep.couple(
                freedom, share(freedom, StepBlock.freedom(k)), carried, expressions.input(along));
        program.output(along, of.along());
        carried = of.rest();
      }
      return carried;
    }

    void transfer(Wrench carried) {
      Wrench seen = step.toParent(carried);
      put(PARENT + CarriedWrench.AFTER, seen.moment());
      put(PARENT + CarriedWrench.AFTER + 3, seen.force());
    }

    void accelerate() {
      Added a = step.fromParent(added(PARENT));
      List<DegreeOfFreedom> freedoms = step.freedoms();
      List<Scalar> rates = new ArrayList<>();
      for (int k = freedoms.size() - 1; k >= 0; k--) {
        DegreeOfFreedom freedom = freedoms.get(k);
        int at = StepBlock.freedom(k);
        Scalar rate = LinkStep.rate(expressions.input(at + 1), share(freedom, at), a);
        rates.add(0, rate);
        a = LinkStep.after(freedom, a, rate);
      }
      putAdded(a);
      putResult(rates);
    }

    void putAdded(Added a) {
      put(StepBlock.ADDED, program.named("dalpha", a.alpha()));
      put(StepBlock.ADDED + 3, program.named("da", a.acceleration()));
    }

    /** Outputs one number per degree of freedom, for a ball in the form of the state. */
    private void putResult(List<Scalar> along) {
      if (along.size() == 3) {
        put(
            StepBlock.BALL_RESULT,
            step.ballToState(new ScalarVector(along.get(0), along.get(1), along.get(2))));
      } else if (!along.isEmpty()) {
        program.output(StepBlock.RESULT, along.get(0));
      }
    }

    void drive() {
      List<Scalar> forces = new ArrayList<>();
      List<DegreeOfFreedom> freedoms = step.freedoms();
      for (int k = 0; k < freedoms.size(); k++) {
        DegreeOfFreedom freedom = freedoms.get(k);
        Scalar taken = added(0).dot(inertia.along(freedom));
        Scalar force = taken.plus(freedom.along(wrench)).minus(tau(k));
        forces.add(force.plus(step.armatureForce(freedom)));
      }
      putResult(forces);
    }

    void force() {
      List<Scalar> forces = new ArrayList<>();
      List<DegreeOfFreedom> freedoms = step.freedoms();
      for (int k = 0; k < freedoms.size(); k++) {
        DegreeOfFreedom freedom = freedoms.get(k);
        Scalar force = freedom.along(wrench).minus(tau(k));
        forces.add(force.plus(step.armatureForce(freedom)));
      }
      putResult(forces);
    }

    @Override
    public Scalar cosine() {
      return in("cos", StepBlock.COSINE);
    }

    @Override
    public Scalar sine() {
      return in("sin", StepBlock.SINE);
    }

    @Override
    public Scalar way() {
      return in("q", StepBlock.POSITION).times(numbers.way());
    }

    @Override
    public Scalar wayRate() {
      return velocity().times(numbers.way());
    }

    @Override
    public Scalar velocity() {
      return in("v", StepBlock.VELOCITY);
    }

    @Override
    public Scalar knownAcceleration() {
      return expressions.input(StepBlock.KNOWN);
    }

    @Override
    public ScalarMatrix ballRotation() {
      return program.named("R", matrix(StepBlock.ROTATION));
    }

    @Override
    public ScalarVector ballVelocity() {
      return program.named("v", vector(StepBlock.BALL_VELOCITY));
    }

    @Override
    public ScalarVector knownBallAcceleration() {
      return vector(StepBlock.BALL_KNOWN);
    }
  }
}
