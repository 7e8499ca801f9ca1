package org.mechservice.sim.service;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.mechservice.idl.NotFound;
import org.mechservice.solver.api.JointType;
import org.mechservice.solver.api.JointVariables;
import org.mechservice.solver.api.ModelDescription;
import org.mechservice.solver.api.RunSettings;
import org.mechservice.solver.api.Variable;

class ColumnSelectionTest {
  private static final ModelDescription MODEL =
      new ModelDescription(
          "m",
          "DTR",
          List.of(new JointVariables("j1", JointType.R), new JointVariables("j2", JointType.P)),
          new RunSettings(0, 1, 1, "DE", 1e-3, 1e-3));

  /** t j1.q j2.q j1.v j2.v j1.a j2.a b.x energy.kinetic. */
  private static final List<Variable> ALL = all();

  private static List<Variable> all() {
    List<Variable> all = new ArrayList<>();
    all.add(new Variable("t", "s"));
    all.addAll(MODEL.states());
    all.addAll(MODEL.accelerations());
    all.add(new Variable("b.x", "m"));
    all.add(new Variable("energy.kinetic", "J"));
    return all;
  }

  private static double[] picked(String... names) throws NotFound {
    double[] rows = new double[2 * ALL.size()];
    for (int i = 0; i < rows.length; i++) {
      rows[i] = i;
    }
    return ColumnSelection.of(names, ALL, MODEL).pick(rows, ALL.size());
  }

  @Test
  void noNamesMeanAllColumns() throws NotFound {
    assertThat(picked()).hasSize(18).startsWith(0, 1, 2);
  }

  @Test
  void columnsComeInTheOrderAskedFor() throws NotFound {
    assertThat(picked("j2.v", "t")).containsExactly(4, 0, 13, 9);
  }

  @Test
  void groupsStandForTheirColumns() throws NotFound {
    assertThat(picked("accelerations")).containsExactly(5, 6, 14, 15);
    assertThat(picked("bodies")).containsExactly(7, 16);
    assertThat(picked("energy")).containsExactly(8, 17);
    assertThat(picked("joints")).startsWith(0, 1, 2, 3, 4).hasSize(10);
  }

  @Test
  void unknownColumnIsAnsweredWithTheKnownOnes() {
    assertThatThrownBy(() -> picked("j3.q"))
        .isInstanceOfSatisfying(
            NotFound.class,
            refusal -> assertThat(refusal.text).contains("\"j3.q\"").contains("j1.q, j2.q"));
  }
}
