package org.mechservice.study;

/** Models of the tests. */
public final class StudyModels {
  /** A mass m on a spring k, from x = 0.1 m at rest, for 1 s. */
  public static final String SPRING =
      "<MechML><MBSsimulation><dynamic><timeSet tini='0' tend='1' tstep='0.01'/><integrator"
          + " name='ode113' relTol='1e-10' absTol='1e-12'/></dynamic></MBSsimulation><MBSmodel"
          + " name='Spring' massUnits='kg' lengthUnits='m'><Parameters><parameter name='k'"
          + " value='20' unit='N/m'/><parameter name='m' value='2' unit='kg'/></Parameters><Bodies>"
          + "<body name='Ground'><point name='o' x='0' y='0' z='0'/><vector name='u' vx='1' vy='0'"
          + " vz='0'/></body><body name='mass'><point name='o' x='0' y='0' z='0'/><vector name='u'"
          + " vx='1' vy='0' vz='0'/><mass value='m'/></body></Bodies><Joints><joint name='x'"
          + " type='P'><body1 name='Ground' point='o' vector='u'/><body2 name='mass' point='o'"
          + " vector='u'/></joint></Joints><Forces><jointForce name='f' joint='x'"
          + " expression='-k*x.q'/></Forces><topology><root name='Ground'/><relCoorVals><jointVal"
          + " name='x' posVals='0.1'/></relCoorVals></topology></MBSmodel></MechML>";

  private StudyModels() {}
}
