package org.mechservice.sim.service.results;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.mechservice.idl.NotFound;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.result.Variable;

class RunColumnsTest {
  private static final RunColumns ALL =
      RunColumns.of(
          RunColumnsTest::columnsOf,
          EnumSet.of(
              ColumnGroup.JOINTS,
              ColumnGroup.ACCELERATIONS,
              ColumnGroup.BODIES,
              ColumnGroup.ENERGY));

  /** t j1.q j2.q j1.v j2.v j1.a j2.a b.x energy.kinetic. */
  private static List<Variable> columnsOf(Set<ColumnGroup> groups) {
    List<String> names = new ArrayList<>(List.of("t", "j1.q", "j2.q", "j1.v", "j2.v"));
    if (groups.contains(ColumnGroup.ACCELERATIONS)) {
      names.addAll(List.of("j1.a", "j2.a"));
    }
    if (groups.contains(ColumnGroup.BODIES)) {
      names.add("b.x");
    }
    if (groups.contains(ColumnGroup.ENERGY)) {
      names.add("energy.kinetic");
    }
    return names.stream().map(name -> new Variable(name, "1")).toList();
  }

  private static double[] picked(String... names) throws NotFound {
    double[] rows = new double[2 * ALL.count()];
    for (int i = 0; i < rows.length; i++) {
      rows[i] = i;
    }
    return ALL.select(names).pick(rows, ALL.count());
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
