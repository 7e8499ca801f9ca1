package org.mechservice.study.gradient;

import java.util.Arrays;
import java.util.List;
import org.mechservice.study.gradient.GradientModel.Part;

/**
 * One of the places at which the state, its derivative or the derivative of that jumps: an event of
 * the file, or a switch of the equations. With g its function, h the change of the state and f⁻, f⁺
 * the derivatives before and behind, a tangent δy becomes
 *
 * <pre>{@code
 * h_y (δy + f⁻ δt) + h_t δt + h_p − f⁺ δt,   δt = −(g_y δy + g_p) / (g_t + g_y f⁻)
 * }</pre>
 *
 * <p>at the same time (Galán, Feehery and Barton 1999, equations 24 and 30). At a corner of the
 * equations f⁻ = f⁺, and tangents go on as they are; they need not cross it.
 */
final class Transition {
  /** Rate of the function, relative to the sizes of its terms, from which it is crossed. */
  private static final double GRAZING = 1e-9;

  /** First distance from a switch at which its sides are looked at, as a part of the time. */
  private static final double LITTLE = 1e-10;

  private static final int TRIES = 20;

  private final GradientModel model;
  private final Part part;
  private final int index;
  private final boolean corner;
  private final String name;

  /** Components of the state that the event sets, and where their values stand. */
  private final int[] assigned;

  private final int firstValue;

  /**
   * @param part triggers or switches
   * @param index which of them
   */
  Transition(GradientModel model, Part part, int index, String name) {
    this.model = model;
    this.part = part;
    this.index = index;
    corner = part == Part.SWITCHES && model.functions.isCorner(index);
    this.name = name;
    List<int[]> components = model.functions.assignedComponents();
    int first = 0;
    for (int e = 0; part == Part.TRIGGERS && e < index; e++) {
      first += components.get(e).length;
    }
    firstValue = first;
    assigned = part == Part.TRIGGERS ? components.get(index) : new int[0];
  }

  /** Returns the value of its function. */
  double value(double t, double[] y) {
    return model.values(part, t, y)[index];
  }

  /** Returns whether the equations take another form there. */
  boolean isSwitch() {
    return part == Part.SWITCHES;
  }

  /** Returns whether the state and its derivative are continuous there. */
  boolean isCorner() {
    return corner;
  }

  /**
   * Both sides of the transition.
   *
   * @param before state before, n numbers
   * @param after state behind
   * @param rateBefore f⁻
   * @param rateAfter f⁺
   * @param speed g_t + g_y f⁻; NaN at a corner that is only touched
   * @param inside a state on the near side: that before an event, or one close before a switch,
   *     whose equations still have their form of before
   * @param insideTime its time, s: between it and the transition the form may be either
   * @param outside a state on the far side: that behind an event, or one close behind a switch
   * @param outsideTime its time, s
   */
  @SuppressWarnings("ArrayRecordComponent") // never compared
  record Sides(
      double[] before,
      double[] after,
      double[] rateBefore,
      double[] rateAfter,
      double speed,
      double[] inside,
      double insideTime,
      double[] outside,
      double outsideTime) {}

  /**
   * Returns both sides.
   *
   * @param y state before the change, at the place where the function is zero or just behind it
   * @throws IllegalArgumentException if something jumps, and the function only touches zero: the
   *     time of the event is no differentiable function then
   */
  Sides sides(double t, double[] y) {
    int n = model.n;
    double[] before = Arrays.copyOf(y, n);
    double[] after = before.clone();
    double[] rateBefore = new double[n];
    double[] rateAfter = new double[n];
    double[] inside = before;
    double insideTime = t;
    double[] outside = after;
    double outsideTime = t;
    if (part == Part.TRIGGERS) {
      double[] values = Part.ASSIGNMENTS.of(model.functions).values(t, before);
      for (int i = 0; i < assigned.length; i++) {
        after[assigned[i]] = values[firstValue + i];
      }
      model.derivative(t, before, rateBefore);
      model.derivative(t, after, rateAfter);
    } else {
      double sign = rateBehind(t, before, rateAfter);
      outside = new double[n];
      outsideTime = stepAhead(t, before, sign, rateAfter, outside);
      inside = new double[n];
      insideTime = stepBack(t, before, sign, rateAfter, rateBefore, inside);
      if (corner) {
        model.derivative(t, before, rateAfter);
        System.arraycopy(rateAfter, 0, rateBefore, 0, n);
      }
    }
    double speed = model.along(part, t, before, rateBefore, 1, -1)[index];
    double size = 0;
    for (int i = 0; i < n; i++) {
      double[] one = new double[n];
      one[i] = rateBefore[i];
      size += Math.abs(model.along(part, t, before, one, 0, -1)[index]);
    }
    if (!(Math.abs(speed) > GRAZING * size) || speed == 0 || Double.isNaN(insideTime)) {
      if (!corner) {
        throw new IllegalArgumentException(
            name
                + " is only touched at t = "
                + t
                + " s, not crossed: its time has no derivative there");
      }
      speed = Double.NaN;
    }
    if (Double.isNaN(insideTime)) {
      inside = before;
      insideTime = t;
    }
    return new Sides(
        before, after, rateBefore, rateAfter, speed, inside, insideTime, outside, outsideTime);
  }

