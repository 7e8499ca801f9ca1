package org.mechservice.solver.analysis;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.mechservice.solver.api.capability.Defects.Defect;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.mechanism.FurtherState;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.Output;
import org.mechservice.solver.system.FrequencyResponse;
import org.mechservice.solver.system.LinearSystem;
import org.mechservice.solver.system.TransmissionZeros;

/**
 * Tables of a linear system: its matrices with one row per state and output, its frequency response
 * with one row per frequency, or its transmission zeros with one row each.
 */
final class SystemTables {
  private static final double TURN = 2 * Math.PI;
  private static final double DEGREES = 180 / Math.PI;

  private final LinearResult result;
  private final List<Variable> states = new ArrayList<>();
  private final List<Variable> inputs = new ArrayList<>();
  private final List<Variable> outputs = new ArrayList<>();

  SystemTables(
      Mechanism mechanism, List<Output> given, CoordinateNames names, LinearResult result) {
    this.result = result;
    for (int j = 0; j < names.count(); j++) {
      states.add(new Variable(names.name(j) + ".q", names.unit(j)));
    }
    for (int j = 0; j < names.count(); j++) {
      states.add(new Variable(names.name(j) + ".v", names.unit(j) + "/s"));
    }
    for (FurtherState state : mechanism.furtherStates()) {
      switch (state.role()) {
        case INTEGRATED -> states.add(new Variable(state.name(), state.unit()));
        case INPUT -> inputs.add(new Variable(state.name(), state.unit()));
        case SAMPLED -> {} // constant between two samples
      }
    }
    given.forEach(output -> outputs.add(new Variable(output.name(), output.unit())));
    for (int j = 0; j < names.count() && given.isEmpty(); j++) {
      outputs.add(new Variable(names.name(j), names.unit(j)));
    }
  }

  /** Returns the columns behind time. */
  List<Variable> columns() {
    List<Variable> columns = new ArrayList<>();
    switch (result.kind()) {
      case SYSTEM -> {
        columns.add(new Variable("row", "1"));
        states.forEach(x -> columns.add(new Variable("x." + x.name(), x.unit())));
        inputs.forEach(u -> columns.add(new Variable("u." + u.name(), u.unit())));
      }
      case RESPONSE -> {
        columns.add(new Variable("frequency", "Hz"));
        columns.add(new Variable("decade", "1"));
        for (Variable y : outputs) {
          for (Variable u : inputs) {
            String name = y.name() + "/" + u.name();
            columns.add(new Variable(name + ".gain", ratio(y.unit(), u.unit())));
            columns.add(new Variable(name + ".dB", "dB"));
            columns.add(new Variable(name + ".phase", "deg"));
          }
        }
      }
      case ZEROS -> {
        columns.add(new Variable("zero", "1"));
        columns.add(new Variable("zero.re", "1/s"));
        columns.add(new Variable("zero.im", "rad/s"));
      }
      case MODES, EQUATIONS -> throw new IllegalStateException("not of the system");
    }
    return columns;
  }

  private static String ratio(String of, String by) {
    return by.equals("1") ? of : of + "/" + (by.matches("\\w+") ? by : "(" + by + ")");
  }

  /**
   * Writes the rows.
   *
   * @return why that is not possible; empty if it was
   */
  Optional<Defect> write(LinearSystem system, double t, ResultSink sink) throws IOException {
    if (result.kind() != LinearResult.Kind.SYSTEM && inputs.isEmpty()) {
      return Optional.of(
          new Defect(
              MessageCode.SYSTEM_WITHOUT_INPUT,
              "",
              "The model has no inputs, between which and the outputs there would be a response.",
              "Add an <input> to States and use it in a force, or ask for gives=\"modes\"."));
    }
    return switch (result.kind()) {
      case SYSTEM -> matrices(system, t, sink);
      case RESPONSE -> response(system, t, sink);
      case ZEROS -> zeros(system, t, sink);
      case MODES, EQUATIONS -> throw new IllegalStateException("not of the system");
    };
  }

  /** Writes [A B] and [C D]; rows and columns of dependent coordinates are left out or zero. */
  private Optional<Defect> matrices(LinearSystem system, double t, ResultSink sink)
      throws IOException {
    int n = system.states().size();
    int m = inputs.size();
    int[] column = new int[n];
    for (int j = 0; j < n; j++) {
      column[j] = states.indexOf(system.states().get(j));
    }
    for (int i = 0; i < n + outputs.size(); i++) {
      double[] row = new double[2 + states.size() + m];
      row[0] = t;
      row[1] = i < n ? column[i] + 1 : states.size() + (i - n) + 1;
      for (int j = 0; j < n; j++) {
        row[2 + column[j]] = i < n ? system.a(i, j) : system.c(i - n, j);
      }
      for (int j = 0; j < m; j++) {
        row[2 + states.size() + j] = i < n ? system.b(i, j) : system.d(i - n, j);
      }
      sink.row(row);
    }
    return Optional.empty();
  }

  private Optional<Defect> response(LinearSystem system, double t, ResultSink sink)
      throws IOException {
    FrequencyResponse response = new FrequencyResponse(system);
    int m = inputs.size();
    double[] phase = new double[outputs.size() * m];
    for (int k = 0; k < result.points(); k++) {
      double frequency = result.frequency(k);
      if (!response.evaluate(TURN * frequency)) {
        return Optional.of(
            new Defect(
                MessageCode.RESPONSE_AT_POLE,
                "",
                "The response at "
                    + frequency
                    + " Hz is not finite: the system has an undamped mode of this frequency.",
                "Choose other frequencies by from, to and points, or add damping."));
      }
      double[] row = new double[3 + 3 * phase.length];
      row[0] = t;
      row[1] = frequency;
      row[2] = StrictMath.log10(frequency);
      for (int i = 0; i < phase.length; i++) {
        double gain = response.gain(i / m, i % m);
        double angle = response.phase(i / m, i % m);
        // the branch nearest to the phase at the frequency before
        phase[i] = k == 0 ? angle : angle + TURN * Math.rint((phase[i] - angle) / TURN);
        row[3 + 3 * i] = gain;
        row[4 + 3 * i] = 20 * StrictMath.log10(Math.max(gain, Double.MIN_NORMAL));
        row[5 + 3 * i] = DEGREES * phase[i];
      }
      sink.row(row);
    }
    return Optional.empty();
  }

  private static Optional<Defect> zeros(LinearSystem system, double t, ResultSink sink)
      throws IOException {
    TransmissionZeros zeros = new TransmissionZeros(system);
    for (int i = 0; i < zeros.count(); i++) {
      sink.row(new double[] {t, i + 1, zeros.real(i), zeros.imaginary(i)});
    }
    return Optional.empty();
  }
}
