package org.mechservice.load;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.mechservice.client.MechSession;
import org.mechservice.client.SimulationOptions;
import org.mechservice.client.run.PreparedRun;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;

/** The simulations of these tests, and their rows to the last bit. */
final class Runs {
  /** The five-bar pendulum: 11 columns, 301 rows to its end at 3 s. */
  static final Path PENDULUM = Path.of("../examples/pendulum/pendulum.xml");

  private static final int KINDS = 4;

  private Runs() {}

  /** Returns one of a few different runs. */
  static SimulationOptions kind(int number) {
    return SimulationOptions.asInFile().relativeTolerance(Math.pow(10, -5 - number % KINDS));
  }

  /** Keeps rows. */
  static final class Kept implements ResultSink {
    private final List<double[]> rows = new ArrayList<>();

    @Override
    public void begin(List<Variable> columns) {
      rows.clear();
    }

    @Override
    public void row(double[] values) {
      rows.add(values.clone());
    }

    /** Returns all bits of all rows. */
    List<Long> bits() {
      List<Long> bits = new ArrayList<>();
      for (double[] row : rows) {
        for (double value : row) {
          bits.add(Double.doubleToRawLongBits(value));
        }
      }
      return bits;
    }
  }

  /** Runs the loaded model of a session and returns the bits of its rows. */
  static List<Long> bits(MechSession session, SimulationOptions options, boolean local)
      throws IOException {
    Kept rows = new Kept();
    try (PreparedRun run =
        local ? session.prepareLocalRun(options) : session.prepareRemoteRun(options)) {
      run.toEnd(rows);
    }
    return rows.bits();
  }
}
