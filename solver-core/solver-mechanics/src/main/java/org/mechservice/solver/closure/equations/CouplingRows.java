package org.mechservice.solver.closure.equations;

import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import org.mechservice.solver.expression.Expression;
import org.mechservice.solver.expression.FormulaEvaluation;
import org.mechservice.solver.force.applied.Couplings;
import org.mechservice.solver.force.applied.ForceJacobian;
import org.mechservice.solver.kinematics.CountedPositions;
import org.mechservice.solver.kinematics.TreeGeometry;
import org.mechservice.solver.kinematics.TreeMotion;
import org.mechservice.solver.mechanism.closure.CoordinateClosure;

/** A coupling of coordinates: one equation. */
final class CouplingRows extends ClosureRows {
  private final FormulaEvaluation evaluation;
  private final CouplingLeaf[] leaves;

  /** ∂Φ/∂(leaf). */
  private final double[] gradient;

  private final double[] direction;
  private final double[] change;
  private double size = 1;

  CouplingRows(
      CoordinateClosure closure,
      TreeGeometry tree,
      double[] parameters,
      double length,
      CountedPositions counted) {
    super(closure);
    evaluation = new FormulaEvaluation(List.of(closure.relation()));
    leaves = new CouplingLeaf[evaluation.leaves().size()];
    for (int i = 0; i < leaves.length; i++) {
      Expression leaf = evaluation.leaves().get(i);
      leaves[i] = CouplingLeaf.of(leaf, closure.name(), tree, parameters, length, counted);
    }
    gradient = new double[leaves.length];
    direction = new double[leaves.length];
    change = new double[leaves.length];
  }

  @Override
  int count() {
    return 1;
  }

  @Override
  String label(int row) {
    return "relation of coordinates";
  }

  @Override
  double size(int row) {
    return size;
  }

  @Override
  void measure(double size) {
    this.size = size > 0 ? size : this.size;
  }

  /**
   * {@inheritDoc} The unit of a coupling's residual follows from its expression, whose terms may
   * have different units.
   */
  @Override
  String unit(int row) {
    return "SI";
  }

  @Override
  void place(TreeMotion motion, double t) {
    for (int i = 0; i < leaves.length; i++) {
      evaluation.setLeaf(i, leaves[i].value(motion, t));
    }
    differentiate();
  }

  @Override
  void placeFar(TreeMotion motion, double t) {
    for (int i = 0; i < leaves.length; i++) {
      evaluation.setLeaf(i, leaves[i].valueFar(motion, t));
    }
    differentiate();
  }

  private void differentiate() {
    evaluation.derivatives();
    evaluation.gradient(0, gradient);
    size = 0;
    for (int i = 0; i < leaves.length; i++) {
      size = Math.max(size, Math.abs(gradient[i]) * leaves[i].size());
    }
    size = size > 0 ? size : 1;
  }

  @Override
  void move(TreeMotion motion, double t) {
    for (int i = 0; i < leaves.length; i++) {
      evaluation.setLeaf(i, leaves[i].value(motion, t), leaves[i].rate(motion), 0);
    }
    evaluation.rates();
  }

  @Override
  void accelerate(TreeMotion motion, double t) {
    for (int i = 0; i < leaves.length; i++) {
      CouplingLeaf leaf = leaves[i];
      evaluation.setLeaf(i, leaf.value(motion, t), leaf.rate(motion), leaf.acceleration(motion));
    }
    evaluation.rates();
  }

  @Override
  double value(int row) {
    return evaluation.value(0);
  }

  @Override
  double rate(int row) {
    return evaluation.rate(0);
  }

  @Override
  double acceleration(int row) {
    return evaluation.secondRate(0);
  }

  @Override
  void addJacobian(TreeMotion motion, int row, double[] rows, int at) {
    for (int i = 0; i < leaves.length; i++) {
      leaves[i].addRow(motion, gradient[i], rows, at);
    }
  }

  @Override
  void addBounds(TreeMotion motion, int row, double[] bounds, int at) {
    for (int i = 0; i < leaves.length; i++) {
      leaves[i].addRow(motion, Math.abs(gradient[i]), bounds, at);
    }
  }

  @Override
  void addForces(int row, double multiplier, double[] wrench, double[] tau) {
    for (int i = 0; i < leaves.length; i++) {
      leaves[i].addForce(multiplier * gradient[i], wrench, tau);
    }
  }

  /** Adds λ ∇Φ times the second derivatives of the variables, and λ ∂²Φ between variables. */
  @Override
  void linearise(double[] multipliers, int at, double factor, ForceJacobian sink) {
    double force = factor * multipliers[at];
    if (force == 0) {
      return;
    }
    for (int i = 0; i < leaves.length; i++) {
      leaves[i].linearise(force * gradient[i], sink);
      Arrays.fill(direction, 0);
      direction[i] = 1;
      evaluation.gradientChange(0, direction, change);
      for (int j = 0; j < leaves.length; j++) {
        leaves[j].linearise(force * change[j], leaves[i], sink);
      }
    }
  }

  @Override
  void addSupport(BitSet ways, BitSet loaded, BitSet velocities) {
    for (CouplingLeaf leaf : leaves) {
      leaf.addSupport(ways, loaded, velocities);
    }
  }

  @Override
  void couplings(Couplings couplings) {
    int[] links = Arrays.stream(leaves).flatMapToInt(leaf -> Arrays.stream(leaf.links())).toArray();
    for (int on : links) {
      for (int by : links) {
        if (on != by) {
          couplings.couple(on, by);
        }
      }
    }
  }

  @Override
  void accepted() {
    for (CouplingLeaf leaf : leaves) {
      leaf.accepted();
    }
  }
}
