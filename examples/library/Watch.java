import java.nio.file.Path;
import java.util.List;
import org.mechservice.library.MechModel;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.Checkpoints;
import org.mechservice.solver.api.run.RunControl;

final class Watch {
  public static void main(String[] arguments) throws Exception {
    MechModel pendulum = MechModel.read(Path.of("examples/pendulum/pendulum.xml"));
    RunControl control = new RunControl();
    ResultSink watching =
        new ResultSink() {
          @Override
          public void begin(List<Variable> columns) {
            System.out.println(columns.get(1));
          }

          @Override
          public void row(double[] values) {
            if (values[1] > 1 && !control.stopRequested()) {
              System.out.printf("beyond 1 rad at %.2f s%n", values[0]);
              control.stop();
            }
          }
        };
    pendulum.simulate(watching, control, Checkpoints.NONE);
  }
}