  /**
   * Evaluates f behind a switch. Where its function is exactly zero, f may still have the form of
   * before: it is extrapolated from two states on the way on then.
   *
   * @param rateAfter overwritten
   * @return sign of the function behind the switch
   */
  private double rateBehind(double t, double[] at, double[] rateAfter) {
    int n = model.n;
    model.derivative(t, at, rateAfter);
    double sign = Math.signum(value(t, at));
    double[] near = new double[n];
    double[] far = new double[n];
    double[] rateFar = new double[n];
    double ahead = LITTLE * Math.max(1e-3, Math.abs(t));
    for (int tries = 0; tries < TRIES && sign == 0; tries++) {
      for (int i = 0; i < n; i++) {
        near[i] = at[i] + ahead * rateAfter[i];
        far[i] = at[i] + 2 * ahead * rateAfter[i];
      }
      sign = Math.signum(value(t + ahead, near));
      if (sign != 0) {
        model.derivative(t + ahead, near, rateAfter);
        model.derivative(t + 2 * ahead, far, rateFar);
        for (int i = 0; i < n; i++) {
          rateAfter[i] = 2 * rateAfter[i] - rateFar[i];
        }
      }
      ahead *= 4;
    }
    return sign;
  }

  /**
   * Goes on from a switch until its function has left zero.
   *
   * @param sign of the function behind the switch
   * @param near overwritten with the state there, or with that at the switch
   * @return its time
   */
  private double stepAhead(double t, double[] at, double sign, double[] rateAfter, double[] near) {
    double ahead = LITTLE * Math.max(1e-3, Math.abs(t));
    for (int tries = 0; tries < TRIES; tries++) {
      for (int i = 0; i < near.length; i++) {
        near[i] = at[i] + ahead * rateAfter[i];
      }
      if (Math.signum(value(t + ahead, near)) == sign) {
        return t + ahead;
      }
      ahead *= 4;
    }
    System.arraycopy(at, 0, near, 0, near.length);
    return t;
  }

  /**
   * Evaluates f before a switch, extrapolated from two states on the way to it.
   *
   * @param sign of the function behind the switch
   * @param near overwritten with the nearer state
   * @return its time; NaN if the function has had the same sign before
   */
  private double stepBack(
      double t, double[] at, double sign, double[] rateAfter, double[] rateBefore, double[] near) {
    int n = model.n;
    double[] far = new double[n];
    double[] rateFar = new double[n];
    double back = LITTLE * Math.max(1e-3, Math.abs(t));
    System.arraycopy(rateAfter, 0, rateBefore, 0, n);
    for (int tries = 0; tries < TRIES; tries++) {
      for (int i = 0; i < n; i++) {
        near[i] = at[i] - back * rateBefore[i];
        far[i] = at[i] - 2 * back * rateBefore[i];
      }
      if (Math.signum(value(t - back, near)) != sign) {
        model.derivative(t - back, near, rateBefore);
        model.derivative(t - 2 * back, far, rateFar);
        for (int i = 0; i < n; i++) {
          rateBefore[i] = 2 * rateBefore[i] - rateFar[i];
        }
        return t - back;
      }
      back *= 4;
    }
    return Double.NaN;
  }

  /**
   * Returns the derivative of the time of the transition along a direction.
   *
   * @param tangent of the state before, n numbers
   */
  double timeRate(double t, Sides sides, double[] tangent, int direction) {
    return -model.along(part, t, sides.before(), tangent, 0, direction)[index] / sides.speed();
  }

  /**
   * Carries a tangent across.
   *
   * @param tangent before at entry, behind at return
   * @param dt derivative of the time along it
   */
  void carry(double t, Sides sides, double[] tangent, double dt, int direction) {
    if (corner) {
      return;
    }
    int n = model.n;
    double[] moved = new double[n];
    for (int i = 0; i < n; i++) {
      moved[i] = tangent[i] + sides.rateBefore()[i] * dt;
    }
    double[] set =
        assigned.length == 0
            ? new double[0]
            : model.along(Part.ASSIGNMENTS, t, sides.before(), moved, dt, direction);
    for (int i = 0; i < assigned.length; i++) {
      moved[assigned[i]] = set[firstValue + i];
    }
    for (int i = 0; i < n; i++) {
      tangent[i] = moved[i] - sides.rateAfter()[i] * dt;
    }
  }

  /**
   * Carries an adjoint back.
   *
   * @param lambda behind at entry, before at return; n numbers
   * @param byDirection derivatives by the directions; added to
   * @param further what the number itself gains for each second by which the transition is later
   */
  void carryBack(double t, Sides sides, double[] lambda, double[] byDirection, double further) {
    int n = model.n;
    if (corner) {
      if (further != 0) {
        addTime(t, sides, further, lambda, byDirection);
      }
      return;
    }
    double gain = further - GradientModel.dot(lambda, sides.rateAfter(), n);
    double[] through = Arrays.copyOf(lambda, n);
    if (assigned.length > 0) {
      double[] weights = new double[Part.ASSIGNMENTS.of(model.functions).count()];
      for (int i = 0; i < assigned.length; i++) {
        weights[firstValue + i] = lambda[assigned[i]];
        through[assigned[i]] = 0;
      }
      gain +=
          model.addAdjointOf(Part.ASSIGNMENTS, t, sides.before(), weights, 1, through, byDirection);
    }
    gain += GradientModel.dot(through, sides.rateBefore(), n);
    addTime(t, sides, gain, through, byDirection);
    System.arraycopy(through, 0, lambda, 0, n);
  }

  /** Adds the derivatives of gain · time of the transition. */
  void addTime(double t, Sides sides, double gain, double[] lambda, double[] byDirection) {
    double[] weights = new double[part.of(model.functions).count()];
    weights[index] = 1;
    model.addAdjointOf(
        part, t, sides.before(), weights, -gain / sides.speed(), lambda, byDirection);
  }
}
