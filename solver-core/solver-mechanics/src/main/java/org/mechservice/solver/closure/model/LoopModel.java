package org.mechservice.solver.closure.model;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.mechservice.solver.api.ModelDescription;
import org.mechservice.solver.api.capability.BodyPoses;
import org.mechservice.solver.api.capability.Defects;
import org.mechservice.solver.api.capability.Energies;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.capability.PowerInput;
import org.mechservice.solver.api.capability.StateJumps;
import org.mechservice.solver.api.run.Failure;
import org.mechservice.solver.api.run.RunNotes;
import org.mechservice.solver.closure.ClosedMechanism;
import org.mechservice.solver.closure.ClosedTree;
import org.mechservice.solver.closure.LoopProjection;
import org.mechservice.solver.closure.PrescribedMotions;
import org.mechservice.solver.closure.Reactions;
import org.mechservice.solver.closure.assembly.LoopFinding;
import org.mechservice.solver.closure.assembly.LoopFinding.Kind;
import org.mechservice.solver.force.formula.FormulaCheck;
import org.mechservice.solver.force.formula.SampleStates;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.mechanism.Body;

/** Common part of all models of closed loops. */
public abstract class LoopModel
    implements ExplicitModel, Energies, PowerInput, BodyPoses, Defects, RunNotes, StateJumps {
  /** Largest number of notes of one kind; a wheel that turns for a long time causes many. */
  private static final int MOST_NOTES = 50;

  public final ClosedMechanism closed;
  public final ClosedTree work;
  private final List<Note> notes = new ArrayList<>();
  private final Map<Kind, Integer> noted = new EnumMap<>(Kind.class);
  private final double[] derivative;

  /** Whether a drive or a constraint of time moves the mechanism. */
  final boolean movedByTime;

  private Optional<Reactions> reactions = Optional.empty();
  private Optional<LoopProjection> afterJumps = Optional.empty();
  private Optional<Defect> defect = Optional.empty();

  public LoopModel(ClosedMechanism closed, UserForceSource userForces) {
    if (!closed.start().isAssembled()) {
      throw new IllegalArgumentException(
          "the loops of " + closed.description().name() + " are not closed at the start");
    }
    this.closed = closed;
    work = closed.newEquations(userForces);
    derivative = new double[work.stateCount];
    movedByTime = closed.isMovedByTime();
    closed.start().findings().forEach(this::note);
  }

  @Override
  public final ModelDescription description() {
    return closed.description();
  }

  @Override
  public final boolean hasUserClasses() {
    return closed.tree().mechanism().hasUserClasses();
  }

  @Override
  public void initialState(double[] y) {
    System.arraycopy(closed.start().state(), 0, y, 0, closed.start().state().length);
  }

  /** Adds a note, up to {@link #MOST_NOTES} of each kind. */
  final void note(LoopFinding finding) {
    if (noted.merge(finding.kind(), 1, Integer::sum) <= MOST_NOTES) {
      notes.add(finding.note());
    }
  }

  /** Adds a note. */
  final void note(Note note) {
    notes.add(note);
  }

  /** {@inheritDoc} The last note gives the number of omitted notes. */
  @Override
  public final List<Note> notes() {
    List<Note> all = new ArrayList<>(notes);
    noted.forEach(
        (kind, count) -> {
          if (count > MOST_NOTES) {
            double last = notes.get(notes.size() - 1).time();
            String text = count - MOST_NOTES + " more notes of this kind are left out.";
            all.add(new Note(kind.code(), last, false, text));
          }
        });
    return all;
  }

  /** Stores why an evaluation fails; returns its result code. */
  final int fail(Defect why) {
    defect = Optional.of(why);
    return DEFECT;
  }

  @Override
  public final Optional<Defect> withoutValue(
      double t, double[] y, double[] yDot, List<Failure.Step> tried) {
    return FormulaCheck.of(work.motion)
        .flatMap(
            check ->
                SampleStates.search(
                    check.lines(),
                    (time, state) -> {
                      work.placeData(time, state);
                      return check.values(time);
                    },
                    t,
                    y,
                    yDot,
                    tried))
        .or(() -> PrescribedMotions.breakOff(work, t, y, tried));
  }

  @Override
  public final Defect lastDefect() {
    return defect.orElseThrow(() -> new IllegalStateException("no evaluation has failed"));
  }

  @Override
  public final boolean jump(double t, double[] y, boolean[] set) {
    boolean[] positionSet = new boolean[work.nv];
    work.coordinates.velocitiesOf(set, positionSet);
    boolean[] velocitySet = Arrays.copyOfRange(set, work.nq, work.nq + work.nv);
    if (afterJumps.isEmpty()) {
      afterJumps = Optional.of(LoopProjection.holding(work));
    }
    boolean closed = afterJumps.get().jump(t, y, positionSet, velocitySet);
    work.place(t, y);
    jumped(t, y, closed);
    return closed;
  }

  /** Records the placed state after a jump. */
  abstract void jumped(double t, double[] y, boolean closed);

  /**
   * Evaluates multipliers and reactions, which {@link #reactions} returns.
   *
   * @param y state that closes the loops; not modified
   * @return as {@link #derivative}
   */
  public final int react(double t, double[] y) {
    int moved = derivative(t, y, derivative);
    if (moved != REGULAR) {
      return moved;
    }
    return reactions().evaluate(t, y, derivative, work.nq) ? REGULAR : fail(reactions().defect());
  }

  /** Returns the multipliers and reactions of the last {@link #react}. */
  public final Reactions reactions() {
    if (reactions.isEmpty()) {
      reactions = Optional.of(new Reactions(work.ofData(), closed.start().rank()));
    }
    return reactions.get();
  }

  @Override
  public final void energy(double t, double[] y, double[] energy) {
    work.energy(t, y, energy);
  }

  /** {@inheritDoc} NaN where the accelerations or a force have no value. */
  @Override
  public final void power(double t, double[] y, double[] power) {
    work.power(t, y, power);
    if (movedByTime) {
      if (react(t, y) == REGULAR) {
        reactions().addPower(power);
      } else {
        Arrays.fill(power, Double.NaN);
      }
    }
  }

  @Override
  public final List<String> bodies() {
    return work.tree.mechanism().bodies().stream().map(Body::name).toList();
  }

  @Override
  public final void poses(double t, double[] y, double[] poses) {
    work.poses(t, y, poses);
  }
}
