package examples.driver;

import org.mechservice.solver.api.ForceBlocks;
import org.mechservice.solver.api.ForceDeclaration;
import org.mechservice.solver.api.ForceLoads;
import org.mechservice.solver.api.ForceState;
import org.mechservice.solver.api.UserForce;

/** A spring in every joint, and a damper of dampingRatio times the spring. */
public final class DriverJointSprings implements UserForce.Derivatives {
  private static final String[] MIDDLE = {
    "j_seat", "j_pelvis", "j_lumbar_i1", "j_lumbar_i2", "j_abdomen", "j_thorax_i1", "j_thorax_i2",
    "j_thorax", "j_neck_i1", "j_neck_i2", "j_head"
  };

  /** N·m/rad, and N/m at the sliding pelvis. */
  private static final double[] MIDDLE_STIFFNESS = {
    20000, 5000, 1500, 1500, 1000, 1500, 1500, 1000, 400, 400, 300
  };

  /** Joints of a side, L and R standing for the %. */
  private static final String[] SIDE = {
    "j_hip%_i1", "j_hip%_i2", "j_thigh%", "j_shank%", "j_ankle%_i1", "j_foot%", "j_sc%_i1",
    "j_girdle%", "j_shoulder%_i1", "j_shoulder%_i2", "j_upperArm%", "j_elbow%_i1", "j_forearm%",
    "j_wrist%_i1", "j_hand%"
  };

  private static final double[] SIDE_STIFFNESS = {
    800, 800, 500, 600, 4000, 3000, 4000, 4000, 500, 500, 300, 400, 2000, 3000, 3000
  };

  private final int[] joint = new int[MIDDLE.length + 2 * SIDE.length];
  private final double[] stiffness = new double[joint.length];
  private final double[] byPosition = new double[1];
  private final double[] byRate = new double[1];
  private int dampingRatio;

  @Override
  public void declare(ForceDeclaration model) {
    dampingRatio = model.parameter("dampingRatio");
    int at = 0;
    for (int i = 0; i < MIDDLE.length; i++) {
      stiffness[at] = MIDDLE_STIFFNESS[i];
      joint[at++] = model.coordinate(MIDDLE[i], 0);
    }
    for (String side : new String[] {"L", "R"}) {
      for (int i = 0; i < SIDE.length; i++) {
        stiffness[at] = SIDE_STIFFNESS[i];
        joint[at++] = model.coordinate(SIDE[i].replace("%", side), 0);
      }
    }
  }

  @Override
  public void apply(ForceState state, ForceLoads loads) {
    double ratio = state.parameter(dampingRatio);
    for (int i = 0; i < joint.length; i++) {
      double k = stiffness[i];
      double c = ratio * k;
      loads.addJointForce(joint[i], -k * state.coordinate(joint[i]) - c * state.rate(joint[i]));
    }
  }

  @Override
  public void differentiate(ForceState state, ForceBlocks blocks) {
    double ratio = state.parameter(dampingRatio);
    for (int i = 0; i < joint.length; i++) {
      byPosition[0] = -stiffness[i];
      byRate[0] = -ratio * stiffness[i];
      blocks.byCoordinate(ForceBlocks.Load.JOINT_FORCE, joint[i], joint[i], byPosition, byRate);
    }
  }
}
