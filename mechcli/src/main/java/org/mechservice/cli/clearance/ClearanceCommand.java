package org.mechservice.cli.clearance;

import com.google.gson.Gson;
import com.google.gson.GsonBuilder;
import com.google.gson.JsonArray;
import com.google.gson.JsonObject;
import java.io.IOException;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.Callable;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.mechservice.cli.model.ParameterOption;
import org.mechservice.cli.model.UserCodeOption;
import org.mechservice.cli.shell.ExitStatus;
import org.mechservice.cli.shell.MechVersion;
import org.mechservice.cli.shell.OutputFile;
import org.mechservice.cli.shell.UsageException;
import org.mechservice.library.MechModel;
import org.mechservice.mechml.diagnosis.MechmlException;
import org.mechservice.mechml.unit.Dimension;
import org.mechservice.mechml.unit.Unit;
import org.mechservice.mechml.unit.UnitException;
import org.mechservice.mechml.unit.UnitParser;
import org.mechservice.solver.api.capability.BodyPoses;
import org.mechservice.solver.api.program.RunFailedException;
import org.mechservice.solver.catalogue.MessageCode;
import org.mechservice.solver.distance.Clearance;
import org.mechservice.solver.distance.RowPaths;
import org.mechservice.solver.distance.SolidPart;
import org.mechservice.solver.mechanism.Body;
import org.mechservice.solver.mechanism.Mechanism;
import org.mechservice.solver.mechanism.Root;
import org.mechservice.solver.mechanism.closure.JointClosure;
import org.mechservice.solver.mechanism.joint.Attachment;
import org.mechservice.solver.mechanism.joint.Joint;
import org.mechservice.solver.spatial.EulerParameters;
import org.mechservice.solver.spatial.Rotation;
import org.mechservice.solver.text.ShortestDecimal;
import org.mechservice.view.mesh.MeshException;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code mech clearance}: the least distances of bodies over a run. */
@Command(
    name = "clearance",
    description = {
      "Says how near bodies come to each other over a run, and when.",
      "The least distance has a proved lower bound: a passage between two rows is not stepped over."
          + " Bodies are taken by their solids, or as they look if they have none."
    },
    footer = {
      "mech clearance model.xml --least 2mm",
      "mech clearance model.xml --pairs crank:case,rod:case --accuracy 0.01mm -o distances.csv"
    },
    exitCodeListHeading = "%nExit status:%n",
    exitCodeList = {
      " 0:done, and no pair comes nearer than --least",
      " 1:a pair may come nearer than --least, or the run has failed",
      " 2:bad input"
    },
    mixinStandardHelpOptions = true,
    versionProvider = MechVersion.class)
public final class ClearanceCommand implements Callable<Integer> {
  private static final Gson JSON =
      new GsonBuilder().setPrettyPrinting().disableHtmlEscaping().create();

  private static final double MILLIMETRE = 1e-3;

  @Parameters(paramLabel = "MODEL.xml", description = "Model in MechML.")
  private Path file = Path.of("");

  @Option(
      names = "--pairs",
      paramLabel = "A:B,...",
      description = "Pairs of bodies; all that have a shape and no joint in common if left out.")
  private @Nullable String pairs;

  @Option(
      names = "--least",
      paramLabel = "LENGTH",
      description =
          "The distance that all pairs must keep, such as 2mm; if one may come nearer, the exit"
              + " status is 1.")
  private @Nullable String least;

  @Option(
      names = "--accuracy",
      paramLabel = "LENGTH",
      defaultValue = "0.01mm",
      description =
          "How near the proved bound comes to the distance found, and the rows to the motion"
              + " (default: ${DEFAULT-VALUE}).")
  private String accuracy = "0.01mm";

  @Option(
      names = "--simulation",
      paramLabel = "NAME",
      description = "Name or number of the simulation of the file (default: the first).")
  private Optional<String> simulation = Optional.empty();

  @Option(
      names = {"-o", "--out", "--output"},
      paramLabel = "FILE.csv",
      description = "Write the distance of each pair at each row, m.")
  private @Nullable Path out;

  @Option(names = "--json", description = "Print one JSON object.")
  private boolean json;

  @Mixin private UserCodeOption userCode = new UserCodeOption();

  @Mixin private ParameterOption settings = new ParameterOption();

  @Spec private CommandSpec spec = CommandSpec.create();

  /** Two bodies by their names. */
  private record Pair(String a, String b) {
    @Override
    public String toString() {
      return a + " - " + b;
    }
  }

  /** What was found of a pair, and by how much the rows miss its motion, m. */
  private record Kept(Clearance.Result result, double missed) {
    /** Returns the distance that the two keep for sure, m. */
    double surely() {
      return Math.max(0, result.proved() - missed);
    }
  }

