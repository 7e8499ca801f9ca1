package org.mechservice.solver.oracle;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.function.IntFunction;
import org.mechservice.solver.expression.BodyPoint;
import org.mechservice.solver.expression.ClosureCoordinate;
import org.mechservice.solver.expression.Coordinate;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.JointCoordinate;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.closure.CoordinateClosure;
import org.mechservice.solver.mechanism.closure.JointClosure;
import org.mechservice.solver.mechanism.joint.Joint;

/** What a coupling sets to zero, its coordinates read from the poses of the bodies. */
record CouplingEquation(Mechanism mechanism, CoordinateClosure coupling) {
  /** Returns it with the bodies it depends on. */
  Condition condition() {
    return new Condition(bodies(), (pose, time) -> List.of(value(pose, time)));
  }

  private Taylor value(IntFunction<TaylorPose> pose, Taylor time) {
    return TimeFunction.of(
        coupling.relation(),
        time,
        coordinate -> {
          JointSide side = JointSide.of(joint(coordinate));
          return JointEquations.coordinate(
              joint(coordinate),
              component(coordinate),
              side.relative(pose.apply(side.body1()), pose.apply(side.body2())));
        });
  }

  private List<Integer> bodies() {
    Set<Integer> bodies = new LinkedHashSet<>();
    collect(coupling.relation(), bodies);
    bodies.remove(BodyPoint.ROOT);
    return List.copyOf(bodies);
  }

  private void collect(Expression expression, Set<Integer> bodies) {
    if (expression instanceof Expression.CoordinatePosition position) {
      bodies.add(joint(position.coordinate()).attachment().parent());
      bodies.add(joint(position.coordinate()).attachment().child());
    } else if (expression instanceof Expression.Sum sum) {
      collect(sum.left(), bodies);
      collect(sum.right(), bodies);
    } else if (expression instanceof Expression.Product product) {
      collect(product.left(), bodies);
      collect(product.right(), bodies);
    } else if (expression instanceof Expression.Negation negation) {
      collect(negation.operand(), bodies);
    } else if (expression instanceof Expression.Call call) {
      call.arguments().forEach(argument -> collect(argument, bodies));
    }
  }

  private Joint joint(Coordinate coordinate) {
    if (coordinate instanceof JointCoordinate ofTree) {
      return mechanism.joints().get(ofTree.joint());
    }
    int closure = ((ClosureCoordinate) coordinate).closure();
    return ((JointClosure) mechanism.closures().get(closure)).joint();
  }

  private static int component(Coordinate coordinate) {
    return coordinate instanceof JointCoordinate ofTree
        ? ofTree.component()
        : ((ClosureCoordinate) coordinate).component();
  }
}
