package org.mechservice.library;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import org.mechservice.solver.api.result.ResultSink;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.api.run.Checkpoints;

/** Keeps all rows, and a checkpoint after each step. */
final class KeptRun implements ResultSink, Checkpoints {
  final List<List<Double>> rows = new ArrayList<>();
  final List<byte[]> checkpoints = new ArrayList<>();
  final List<Integer> rowsAt = new ArrayList<>();
  private final Optional<byte[]> from;

  KeptRun(Optional<byte[]> from) {
    this.from = from;
  }

  @Override
  public void begin(List<Variable> columns) {}

  @Override
  public void row(double[] values) {
    rows.add(Arrays.stream(values).boxed().toList());
  }

  @Override
  public String modelHash() {
    return "";
  }

  @Override
  public double secondsBetween() {
    return 0;
  }

  @Override
  public Optional<byte[]> saved() {
    return from;
  }

  @Override
  public void keep(byte[] checkpoint) {
    checkpoints.add(checkpoint);
    rowsAt.add(rows.size());
  }
}
