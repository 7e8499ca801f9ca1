package org.mechservice.study.run;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.mechservice.study.PointModel;
import org.mechservice.study.PointOutcome;
import org.mechservice.study.design.Design;

/**
 * A study that can run: every name in it is known to the model.
 *
 * @param factors names of the factors, in the order of the points' values
 * @param design the points, in the units that the model file gives the parameters
 * @param shown factors of the table, by which a value is multiplied, then divided, for its unit
 * @param outputs columns of the table, one for each value of the model's outcomes
 * @param stop when it ends early
 * @param model runs the points in this process
 * @param modelFile where the model was read
 * @param tables names of the files of points, as the study has them
 * @param identity what the bytes of the table depend on: hashes of study and model, version
 */
public record StudyPlan(
    List<String> factors,
    Design design,
    List<StudyFactor> shown,
    List<StudyOutput> outputs,
    StopRule stop,
    PointModel model,
    Path modelFile,
    List<String> tables,
    JsonObject identity) {
  public StudyPlan {
    factors = List.copyOf(factors);
    shown = List.copyOf(shown);
    outputs = List.copyOf(outputs);
    tables = List.copyOf(tables);
  }

  /** Returns how many points the design has. */
  public int points() {
    return design.size();
  }

  /** Returns the warning that the classes of forces run unconfined; empty if they do not. */
  public Optional<String> userCodeWarning() {
    return model.model().userCodeWarning();
  }

  /** Returns name or number of the model's simulation; empty for the first. */
  public Optional<String> simulation() {
    return Optional.ofNullable(identity.get("simulation")).map(JsonElement::getAsString);
  }

  /** Returns the settings of its runs that are not those of the file, as options of the service. */
  public Map<String, String> runOptions() {
    Map<String, String> options = new LinkedHashMap<>();
    for (JsonElement run : identity.getAsJsonArray("run")) {
      run.getAsJsonObject().asMap().forEach((key, text) -> options.put(key, text.getAsString()));
    }
    return options;
  }

  /**
   * Returns the values of a point for the model.
   *
   * @param values of the design; not modified
   */
  Map<String, Double> values(double[] values) {
    Map<String, Double> named = new LinkedHashMap<>();
    for (int j = 0; j < values.length; j++) {
      named.put(factors.get(j), shown.get(j).inModel(values[j]));
    }
    return named;
  }

  /** Returns the first line of the table. */
  String header() {
    List<String> cells = new ArrayList<>(List.of("point"));
    cells.addAll(factors);
    cells.addAll(List.of("outcome", "code", "message"));
    outputs.forEach(output -> cells.add(output.name()));
    return CsvLine.of(cells);
  }

  /** Returns the line of a point. */
  String row(int point, PointOutcome outcome) {
    return row(point, design.point(point), outcome, shown(outcome));
  }

  /**
   * Returns the line of a point.
   *
   * @param values of the design; not modified
   * @param shown values of the outputs as {@link #shown} gives them; not modified
   */
  String row(int point, double[] values, PointOutcome outcome, double[] shown) {
    List<String> cells = new ArrayList<>(factors.size() + outputs.size() + 4);
    cells.add(Integer.toString(point + 1));
    for (double value : values) {
      cells.add(CsvLine.number(value));
    }
    if (outcome instanceof PointOutcome.Failed failed) {
      cells.addAll(List.of(FAILED, failed.code(), failed.message()));
    } else {
      cells.addAll(List.of(COMPLETED, "", ""));
    }
    for (double value : shown) {
      cells.add(Double.isNaN(value) ? "" : CsvLine.number(value));
    }
    return CsvLine.of(cells);
  }

  /** Returns the values of the outputs in their units, NaN where there is none. */
  double[] shown(PointOutcome outcome) {
    double[] shown = new double[outputs.size()];
    Arrays.fill(shown, Double.NaN);
    if (outcome instanceof PointOutcome.Values reached) {
      for (int i = 0; i < shown.length; i++) {
        shown[i] = outputs.get(i).scale().fromSi(reached.values()[i]);
      }
    }
    return shown;
  }

  /** The outcome of a run that reached its end. */
  static final String COMPLETED = "completed";

  /** The outcome of one that did not. */
  static final String FAILED = "failed";
}
