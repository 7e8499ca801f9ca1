package org.mechservice.sim.emit.c;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.regex.Pattern;
import org.mechservice.solver.api.JointVariables;
import org.mechservice.solver.api.ModelDescription;
import org.mechservice.solver.api.result.Variable;
import org.mechservice.solver.links.Labels;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.Parameter;
import org.mechservice.solver.symbol.Program;

/**
 * The equations of motion of a mechanism as C99: the same operations in the same order as on the
 * Java machine, so that both compute the same bits. The code depends on no library, and allocates
 * nothing.
 */
public final class CModel {
  private static final List<String> COPIED = List.of("mech_math.h", "mech_math.c");

  private static final List<String> COPIED_WITH_LOOPS = List.of("mech_loops.h", "mech_loops.c");

  /** Names with whose ending {@code _t} C and POSIX declare types, and names of other files. */
  private static final Set<String> TAKEN =
      Set.of(
          "size",
          "ssize",
          "ptrdiff",
          "wchar",
          "float",
          "double",
          "div",
          "ldiv",
          "lldiv",
          "time",
          "clock",
          "off",
          "blkcnt",
          "blksize",
          "clockid",
          "dev",
          "fsid",
          "gid",
          "id",
          "ino",
          "key",
          "loff",
          "mode",
          "nlink",
          "pid",
          "quad",
          "register",
          "sigset",
          "suseconds",
          "timer",
          "u_quad",
          "uid",
          "useconds",
          "fpos",
          "sig_atomic",
          "max_align",
          "math",
          "string",
          "stdio",
          "stdlib",
          "stdarg",
          "stddef",
          "stdint",
          "limits",
          "errno",
          "example");

  /** Beginnings of the names of whole-number types, and of the files copied beside the model. */
  private static final Pattern TAKEN_PREFIX =
      Pattern.compile("u?int(_least|_fast)?\\d+$|u?int(ptr|max)$|mech_");

  private final String name;
  private final Mechanism mechanism;
  private final ModelDescription description;
  private final double[] start;
  private final CMotion motion;
  private final Program energy;
  private final List<COutputs> outputs;
  private final CEvents events;
  private final CInputs inputs;
  private final Optional<CWatch> watch;

  /**
   * @param start state [q; v; s] at the start, loops closed
   * @param motion what gives the derivative of the state
   * @param energy program from [q; v; s] to kinetic and potential energy
   * @param outputs what the model puts out, in order
   * @param watch what its steps watch, if there is anything
   */
  public CModel(
      Mechanism mechanism,
      ModelDescription description,
      double[] start,
      CMotion motion,
      Program energy,
      List<COutputs> outputs,
      CEvents events,
      CInputs inputs,
      Optional<CWatch> watch) {
    this.name = identifier(mechanism.name());
    this.mechanism = mechanism;
    this.description = description;
    this.start = start.clone();
    this.motion = motion;
    this.energy = energy;
    this.outputs = List.copyOf(outputs);
    this.events = events;
    this.inputs = inputs;
    this.watch = watch;
  }

  private static String identifier(String modelName) {
    String name = Labels.sanitized(modelName);
    String lower = name.toLowerCase(Locale.ROOT);
    boolean taken = TAKEN.contains(lower) || TAKEN_PREFIX.matcher(lower).lookingAt();
    return Character.isLetter(name.charAt(0)) && !taken ? name : "model_" + name;
  }

  /** Returns the statements by which a function takes the present inputs. */
  List<String> inputLines() {
    return inputs.variables().isEmpty() ? List.of() : List.of("take_inputs(m);");
  }

  /** Returns the statements by which a function evaluates with the inputs, beside a jump. */
  List<String> placeLines() {
    List<String> lines = new ArrayList<>(inputLines());
    if (!events.jumps().isEmpty()) {
      lines.add("t = beside(m, t);");
    }
    return lines;
  }

