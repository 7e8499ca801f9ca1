package org.mechservice.solver.dynamics.event;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.mechservice.solver.api.capability.ModelEvents;
import org.mechservice.solver.api.capability.ModelState;
import org.mechservice.solver.api.run.RunNotes.Note;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.mechanism.Event;
import org.mechservice.solver.mechanism.FurtherChange;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.MotionJump;
import org.mechservice.solver.mechanism.Sampling;
import org.mechservice.solver.mechanism.StateChange;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.spatial.EulerParameters;

/** The events of a mechanism, evaluated in its motion, for all formulations. */
public final class StateEvents implements ModelEvents, ModelState {
  private static final int EULER_PARAMETERS = 4;

  private final Mechanism mechanism;
  private final List<Kind> kinds;
  private final TreeMotion motion;
  private final List<Assignment> assignments;
  private final WrittenValues expressions;
  private final double[] assigned;
  private final SampleTimes samples;
  private final int triggerCount;
  private final int ownCount;
  private final Optional<StepSearch> search;
  private Optional<DrivenJumps> driven = Optional.empty();

  /**
   * Prepares the events of a mechanism.
   *
   * @param code generated code for their expressions, if any
   * @throws IllegalArgumentException if an expression refers to an element that the mechanism does
   *     not have
   */
  public StateEvents(Mechanism mechanism, Optional<WrittenValues> code) {
    this.mechanism = mechanism;
    List<Event> events = mechanism.events();
    kinds = events.stream().map(e -> new Kind(e.name(), e.direction(), e.action())).toList();
    motion = new TreeMotion(new TreeGeometry(mechanism));
    assignments = assignments(mechanism);
    assigned = new double[assignments.size()];
    samples = new SampleTimes(mechanism.samplings());
    triggerCount = events.size();
    ownCount = triggerCount + mechanism.samplings().size();
    WatchedTape watched = WatchedTape.of(mechanism);
    expressions =
        code.orElseGet(
            () ->
                new EventExpressions(
                    motion,
                    events.stream().map(Event::trigger).toList(),
                    assigned(mechanism),
                    watched.quantities()));
    search =
        watched.isEmpty()
            ? Optional.empty()
            : Optional.of(new StepSearch(watched, expressions::watched));
  }

  /** Prepares the events of a mechanism, their expressions evaluated in its motion. */
  public StateEvents(Mechanism mechanism) {
    this(mechanism, Optional.empty());
  }

  /**
   * Returns the expressions that the events of a mechanism assign, in the order used everywhere.
   */
  public static List<Expression> assigned(Mechanism mechanism) {
    return assignments(mechanism).stream().map(Assignment::value).toList();
  }

  /** Returns event and component of the state of each expression of {@link #assigned}. */
  public static List<int[]> assignedComponents(Mechanism mechanism) {
    return assignments(mechanism).stream()
        .map(one -> new int[] {one.event(), one.component()})
        .toList();
  }

  private static List<Assignment> assignments(Mechanism mechanism) {
    List<Assignment> all = new ArrayList<>();
    List<Event> events = mechanism.events();
    for (int i = 0; i < events.size(); i++) {
      for (StateChange change : events.get(i).changes()) {
        int q = mechanism.positionOffset(change.joint());
        int v = mechanism.positionCount() + mechanism.velocityOffset(change.joint());
        assign(i, q, change.positions(), all);
        assign(i, v, change.velocities(), all);
      }
      assignFurther(i, events.get(i).furtherChanges(), mechanism.furtherOffset(), all);
    }
    List<Sampling> samplings = mechanism.samplings();
    for (int i = 0; i < samplings.size(); i++) {
      List<FurtherChange> changes = samplings.get(i).changes();
      assignFurther(events.size() + i, changes, mechanism.furtherOffset(), all);
    }
    return all;
  }

  private static void assignFurther(
      int event, List<FurtherChange> changes, int offset, List<Assignment> all) {
    for (FurtherChange change : changes) {
      all.add(new Assignment(event, offset + change.state(), change.value()));
    }
  }

  private static void assign(
      int event, int at, List<Expression> expressions, List<Assignment> all) {
    for (int k = 0; k < expressions.size(); k++) {
      all.add(new Assignment(event, at + k, expressions.get(k)));
    }
  }

