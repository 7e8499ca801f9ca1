package org.mechservice.solver.analysis.column;

import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.analysis.equation.EquationsOfMotion;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.closure.CutReaction;
import org.mechservice.solver.closure.equations.LoopEquations;
import org.mechservice.solver.dynamics.recursion.JointReactions;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.closure.JointClosure;
import org.mechservice.solver.mechanism.joint.Joint;

/**
 * Reaction force and moment of each joint: its constraint and driving forces, without springs,
 * dampers and friction along its coordinates. They act on the outer body of a joint of the tree,
 * and on body 2 of a cut joint, at that body's point of the joint; world axes.
 */
final class ReactionColumns implements ColumnValues {
  private static final String[] COMPONENTS = {".fx", ".fy", ".fz", ".tx", ".ty", ".tz"};

  private final EquationsOfMotion equations;
  private final List<Variable> columns = new ArrayList<>();
  private final List<CutReaction> cuts = new ArrayList<>();
  private final JointReactions joints;

  ReactionColumns(EquationsOfMotion equations) {
    this.equations = equations;
    joints = new JointReactions(equations.motion);
    Mechanism mechanism = equations.tree.mechanism();
    mechanism.joints().forEach(this::addColumns);
    LoopEquations loops = equations.loops;
    for (int row = 0; row < loops.count(); row++) {
      boolean first = row == 0 || loops.closure(row) != loops.closure(row - 1);
      if (first && loops.closure(row) instanceof JointClosure cut) {
        addColumns(cut.joint());
        cuts.add(new CutReaction(cut, equations.tree, loops, row));
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
    joints.evaluate(equations.loadedWrench, equations.loadedTau);
    System.arraycopy(joints.wrench, 0, values, at, joints.wrench.length);
    int to = at + joints.wrench.length;
    for (int i = 0; i < cuts.size(); i++) {
      cuts.get(i).write(equations.motion, equations.lambda, values, to);
      to += COMPONENTS.length;
    }
  }
}
