import java.nio.file.Path;
import org.mechservice.library.MechModel;
import org.mechservice.solver.api.program.Trajectory;

final class Analyses {
  public static void main(String[] arguments) throws Exception {
    MechModel block = MechModel.read(Path.of("examples/elements/static.xml"));
    System.out.printf("rests at %.4f m%n", block.equilibrium().column("fall.q")[0]);
    Trajectory modes = block.modes();
    System.out.printf("swings at %.4f Hz%n", modes.column("frequency")[0]);
    MechModel arm = MechModel.read(Path.of("examples/elements/inverseDynamic.xml"));
    Trajectory forces = arm.inverseDynamics();
    String name = forces.columns().get(1).name();
    System.out.printf(
        "%s at the start: %.4f %s%n", name, forces.column(name)[0], forces.unit(name));
  }
}
