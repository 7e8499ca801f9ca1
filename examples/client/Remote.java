import java.nio.file.Path;
import org.mechservice.client.MechConnection;
import org.mechservice.library.MechModel;

final class Remote {
  public static void main(String[] arguments) throws Exception {
    Path file = Path.of("examples/pendulum/pendulum.xml");
    try (MechConnection service = MechConnection.open("localhost:15000")) {
      var here = MechModel.read(file).until(1).every(0.5);
      var there = service.read(file).until(1).every(0.5);
      double[] a = here.simulate().column("j1.q");
      double[] b = there.simulate().column("j1.q");
      for (int i = 0; i < a.length; i++) {
        System.out.printf("%.4f %.4f %b%n", a[i], b[i], a[i] == b[i]);
      }
    }
  }
}
