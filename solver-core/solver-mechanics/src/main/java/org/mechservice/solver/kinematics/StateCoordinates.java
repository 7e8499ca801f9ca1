package org.mechservice.solver.kinematics;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.spatial.EulerParameters;

/**
 * The kinematic equation of the state, q' = N(q) v, with N the identity except for Euler
 * parameters, and finite moves along the tangent, one number per velocity
 * (docs/theory/motion.md#positions). Immutable.
 */
public final class StateCoordinates {
  /** For each position: its velocity, or -1 for an Euler parameter. */
  private final int[] velocityOfPosition;

  /** For each velocity: the position it is the rate of, or -1 for an angular velocity. */
  private final int[] positionOfVelocity;

  private final int[] ballPosition;
  private final int[] ballVelocity;
  private final int velocityCount;

  /** Reads the layout of a mechanism's state. */
  public StateCoordinates(Mechanism mechanism) {
    this(
        IntStream.range(0, mechanism.joints().size())
            .filter(j -> !mechanism.isDriven(j))
            .mapToObj(j -> mechanism.joints().get(j).type())
            .toList());
  }

  /**
   * Lays out a state.
   *
   * @param types of the joints that have states, in their order
   */
  public StateCoordinates(List<JointType> types) {
    velocityOfPosition = new int[types.stream().mapToInt(JointType::positionCount).sum()];
    int balls = 0;
    int[] positions = new int[types.size()];
    int[] velocities = new int[types.size()];
    int position = 0;
    int velocity = 0;
    for (JointType type : types) {
      int end = position + type.positionCount();
      if (type.hasEulerParameters()) {
        positions[balls] = position;
        velocities[balls++] = velocity;
        Arrays.fill(velocityOfPosition, position, position + 4, -1);
        position += 4;
        velocity += 3;
      }
      while (position < end) {
        velocityOfPosition[position++] = velocity++;
      }
    }
    velocityCount = velocity;
    positionOfVelocity = new int[velocity];
    Arrays.fill(positionOfVelocity, -1);
    for (int i = 0; i < velocityOfPosition.length; i++) {
      if (velocityOfPosition[i] >= 0) {
        positionOfVelocity[velocityOfPosition[i]] = i;
      }
    }
    ballPosition = Arrays.copyOf(positions, balls);
    ballVelocity = Arrays.copyOf(velocities, balls);
  }

  /** Returns nq. */
  public int positionCount() {
    return velocityOfPosition.length;
  }

  /** Returns nv. */
  public int velocityCount() {
    return velocityCount;
  }

  /** Returns the velocity that is the rate of a position, or -1 for an Euler parameter. */
  public int velocityOf(int position) {
    return velocityOfPosition[position];
  }

  /** Returns the position that a velocity is the rate of, or -1 if it turns Euler parameters. */
  public int positionOf(int velocity) {
    return positionOfVelocity[velocity];
  }

  /**
   * Marks the velocities whose positions are marked: all three of a set of Euler parameters if one
   * of the four is.
   *
   * @param positions the first nq count; not modified
   * @param velocities nv; overwritten
   */
  public void velocitiesOf(boolean[] positions, boolean[] velocities) {
    for (int i = 0; i < velocityOfPosition.length; i++) {
      if (velocityOfPosition[i] >= 0) {
        velocities[velocityOfPosition[i]] = positions[i];
      }
    }
    for (int b = 0; b < ballPosition.length; b++) {
      boolean any = false;
      for (int i = ballPosition[b]; i < ballPosition[b] + 4; i++) {
        any |= positions[i];
      }
      Arrays.fill(velocities, ballVelocity[b], ballVelocity[b] + 3, any);
    }
  }

  /** Returns the number of sets of Euler parameters in the state. */
  public int ballCount() {
    return ballPosition.length;
  }

  /** Returns the index in q of the first of the four parameters of a set. */
  public int ballPosition(int ball) {
    return ballPosition[ball];
  }

  /** Returns the index in v of the angular velocity of a set. */
  public int ballVelocity(int ball) {
    return ballVelocity[ball];
  }

  /**
   * Writes q' = N(q) v.
   *
   * @param q positions from {@code qAt}; not modified
   * @param v velocities from {@code vAt}; not modified
   * @param rate nq numbers from {@code rateAt}; overwritten; must not be {@code q}
   */
  public void rates(double[] q, int qAt, double[] v, int vAt, double[] rate, int rateAt) {
    for (int i = 0; i < velocityOfPosition.length; i++) {
      if (velocityOfPosition[i] >= 0) {
        rate[rateAt + i] = v[vAt + velocityOfPosition[i]];
      }
    }
    for (int b = 0; b < ballPosition.length; b++) {
      EulerParameters.rate(
          q, qAt + ballPosition[b], v, vAt + ballVelocity[b], rate, rateAt + ballPosition[b]);
    }
  }

  /**
   * Moves positions along the tangent: q += factor δ, e ← exp(½ factor δ) ∘ e.
   *
   * @param q positions from {@code qAt}; overwritten
   * @param delta nv numbers from {@code deltaAt}, rad or m; not modified
   * @param factor factor of δ
   */
  public void move(double[] q, int qAt, double[] delta, int deltaAt, double factor) {
    for (int i = 0; i < velocityOfPosition.length; i++) {
      if (velocityOfPosition[i] >= 0) {
        q[qAt + i] += factor * delta[deltaAt + velocityOfPosition[i]];
      }
    }
    for (int b = 0; b < ballPosition.length; b++) {
      EulerParameters.turn(q, qAt + ballPosition[b], delta, deltaAt + ballVelocity[b], factor);
    }
  }

  /**
   * Writes the small displacement along the tangent that belongs to a small change of positions: a
   * rotation δ for Euler parameters, 2 vec(δe ∘ e⁻¹).
   *
   * @param q positions; not modified
   * @param change their change; not modified
   * @param delta nv numbers; overwritten
   */
  public void tangent(double[] q, double[] change, double[] delta) {
    for (int i = 0; i < velocityOfPosition.length; i++) {
      if (velocityOfPosition[i] >= 0) {
        delta[velocityOfPosition[i]] = change[i];
      }
    }
    for (int b = 0; b < ballPosition.length; b++) {
      EulerParameters.rotation(q, ballPosition[b], change, delta, ballVelocity[b]);
    }
  }

  /**
   * Writes the move along the tangent that leads from one set of positions to another: the inverse
   * of {@link #move}, with rotations of at most half a turn.
   *
   * @param from positions; not modified
   * @param to positions; not modified
   * @param delta nv numbers, rad or m; overwritten
   */
  public void moveBetween(double[] from, double[] to, double[] delta) {
    for (int i = 0; i < velocityOfPosition.length; i++) {
      if (velocityOfPosition[i] >= 0) {
        delta[velocityOfPosition[i]] = to[i] - from[i];
      }
    }
    for (int b = 0; b < ballPosition.length; b++) {
      EulerParameters.turnBetween(from, to, ballPosition[b], delta, ballVelocity[b]);
    }
  }

  /** Scales all Euler parameters to norm 1. */
  public void normalize(double[] q, int qAt) {
    for (int at : ballPosition) {
      double norm = EulerParameters.norm(q, qAt + at);
      for (int i = qAt + at; i < qAt + at + 4; i++) {
        q[i] /= norm;
      }
    }
  }
}
