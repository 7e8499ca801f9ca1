package org.mechservice.library;

/**
 * Text of a model: a cart of mass 2 that slides along x under a force, beside states of its own. In
 * a run of 2 s at tolerances of 1e-10 and 1e-12.
 */
final class SlidingCart {
  static final String AXES =
      "<vector name='x' vx='1' vy='0' vz='0'/><vector name='y' vx='0' vy='1' vz='0'/>";

  private SlidingCart() {}

  /** Returns a body of mass 2 with the points o and p. */
  static String body(String name) {
    return "<body name='"
        + name
        + "'><point name='o' x='0' y='0' z='0'/><point name='p' x='1.3' y='0' z='0'/>"
        + AXES
        + "<cog x='0.5' y='0' z='0'/><mass value='2'/><inertiaTensor Ixx='0.1' Iyy='0.2'"
        + " Izz='0.25'/></body>";
  }

  /**
   * Returns a model with any mechanism.
   *
   * @param step between two rows, s
   * @param events elements of the simulation
   * @param parts what the model consists of
   */
  static String model(String step, String events, String parts) {
    return "<MechML><MBSsimulation><dynamic><timeSet tini='0' tend='2' tstep='"
        + step
        + "'/><integrator name='ode113' relTol='1e-10' absTol='1e-12'/>"
        + events
        + "</dynamic></MBSsimulation><MBSmodel name='m' massUnits='kg' lengthUnits='m'>"
        + parts
        + "</MBSmodel></MechML>";
  }

  /**
   * Returns the parts of the cart's model.
   *
   * @param states elements of States
   * @param force along x, as an expression, N
   * @param outputs the element Outputs, or nothing
   */
  static String parts(String states, String force, String outputs) {
    return "<Bodies><body name='Ground'><point name='o' x='0' y='0' z='0'/>"
        + AXES
        + "</body>"
        + body("cart")
        + "</Bodies><Joints><joint name='j' type='P'><body1 name='Ground' point='o'"
        + " vector='x'/><body2 name='cart' point='o' vector='x'/></joint></Joints><States>"
        + states
        + "</States><Forces><jointForce name='f' joint='j' expression='"
        + force
        + "'/></Forces>"
        + outputs
        + "<topology><root name='Ground'/></topology>";
  }
}