  /** Returns how many parameters, inputs and loads the programs read. */
  int parameterSlots() {
    return parameters().size() + inputs.parameters() + inputs.loads();
  }

  /** Returns whether the programs take unwrapped angles behind the state. */
  boolean hasAngles() {
    return motion instanceof CLoops loops && loops.angles().isPresent();
  }

  /** Returns the identifier that the names of all its functions begin with. */
  public String name() {
    return name;
  }

  /** Returns the name of the model in its file. */
  public String modelName() {
    return mechanism.name();
  }

  /** Returns the states x = [q; v; s] in order. */
  public List<CVariable> states() {
    List<CVariable> states = new ArrayList<>();
    for (Variable state : description.states()) {
      int i = states.size();
      String what =
          i < description.positionCount()
              ? "position"
              : i < mechanism.furtherOffset() ? "velocity" : "state";
      states.add(new CVariable(state.name(), state.unit(), what, start[i]));
    }
    return states;
  }

  /** Returns the start state. */
  double[] start() {
    return start.clone();
  }

  /** Returns the tunable parameters in order. */
  public List<CVariable> parameters() {
    List<Parameter> all = mechanism.parameters();
    return all.subList(0, all.size() - inputs.parameters()).stream().map(CModel::variable).toList();
  }

  private static CVariable variable(Parameter parameter) {
    return new CVariable(
        parameter.name(), parameter.unit(), "tunable parameter", parameter.value());
  }

  /** Returns the outputs in order. */
  public List<CVariable> outputs() {
    return outputs.stream().flatMap(group -> group.variables().stream()).toList();
  }

  /** Returns the groups of outputs. */
  List<COutputs> groups() {
    return outputs;
  }

  /** Returns the mechanism. */
  public Mechanism mechanism() {
    return mechanism;
  }

  /** Returns its joints, states and settings. */
  public ModelDescription description() {
    return description;
  }

  /** Returns what gives the derivative of the state. */
  public CMotion motion() {
    return motion;
  }

  /** Returns the inputs. */
  public CInputs inputs() {
    return inputs;
  }

  /** Returns the events and the times of jumps. */
  public CEvents events() {
    return events;
  }

  Program energy() {
    return energy;
  }

  /** Returns the index of the first element of each set of Euler parameters in the state. */
  List<Integer> eulerParameters() {
    List<Integer> found = new ArrayList<>();
    int position = 0;
    for (JointVariables joint : description.joints()) {
      if (joint.type().hasEulerParameters()) {
        found.add(position);
      }
      position += joint.type().positionCount();
    }
    return found;
  }

  /**
   * Returns the texts of all files of a model that a program integrates, by their names: header,
   * code, elementary functions, example.
   */
  public Map<String, String> files() {
    Map<String, String> files = files(Optional.empty());
    files.put("example.c", resource("example.c").replace("MODEL", name));
    return files;
  }

  /**
   * Returns the texts of all files of a model whose steps are searched, by their names: as {@link
   * #files} without the example, and if there is anything to watch, the function of its quantities
   * and the tape of its formulas.
   */
  public Map<String, String> searchedFiles() {
    Map<String, String> files = files(watch);
    watch.ifPresent(watched -> files.putAll(CWatchTape.files(watched)));
    return files;
  }

  private Map<String, String> files(Optional<CWatch> watched) {
    Map<String, String> files = new LinkedHashMap<>();
    CSource source = new CSource(this, watched);
    files.put(name + ".h", new CHeader(this, source.slots(), watched).text());
    files.put(name + ".c", source.text());
    List<String> copied = new ArrayList<>(COPIED);
    if (motion instanceof CLoops) {
      copied.addAll(COPIED_WITH_LOOPS);
    }
    copied.forEach(file -> files.put(file, resource(file)));
    return files;
  }

  private static String resource(String file) {
    try (InputStream in = CModel.class.getResourceAsStream(file)) {
      if (in == null) {
        throw new IllegalStateException(file + " is missing in this installation");
      }
      return new String(in.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