  @Override
  public Integer call() throws IOException {
    if (out != null) {
      OutputFile.requireUsable(out);
    }
    double close = length("--accuracy", accuracy);
    double kept = least == null ? 0 : length("--least", least);
    Map<Pair, Kept> found = new LinkedHashMap<>();
    Map<Pair, double[]> curves = new LinkedHashMap<>();
    BodyMotion motion;
    try {
      MechModel model = model();
      Mechanism mechanism = model.content().mechanism();
      BodyParts shapes =
          new BodyParts(
              model.content(), model.folder().orElse(Path.of("")), Math.max(close / 2, 1e-9));
      List<Pair> chosen = pairs(mechanism, shapes);
      Map<String, List<SolidPart>> parts = new LinkedHashMap<>();
      for (Pair pair : chosen) {
        for (String body : List.of(pair.a(), pair.b())) {
          if (!parts.containsKey(body)) {
            parts.put(body, shapes.of(body));
          }
        }
      }
      Set<String> moving = new HashSet<>(parts.keySet());
      moving.remove(mechanism.root().name());
      motion =
          BodyMotion.of(
              model,
              moving,
              pose(mechanism.root()),
              close,
              rows ->
                  chosen.stream().mapToDouble(pair -> missed(pair, parts, rows)).max().orElse(0));
      for (Pair pair : chosen) {
        Clearance clearance = new Clearance(shape(pair.a(), parts), shape(pair.b(), parts));
        double[][] a = motion.of(pair.a());
        double[][] b = motion.of(pair.b());
        Clearance.Result result = clearance.along(motion.times(), a, b, close);
        found.put(pair, new Kept(result, missed(pair, parts, motion)));
        if (out != null) {
          curves.put(pair, clearance.atRows(motion.times(), a, b));
        }
      }
    } catch (MechmlException | IllegalArgumentException e) {
      throw new UsageException(coded(e));
    } catch (MeshException e) {
      throw new UsageException(MessageCode.CLEARANCE_UNUSABLE + " " + e.getMessage());
    } catch (RunFailedException | ArithmeticException e) {
      spec.commandLine().getErr().println(MessageCode.CLEARANCE_FAILED + " " + e.getMessage());
      return ExitStatus.SIMULATION_FAILED;
    }
    if (out != null) {
      OutputFile.write(out, csv(motion, curves).getBytes(StandardCharsets.UTF_8));
    }
    PrintWriter shown = spec.commandLine().getOut();
    shown.println(
        json
            ? JSON.toJson(json(found, motion.times().length))
            : text(found, motion.times().length));
    shown.flush();
    boolean all = found.values().stream().allMatch(one -> one.surely() >= kept);
    return all || least == null ? ExitStatus.DONE : ExitStatus.SIMULATION_FAILED;
  }

  private static String coded(Exception why) {
    String text = String.valueOf(why.getMessage());
    boolean coded = why instanceof MechmlException || text.matches("(?s)[MNS]-\\d{3} .*");
    return coded ? text : MessageCode.CLEARANCE_UNUSABLE + " " + text;
  }

  private static List<SolidPart> shape(String body, Map<String, List<SolidPart>> parts) {
    return Objects.requireNonNull(parts.get(body));
  }

  private static double missed(Pair pair, Map<String, List<SolidPart>> parts, BodyMotion motion) {
    double[][] a = motion.of(pair.a());
    double[][] b = motion.of(pair.b());
    return RowPaths.missed(motion.times(), a, b, shape(pair.b(), parts));
  }

  private MechModel model() throws IOException, MechmlException {
    MechModel model = MechModel.read(file, userCode.consent());
    if (simulation.isPresent()) {
      model = model.simulation(simulation.get());
    }
    for (Map.Entry<String, String> value : settings.values().entrySet()) {
      model = model.set(value.getKey(), value.getValue());
    }
    return model;
  }

  private static double length(String option, String text) {
    String number = text.strip().replaceFirst("[A-Za-zµ°]*$", "");
    String symbol = text.strip().substring(number.length());
    try {
      Unit unit = symbol.isEmpty() ? Unit.ONE : UnitParser.parse(symbol);
      double value = unit.toSi(Double.parseDouble(number));
      if (!symbol.isEmpty() && unit.dimension().equals(Dimension.LENGTH) && value > 0) {
        return value;
      }
    } catch (UnitException | NumberFormatException e) {
      // told below
    }
    throw new UsageException(
        MessageCode.OPTION_UNUSABLE
            + " "
            + option
            + " takes a positive length with its unit, such as 0.5mm, not \""
            + text
            + "\"");
  }

  private List<Pair> pairs(Mechanism mechanism, BodyParts shapes) {
    List<String> names =
        Stream.concat(
                Stream.of(mechanism.root().name()), mechanism.bodies().stream().map(Body::name))
            .toList();
    if (pairs != null) {
      return Stream.of(pairs.split(",", -1)).map(text -> pair(text, names, shapes)).toList();
    }
    Set<Set<String>> joined = joined(mechanism, names);
    List<Pair> all = new ArrayList<>();
    for (int i = 0; i < names.size(); i++) {
      for (int j = i + 1; j < names.size(); j++) {
        Set<String> both = Set.of(names.get(i), names.get(j));
        if (!joined.contains(both) && both.stream().allMatch(shapes::has)) {
          all.add(new Pair(names.get(i), names.get(j)));
        }
      }
    }
    if (all.isEmpty()) {
      throw new IllegalArgumentException(
          "no two bodies have a shape and no joint in common; give them a <box>, another solid or a <look>, or"
              + " name joined ones by --pairs");
    }
    return all;
  }

