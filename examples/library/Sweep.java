import java.nio.file.Path;
import org.mechservice.library.MechModel;

final class Sweep {
  public static void main(String[] arguments) throws Exception {
    MechModel model = MechModel.read(Path.of("examples/elements/Parameters.xml"));
    for (double push : new double[] {1, 2, 4}) {
      double[] place = model.set("push", push).simulate().column("slide.q");
      System.out.printf("%.0f N: %.3f m%n", push, place[place.length - 1]);
    }
  }
}
