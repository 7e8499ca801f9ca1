package org.mechservice.examples;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;

/** A pendulum with a force that is a class of its user, for tests of what such classes may do. */
final class DraggedBob {
  static final String MODEL =
      """
      <MechML>
        <MBSsimulation>
          <dynamic>
            <timeSet tini="0" tend="0.2" tstep="0.1"/>
            <integrator name="ode113" relTol="1e-8" absTol="1e-10"/>
          </dynamic>
        </MBSsimulation>
        <MBSmodel name="m" massUnits="kg" lengthUnits="m">
          <Parameters><parameter name="k" value="1" tunable="true"/></Parameters>
          <Bodies>
            <body name="Ground"/>
            <body name="bob">
              <point name="tip" x="1" y="0" z="0"/>
              <cog x="1" y="0" z="0"/>
              <mass value="1"/>
            </body>
          </Bodies>
          <Joints><joint name="j" type="R" body1="Ground" body2="bob" axis="0;1;0"/></Joints>
          <Forces>
            <gravity gx="0" gy="0" gz="-9.81"/>
            <force name="drag" fileName="Drag.class"/>
          </Forces>
          <Outputs><output name="e" expression="k*t"/></Outputs>
          <topology><root name="Ground"/></topology>
        </MBSmodel>
      </MechML>
      """;

  private DraggedBob() {}

  /**
   * Writes the source of the class, {@code Drag.java}.
   *
   * @param inClass what it has besides its methods
   * @param inDeclare what it does when it declares
   * @param inApply what it does at each state
   */
  static void writeSource(Path folder, String inClass, String inDeclare, String inApply)
      throws IOException {
    Files.writeString(
        folder.resolve("Drag.java"),
        "import org.mechservice.solver.api.*; public final class Drag implements UserForce { "
            + inClass
            + " public void declare(ForceDeclaration m) { m.point(\"bob\", \"tip\","
            + " ForceDeclaration.Reads.VELOCITY); "
            + inDeclare
            + " } public void apply(ForceState s, ForceLoads l) { double[] v = new double[3];"
            + " s.velocity(0, v); l.addForce(0, -v[0], 0, -v[2]); "
            + inApply
            + " } }");
  }
}
