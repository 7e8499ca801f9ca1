package org.mechservice.solver.simulation;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import org.mechservice.solver.api.capability.BodyPoses;
import org.mechservice.solver.api.capability.Energies;
import org.mechservice.solver.api.capability.ExplicitModel;
import org.mechservice.solver.api.capability.PowerInput;
import org.mechservice.solver.api.capability.ResultColumns;
import org.mechservice.solver.api.result.ColumnGroup;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.run.RunNotes.Note;
import org.mechservice.solver.api.run.RunRequest;
import org.mechservice.solver.ode.SavedState;

/** Completes states to rows and passes them to the sink. */
final class RowWriter {
  /** Result of {@link #write} if every number of the row is finite. */
  static final int ALL_FINITE = -1;

  private final ExplicitModel model;
  private final ResultColumns further;
  private final RowLayout layout;
  private final ResultSink sink;
  private final UnitOutput unitOutput;
  private final EnergyMonitor energyMonitor = new EnergyMonitor();
  private final boolean balanceWatched;
  private final double[] row;
  private final double[] yDot;
  private final double[] poses;
  private final int positionCount;
  private final int velocityCount;
  private final double[] energy = new double[2];
  private double initialEnergy;
  private long rows;

  /**
   * @param further columns that the model names itself
   * @throws IllegalArgumentException if the model was built without a column group that is asked
   *     for
   * @throws IOException if the sink cannot take results
   */
  RowWriter(ExplicitModel model, ResultColumns further, RunRequest request, ResultSink sink)
      throws IOException {
    this.model = model;
    this.further = further;
    this.sink = sink;
    layout = new RowLayout(model, further, request.columns());
    row = new double[layout.columns().size()];
    yDot = new double[model.description().stateCount()];
    positionCount = model.description().positionCount();
    velocityCount = model.description().velocityCount();
    balanceWatched = request.maxDrift().isPresent();
    unitOutput = new UnitOutput(model.description());
    poses =
        layout.bodies() != RowLayout.ABSENT && model instanceof BodyPoses posed
            ? new double[posed.bodies().size() * BodyPoses.NUMBERS_PER_BODY]
            : new double[0];
    sink.begin(layout.columns());
  }

  /**
   * Writes the row of one state.
   *
   * @param time time in the row, s
   * @param t time of the evaluation: the same, except at jumps of a prescribed motion
   * @param y state, which multipliers may follow; not modified
   * @param work work of forces without potential energy, J
   * @param turnover sum of added and removed energy, J
   * @param unmeasured whether work is done that is not in {@code work}
   * @return {@link #ALL_FINITE}, or the column of the first number that is not finite; the row is
   *     then not written
   * @throws IOException if the sink cannot keep the row
   */
  int write(double time, double t, double[] y, double work, double turnover, boolean unmeasured)
      throws IOException {
    row[0] = time;
    System.arraycopy(y, 0, row, 1, yDot.length);
    unitOutput.normalize(t, row, 1);
    if (layout.accelerations() != RowLayout.ABSENT) {
      model.derivative(t, y, yDot);
      System.arraycopy(yDot, positionCount, row, layout.accelerations(), velocityCount);
    }
    if (layout.bodies() != RowLayout.ABSENT) {
      ((BodyPoses) model).poses(t, y, poses);
      System.arraycopy(poses, 0, row, layout.bodies(), poses.length);
    }
    if (model instanceof Energies energies) {
      energyMonitor.observe(energies, t, y, work, turnover, unmeasured);
      if (layout.energy() != RowLayout.ABSENT) {
        row[layout.energy()] = energyMonitor.kinetic();
        row[layout.energy() + 1] = energyMonitor.potential();
        row[layout.energy() + 2] = work;
      }
    }
    for (ColumnGroup group : RowLayout.BY_THE_MODEL) {
      if (layout.offset(group) != RowLayout.ABSENT) {
        further.values(group, t, y, row, layout.offset(group));
      }
    }
    if (layout.offset(ColumnGroup.CONSTRAINTS) == RowLayout.ABSENT) {
      further.observe(t, y);
    }
    for (int i = 0; i < row.length; i++) {
      if (!Double.isFinite(row[i])) {
        return i;
      }
    }
    sink.row(row);
    rows++;
    return ALL_FINITE;
  }

  /**
   * Writes the row of a state found without integration. All motion is prescribed or at rest, so
   * the work since the first row is the change of the energy since then: what drives put in less
   * what dampers and friction take out.
   *
   * @return as {@link #write(double, double, double[], double, double, boolean)}
   */
  int write(double t, double[] y) throws IOException {
    double work = 0;
    if (layout.energy() != RowLayout.ABSENT && model instanceof Energies energies) {
      energies.energy(t, y, energy);
      double total = energy[0] + energy[1];
      if (rows == 0) {
        initialEnergy = total;
      }
      work = total - initialEnergy;
    }
    boolean unmeasured = !measuresWork() && model instanceof PowerInput;
    return write(t, t, y, work, Math.abs(work), unmeasured);
  }

  /**
   * Copies a state as its row would have it.
   *
   * @param y state, which multipliers may follow; not modified
   * @param state overwritten
   */
  void copyState(double[] y, double[] state) {
    System.arraycopy(y, 0, state, 0, yDot.length);
    unitOutput.scale(state, 0);
  }

  /**
   * Returns whether work is measured: if its column is written or the energy balance is monitored.
   */
  boolean measuresWork() {
    return layout.energy() != RowLayout.ABSENT || balanceWatched;
  }

  /** Returns the name of a column. */
  String columnName(int column) {
    return layout.columns().get(column).name();
  }

  /** Returns the column of the largest state in the last row, and its value. */
  String largestState() {
    int largest = 0;
    double most = 0;
    for (int i = 1; i <= yDot.length; i++) {
      if (Math.abs(row[i]) > most) {
        largest = i;
        most = Math.abs(row[i]);
      }
    }
    return columnName(largest) + ", " + row[largest];
  }

  /** Returns the number of rows written. */
  long rows() {
    return rows;
  }

  /** Returns the notes of the rows. */
  List<Note> notes() {
    List<Note> notes = new ArrayList<>(unitOutput.notes());
    notes.addAll(further.notes());
    return notes;
  }

  EnergyMonitor energyMonitor() {
    return energyMonitor;
  }

  /** Saves or restores the number of rows and the observed values. */
  void transfer(SavedState state) {
    rows = state.integer(rows);
    energyMonitor.transfer(state);
  }
}
