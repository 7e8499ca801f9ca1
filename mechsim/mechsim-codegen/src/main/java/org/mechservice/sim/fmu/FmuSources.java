package org.mechservice.sim.fmu;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import org.mechservice.solver.text.ShortestDecimal;

/** The C files of an FMU: those of the model, those of the resources, and the header between. */
final class FmuSources {
  private static final String MODEL_HEADER = "mech_fmu_model.h";

  private static final List<String> METHODS =
      List.of(
          "mech_adams.c",
          "mech_adams.h",
          "mech_backward.c",
          "mech_backward.h",
          "mech_fmu.c",
          "mech_fmu.h",
          "mech_steps.h");

  /** The search of steps, of a model that has something to watch. */
  private static final List<String> SEARCH = List.of("mech_watch.c", "mech_watch.h");

  /** Functions of what is evaluated for it. */
  static final List<String> QUANTITIES = List.of("watched", "overlaps");

  private static final List<String> FUNCTIONS =
      List.of(
          "init",
          "start",
          "derivatives",
          "outputs",
          "event_values",
          "event",
          "project",
          "close",
          "begin",
          "accepted",
          "next_jump",
          "go_on",
          "directional",
          "failure");

  /** The substitute for a function that a model does not have. */
  private static final Map<String, String> WITHOUT =
      Map.ofEntries(
          Map.entry("event_values", "(m, t, x, g) 0"),
          Map.entry("event", "(m, occurred, t, x) ((void)(occurred), 0)"),
          Map.entry("project", "(m, t, x) 0"),
          Map.entry("close", "(m, t, x, set) MODEL_project(m, t, x)"),
          Map.entry("accepted", "(m, t, x) ((void)0)"),
          Map.entry("next_jump", "(m, t) HUGE_VAL"),
          Map.entry("begin", "(m, t, x) 0"),
          Map.entry("go_on", "(m, t, x) ((void)(t), 0)"),
          Map.entry("outputs", "(m, t, x, y) 0"),
          Map.entry("directional", "(m, t, x, seed, dx) ((void)(seed), (void)(dx), -1)"),
          Map.entry("overlaps", "(m, t, x, values) 0"),
          Map.entry("failure", "(m) \"\""));

  private FmuSources() {}

  /**
   * Returns all files by name.
   *
   * @param token GUID or instantiation token, compiled in
   */
  static SortedMap<String, String> of(FmuModel model, FmiVersion version, String token) {
    SortedMap<String, String> files = withoutHeader(model, version);
    files.put(MODEL_HEADER, header(model, token));
    return files;
  }

  /** Returns the files that do not depend on the token. */
  static SortedMap<String, String> withoutHeader(FmuModel model, FmiVersion version) {
    SortedMap<String, String> files = unit(model);
    files.put(version.source(), resource(version.source()));
    return files;
  }

  /** Returns the files of a model and its integrator, without an interface. */
  private static SortedMap<String, String> unit(FmuModel model) {
    SortedMap<String, String> files = new TreeMap<>(model.sources());
    METHODS.forEach(name -> files.put(name, resource(name)));
    if (model.isWatched()) {
      SEARCH.forEach(name -> files.put(name, resource(name)));
    }
    for (String name : List.of("mech_math.c", "mech_math.h")) {
      files.putIfAbsent(name, resource("/org/mechservice/sim/emit/c/" + name));
    }
    return files;
  }

  /** Returns the files of a model as a WebAssembly module, with what it needs of a C library. */
  static SortedMap<String, String> ofModule(FmuModel model) {
    SortedMap<String, String> files = unit(model);
    files.put(MODEL_HEADER, header(model, ""));
    files.put("mech_wasm.c", resource("wasm/mech_wasm.c"));
    for (String name : List.of("math.h", "stdio.h", "stdlib.h", "string.h")) {
      files.put(name, resource("wasm/" + name));
    }
    return files;
  }

  /** Returns the names of those to compile. */
  static List<String> compiled(SortedMap<String, String> files) {
    return files.keySet().stream().filter(name -> name.endsWith(".c")).toList();
  }

  private static String header(FmuModel model, String token) {
    String name = model.prefix();
    FmuModel.Experiment run = model.experiment();
    StringBuilder text =
        new StringBuilder(
            """
            /* The model as the files of the FMU name it. */
            #ifndef MECH_FMU_MODEL_H
            #define MECH_FMU_MODEL_H

            #include <math.h>

            """);
    text.append("#include \"").append(name).append(".h\"\n\n");
    int[] counts = {
      model.states().size(),
      model.parameters().size(),
      model.inputs().size(),
      model.outputs().size(),
      model.events().size()
    };
    List<String> letters = List.of("X", "P", "U", "Y", "G");
    StringBuilder check = new StringBuilder();
    for (int i = 0; i < counts.length; i++) {
      define(text, "N" + letters.get(i), Integer.toString(counts[i]));
      check.append(i == 0 ? "(" : " && ").append(name).append("_N").append(letters.get(i));
      check.append(" == ").append(counts[i]);
    }
    define(text, "CHECK", check + ")");
    define(text, "T", name + "_t");
    String within = model.isIndependent() ? "full." : "";
    define(text, "P(m)", "((m)->" + within + "p)");
    define(text, "U(m)", "((m)->" + within + "u)");
    define(text, "LOST(m)", model.isIndependent() ? "((m)->lost)" : "((void)(m), 0)");
    define(text, "IS_LOSING(m)", model.isIndependent() ? "((m)->failures == 1)" : "((void)(m), 0)");
    List<String> functions = new ArrayList<>(FUNCTIONS);
    if (model.isWatched()) {
      define(text, "WATCHES", "1");
      functions.addAll(QUANTITIES);
    }
    for (String function : functions) {
      boolean there = model.declares(name, function);
      String without = WITHOUT.getOrDefault(function, "");
      if (there || without.isEmpty()) {
        define(text, function, name + "_" + function);
      } else {
        text.append("#define MODEL_").append(function).append(without).append('\n');
      }
    }
    define(text, "TOKEN", "\"" + token + "\"");
    define(text, "LOOPS", model.sources().containsKey("mech_loops.h") ? "1" : "0");
    define(text, "STIFF", run.stiff() ? "1" : "0");
    define(text, "START", number(run.start()));
    define(text, "INTERVAL", number(run.end() - run.start()));
    define(text, "RTOL", number(run.relativeTolerance()));
    define(text, "ATOL", number(run.absoluteTolerance()));
    define(text, "LONGEST", number(run.maxStep()));
    return text.append("\n#endif\n").toString();
  }

  private static void define(StringBuilder text, String name, String value) {
    text.append("#define MODEL_").append(name).append(' ').append(value).append('\n');
  }

  /** Returns a constant of type double. */
  private static String number(double value) {
    if (Double.isInfinite(value)) {
      return "HUGE_VAL";
    }
    String text = ShortestDecimal.format(value).toLowerCase(Locale.ROOT);
    String decimal = text.contains(".") || text.contains("e") ? text : text + ".0";
    return value < 0 ? "(" + decimal + ")" : decimal;
  }

  /** Returns the text of a file of this package. */
  static String resource(String name) {
    try (InputStream in = FmuSources.class.getResourceAsStream(name)) {
      if (in == null) {
        throw new IllegalStateException("this program lacks its file " + name);
      }
      return new String(in.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException("cannot read " + name, e);
    }
  }
}
