package org.mechservice.study.run;

import com.google.gson.JsonElement;
import com.google.gson.JsonObject;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.mechservice.solver.text.ShortestDecimal;
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

  /** Returns name or number of the model's simulation; empty for the first. */
  public Optional<String> simulation() {
    return Optional.ofNullable(identity.get("simulation")).map(JsonElement::getAsString);
  }

  /** Returns the values of a point for the model. */
  Map<String, Double> values(int point) {
    double[] values = design.point(point);
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
    List<String> cells = new ArrayList<>(factors.size() + outputs.size() + 4);
    cells.add(Integer.toString(point + 1));
    for (double value : design.point(point)) {
      cells.add(ShortestDecimal.format(value));
    }
    if (outcome instanceof PointOutcome.Failed failed) {
      cells.addAll(List.of(FAILED, failed.code(), failed.message()));
      outputs.forEach(output -> cells.add(""));
    } else if (outcome instanceof PointOutcome.Values reached) {
      cells.addAll(List.of(COMPLETED, "", ""));
      double[] values = reached.values();
      for (int i = 0; i < values.length; i++) {
        double shownValue = outputs.get(i).scale().fromSi(values[i]);
        cells.add(Double.isNaN(shownValue) ? "" : ShortestDecimal.format(shownValue));
      }
    }
    return CsvLine.of(cells);
  }

  /** The outcome of a run that reached its end. */
  static final String COMPLETED = "completed";

  /** The outcome of one that did not. */
  static final String FAILED = "failed";

  /** Returns the factors with their units, for messages. */
  public String describe() {
    return points()
        + " points of "
        + shown.stream().map(StudyFactor::toString).collect(Collectors.joining(", "));
  }
}
