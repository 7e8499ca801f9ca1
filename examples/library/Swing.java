import java.nio.file.Path;
import org.mechservice.library.MechModel;
import org.mechservice.solver.api.program.Trajectory;

final class Swing {
  public static void main(String[] arguments) throws Exception {
    MechModel pendulum = MechModel.read(Path.of("examples/pendulum/pendulum.xml"));
    Trajectory motion = pendulum.until(1).every(0.5).simulate();
    double[] time = motion.time();
    double[] angle = motion.column("j1.q");
    for (int i = 0; i < motion.rows(); i++) {
      System.out.printf("t = %.1f s: %.4f %s%n", time[i], angle[i], motion.unit("j1.q"));
    }
  }
}
