package org.mechservice.solver.force.formula;

import java.util.function.IntConsumer;
import org.mechservice.solver.expression.ClosureCoordinate;
import org.mechservice.solver.expression.Coordinate;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.Expression.ClosestStation;
import org.mechservice.solver.expression.Expression.CoordinatePosition;
import org.mechservice.solver.expression.Expression.CoordinateVelocity;
import org.mechservice.solver.expression.Expression.ParameterValue;
import org.mechservice.solver.expression.Expression.PointPosition;
import org.mechservice.solver.expression.Expression.PointVelocity;
import org.mechservice.solver.expression.Expression.RelativeMotion;
import org.mechservice.solver.expression.Expression.StateValue;
import org.mechservice.solver.expression.Expression.Time;
import org.mechservice.solver.expression.JointCoordinate;
import org.mechservice.solver.force.applied.ForceJacobian;
import org.mechservice.solver.force.applied.GradientSink;
import org.mechservice.solver.force.applied.TreeCoordinate;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;

/** The value of a leaf of an expression in a swept motion, and its gradient. */
public abstract class LeafInput {
  /** Reads the leaf. */
  abstract double value(double t);

  /** Passes on the derivatives of the value last read. */
  public abstract void gradient(GradientSink sink);

  /**
   * Adds the derivatives, by places, of the loads that a constant force along the value last read
   * exerts. A coordinate of a joint of the tree has none.
   */
  void addCurvature(double force, ForceJacobian sink) {}

  /** Stores the unwrapped angle of a cut joint after an accepted step. */
  void accepted() {}

  /** Calls the consumer for each link whose pose or velocity is read. */
  public void links(IntConsumer taker) {}

  /**
   * @param parameters values of the parameters; stored, and read at each evaluation
   * @throws IllegalArgumentException if the leaf has no value in a motion
   */
  static LeafInput of(Expression leaf, TreeMotion motion, double[] parameters) {
    if (leaf instanceof Time) {
      return new TimeInput();
    } else if (leaf instanceof ParameterValue parameter) {
      return new ParameterInput(parameters, parameter.index());
    } else if (leaf instanceof StateValue state) {
      return new StateInput(motion.further, state.index());
    } else if (leaf instanceof CoordinatePosition position) {
      return ofPosition(position.coordinate(), motion);
    } else if (leaf instanceof CoordinateVelocity velocity) {
      return ofVelocity(velocity.coordinate(), motion);
    } else if (leaf instanceof PointPosition point) {
      return new PointInput(motion, point.point(), point.axis(), false);
    } else if (leaf instanceof PointVelocity point) {
      return new PointInput(motion, point.point(), point.axis(), true);
    } else if (leaf instanceof RelativeMotion relative) {
      return new RelativeInput(motion, relative);
    } else if (leaf instanceof ClosestStation closest) {
      return new StationInput(motion, closest, parameters);
    }
    throw new IllegalArgumentException(leaf + " has no value in a force");
  }

  private static LeafInput ofPosition(Coordinate coordinate, TreeMotion motion) {
    if (coordinate instanceof ClosureCoordinate cut) {
      return new CutInput(motion, cut, false);
    }
    JointCoordinate joint = (JointCoordinate) coordinate;
    TreeCoordinate at = TreeCoordinate.ofPosition(motion.tree(), joint);
    return at.velocity() < 0
        ? new EulerInput(motion, at.position() - joint.component(), joint)
        : new CoordinateInput(motion, at, false);
  }

  private static LeafInput ofVelocity(Coordinate coordinate, TreeMotion motion) {
    if (coordinate instanceof ClosureCoordinate cut) {
      return new CutInput(motion, cut, true);
    }
    TreeGeometry tree = motion.tree();
    return new CoordinateInput(
        motion, TreeCoordinate.ofVelocity(tree, (JointCoordinate) coordinate), true);
  }

  /** Returns the input of a coordinate of the tree: its position or its rate. */
  public static LeafInput ofCoordinate(TreeMotion motion, TreeCoordinate at, boolean velocity) {
    return new CoordinateInput(motion, at, velocity);
  }

  private static final class TimeInput extends LeafInput {
    @Override
    double value(double t) {
      return t;
    }

    @Override
    public void gradient(GradientSink sink) {}
  }

  private static final class ParameterInput extends LeafInput {
    private final double[] parameters;
    private final int index;

    ParameterInput(double[] parameters, int index) {
      this.parameters = parameters;
      this.index = index;
    }

    @Override
    double value(double t) {
      return parameters[index];
    }

    @Override
    public void gradient(GradientSink sink) {}
  }

  /** A further state; its slope is taken from {@link ExpressionInputs#byState}. */
  private static final class StateInput extends LeafInput {
    private final double[] states;
    private final int index;

    StateInput(double[] states, int index) {
      this.states = states;
      this.index = index;
    }

    @Override
    double value(double t) {
      return states[index];
    }

    @Override
    public void gradient(GradientSink sink) {}
  }

  private static final class CoordinateInput extends LeafInput {
    private final TreeMotion motion;
    private final TreeCoordinate at;
    private final boolean velocity;

    CoordinateInput(TreeMotion motion, TreeCoordinate at, boolean velocity) {
      this.motion = motion;
      this.at = at;
      this.velocity = velocity;
    }

    @Override
    double value(double t) {
      return velocity ? motion.v[at.velocity()] : motion.q[at.position()];
    }

    @Override
    public void gradient(GradientSink sink) {
      sink.byCoordinate(at.velocity(), velocity ? 0 : 1, velocity ? 1 : 0);
    }

    @Override
    public void links(IntConsumer taker) {
      taker.accept(motion.tree().linkOfVelocity[at.velocity()]);
    }
  }
}
