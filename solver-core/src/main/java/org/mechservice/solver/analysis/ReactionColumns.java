package org.mechservice.solver.analysis;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.api.Variable;
import org.mechservice.solver.force.UserForceSource;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.mechanism.Joint;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.closure.JointClosure;
import org.mechservice.solver.mechanism.closure.LoopClosure;

/**
 * Force and moment that pass through each joint, as if it were cut: bearing forces, what drives it,
 * and springs, dampers and friction in it. They act on the outer body of a joint of the tree, and
 * on body 2 of a cut joint, at that body's point of the joint; world axes.
 */
final class ReactionColumns implements ColumnValues {
  private static final String[] COMPONENTS = {".fx", ".fy", ".fz", ".tx", ".ty", ".tz"};

  private final EquationsOfMotion equations;
  private final List<Variable> columns = new ArrayList<>();
  private final List<CutReaction> cuts = new ArrayList<>();

  ReactionColumns(EquationsOfMotion equations, UserForceSource userForces) {
    this.equations = equations;
    Mechanism mechanism = equations.tree.mechanism();
    mechanism.joints().forEach(this::addColumns);
    for (int c = 0; c < mechanism.closures().size(); c++) {
      LoopClosure closure = mechanism.closures().get(c);
      if (closure instanceof JointClosure cut) {
        addColumns(cut.joint());
        cuts.add(new CutReaction(equations, userForces, c));
      }
    }
  }

  private void addColumns(Joint joint) {
    for (int i = 0; i < COMPONENTS.length; i++) {
      columns.add(new Variable(joint.name() + COMPONENTS[i], i < 3 ? "N" : "N·m"));
    }
  }

  @Override
  public List<Variable> columns() {
    return columns;
  }

  @Override
  public void write(double t, double[] values, int at) {
    TreeGeometry tree = equations.tree;
    List<Joint> joints = tree.mechanism().joints();
    double[] transmitted = equations.open.transmitted();
    int to = at;
    for (int j = 0; j < joints.size(); j++) {
      // The reference point of a body's link is the joint's point on it.
      int link = tree.linkOf(joints.get(j).attachment().child());
      equations.motion.toWorld(link, transmitted, 6 * link + 3, values, to);
      equations.motion.toWorld(link, transmitted, 6 * link, values, to + 3);
      to += COMPONENTS.length;
    }
    for (int i = 0; i < cuts.size(); i++) {
      cuts.get(i).write(t, values, to);
      to += COMPONENTS.length;
    }
  }
}