  private static Pair pair(String text, List<String> names, BodyParts shapes) {
    String[] both = text.strip().split(":", -1);
    if (both.length != 2 || both[0].equals(both[1])) {
      throw new UsageException(
          MessageCode.OPTION_UNUSABLE
              + " --pairs takes two bodies A:B, and more after commas, not \""
              + text
              + "\"");
    }
    for (String name : both) {
      if (!names.contains(name)) {
        throw new IllegalArgumentException(
            "--pairs names \"" + name + "\"; there are " + String.join(", ", names));
      }
      if (!shapes.has(name)) {
        throw new IllegalArgumentException(
            "body \"" + name + "\" has no shape; give it a <box>, another solid or a <look>");
      }
    }
    return new Pair(both[0], both[1]);
  }

  /** Returns the pairs of bodies with a joint in common, also one that closes a loop. */
  private static Set<Set<String>> joined(Mechanism mechanism, List<String> names) {
    Stream<Joint> cut =
        mechanism.closures().stream()
            .filter(JointClosure.class::isInstance)
            .map(closure -> ((JointClosure) closure).joint());
    Set<Set<String>> joined = new HashSet<>();
    Stream.concat(mechanism.joints().stream(), cut)
        .map(Joint::attachment)
        .filter(attachment -> attachment.parent() != attachment.child())
        .forEach(attachment -> joined.add(bodies(attachment, names)));
    return joined;
  }

  private static Set<String> bodies(Attachment attachment, List<String> names) {
    // the root comes first
    return Set.of(names.get(attachment.parent() + 1), names.get(attachment.child() + 1));
  }

  private static double[] pose(Root root) {
    Rotation r = root.orientation();
    double[] rows = {r.xx(), r.xy(), r.xz(), r.yx(), r.yy(), r.yz(), r.zx(), r.zy(), r.zz()};
    double[] pose = new double[BodyPoses.NUMBERS_PER_BODY];
    pose[0] = root.position().x();
    pose[1] = root.position().y();
    pose[2] = root.position().z();
    EulerParameters.of(rows, 0, pose, 3);
    return pose;
  }

  private static String text(Map<Pair, Kept> found, int rows) {
    StringBuilder text = new StringBuilder();
    found.forEach(
        (pair, kept) -> {
          Clearance.Result result = kept.result();
          text.append(pair).append("  ");
          if (result.least() == 0) {
            text.append("touch or overlap at ");
          } else {
            text.append(millimetres(result.least())).append(" at ");
          }
          text.append(String.format(Locale.ROOT, "%.6g s", result.time()));
          if (result.least() > 0) {
            text.append("; at all times at least ").append(millimetres(kept.surely()));
          }
          if (result.band() > 0) {
            text.append("; facets ").append(millimetres(result.band()));
          }
          text.append('\n');
        });
    return text.append(rows)
        .append(" rows, which tell the motion between them to ")
        .append(millimetres(missed(found)))
        .toString();
  }

  private static double missed(Map<Pair, Kept> found) {
    return found.values().stream().mapToDouble(Kept::missed).max().orElse(0);
  }

  private static String millimetres(double metres) {
    return String.format(Locale.ROOT, "%.6g mm", metres / MILLIMETRE);
  }

  private static JsonObject json(Map<Pair, Kept> found, int rows) {
    JsonArray all = new JsonArray();
    found.forEach(
        (pair, kept) -> {
          Clearance.Result result = kept.result();
          JsonObject one = new JsonObject();
          one.addProperty("a", pair.a());
          one.addProperty("b", pair.b());
          one.addProperty("distance", result.least());
          one.addProperty("bound", kept.surely());
          one.addProperty("time", result.time());
          one.add("pointOnA", array(result.onA()));
          one.add("pointOnB", array(result.onB()));
          one.addProperty("facets", result.band());
          all.add(one);
        });
    JsonObject object = new JsonObject();
    object.add("pairs", all);
    object.addProperty("rows", rows);
    object.addProperty("rowsMiss", missed(found));
    return object;
  }

  private static JsonArray array(double[] numbers) {
    JsonArray array = new JsonArray();
    for (double number : numbers) {
      array.add(number);
    }
    return array;
  }

  private static String csv(BodyMotion motion, Map<Pair, double[]> curves) {
    StringBuilder text = new StringBuilder("t");
    curves.keySet().forEach(pair -> text.append(',').append(quoted(pair.toString())));
    text.append("\r\n");
    for (int row = 0; row < motion.times().length; row++) {
      text.append(ShortestDecimal.format(motion.times()[row]));
      for (double[] curve : curves.values()) {
        text.append(',').append(ShortestDecimal.format(curve[row]));
      }
      text.append("\r\n");
    }
    return text.toString();
  }

  private static String quoted(String text) {
    return text.matches("[^,\"\r\n]*") ? text : '"' + text.replace("\"", "\"\"") + '"';
  }
}
