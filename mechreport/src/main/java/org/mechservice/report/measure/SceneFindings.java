package org.mechservice.report.measure;

import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.mechservice.report.method.OmittedMethod;
import org.mechservice.report.method.SimulationMethod;
import org.mechservice.report.solution.Judge;
import org.mechservice.report.solution.Reference;

/**
 * All findings of a report about a scene, from which its page is written.
 *
 * @param scene that the report is about
 * @param methods methods that fit, in order
 * @param leftOut methods that do not fit
 * @param judge reference of the errors
 * @param points all methods at all tolerances; none without a reference
 * @param spectrum along the run
 * @param shares of time, by method name
 * @param freshStarts times of first runs in machines of their own, by method name
 * @param effort how much was measured
 * @param versions versions of the product and of Java, and the machine
 * @param savings what was left out to keep the time for the report, one sentence each
 */
public record SceneFindings(
    ReportedScene scene,
    List<SimulationMethod> methods,
    List<OmittedMethod> leftOut,
    Judge judge,
    List<Point> points,
    Optional<Spectrum> spectrum,
    Map<String, TimeShares> shares,
    Map<String, ColdRunTimes> freshStarts,
    Effort effort,
    List<String> versions,
    List<String> savings) {
  public SceneFindings {
    methods = List.copyOf(methods);
    leftOut = List.copyOf(leftOut);
    points = List.copyOf(points);
    shares = Map.copyOf(shares);
    freshStarts = Map.copyOf(freshStarts);
    versions = List.copyOf(versions);
    savings = List.copyOf(savings);
  }

  /** Returns the points of a method, loosest tolerance first. */
  public List<Point> pointsOf(String method) {
    return points.stream().filter(point -> point.first().method().equals(method)).toList();
  }

  /** Returns the methods of which a point reached the end. */
  public List<SimulationMethod> measured() {
    return methods.stream()
        .filter(method -> pointsOf(method.name()).stream().anyMatch(Point::completed))
        .toList();
  }

  /** Returns the floor below which errors have no meaning. */
  public double floor() {
    return judge.reference().map(reference -> reference.worstFloor()).orElse(Double.NaN);
  }

  /** Returns by how much the scene makes a small change of the start grow at most; 0 if unknown. */
  public double growth() {
    return judge
        .reference()
        .flatMap(Reference::amplification)
        .map(factors -> Arrays.stream(factors).max().orElse(0))
        .orElse(0.0);
  }
}
