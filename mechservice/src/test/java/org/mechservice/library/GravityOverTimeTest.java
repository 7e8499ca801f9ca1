package org.mechservice.library;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.mechservice.solver.api.program.Trajectory;

/** Gravity that depends on time. */
class GravityOverTimeTest {
  private static String model(
      String formulation, String integrator, String driven, String gravity) {
    String axes =
        "<point name='o' x='0' y='0' z='0'/><vector name='y' vx='0' vy='1' vz='0'/><vector name='z'"
            + " vx='0' vy='0' vz='1'/>";
    String bar =
        axes
            + "<point name='end' x='0.1' y='0' z='-1'/><cog x='0.1' y='0' z='-0.4'/><mass"
            + " value='1.5'/><inertiaTensor Ixx='0.2' Iyy='0.2' Izz='0.1'/>";
    return "<MechML><MBSsimulation><dynamic><timeSet tini='0' tend='2' tstep='0.1'/><integrator"
        + " name='"
        + integrator
        + "' relTol='1e-10' absTol='1e-12'/><formulation name='"
        + formulation
        + "'/></dynamic></MBSsimulation><MBSmodel name='m' massUnits='kg' lengthUnits='m'><Bodies>"
        + "<body name='Ground'>"
        + axes
        + "</body><body name='lift'>"
        + axes
        + "<mass value='3'/></body><body name='first'>"
        + bar
        + "</body><body name='second'>"
        + bar
        + "</body></Bodies><Joints><joint name='lift' type='P'><body1 name='Ground' point='o'"
        + " vector='z'/><body2 name='lift' point='o' vector='z'/></joint><joint name='a' type='R'>"
        + "<body1 name='lift' point='o' vector='y'/><body2 name='first' point='o' vector='y'/>"
        + "</joint><joint name='b' type='R'><body1 name='first' point='end' vector='y'/><body2"
        + " name='second' point='o' vector='y'/></joint></Joints><Forces><gravity gx='0' gy='0'"
        + " gz='"
        + gravity
        + "'/></Forces><topology><root name='Ground'/><relCoorVals><jointVal name='lift' driven='"
        + driven
        + "'/><jointVal name='a' posVals='1'/><jointVal name='b' velVals='2'/></relCoorVals>"
        + "</topology></MBSmodel></MechML>";
  }

  private static Trajectory run(String text) throws Exception {
    return MechModel.of("m.xml", text).simulate();
  }

  /**
   * A double pendulum in a lift that moves by h(t) swings as one at rest under g + h''. Tolerances
   * of 1e-10 leave errors of 1e-8 at most in two seconds.
   */
  @ParameterizedTest
  @CsvSource({"DTR, ode113", "DSR, DE", "RR, ode15sR", "RR-JF, ode15sR"})
  void liftActsAsGravity(String formulation, String integrator) throws Exception {
    String moving = model(formulation, integrator, "0.1*sin(5*t)", "-9.81");
    String heavy = model(formulation, integrator, "0*t", "-9.81 + 2.5*sin(5*t)");
    Trajectory expected = run(moving);
    Trajectory found = run(heavy);
    for (String column : new String[] {"a.q", "b.q"}) {
      assertThat(found.column(column)).containsExactly(expected.column(column), within(2e-7));
    }
  }
}
