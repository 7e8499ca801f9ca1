package org.mechservice.solver.dynamics.event;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Expression.ClosestStation;
import org.mechservice.solver.expression.Expression.CoordinateVelocity;
import org.mechservice.solver.expression.Expression.PointPosition;
import org.mechservice.solver.expression.Expression.PointVelocity;
import org.mechservice.solver.expression.Expression.RelativeMotion;
import org.mechservice.solver.expression.JointCoordinate;
import org.mechservice.solver.expression.Tape;
import org.mechservice.solver.expression.TapeListing;
import org.mechservice.solver.expression.TapePieces;
import org.mechservice.solver.mechanism.Event;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.Overlap;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.symbol.MathFunction;

/**
 * What a run watches in its steps, as formulas: the tape of the watched formulas of forces, states,
 * drives and couplings and of the events, and the quantities from which it is evaluated along a
 * step.
 *
 * <p>The quantities are the leaves of the tape, and after them the rates of all angles that turn
 * the bodies of those leaves: a step is looked at in parts in which these turn little.
 */
public final class WatchedTape {
  private final Tape tape;
  private final int formulas;
  private final List<Expression> quantities;

  /** Number of quantities that the search needs; those behind are of the overlaps alone. */
  private final int searched;

  private final List<int[]> turns;
  private final List<Overlap> overlaps;

  private WatchedTape(
      Tape tape,
      int formulas,
      List<Expression> quantities,
      int searched,
      List<int[]> turns,
      List<Overlap> overlaps) {
    this.tape = tape;
    this.formulas = formulas;
    this.quantities = List.copyOf(quantities);
    this.searched = searched;
    this.turns = List.copyOf(turns);
    this.overlaps = overlaps;
  }

  /** Derives what a mechanism has to watch. */
  public static WatchedTape of(Mechanism mechanism) {
    List<Expression> results = new ArrayList<>(mechanism.watchedFormulas());
    int formulas = results.size();
    for (Event event : mechanism.events()) {
      results.add(Expression.call(MathFunction.STEP, List.of(event.trigger())));
    }
    Tape tape = new Tape(results);
    List<Expression> quantities = new ArrayList<>(tape.leaves());
    Set<List<Expression>> paths = new LinkedHashSet<>();
    for (Expression leaf : tape.leaves()) {
      paths.add(turnsOf(leaf, mechanism));
    }
    List<int[]> turns = new ArrayList<>();
    int first = quantities.size();
    List<Expression> rates = new ArrayList<>();
    for (List<Expression> path : paths) {
      for (Expression rate : path) {
        if (!rates.contains(rate)) {
          rates.add(rate);
        }
      }
      if (!path.isEmpty()) {
        turns.add(path.stream().mapToInt(rate -> first + rates.indexOf(rate)).toArray());
      }
    }
    quantities.addAll(rates);
    int searched = quantities.size();
    List<Overlap> overlaps = mechanism.overlaps();
    for (Expression leaf : OverlapMonitor.tape(overlaps).leaves()) {
      if (!quantities.contains(leaf)) {
        quantities.add(leaf);
      }
    }
    return new WatchedTape(tape, formulas, quantities, searched, turns, overlaps);
  }

  /** Returns the rates of the angles that turn the bodies of a leaf, relative to each other. */
  private static List<Expression> turnsOf(Expression leaf, Mechanism mechanism) {
    if (leaf instanceof PointPosition point) {
      return turns(path(point.point().body(), mechanism), mechanism);
    } else if (leaf instanceof PointVelocity point) {
      return turns(path(point.point().body(), mechanism), mechanism);
    } else if (leaf instanceof ClosestStation closest) {
      return turnsOf(closest.along(), mechanism);
    } else if (leaf instanceof RelativeMotion relative) {
      Set<Integer> one = path(relative.frame1().body(), mechanism);
      Set<Integer> other = path(relative.frame2().body(), mechanism);
      Set<Integer> both = new LinkedHashSet<>(one);
      both.retainAll(other);
      one.addAll(other);
      one.removeAll(both);
      return turns(one, mechanism);
    }
    return List.of();
  }

  /** Returns the joints between a body and the root. */
  private static Set<Integer> path(int body, Mechanism mechanism) {
    Set<Integer> joints = new LinkedHashSet<>();
    for (int b = body; b != BodyPoint.ROOT; ) {
      int joint = mechanism.jointOf(b);
      joints.add(joint);
      b = mechanism.joints().get(joint).attachment().parent();
    }
    return joints;
  }

  private static List<Expression> turns(Set<Integer> joints, Mechanism mechanism) {
    List<Expression> rates = new ArrayList<>();
    for (int j : joints) {
      Joint joint = mechanism.joints().get(j);
      for (int k = 0; k < joint.type().velocityCount(); k++) {
        if (joint.type().velocityUnit(k).equals("rad/s")) {
          rates.add(new CoordinateVelocity(new JointCoordinate(j, k)));
        }
      }
    }
    return rates;
  }

  /** Returns whether there is nothing to watch. */
  public boolean isEmpty() {
    return tape.resultCount() == 0;
  }

  /** Returns the tape: the watched formulas, then a step of each event's expression. */
  Tape tape() {
    return tape;
  }

  /** Returns the number of watched formulas that are not those of events. */
  int formulaCount() {
    return formulas;
  }

  /**
   * Returns the quantities from which the tape is evaluated: its leaves, rates of angles, and more.
   */
  public List<Expression> quantities() {
    return quantities;
  }

  /** Returns those of the quantities that the search of steps needs: the leaves, then the rates. */
  public List<Expression> searchedQuantities() {
    return quantities.subList(0, searched);
  }

  /** Returns the tape and its choices as lists. */
  public TapeListing listing() {
    return new TapePieces(tape, formulas).listing();
  }

  /** Returns how far shapes are inside each other, of quantities. */
  List<Overlap> overlaps() {
    return overlaps;
  }

  /** Returns groups of rates, rad/s, as indices of quantities: one for each path between bodies. */
  public List<int[]> turns() {
    return turns;
  }
}
