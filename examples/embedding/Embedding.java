import org.mechservice.solver.api.JointVariables;
import org.mechservice.solver.api.ModelSource;
import org.mechservice.solver.api.capability.Energies;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.capability.ModelParts;

/** Integrates a model by the classical Runge-Kutta method; give its class, the end, the steps. */
public final class Embedding {
  public static void main(String[] arguments) throws Exception {
    Object built = Class.forName(arguments[0]).getConstructor().newInstance();
    ExplicitModel model = (ExplicitModel) ModelParts.of(ModelSource.of(built)).equations();
    double h = Double.parseDouble(arguments[1]) / Integer.parseInt(arguments[2]);
    double[] y = new double[model.description().stateCount()];
    double[] energy = new double[2];
    double[][] k = new double[5][y.length];
    model.initialState(y);
    for (int step = 0; step < Integer.parseInt(arguments[2]); step++) {
      double[] start = y.clone();
      for (int stage = 1; stage <= 4; stage++) {
        double later = stage == 1 ? 0 : stage == 4 ? h : h / 2;
        double[] at = start.clone();
        for (int i = 0; i < y.length; i++) {
          at[i] += later * k[stage - 1][i];
        }
        model.derivative(step * h + later, at, k[stage]);
        for (int i = 0; i < y.length; i++) {
          y[i] += (stage == 1 || stage == 4 ? h / 6 : h / 3) * k[stage][i];
        }
      }
    }
    int position = 0;
    for (JointVariables joint : model.description().joints()) {
      System.out.println(joint.name() + ".q " + y[position]);
      position += joint.type().positionCount();
    }
    ((Energies) model).energy(h, y, energy);
    System.out.println("energy " + (energy[0] + energy[1]));
  }
}
