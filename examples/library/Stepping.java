import java.nio.file.Path;
import org.mechservice.library.MechModel;
import org.mechservice.solver.api.program.SteppedModel;

final class Stepping {
  public static void main(String[] arguments) throws Exception {
    MechModel block = MechModel.read(Path.of("examples/elements/input.xml"));
    SteppedModel run = block.until(2).stepped(0.01);
    run.input("gust", 0);
    while (run.isRunning()) {
      run.input("force", 40 * (0.5 - run.value("slide.q")) - 12 * run.value("slide.v"));
      run.step();
      if (Math.rint(run.time() / 0.5) * 0.5 == run.time()) {
        System.out.printf("t = %.1f s: %.4f m%n", run.time(), run.value("slide.q"));
      }
    }
  }
}
