package org.mechservice.sim.emit.c;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.mechservice.mechml.MechmlModel;
import org.mechservice.mechml.resolve.MechmlReader;
import org.mechservice.sim.model.BuildOptions;
import org.mechservice.sim.model.ModelFactory;
import org.mechservice.sim.scene.ModelBuildException;
import org.mechservice.solver.api.result.ColumnGroup;

/** Loops of more than a hundred velocities in C: a row of parallelograms. */
class LargeLoopsInCTest {
  private static final double ANGLE = 1;
  private static final double GRAVITY = 9.81;

  @TempDir private Path folder = Path.of("");

  /** n parallelograms of rods of 1 m and 1 kg: n + 1 cranks on the ground, couplers between. */
  private static MechmlModel parallelograms(int n) throws Exception {
    StringBuilder places = new StringBuilder();
    StringBuilder rods = new StringBuilder();
    StringBuilder joints = new StringBuilder();
    StringBuilder cuts = new StringBuilder();
    StringBuilder starts = new StringBuilder();
    for (int i = 0; i <= n; i++) {
      places.append("<point name='p%d' x='%d' y='0' z='0'/>".formatted(i, i));
      rods.append(rod("k" + i));
      joints.append(hinge("hk" + i, "Ground", "p" + i, "k" + i));
      starts.append(start("hk" + i, ANGLE));
    }
    for (int i = 0; i < n; i++) {
      rods.append(rod("c" + i));
      joints.append(hinge("hc" + i, "k" + i, "p2", "c" + i));
      starts.append(start("hc" + i, -ANGLE));
      cuts.append(
          ("<PointOnLine name='l%d'><body1 name='k%d' point='p2' vector='y'/>"
                  + "<body2 name='c%d' point='p2'/></PointOnLine>")
              .formatted(i, i + 1, i));
    }
    String text =
        "<MechML><MBSsimulation><dynamic><timeSet tini='0' tend='1' tstep='0.1'/></dynamic>"
            + "</MBSsimulation><MBSmodel name='row' massUnits='kg' lengthUnits='m'><Bodies>"
            + "<body name='Ground'>"
            + places
            + "<vector name='y' vx='0' vy='1' vz='0'/></body>"
            + rods
            + "</Bodies><Joints>"
            + joints
            + "</Joints><Constraints>"
            + cuts
            + "</Constraints><Forces><gravity gx='0' gy='0' gz='"
            + -GRAVITY
            + "'/></Forces><topology><root name='Ground'/><relCoorVals>"
            + starts
            + "</relCoorVals></topology></MBSmodel></MechML>";
    return MechmlReader.read("row.xml", text.getBytes(StandardCharsets.UTF_8));
  }

  private static String rod(String name) {
    return "<body name='"
        + name
        + "'><point name='p1' x='0' y='0' z='0'/><point name='p2' x='1' y='0' z='0'/>"
        + "<vector name='y' vx='0' vy='1' vz='0'/><cog x='0.5' y='0' z='0'/><mass value='1'/>"
        + "<inertiaTensor Ixx='1/1200' Iyy='1/12' Izz='1/12'/></body>";
  }

  private static String hinge(String name, String first, String point, String second) {
    return ("<joint name='%s' type='R'><body1 name='%s' point='%s' vector='y'/>"
            + "<body2 name='%s' point='p1' vector='y'/></joint>")
        .formatted(name, first, point, second);
  }

  private static String start(String joint, double angle) {
    return "<jointVal name='%s' posVals='%s' velVals='0'/>".formatted(joint, angle);
  }

  private static CModel inC(int parallelograms) throws Exception {
    MechmlModel model = parallelograms(parallelograms);
    BuildOptions options =
        new BuildOptions("DTR", EnumSet.of(ColumnGroup.JOINTS), model.settings().run());
    return ModelFactory.inC(model, options);
  }

  @Test
  void loopsBeyondThreeHundredVelocitiesAreRefusedWithTheReason() {
    assertThatThrownBy(() -> inC(150))
        .isInstanceOf(ModelBuildException.class)
        .hasMessageStartingWith("S-170")
        .hasMessageContaining("more than 300 velocities (it has 301)")
        .hasMessageContaining("mech build -o FILE.jar");
  }

  /**
   * All cranks turn alike, the couplers move with their ends: ((n + 1) / 3 + n) angle'' = g cos
   * angle ((n + 1) / 2 + n).
   */
  @Tag("soak")
  @Test
  void rowOfParallelogramsMovesAsOneCrank() throws Exception {
    CCode.compiler();
    int n = 51;
    CModel model = inC(n);
    int size = model.states().size();
    assertThat(size / 2).isGreaterThan(100);
    double[] given = new double[size + 1];
    for (int i = 0; i < size; i++) {
      given[i + 1] = model.states().get(i).start();
    }
    double[] rates = CCode.run(compiled(model), List.of(), given);
    double expected = GRAVITY * Math.cos(ANGLE) * ((n + 1) / 2.0 + n) / ((n + 1) / 3.0 + n);
    for (int i = 0; i <= n; i++) {
      assertThat(rates[size / 2 + i]).isCloseTo(expected, within(1e-10));
    }
  }

  private Path compiled(CModel model) throws IOException {
    return CCode.compiled(
        model,
        folder,
        CCode.PLAIN,
        """
        #include "row.h"
        #include <stdio.h>

        int main(void) {
          static row_t m;
          static double given[row_NX + 1], dx[row_NX];
          row_init(&m);
          if (fread(given, sizeof(double), row_NX + 1, stdin) != row_NX + 1 ||
              row_derivatives(&m, given[0], given + 1, dx) != 0) {
            return 1;
          }
          return fwrite(dx, sizeof(double), row_NX, stdout) != row_NX;
        }
        """);
  }
}
