package org.mechservice.solver.analysis.column;

import org.mechservice.solver.dynamics.event.WrittenValues;

/** User-defined outputs, evaluated by generated code. */
final class WrittenOutputs {
  private final WrittenValues code;
  private final double[] outputs;

  WrittenOutputs(WrittenValues code, int count) {
    this.code = code;
    outputs = new double[count];
  }

  void write(double t, double[] y, double[] values, int at) {
    code.outputs(t, y, outputs);
    System.arraycopy(outputs, 0, values, at, outputs.length);
  }
}
