import org.mechservice.library.MechModel;
import org.mechservice.library.MechanismBuilder;

final class Built {
  public static void main(String[] arguments) throws Exception {
    MechanismBuilder arm = MechanismBuilder.of("DoublePendulum");
    arm.parameter("stiffness", 20, "N/m");
    arm.root("ground").point("anchor", 0.5, 0, 0);
    arm.body("upper").cylinder(0.02, "0;0;0", "0;0;-1").set("mass", 1200, "g");
    arm.body("lower").point("end", 0, 0, -2).cylinder(0.02, "0;0;-1", "end").set("mass", 0.7);
    arm.joint("shoulder", "R").between("ground", "upper").at(0, 0, 0).axis(0, 1, 0);
    arm.joint("elbow", "R").between("upper", "lower").at(0, 0, -1).axis(0, 1, 0);
    arm.springDamper("spring")
        .between("ground", "anchor", "lower", "end")
        .set("k", "stiffness")
        .set("length0", 1800, "mm");
    arm.gravity(0, 0, -9.81);
    arm.start("shoulder", 0.3, 0);
    arm.dynamic(1, 0.5).integrator("ode113", 1e-8, 1e-10);
    MechModel model = arm.model();
    for (double angle : model.simulate().column("elbow.q")) {
      System.out.printf("%.4f%n", angle);
    }
    try {
      arm.joint("wrist", "RR");
    } catch (IllegalArgumentException e) {
      System.out.println(e.getMessage());
    }
  }
}
