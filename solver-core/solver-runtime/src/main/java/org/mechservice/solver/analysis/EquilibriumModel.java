package org.mechservice.solver.analysis;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.mechservice.solver.analysis.equation.Linearisation;
import org.mechservice.solver.compact.CompactModel;
import org.mechservice.solver.force.user.UserForceSource;
import org.mechservice.solver.mechanism.FurtherState;

/**
 * A mechanism at one state: at rest, where all forces balance and further states do not change, or
 * where a trim problem is solved.
 */
final class EquilibriumModel extends AnalysisModel {
  private final Search search;

  /** Finds a state. */
  private interface Search {
    boolean find(double t);

    double[] state();

    double[] accelerations();

    Defect defect();

    List<Note> notes();

    long iterations();
  }

  /**
   * @param data the model; with its motions held constant if it is to rest
   * @param tolerance largest residual force relative to the largest force
   * @param most largest number of corrections
   * @param trim the trim problem; empty for rest
   * @param userForces creates the user forces
   */
  EquilibriumModel(
      CompactModel data,
      double tolerance,
      int most,
      Optional<Trim> trim,
      UserForceSource userForces) {
    super(data, userForces);
    boolean changes =
        mechanism.furtherStates().stream()
            .anyMatch(state -> state.role() == FurtherState.Role.INTEGRATED);
    search =
        trim.isPresent() || changes
            ? trimmed(
                new TrimPoint(
                    data, userForces, trim.orElseGet(() -> Trim.ofRest(mechanism)), trim.isEmpty()),
                trim.isEmpty())
            : atRest(new StaticEquilibrium(mechanism, userForces, tolerance, most));
  }

  private static Search trimmed(TrimPoint point, boolean atRest) {
    return new Search() {
      private final List<Note> ofStability = new ArrayList<>();

      @Override
      public boolean find(double t) {
        if (!point.find(t)) {
          return false;
        }
        if (atRest) {
          ofStability.addAll(judged(point, t));
        }
        return true;
      }

      @Override
      public double[] state() {
        return point.state();
      }

      @Override
      public double[] accelerations() {
        return point.accelerations();
      }

      @Override
      public Defect defect() {
        return point.defect();
      }

      @Override
      public List<Note> notes() {
        List<Note> notes = new ArrayList<>(point.notes());
        notes.addAll(ofStability);
        return notes;
      }

      @Override
      public long iterations() {
        return point.iterations();
      }
    };
  }

  /** Returns notes on the stability of a point at rest; none if forces have no derivative there. */
  static List<Note> judged(TrimPoint point, double t) {
    try {
      double[] rest = new double[point.equations().nv];
      Linearisation linear = new Linearisation(point.equations(), t, point.state(), rest);
      return EquilibriumStability.judged(point.equations(), t, linear);
    } catch (Linearisation.NotLinearised e) {
      return List.of();
    }
  }

  private static Search atRest(StaticEquilibrium equilibrium) {
    return new Search() {
      @Override
      public boolean find(double t) {
        return equilibrium.find(t);
      }

      @Override
      public double[] state() {
        return equilibrium.state();
      }

      @Override
      public double[] accelerations() {
        return new double[equilibrium.equations().nv];
      }

      @Override
      public Defect defect() {
        return equilibrium.defect();
      }

      @Override
      public List<Note> notes() {
        return equilibrium.notes();
      }

      @Override
      public long iterations() {
        return equilibrium.iterations();
      }
    };
  }

  @Override
  public int find(double t, double[] y) {
    if (!search.find(t)) {
      return fail(search.defect());
    }
    System.arraycopy(search.state(), 0, y, 0, y.length);
    double[] found = search.accelerations();
    System.arraycopy(found, 0, acceleration, 0, found.length);
    return REGULAR;
  }

  @Override
  public long iterations() {
    return search.iterations();
  }

  @Override
  public List<Note> notes() {
    return search.notes();
  }
}
