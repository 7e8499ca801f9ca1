package org.mechservice.solver.analysis;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.mechservice.solver.analysis.equation.EquationsOfMotion;
import org.mechservice.solver.analysis.equation.Linearisation;
import org.mechservice.solver.api.ModelDescription;
import org.mechservice.solver.api.capability.Defects;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.capability.ModelParts;
import org.mechservice.solver.api.capability.ResultTable;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.RunNotes;
import org.mechservice.solver.catalogue.ClosureMethod;
import org.mechservice.solver.catalogue.Formulation;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.catalogue.MethodNames;
import org.mechservice.solver.compact.CompactModel;
import org.mechservice.solver.compact.DataDriven;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.mechanism.FurtherState;
import org.mechservice.solver.system.LinearSystem;

/**
 * Small motions of a mechanism about its start, an equilibrium or a trimmed state, as a table: one
 * row per mode with eigenvalue, frequency, damping ratio and shape; or one row per equation with
 * the elements of M, C and K; or what {@link SystemTables} writes of the system from inputs to
 * outputs.
 */
final class LinearModel implements ResultTable, RunNotes {
  /** Defaults of a static simulation in MechML. */
  private static final double TOLERANCE = 1e-9;

  private static final int MOST_CORRECTIONS = 100;

  private final CompactModel data;
  private final UserForceSource userForces;
  private final boolean atEquilibrium;
  private final Optional<Trim> trim;
  private final LinearResult result;
  private final List<FurtherState> changing;
  private final ModelDescription description;
  private final CoordinateNames names;
  private final SystemTables tables;
  private final List<Note> notes = new ArrayList<>();
  private Optional<Defect> defect = Optional.empty();

  /** Point of linearisation: the equations, the state, its accelerations. */
  private EquationsOfMotion equations;

  private double[] y;
  private double[] a;

  LinearModel(
      CompactModel data,
      boolean atEquilibrium,
      Optional<Trim> trim,
      LinearResult result,
      UserForceSource userForces) {
    this.trim = trim;
    this.data = data;
    this.userForces = userForces;
    this.atEquilibrium = atEquilibrium;
    this.result = result;
    changing = data.mechanism().furtherStates().stream().filter(LinearModel::changes).toList();
    description = AnalysisModel.description(data);
    names = new CoordinateNames(data.mechanism());
    tables = new SystemTables(data.mechanism(), data.outputs(), names, result);
    equations = new EquationsOfMotion(data.mechanism(), userForces);
    y = new double[data.mechanism().stateCount()];
    a = new double[equations.nv];
  }

  @Override
  public ModelDescription description() {
    return description;
  }

  @Override
  public void initialState(double[] start) {
    data.mechanism().initialState(start);
  }

  @Override
  public List<Variable> columns() {
    List<Variable> columns = new ArrayList<>();
    columns.add(new Variable("t", "s"));
    if (result.isOfSystem()) {
      columns.addAll(tables.columns());
      return columns;
    }
    boolean modes = result.kind() == LinearResult.Kind.MODES;
    columns.add(new Variable(modes ? "mode" : "equation", "1"));
    if (modes) {
      columns.add(new Variable("eigenvalue.re", "1/s"));
      columns.add(new Variable("eigenvalue.im", "rad/s"));
      columns.add(new Variable("frequency", "Hz"));
      columns.add(new Variable("damping", "1"));
      for (int j = 0; j < names.count(); j++) {
        columns.add(new Variable(names.name(j) + ".re", names.unit(j)));
        columns.add(new Variable(names.name(j) + ".im", names.unit(j)));
      }
      for (FurtherState state : changing) {
        columns.add(new Variable(state.name() + ".re", state.unit()));
        columns.add(new Variable(state.name() + ".im", state.unit()));
      }
      return columns;
    }
    for (String matrix : List.of("M", "C", "K")) {
      for (int j = 0; j < names.count(); j++) {
        columns.add(new Variable(matrix + "." + names.name(j), "SI"));
      }
    }
    for (FurtherState state : data.mechanism().furtherStates()) {
      columns.add(new Variable("S." + state.name(), "SI"));
    }
    return columns;
  }

  @Override
  public int tabulate(double t, ResultSink sink) throws IOException {
    boolean found = trim.isPresent() ? trimmed(t) : atEquilibrium ? rest(t) : start(t);
    if (!found) {
      return Defects.DEFECT;
    }
    try {
      Linearisation linear = new Linearisation(equations, t, y, a);
      return switch (result.kind()) {
        case MODES -> writeModes(t, linear, sink);
        case EQUATIONS -> writeMatrices(t, linear, sink);
        case SYSTEM, RESPONSE, ZEROS -> writeSystem(t, linear, sink);
      };
    } catch (Linearisation.NotLinearised e) {
      return fail(e.defect());
    }
  }

  private boolean trimmed(double t) {
    return at(new TrimPoint(data, userForces, trim.orElseThrow(), false), t);
  }

  private boolean at(TrimPoint point, double t) {
    boolean found = point.find(t);
    notes.addAll(point.notes());
    if (!found) {
      fail(point.defect());
      return false;
    }
    equations = point.equations();
    y = point.state();
    a = point.accelerations();
    return true;
  }

  private boolean rest(double t) {
    if (!changing.isEmpty()) {
      CompactModel held =
          new CompactModel(
              HeldMotions.at(data.mechanism(), t),
              data.formulation(),
              data.closure(),
              data.settings(),
              data.outputs());
      TrimPoint point = new TrimPoint(held, userForces, Trim.ofRest(data.mechanism()), true);
      boolean found = at(point, t);
      if (found) {
        notes.addAll(EquilibriumModel.judged(point, t));
      }
      return found;
    }
    StaticEquilibrium equilibrium =
        new StaticEquilibrium(data.mechanism(), userForces, TOLERANCE, MOST_CORRECTIONS);
    boolean found = equilibrium.find(t);
    notes.addAll(equilibrium.notes());
    if (!found) {
      fail(equilibrium.defect());
      return false;
    }
    equations = equilibrium.equations();
    y = equilibrium.state();
    return true;
  }

