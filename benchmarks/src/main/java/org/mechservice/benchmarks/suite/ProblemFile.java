package org.mechservice.benchmarks.suite;

import com.google.gson.Gson;
import com.google.gson.JsonElement;
import com.google.gson.reflect.TypeToken;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;

/** A problem of the suite as its file has it: expressions, start, verified end. */
final class ProblemFile {
  private static final String SUITE = "/org/mechservice/benchmarks/suite/problems.json";
  private static final String FURTHER = "/org/mechservice/benchmarks/suite/further.json";
  private static final String UNSEEN = "/org/mechservice/benchmarks/suite/unseen.json";
  private static final String FRESH = "/org/mechservice/benchmarks/suite/fresh.json";
  private static final String FLEXIBLE = "/org/mechservice/benchmarks/suite/flexible.json";
  private static final String HELD_OUT = "/org/mechservice/benchmarks/suite/heldout.json";

  String id = "";
  String title = "";
  String klass = "";
  String form = "";
  int n;
  Map<String, String> params = Map.of();
  List<Named> aux = List.of();
  List<String> rhs = List.of();
  List<MassElement> mass = List.of();
  List<String> residual = List.of();
  String t0 = "0";
  String t1 = "0";
  List<String> y0 = List.of();
  List<String> yp0 = List.of();
  List<Integer> algebraic = List.of();
  List<String> scale = List.of();
  @Nullable JsonElement scd_components;
  List<String> reference = List.of();
  double digits;

  /**
   * An expression that others use.
   *
   * @param name by which
   * @param expr its text
   */
  record Named(String name, String expr) {}

  /**
   * An element of the mass matrix; those not listed are zero.
   *
   * @param i row
   * @param j column
   * @param expr its text
   */
  record MassElement(int i, int j, String expr) {}

  /** Returns all problems of the suite. */
  static List<ProblemFile> all() {
    return read(SUITE);
  }

  /**
   * Returns further problems: 14 stiff ones and three slider cranks, two with bushings and one with
   * an elastic rod. Their ends are those of our own methods at 1e-13, the cranks' by ode113, which
   * the same run at 1e-12 confirms to the digits given.
   */
  static List<ProblemFile> further() {
    return read(FURTHER);
  }

  /**
   * Returns problems of the literature on which no parameter of the methods was chosen: E5, CUSP
   * and PLATE of Hairer and Wanner 1996, IV.10; POLLU, the ring modulator, Medical and Chemical
   * Akzo Nobel and the car axis, the latter with its constraints differentiated twice, of Mazzia
   * and Magherini 2008, <i>Test Set for Initial Value Problem Solvers</i>. Ends of Chemical Akzo
   * Nobel and the car axis are those published there, the others those of our own methods at 1e-13,
   * which 1e-12 confirms to the digits given; of POLLU and, at its published end, of the ring
   * modulator they agree with those published, of PLATE ode15s with ode113.
   */
  static List<ProblemFile> unseen() {
    return read(UNSEEN);
  }

  /**
   * Returns problems written after the methods were as they are: D1, D5, E2 and E3 of Enright, Hull
   * and Lindberg 1975, <i>BIT</i> 15, 10; F1 of Enright and Pryce 1987, <i>ACM TOMS</i> 13, 1; a
   * double pendulum of unit masses and lengths that falls from the horizontal. Ends of the former
   * are those of SciPy's Radau at 3e-13, that of the pendulum is DOP853's of its angles at 1e-13.
   */
  static List<ProblemFile> fresh() {
    return read(FRESH);
  }

  /**
   * Returns problems for the flexible parts of mechanisms: slider crank and four-bar with bushings,
   * a pendulum on a stiff spring, gears with elastic teeth, a beam of lumps, a ring of springs, a
   * pendulum that carries another on a spring; D2 of Enright, Hull and Lindberg 1975 and F2 of
   * Enright and Pryce 1987. The first six were looked at when steps at the edge of stability were
   * reconsidered. Ends are those of SciPy's DOP853 at 1e-13, with multipliers solved for, and of
   * Radau at 3e-13; ode113, ode15sR and ode15s at 1e-13 agree to the digits given.
   */
  static List<ProblemFile> flexible() {
    return read(FLEXIBLE);
  }

  /**
   * Returns the same kinds of mechanisms with other measures and dampings, and D3 and F3, on which
   * nothing was tried before the end; ends as those of {@link #flexible}.
   */
  static List<ProblemFile> heldOut() {
    return read(HELD_OUT);
  }

  private static List<ProblemFile> read(String file) {
    try (InputStream in = ProblemFile.class.getResourceAsStream(file)) {
      if (in == null) {
        throw new IllegalStateException("resource " + file + " is missing");
      }
      return new Gson()
          .fromJson(
              new InputStreamReader(in, StandardCharsets.UTF_8),
              new TypeToken<List<ProblemFile>>() {});
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Returns whether y' can be had by solving for it: not of algebraic or implicit equations. */
  boolean isExplicit() {
    return !form.equals("residual") && !klass.startsWith("dae");
  }

  /** Returns whether stability limits explicit methods on it. */
  boolean isStiff() {
    return klass.contains("stiff") && !klass.equals("nonstiff");
  }

  /** Returns the components that count. */
  int[] scored() {
    if (scd_components == null || !scd_components.isJsonArray()) {
      return IntStream.range(0, n).toArray();
    }
    return scd_components.getAsJsonArray().asList().stream()
        .mapToInt(JsonElement::getAsInt)
        .toArray();
  }

  /** Returns numbers written as text. */
  static double[] numbers(List<String> texts) {
    return texts.stream()
        .mapToDouble(text -> Formula.of(text, name -> -1).at(new double[0]))
        .toArray();
  }

  /** Returns the error of an end: the largest |y − ref| / (|ref| + scale) that counts. */
  double error(double[] y) {
    double[] expected = numbers(reference);
    double[] scales = numbers(scale);
    double largest = 0;
    for (int i : scored()) {
      double error = Math.abs(y[i] - expected[i]) / (Math.abs(expected[i]) + scales[i]);
      largest = error >= 0 ? Math.max(largest, error) : Double.POSITIVE_INFINITY;
    }
    return largest;
  }
}