  /** A component of the state that takes the value of an expression. */
  private record Assignment(int event, int component, Expression value) {}

  @Override
  public List<Kind> kinds() {
    List<Kind> all = new ArrayList<>(kinds);
    all.addAll(samples.kinds());
    driven.ifPresent(jumps -> all.addAll(jumps.kinds()));
    return all;
  }

  @Override
  public void values(double t, double[] y, double[] g) {
    expressions.triggers(t, y, g);
    samples.values(t, g, triggerCount);
    if (driven.isPresent()) {
      driven.get().values(t, g, ownCount);
    }
  }

  @Override
  public boolean watches() {
    return search.isPresent();
  }

  @Override
  public double seenUntil(double from, double to, Path path) {
    return search.isPresent() ? search.get().search(from, to, path) : Double.NaN;
  }

  @Override
  public boolean moveAcross(double t, double[] y, double[] yDot, double[] behind) {
    return search.isPresent() && search.get().moveAcross(t, y, yDot, behind);
  }

  @Override
  public double slidingSince() {
    return search.isPresent() ? search.get().slidingSince() : Double.NaN;
  }

  @Override
  public double longestFirstStep() {
    return search.isPresent() ? search.get().longestFirstStep() : Double.POSITIVE_INFINITY;
  }

  @Override
  public List<Note> notes() {
    return search.map(StepSearch::notes).orElse(List.of());
  }

  @Override
  public int stateLength() {
    return search.isPresent() ? search.get().stateLength() : 0;
  }

  @Override
  public void saveState(double[] state) {
    search.ifPresent(steps -> steps.save(state));
  }

  @Override
  public void restoreState(double[] state) {
    search.ifPresent(steps -> steps.restore(state));
  }

  @Override
  public boolean begin(double t, double[] y) {
    boolean[] due = new boolean[kinds().size()];
    samples.mark(t, due, triggerCount);
    boolean any = false;
    for (boolean one : due) {
      any |= one;
    }
    if (any) {
      assign(due, t, y);
    }
    return any;
  }

  @Override
  public void change(boolean[] occurred, double t, double[] y) {
    if (driven.isPresent()) {
      driven.get().change(occurred, ownCount, t, y);
    }
    assign(occurred, t, y);
    normalize(y);
  }

  private void assign(boolean[] occurred, double t, double[] y) {
    expressions.assignments(t, y, assigned);
    for (int i = 0; i < assignments.size(); i++) {
      if (occurred[assignments.get(i).event()]) {
        y[assignments.get(i).component()] = assigned[i];
      }
    }
  }

  /** Normalises Euler parameters; the values of expressions need not have norm one. */
  private void normalize(double[] y) {
    for (int j = 0; j < mechanism.joints().size(); j++) {
      Joint joint = mechanism.joints().get(j);
      if (joint.type().hasEulerParameters() && !mechanism.isDriven(j)) {
        int at = mechanism.positionOffset(j);
        double norm = EulerParameters.norm(y, at);
        for (int k = at; k < at + EULER_PARAMETERS; k++) {
          y[k] /= norm;
        }
      }
    }
  }

  @Override
  public boolean changes(int event, int component) {
    return assignments.stream().anyMatch(a -> a.event() == event && a.component() == component);
  }

  @Override
  public double evaluationTime(double t) {
    return driven.isPresent() ? driven.get().evaluationTime(t) : t;
  }

  @Override
  public void continueFrom(double t) {
    driven.ifPresent(jumps -> jumps.continueFrom(t));
    search.ifPresent(StepSearch::begin);
  }

  @Override
  public double after(boolean[] occurred, double t) {
    return driven.isPresent() ? driven.get().after(occurred, ownCount, t) : t;
  }

  @Override
  public List<Double> begin(double from, double to) {
    List<MotionJump> jumps = mechanism.motionJumps(from, to);
    driven = jumps.isEmpty() ? Optional.empty() : Optional.of(new DrivenJumps(motion, jumps));
    List<Double> times = new ArrayList<>();
    for (double time : mechanism.timeJumps(from, to)) {
      if (evaluationTime(time) == time) {
        times.add(time);
      }
    }
    jumps.forEach(jump -> times.add(jump.time()));
    times.addAll(samples.between(from, to));
    return times;
  }
}