  private boolean start(double t) {
    boolean open = data.mechanism().closures().isEmpty();
    CompactModel free =
        new CompactModel(
            data.mechanism(),
            Formulation.DSR.label(),
            open ? MethodNames.NONE : ClosureMethod.PROJECTION.label(),
            data.settings());
    ExplicitModel model =
        (ExplicitModel) ModelParts.of(DataDriven.model(free, userForces)).equations();
    model.initialState(y);
    double[] yDot = new double[y.length];
    int result = model.derivative(t, y, yDot);
    if (model instanceof RunNotes noted) {
      notes.addAll(noted.notes());
    }
    if (result == Defects.DEFECT) {
      fail(((Defects) model).lastDefect());
    } else if (result != ExplicitModel.REGULAR) {
      fail(noInertia("joint \"" + description.joints().get(result).name() + "\""));
    }
    a = Arrays.copyOfRange(yDot, equations.nq, equations.nq + equations.nv);
    return result == ExplicitModel.REGULAR;
  }

  private static Defect noInertia(String part) {
    return new Defect(
        MessageCode.SMALL_MOTION_WITHOUT_INERTIA,
        part,
        "Small motions have no inertia in some direction.",
        "Give the bodies beyond this joint mass and inertia.");
  }

  private static boolean changes(FurtherState state) {
    return state.role() == FurtherState.Role.INTEGRATED;
  }

  private int writeSystem(double t, Linearisation linear, ResultSink sink) throws IOException {
    double[] system = linear.system();
    if (system.length == 0 && linear.freedom() > 0) {
      return fail(noInertia(names.part(linear.independent()[0])));
    }
    LinearSystem found = LinearSystems.of(equations, linear, system, t, y, data.outputs());
    Optional<Defect> refused = tables.write(found, t, sink);
    return refused.isPresent() ? fail(refused.get()) : ExplicitModel.REGULAR;
  }

  private int writeModes(double t, Linearisation linear, ResultSink sink) throws IOException {
    if (linear.order() - linear.furtherCount() + changing.size() == 0) {
      return ExplicitModel.REGULAR;
    }
    double[] system = linear.system();
    if (system.length == 0) {
      return fail(noInertia(names.part(linear.independent()[0])));
    }
    Modes found = new Modes(linear, linear.changing(system));
    if (!found.converged()) {
      return fail(
          new Defect(
              MessageCode.SMALL_MOTION_WITHOUT_INERTIA,
              "",
              "The eigenvalues of small motions were not found.",
              "Look for masses and stiffnesses that differ by more than 1e16."));
    }
    double[] re = new double[names.count() + changing.size()];
    double[] im = new double[re.length];
    double[] row = new double[6 + 2 * re.length];
    for (int k = 0; k < found.count(); k++) {
      row[0] = t;
      row[1] = k + 1;
      row[2] = found.growth(k);
      row[3] = found.angularFrequency(k);
      row[4] = found.frequency(k);
      row[5] = found.dampingRatio(k);
      found.shape(k, equations.unit, re, im);
      for (int j = 0; j < re.length; j++) {
        row[6 + 2 * j] = re[j];
        row[7 + 2 * j] = im[j];
      }
      sink.row(row);
    }
    return ExplicitModel.REGULAR;
  }

  /**
   * Writes the row of each independent coordinate, then that of each further state that changes;
   * columns of dependent coordinates are zero.
   */
  private int writeMatrices(double t, Linearisation linear, ResultSink sink) throws IOException {
    int f = linear.freedom();
    int fq = linear.placeFreedom();
    int ns = linear.furtherCount();
    int ofStiffness = 2 + 2 * names.count();
    int ofStates = 2 + 3 * names.count();
    double[][] matrices = {linear.mass, linear.damping};
    for (int i = 0; i < f; i++) {
      double[] row = new double[ofStates + ns];
      row[0] = t;
      row[1] = linear.independent()[i] + 1;
      System.arraycopy(linear.byState, i * ns, row, ofStates, ns);
      for (int m = 0; m < matrices.length; m++) {
        for (int j = 0; j < f; j++) {
          row[2 + m * names.count() + linear.independent()[j]] = matrices[m][i * f + j];
        }
      }
      for (int j = 0; j < fq; j++) {
        row[ofStiffness + linear.independentPlaces()[j]] = linear.stiffnessOfPlaces[i * fq + j];
      }
      sink.row(row);
    }
    for (int k = 0; k < ns; k++) {
      if (!changes(data.mechanism().furtherStates().get(k))) {
        continue;
      }
      double[] row = new double[ofStates + ns];
      row[0] = t;
      row[1] = names.count() + k + 1;
      for (int l = 0; l < f; l++) {
        row[2 + names.count() + linear.independent()[l]] = linear.rateDamping[k * f + l];
      }
      for (int l = 0; l < fq; l++) {
        row[ofStiffness + linear.independentPlaces()[l]] = linear.rateStiffness[k * fq + l];
      }
      System.arraycopy(linear.rateByState, k * ns, row, ofStates, ns);
      sink.row(row);
    }
    return ExplicitModel.REGULAR;
  }

  private int fail(Defect why) {
    defect = Optional.of(why);
    return Defects.DEFECT;
  }

  @Override
  public Defect lastDefect() {
    return defect.orElseThrow(() -> new IllegalStateException("nothing has failed"));
  }

  @Override
  public List<Note> notes() {
    return List.copyOf(notes);
  }
}
