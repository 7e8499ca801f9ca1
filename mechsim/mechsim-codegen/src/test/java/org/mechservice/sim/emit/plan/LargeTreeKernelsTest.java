package org.mechservice.sim.emit.plan;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.mechservice.sim.emit.method.ConstantTable;
import org.mechservice.sim.emit.method.MethodPlan;
import org.mechservice.sim.emit.method.MethodSignature;
import org.mechservice.sim.equations.ArticulatedBodyEquations;
import org.mechservice.sim.equations.EnergyEquations;
import org.mechservice.solver.links.Links;
import org.mechservice.solver.mechanism.RandomTrees;
import org.mechservice.solver.symbol.Differentiation;
import org.mechservice.solver.symbol.Program;
import org.mechservice.solver.symbol.ReverseDifferentiation;
import org.mechservice.solver.symbol.Scalar;

/**
 * The code of a large tree has a method for each kind of link and each place in the tree that
 * differs, not for each link.
 */
@Tag("slow")
class LargeTreeKernelsTest {
  private static final int BODIES = 300;

  /** Methods per section; without a shared form there is nearly one for each. */
  private static final double SHARED = 0.4;

  private static Program accelerations(int bodies) {
    return ArticulatedBodyEquations.derive(Links.of(RandomTrees.tree(1, bodies)));
  }

  private static int inputs(Program program) {
    return program.sections().stream().mapToInt(section -> section.outputs().size()).sum();
  }

  private static Map<Scalar, Scalar> weights(Program program, int from) {
    Map<Scalar, Scalar> weights = new HashMap<>();
    for (Program.Section section : program.sections()) {
      for (Program.Output output : section.outputs()) {
        weights.put(output.value(), program.expressions().input(from + output.index()));
      }
    }
    return weights;
  }

  private static Program tangents(int bodies) {
    Program program = accelerations(bodies);
    int n = inputs(program);
    Map<Scalar, Scalar> rates = new HashMap<>();
    for (int i = 0; i < n; i++) {
      rates.put(program.expressions().input(i), program.expressions().input(n + i));
    }
    Program along =
        program.in(program.sections().stream().map(Program.Section::withoutOutputs).toList());
    Differentiation differentiation = new Differentiation(program.expressions(), rates);
    differentiation.sections(program, along);
    along.section("Along.", "d");
    for (Program.Section section : program.sections()) {
      section.outputs().forEach(out -> along.output(out.index(), differentiation.of(out.value())));
    }
    return along;
  }

  private static Program adjoint(int bodies) {
    Program program = accelerations(bodies);
    int n = inputs(program);
    Program back =
        program.in(program.sections().stream().map(Program.Section::withoutOutputs).toList());
    ReverseDifferentiation slopes =
        ReverseDifferentiation.sections(program, weights(program, n), back);
    back.section("By.", "by");
    for (int i = 0; i < n; i++) {
      back.output(i, slopes.by(program.expressions().input(i)));
    }
    return back;
  }

  private static int methods(Program program) {
    MethodSignature head =
        new MethodSignature(
            "f", List.of(new MethodSignature.Argument("y", true, 0)), "out", false, true);
    List<MethodPlan> methods = KernelPlanner.plan(program, head, new ConstantTable()).methods();
    assertThat(methods).isNotEmpty();
    return methods.size();
  }

  private static void assertShared(Program program) {
    assertThat(methods(program)).isLessThan((int) (SHARED * program.sections().size()));
  }

  @Test
  void ofAccelerations() {
    assertShared(accelerations(BODIES));
  }

  @Test
  void ofTheirTangents() {
    assertShared(tangents(BODIES));
  }

  @Test
  void ofTheirAdjoint() {
    assertShared(adjoint(BODIES));
  }

  @Test
  void ofEnergies() {
    assertShared(EnergyEquations.derive(Links.of(RandomTrees.tree(1, BODIES))));
  }
}
